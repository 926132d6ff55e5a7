/*!
SPDX-License-Identifier: Apache-2.0
The scene of pitchpoint, with three.js 0.187.0 and uPlot 1.6.32 inside; their licences:

--- three.js ---

The MIT License

Copyright (c) 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

--- uPlot ---

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
(()=>{var yh='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var bh=`.ppv { --v-paper: var(--pp-paper, #fff); --v-ink: var(--pp-ink, #1f2933); --v-soft: var(--pp-soft, #5b6672); --v-grid: var(--pp-grid, #e3e7ec);
  --v-accent: #2f6fb3; --v-scene: #f3f5f8; --v-panel: rgba(255, 255, 255, .92); --v-hover: rgba(31, 41, 51, .07);
  position: relative; display: flex; flex-direction: column; width: 100%; height: 100%; min-height: 240px; min-width: 0; overflow: hidden; box-sizing: border-box;
  color: var(--v-ink); background: var(--v-paper); font: 13px/1.35 var(--pp-font, system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif); text-align: left; color-scheme: light; }
@media (prefers-color-scheme: dark) {
  .ppv { --v-paper: var(--pp-paper, #14181d); --v-ink: var(--pp-ink, #e6e9ed); --v-soft: var(--pp-soft, #a3adb8); --v-grid: var(--pp-grid, #2c343d);
    --v-accent: #6aa5e0; --v-scene: #1b2026; --v-panel: rgba(24, 29, 35, .92); --v-hover: rgba(230, 233, 237, .1); color-scheme: dark; }
}
.ppv *, .ppv *::before { box-sizing: border-box; }
.ppv [hidden] { display: none !important; }
.ppv button, .ppv select, .ppv input { font: inherit; color: inherit; accent-color: var(--v-accent); margin: 0; }
.ppv button { border: 1px solid transparent; background: none; border-radius: 5px; padding: 3px 8px; cursor: pointer; line-height: 1.3; white-space: nowrap; }
.ppv button:hover, .ppv button[aria-expanded="true"] { background: var(--v-hover); }
.ppv button[aria-pressed="true"] { background: var(--v-accent); color: var(--v-paper); }
.ppv :focus-visible { outline: 2px solid var(--v-accent); outline-offset: 1px; }
.ppv select, .ppv input[type="search"] { background: var(--v-paper); border: 1px solid var(--v-grid); border-radius: 5px; padding: 2px 5px; max-width: 170px; min-width: 0; }
.ppv input[type="range"] { min-width: 0; flex: 1; }
.ppv-head { display: flex; flex-wrap: wrap; align-items: center; gap: 0 14px; padding: 4px 8px 4px 12px; border-bottom: 1px solid var(--v-grid); }
.ppv-title { flex: 1 1 120px; min-width: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.ppv-title span { color: var(--v-soft); margin-left: 8px; }
.ppv-tools { display: flex; flex-wrap: wrap; gap: 0 1px; }
.ppv-scene { position: relative; flex: 1 1 62%; min-height: 150px; overflow: hidden; background: var(--v-scene); }
.ppv-view { position: absolute; inset: 0; }
.ppv-canvas { display: block; touch-action: none; cursor: grab; outline-offset: -3px; }
.ppv-canvas:active { cursor: grabbing; }
.ppv-message { position: absolute; inset: 0; display: grid; place-items: center; padding: 24px; text-align: center; color: var(--v-soft); pointer-events: none; }
.ppv-message p { max-width: 52ch; margin: 0; font-size: 15px; }
.ppv-panel { position: absolute; top: 8px; left: 8px; width: 250px; max-width: calc(100% - 16px); max-height: calc(100% - 16px); overflow: auto; padding: 8px 10px 10px; z-index: 3; background: var(--v-panel); border: 1px solid var(--v-grid); border-radius: 8px; box-shadow: 0 3px 14px rgba(0, 0, 0, .12); display: flex; flex-direction: column; gap: 7px; }
.ppv-panel > * { flex: none; }
.ppv-panel p { margin: 0; }
.ppv-panel-head { display: flex; justify-content: space-between; align-items: center; }
.ppv-panel-head button { padding: 0 6px; font-size: 15px; color: var(--v-soft); }
.ppv-buttons { display: flex; flex-wrap: wrap; gap: 4px; }
.ppv-buttons button { border-color: var(--v-grid); }
.ppv-soft { color: var(--v-soft); font-size: 12px; }
.ppv-slider, .ppv-choice, .ppv-tick { display: flex; align-items: center; gap: 7px; }
.ppv-slider output { min-width: 3.6em; text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.ppv-choice span { color: var(--v-soft); white-space: nowrap; }
.ppv-panel .ppv-choice { justify-content: space-between; }
.ppv-legend { position: absolute; top: 8px; right: 8px; max-height: calc(100% - 44px); max-width: calc(100% - 16px); overflow: auto; padding: 5px 9px 6px; background: var(--v-panel); border: 1px solid var(--v-grid); border-radius: 8px; font-size: 12px; z-index: 2; pointer-events: auto; }
.ppv-legend table { border-collapse: collapse; }
.ppv-legend th { font-weight: 500; text-align: left; padding: 1px 8px 1px 0; white-space: nowrap; }
.ppv-legend td { text-align: right; padding: 1px 0 1px 12px; font-variant-numeric: tabular-nums; white-space: nowrap; }
.ppv-legend thead th { text-align: right; padding: 1px 0 2px 12px; color: var(--v-soft); font-weight: 400; }
.ppv-legend thead i { display: inline-block; width: 12px; height: 4px; border-radius: 2px; margin-right: 5px; vertical-align: 2px; }
.ppv-circumferential i { background: var(--pp-force-circumferential, #d55e00); }
.ppv-radial i { background: var(--pp-force-radial, #0072b2); }
.ppv-axial i { background: var(--pp-force-axial, #009e73); }
.ppv-state { display: inline-block; width: 9px; height: 9px; border-radius: 50%; margin-right: 6px; }
.ppv-states { display: flex; flex-wrap: wrap; gap: 0 12px; margin-top: 3px; color: var(--v-soft); font-size: 11px; }
.ppv-states i { display: inline-block; width: 8px; height: 8px; border-radius: 50%; margin-right: 4px; }
.ppv-label { position: absolute; left: 0; top: 0; padding: 2px 7px; background: var(--v-ink); color: var(--v-paper); border-radius: 4px; font-size: 12px; pointer-events: none; white-space: nowrap; z-index: 2; }
.ppv-scale { position: absolute; left: 12px; bottom: 8px; font-size: 11px; color: var(--v-soft); pointer-events: none; }
.ppv-scale i { display: block; height: 5px; border: 1px solid var(--v-soft); border-top: 0; }
.ppv-status { position: absolute; left: 50%; bottom: 6px; transform: translateX(-50%); color: var(--v-soft); font-size: 12px; pointer-events: none; white-space: nowrap; }
.ppv-halves { position: absolute; inset: 0; display: flex; pointer-events: none; }
.ppv-half { position: relative; flex: 1; min-width: 0; }
.ppv-half + .ppv-half { border-left: 1px solid var(--v-grid); }
.ppv-name { position: absolute; right: 12px; bottom: 8px; max-width: 60%; font-weight: 600; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.ppv-time { border-top: 1px solid var(--v-grid); padding: 2px 10px 4px; }
.ppv-still { display: none; }
.ppv-track { position: relative; display: flex; flex-direction: column; }
.ppv-marks { display: block; width: calc(100% - 16px); height: 13px; margin: 0 8px -2px; }
.ppv-range { width: 100%; height: 16px; }
.ppv-tip { position: absolute; bottom: 26px; padding: 2px 7px; background: var(--v-ink); color: var(--v-paper); border-radius: 4px; font-size: 12px; white-space: nowrap; z-index: 4; pointer-events: none; }
.ppv-transport { display: flex; flex-wrap: wrap; align-items: center; gap: 2px 6px; }
.ppv-transport button { min-width: 30px; }
.ppv-play { font-size: 14px; color: var(--v-accent) !important; }
.ppv-now { min-width: 8.5em; font-variant-numeric: tabular-nums; font-size: 14px; font-weight: 600; text-align: right; padding-right: 10px; }
.ppv-transport .ppv-slider input { width: 110px; flex: none; }
.ppv-transport .ppv-slider output { min-width: 9.5em; text-align: left; }
.ppv-said { color: var(--v-soft); font-size: 12px; }
.ppv-curves { flex: 1 1 38%; min-height: 0; display: flex; flex-direction: column; border-top: 1px solid var(--v-grid); position: relative; }
.ppv-bar { display: flex; justify-content: flex-end; gap: 6px; padding: 3px 10px 0; position: absolute; right: 0; top: 0; z-index: 3; pointer-events: none; }
.ppv-bar > * { pointer-events: auto; }
.ppv-bar button { border-color: var(--v-grid); background: var(--v-paper); }
.ppv-picker { position: relative; }
.ppv-picker input { width: 170px; }
.ppv-list { position: absolute; right: 0; bottom: 100%; width: min(340px, 80vw); max-height: 260px; overflow: auto; background: var(--v-paper); border: 1px solid var(--v-grid); border-radius: 8px; padding: 4px; display: flex; flex-direction: column; box-shadow: 0 3px 14px rgba(0, 0, 0, .12); }
.ppv-list button { text-align: left; white-space: normal; flex: none; background: none; border: 0; }
.ppv-list button[aria-selected="true"] { font-weight: 600; color: var(--v-accent); }
.ppv-list button[aria-selected="true"]::before { content: "\u2713 "; }
.ppv-list p, .ppv-none { margin: 6px 8px; color: var(--v-soft); }
.ppv-curves-body { flex: 1; min-height: 0; position: relative; }
.ppv-plots { height: 100%; overflow-y: auto; overflow-x: hidden; padding: 3px 0 0 4px; }
.ppv-spectra { padding: 4px; }
.ppv-caption { display: flex; flex-wrap: wrap; gap: 0 14px; min-height: 20px; padding: 0 330px 0 8px; font-size: 12px; align-items: center; }
.ppv-plot + .ppv-plot .ppv-caption { padding-right: 8px; }
.ppv-curve { display: inline-flex; align-items: center; gap: 5px; white-space: nowrap; }
.ppv-curve i { width: 12px; height: 3px; border-radius: 2px; }
.ppv-curve output { font-variant-numeric: tabular-nums; font-weight: 600; }
.ppv-curve small, .ppv-spectra output { color: var(--v-soft); font-size: 12px; }
.ppv-curve button { padding: 0 4px; color: var(--v-soft); }
.ppv-box { width: 100%; min-width: 0; overflow: hidden; }
.ppv .u-over { cursor: ew-resize; touch-action: pan-y; }
.ppv-cursor { position: absolute; left: -.5px; top: 0; bottom: 0; width: 1.5px; background: var(--v-accent); pointer-events: none; }
.ppv-notes { margin: 0; padding-left: 18px; }
.ppv dl { display: grid; grid-template-columns: auto 1fr; gap: 2px 10px; margin: 0; font-size: 12px; }
.ppv dt { font-weight: 600; white-space: nowrap; }
.ppv dd { margin: 0; color: var(--v-soft); }
.ppv-modes { display: flex; flex-direction: column; max-height: 190px; overflow: auto; }
.ppv-modes button { text-align: left; display: flex; justify-content: space-between; gap: 8px; flex: none; }
@media (max-width: 640px) {
  .ppv-caption { padding-right: 8px; }
  .ppv-bar { position: static; }
  .ppv-now { min-width: 6em; }
  .ppv-legend { font-size: 11px; max-height: 45%; }
}
@media print { .ppv-tools, .ppv-time, .ppv-bar { display: none; } }
`;function ae(n,e={},...t){let i=document.createElement(n);for(let[r,s]of Object.entries(e))s==null||s===!1||(r.startsWith("on")?i.addEventListener(r.slice(2),s):r in i&&r!=="list"&&typeof s!="string"?i[r]=s:i.setAttribute(r==="className"?"class":r,s===!0?"":String(s)));return i.append(...t.filter(r=>r!=null)),i}function Ht(n,e,t,i={}){return ae("button",{type:"button",title:e,"aria-label":e,onclick:t,...i},n)}function Qr({label:n,title:e,least:t,most:i,value:r,show:s,changed:o}){let a=Math.log(i/t),c=ae("output",{},s(r)),l=ae("input",{type:"range",min:"0",max:"1",step:"0.001",title:e,"aria-label":e}),h=()=>t*Math.exp(a*Number(l.value)),f=u=>{l.value=String(Math.log(u/t)/a),c.textContent=l.ariaValueText=s(u)};return l.addEventListener("input",()=>{let u=h();c.textContent=l.ariaValueText=s(u),o(u)}),f(r),{row:ae("label",{className:"ppv-slider"},ae("span",{},n),l,c),set:f,input:l}}function ur(n,e,t,i=n){let r=ae("select",{title:i,"aria-label":i,onchange:()=>t(r.value)},...e.map(([s,o])=>ae("option",{value:s},o)));return{row:ae("label",{className:"ppv-choice"},ae("span",{},n),r),select:r}}function jr(n,e,t,i=null){let r=ae("input",{type:"checkbox",checked:e,onchange:()=>t(r.checked)});return{row:ae("label",{className:"ppv-tick"},r,i,ae("span",{},n)),input:r}}var $_="uplot",J_="u-hz",Q_="u-vt",j_="u-title",ev="u-wrap",tv="u-under",iv="u-over",nv="u-axis",is="u-off",rv="u-select",sv="u-cursor-x",ov="u-cursor-y",av="u-cursor-pt",lv="u-legend",cv="u-live",fv="u-inline",uv="u-series",hv="u-marker",Eh="u-label",dv="u-value",Vo="width",Wo="height";var wh="bottom",Ls="left",Lf="right",Kf="#000",Th=Kf+"0",Df="mousemove",Ah="mousedown",Nf="mouseup",Rh="mouseenter",Ch="mouseleave",Ph="dblclick",pv="resize",mv="scroll",Lh="change",ml="dppxchange",Zf="--",Bs=typeof window<"u",Bf=Bs?document:null,Ns=Bs?window:null,gv=Bs?navigator:null,wt,ul;function Gf(){let n=devicePixelRatio;wt!=n&&(wt=n,ul&&kf(Lh,ul,Gf),ul=matchMedia(`(min-resolution: ${wt-.001}dppx) and (max-resolution: ${wt+.001}dppx)`),ns(Lh,ul,Gf),Ns.dispatchEvent(new CustomEvent(ml)))}function dn(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function zf(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Vt(n,e,t){n.style[e]=t+"px"}function Bn(n,e,t,i){let r=Bf.createElement(n);return e!=null&&dn(r,e),t?.insertBefore(r,i),r}function An(n,e){return Bn("div",n,e)}var Dh=new WeakMap;function jn(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=Dh.get(n);s!=o&&(n.style.transform=s,Dh.set(n,s),e<0||t<0||e>i||t>r?dn(n,is):zf(n,is))}var Nh=new WeakMap;function Ih(n,e,t){let i=e+t,r=Nh.get(n);i!=r&&(Nh.set(n,i),n.style.background=e,n.style.borderColor=t)}var Uh=new WeakMap;function Fh(n,e,t,i){let r=e+""+t,s=Uh.get(n);r!=s&&(Uh.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var $f={passive:!0},xv={...$f,capture:!0};function ns(n,e,t,i){e.addEventListener(n,t,i?xv:$f)}function kf(n,e,t,i){e.removeEventListener(n,t,$f)}Bs&&Gf();function Gn(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:pn((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function fd(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var ud=n=>n!=null,hd=n=>n!=null&&n>0,_l=fd(ud),_v=fd(hd);function vv(n,e,t,i=0,r=!1){let s=r?_v:_l,o=r?hd:ud;[e,t]=s(n,e,t);let a=n[e],c=n[e];if(e>-1)if(i==1)a=n[e],c=n[t];else if(i==-1)a=n[t],c=n[e];else for(let l=e;l<=t;l++){let h=n[l];o(h)&&(h<a?a=h:h>c&&(c=h))}return[a??Nt,c??-Nt]}function vl(n,e,t,i){let r=Gh(n),s=Gh(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?hr:dd,a=r==1?pn:Rn,c=s==1?Rn:pn,l=a(o(yi(n))),h=c(o(yi(e))),f=Is(t,l),u=Is(t,h);return t==10&&(l<0&&(f=It(f,-l)),h<0&&(u=It(u,-h))),i||t==2?(n=f*r,e=u*s):(n=xd(n,f),e=Ml(e,u)),[n,e]}function Jf(n,e,t,i){let r=vl(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var Qf=.1,Oh={mode:3,pad:Qf},qo={pad:0,soft:null,mode:0},Mv={min:qo,max:qo};function gl(n,e,t,i){return Sl(t)?Bh(n,e,t):(qo.pad=t,qo.soft=i?0:null,qo.mode=i?3:0,Bh(n,e,Mv))}function yt(n,e){return n??e}function Sv(n,e,t){for(e=yt(e,0),t=yt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Bh(n,e,t){let i=t.min,r=t.max,s=yt(i.pad,0),o=yt(r.pad,0),a=yt(i.hard,-Nt),c=yt(r.hard,Nt),l=yt(i.soft,Nt),h=yt(r.soft,-Nt),f=yt(i.mode,0),u=yt(r.mode,0),m=e-n,x=hr(m),M=Qi(yi(n),yi(e)),d=hr(M),p=yi(d-x);(m<1e-24||p>10)&&(m=0,(n==0||e==0)&&(m=1e-24,f==2&&l!=Nt&&(s=0),u==2&&h!=-Nt&&(o=0)));let v=m||M||1e3,A=hr(v),y=Is(10,pn(A)),R=v*(m==0?n==0?.1:1:s),T=It(xd(n-R,y/10),24),g=n>=l&&(f==1||f==3&&T<=l||f==2&&T>=l)?l:Nt,w=Qi(a,T<g&&n>=g?g:zn(g,T)),O=v*(m==0?e==0?.1:1:o),L=It(Ml(e+O,y/10),24),D=e<=h&&(u==1||u==3&&L>=h||u==2&&L<=h)?h:-Nt,G=zn(c,L>D&&e<=D?D:Qi(D,L));return w==G&&w==0&&(G=100),[w,G]}var yv=new Intl.NumberFormat(Bs?gv.language:"en-US"),jf=n=>yv.format(n),mn=Math,pl=mn.PI,yi=mn.abs,pn=mn.floor,Si=mn.round,Rn=mn.ceil,zn=mn.min,Qi=mn.max,Is=mn.pow,Gh=mn.sign,hr=mn.log10,dd=mn.log2,bv=(n,e=1)=>mn.sinh(n)*e,If=(n,e=1)=>mn.asinh(n/e),Nt=1/0;function zh(n){return(hr((n^n>>31)-(n>>31))|0)+1}function Hf(n,e,t){return zn(Qi(n,e),t)}function pd(n){return typeof n=="function"}function _t(n){return pd(n)?n:()=>n}var Ev=()=>{},md=n=>n,gd=(n,e)=>e,wv=n=>null,kh=n=>!0,Hh=(n,e)=>n==e,Tv=/\.\d*?(?=9{6,}|0{6,})/gm,rs=n=>{if(vd(n)||Dr.has(n))return n;let e=`${n}`,t=e.match(Tv);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${rs(r)}e${s}`}return It(n,i)};function es(n,e){return rs(It(rs(n/e))*e)}function Ml(n,e){return rs(Rn(rs(n/e))*e)}function xd(n,e){return rs(pn(rs(n/e))*e)}function It(n,e=0){if(vd(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Si(i)/t}var Dr=new Map;function _d(n){return((""+n).split(".")[1]||"").length}function Ko(n,e,t,i){let r=[],s=i.map(_d);for(let o=e;o<t;o++){let a=yi(o),c=It(Is(n,o),a);for(let l=0;l<i.length;l++){let h=n==10?+`${i[l]}e${o}`:i[l]*c,f=(o>=0?0:a)+(o>=s[l]?0:s[l]),u=n==10?h:It(h,f);r.push(u),Dr.set(u,f)}}return r}var Yo={},eu=[],Us=[null,null],Lr=Array.isArray,vd=Number.isInteger,Av=n=>n===void 0;function Vh(n){return typeof n=="string"}function Sl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Rv(n){return n!=null&&typeof n=="object"}var Cv=Object.getPrototypeOf(Uint8Array),Md="__proto__";function Fs(n,e=Sl){let t;if(Lr(n)){let i=n.find(r=>r!=null);if(Lr(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=Fs(n[r],e)}else t=n.slice()}else if(n instanceof Cv)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Md&&(t[i]=Fs(n[i],e))}else t=n;return t}function gi(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=Md&&(Sl(n[r])?gi(n[r],Fs(i[r])):n[r]=Fs(i[r]))}return n}var Pv=0,Lv=1,Dv=2;function Nv(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function Iv(n,e){if(Ov(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Bv(o[0])||(o=Fv(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let c=n[o][0],l=c.length;for(let h=0;h<l;h++)t.add(c[h])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],c=a[0];for(let l=1;l<a.length;l++){let h=a[l],f=Array(r).fill(void 0),u=e?e[o][l]:Lv,m=[];for(let x=0;x<h.length;x++){let M=h[x],d=s.get(c[x]);M===null?u!=Pv&&(f[d]=M,u==Dv&&m.push(d)):f[d]=M}Nv(f,m,r),i.push(f)}}return i}var Uv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Fv(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let c=0;c<t;c++)a[c]=o[i[c]];r.push(a)}return r}function Ov(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function Bv(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=Qi(1,pn((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let c=n[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var Sd=["January","February","March","April","May","June","July","August","September","October","November","December"],yd=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function bd(n){return n.slice(0,3)}var Gv=yd.map(bd),zv=Sd.map(bd),kv={MMMM:Sd,MMM:zv,WWWW:yd,WWW:Gv};function Ho(n){return(n<10?"0":"")+n}function Hv(n){return(n<10?"00":n<100?"0":"")+n}var Vv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ho(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ho(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ho(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ho(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ho(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Hv(n.getMilliseconds())};function tu(n,e){e=e||kv;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?Vv[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var Wv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Xv(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Wv?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Ed=n=>n%1==0,xl=[1,2,2.5,5],qv=Ko(10,-32,0,xl),wd=Ko(10,0,32,xl),Yv=wd.filter(Ed),ts=qv.concat(wd),iu=`
`,Td="{YYYY}",Wh=iu+Td,Ad="{M}/{D}",Xo=iu+Ad,hl=Xo+"/{YY}",Rd="{aa}",Kv="{h}:{mm}",Ds=Kv+Rd,Xh=iu+Ds,qh=":{ss}",Tt=null;function Cd(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,c=(n==1?Ko(10,0,3,xl).filter(Ed):Ko(10,-3,0,xl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,Td,Tt,Tt,Tt,Tt,Tt,Tt,1],[r*28,"{MMM}",Wh,Tt,Tt,Tt,Tt,Tt,1],[r,Ad,Wh,Tt,Tt,Tt,Tt,Tt,1],[i,"{h}"+Rd,hl,Tt,Xo,Tt,Tt,Tt,1],[t,Ds,hl,Tt,Xo,Tt,Tt,Tt,1],[e,qh,hl+" "+Ds,Tt,Xo+" "+Ds,Tt,Xh,Tt,1],[n,qh+".{fff}",hl+" "+Ds,Tt,Xo+" "+Ds,Tt,Xh,Tt,1]];function h(f){return(u,m,x,M,d,p)=>{let v=[],A=d>=o,y=d>=s&&d<o,R=f(x),T=It(R*n,3),g=Uf(R.getFullYear(),A?0:R.getMonth(),y||A?1:R.getDate()),w=It(g*n,3);if(y||A){let O=y?d/s:0,L=A?d/o:0,D=T==w?T:It(Uf(g.getFullYear()+L,g.getMonth()+O,1)*n,3),G=new Date(Si(D/n)),k=G.getFullYear(),I=G.getMonth();for(let W=0;D<=M;W++){let Y=Uf(k+L*W,I+O*W,1),V=Y-f(It(Y*n,3));D=It((+Y+V)*n,3),D<=M&&v.push(D)}}else{let O=d>=r?r:d,L=pn(x)-pn(T),D=w+L+Ml(T-w,O);v.push(D);let G=f(D),k=G.getHours()+G.getMinutes()/t+G.getSeconds()/i,I=d/i,W=u.axes[m]._space,Y=p/W;for(;D=It(D+d,n==1?0:3),!(D>M);)if(I>1){let V=pn(It(k+I,6))%24,Q=f(D).getHours()-V;Q>1&&(Q=-1),D-=Q*i,k=(k+I)%24;let ne=v[v.length-1];It((D-ne)/d,3)*Y>=.7&&v.push(D)}else v.push(D)}return v}}return[c,l,h]}var[Zv,$v,Jv]=Cd(1),[Qv,jv,eM]=Cd(.001);Ko(2,-53,53,[1]);function Yh(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function Kh(n,e){return(t,i,r,s,o)=>{let a=e.find(x=>o>=x[0])||e[e.length-1],c,l,h,f,u,m;return i.map(x=>{let M=n(x),d=M.getFullYear(),p=M.getMonth(),v=M.getDate(),A=M.getHours(),y=M.getMinutes(),R=M.getSeconds(),T=d!=c&&a[2]||p!=l&&a[3]||v!=h&&a[4]||A!=f&&a[5]||y!=u&&a[6]||R!=m&&a[7]||a[1];return c=d,l=p,h=v,f=A,u=y,m=R,T(M)})}}function tM(n,e){let t=tu(e);return(i,r,s,o,a)=>r.map(c=>t(n(c)))}function Uf(n,e,t){return new Date(n,e,t)}function Zh(n,e){return e(n)}var iM="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function $h(n,e){return(t,i,r,s)=>s==null?Zf:e(n(i))}function nM(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function rM(n,e){return n.series[e].fill(n,e)}var sM={show:!0,live:!0,isolate:!1,mount:Ev,markers:{show:!0,width:2,stroke:nM,fill:rM,dash:"solid"},idx:null,idxs:null,values:[]};function oM(n,e){let t=n.cursor.points,i=An(),r=t.size(n,e);Vt(i,Vo,r),Vt(i,Wo,r);let s=r/-2;Vt(i,"marginLeft",s),Vt(i,"marginTop",s);let o=t.width(n,e,r);return o&&Vt(i,"borderWidth",o),i}function aM(n,e){let t=n.series[e].points;return t._fill||t._stroke}function lM(n,e){let t=n.series[e].points;return t._stroke||t._fill}function cM(n,e){return n.series[e].points.size}var Ff=[0,0];function fM(n,e,t){return Ff[0]=e,Ff[1]=t,Ff}function dl(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function Of(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var uM={show:!0,x:!0,y:!0,lock:!1,move:fM,points:{one:!1,show:oM,size:cM,width:0,stroke:lM,fill:aM},bind:{mousedown:dl,mouseup:dl,click:dl,dblclick:dl,mousemove:Of,mouseleave:Of,mouseenter:Of},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Pd={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},nu=gi({},Pd,{filter:gd}),Ld=gi({},nu,{size:10}),Dd=gi({},Pd,{show:!1}),ru='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Nd="bold "+ru,Id=1.5,Jh={show:!0,scale:"x",stroke:Kf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Nd,side:2,grid:nu,ticks:Ld,border:Dd,font:ru,lineGap:Id,rotate:0},hM="Value",dM="Time",Qh={show:!0,scale:"x",auto:!1,sorted:1,min:Nt,max:-Nt,idxs:[]};function pM(n,e,t,i,r){return e.map(s=>s==null?"":jf(s))}function mM(n,e,t,i,r,s,o){let a=[],c=Dr.get(r)||0;t=o?t:It(Ml(t,r),c);for(let l=t;l<=i;l=It(l+r,c))a.push(Object.is(l,-0)?0:l);return a}function Vf(n,e,t,i,r,s,o){let a=[],c=n.scales[n.axes[e].scale].log,l=c==10?hr:dd,h=pn(l(t));r=Is(c,h),c==10&&(r=ts[Gn(r,ts)]);let f=t,u=r*c;c==10&&(u=ts[Gn(u,ts)]);do a.push(f),f=f+r,c==10&&!Dr.has(f)&&(f=It(f,Dr.get(r))),f>=u&&(r=f,u=r*c,c==10&&(u=ts[Gn(u,ts)]));while(f<=i);return a}function gM(n,e,t,i,r,s,o){let c=n.scales[n.axes[e].scale].asinh,l=i>c?Vf(n,e,Qi(c,t),i,r):[c],h=i>=0&&t<=0?[0]:[];return(t<-c?Vf(n,e,Qi(c,-i),-t,r):[c]).reverse().map(u=>-u).concat(h,l)}var Ud=/./,xM=/[12357]/,_M=/[125]/,jh=/1/,Wf=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function vM(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],c=n.valToPos,l=s._space,h=c(10,o),f=c(9,o)-h>=l?Ud:c(7,o)-h>=l?xM:c(5,o)-h>=l?_M:jh;if(f==jh){let u=yi(c(1,o)-h);if(u<l)return Wf(e.slice().reverse(),a.distr,f,Rn(l/u)).reverse()}return Wf(e,a.distr,f,1)}function MM(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,c=n.valToPos,l=yi(c(1,o)-c(2,o));return l<a?Wf(e.slice().reverse(),3,Ud,Rn(a/l)).reverse():e}function SM(n,e,t,i){return i==null?Zf:e==null?"":jf(e)}var ed={show:!0,scale:"y",stroke:Kf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Nd,side:3,grid:nu,ticks:Ld,border:Dd,font:ru,lineGap:Id,rotate:0};function yM(n,e){let t=3+(n||1)*2;return It(t*e,3)}function bM(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=yi(o-s),c=n.series[e],l=a/(c.points.space*wt);return i[1]-i[0]<=l}var td={scale:null,auto:!0,sorted:0,min:Nt,max:-Nt},Fd=(n,e,t,i,r)=>r,id={show:!0,auto:!0,sorted:0,gaps:Fd,alpha:1,facets:[gi({},td,{scale:"x"}),gi({},td,{scale:"y"})]},nd={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Fd,alpha:1,points:{show:bM,filter:null},values:null,min:Nt,max:-Nt,idxs:[],path:null,clip:null};function EM(n,e,t,i,r){return t/10}var Od={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},wM=gi({},Od,{time:!1,ori:1}),rd={};function Bd(n,e){let t=rd[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,c,l){for(let h=0;h<t.plots.length;h++)t.plots[h]!=r&&t.plots[h].pub(i,r,s,o,a,c,l)}},n!=null&&(rd[n]=t)),t}var Os=1,Xf=2;function ss(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,c=s[0],l=i==2?s[1]:s[e],h=i==2?o[r.facets[0].scale]:o[n.series[0].scale],f=i==2?o[r.facets[1].scale]:o[r.scale],u=a.left,m=a.top,x=a.width,M=a.height,d=n.valToPosH,p=n.valToPosV;return h.ori==0?t(r,c,l,h,f,d,p,u,m,x,M,bl,Gs,wl,zd,Hd):t(r,c,l,h,f,p,d,m,u,M,x,El,zs,au,kd,Vd)}function su(n,e){let t=0,i=0,r=yt(n.bands,eu);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function TM(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,c=n.scales[a];return r==-1?c.min:r==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function dr(n,e,t,i,r,s){return ss(n,e,(o,a,c,l,h,f,u,m,x,M,d)=>{let p=o.pxRound,v=l.dir*(l.ori==0?1:-1),A=l.ori==0?Gs:zs,y,R;v==1?(y=t,R=i):(y=i,R=t);let T=p(f(a[y],l,M,m)),g=p(u(c[y],h,d,x)),w=p(f(a[R],l,M,m)),O=p(u(s==1?h.max:h.min,h,d,x)),L=new Path2D(r);return A(L,w,O),A(L,T,O),A(L,T,g),L})}function yl(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?wl:au,c=t;for(let f=0;f<n.length;f++){let u=n[f];if(u[1]>u[0]){let m=u[0]-c;m>0&&a(o,c,i,m,i+s),c=u[1]}}let l=t+r-c,h=10;l>0&&a(o,c,i-h/2,l,i+s+h)}return o}function AM(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function ou(n,e,t,i,r,s,o){let a=[],c=n.length;for(let l=r==1?t:i;l>=t&&l<=i;l+=r)if(e[l]===null){let f=l,u=l;if(r==1)for(;++l<=i&&e[l]===null;)u=l;else for(;--l>=t&&e[l]===null;)u=l;let m=s(n[f]),x=u==f?m:s(n[u]),M=f-r;m=o<=0&&M>=0&&M<c?s(n[M]):m;let p=u+r;x=o>=0&&p>=0&&p<c?s(n[p]):x,x>=m&&a.push([m,x])}return a}function sd(n){return n==0?md:n==1?Si:e=>es(e,n)}function Gd(n){let e=n==0?bl:El,t=n==0?(r,s,o,a,c,l)=>{r.arcTo(s,o,a,c,l)}:(r,s,o,a,c,l)=>{r.arcTo(o,s,c,a,l)},i=n==0?(r,s,o,a,c)=>{r.rect(s,o,a,c)}:(r,s,o,a,c)=>{r.rect(o,s,c,a)};return(r,s,o,a,c,l=0,h=0)=>{l==0&&h==0?i(r,s,o,a,c):(l=zn(l,a/2,c/2),h=zn(h,a/2,c/2),e(r,s+l,o),t(r,s+a,o,s+a,o+c,l),t(r,s+a,o+c,s,o+c,h),t(r,s,o+c,s,o,h),t(r,s,o,s+a,o,l),r.closePath())}}var bl=(n,e,t)=>{n.moveTo(e,t)},El=(n,e,t)=>{n.moveTo(t,e)},Gs=(n,e,t)=>{n.lineTo(e,t)},zs=(n,e,t)=>{n.lineTo(t,e)},wl=Gd(0),au=Gd(1),zd=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},kd=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},Hd=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},Vd=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function Wd(n){return(e,t,i,r,s)=>ss(e,t,(o,a,c,l,h,f,u,m,x,M,d)=>{let{pxRound:p,points:v}=o,A,y;l.ori==0?(A=bl,y=zd):(A=El,y=kd);let R=It(v.width*wt,3),T=(v.size-v.width)/2*wt,g=It(T*2,3),w=new Path2D,O=new Path2D,{left:L,top:D,width:G,height:k}=e.bbox;wl(O,L-g,D-g,G+g*2,k+g*2);let I=W=>{if(c[W]!=null){let Y=p(f(a[W],l,M,m)),V=p(u(c[W],h,d,x));A(w,Y+T,V),y(w,Y,V,T,0,pl*2)}};if(s)s.forEach(I);else for(let W=i;W<=r;W++)I(W);return{stroke:R>0?w:null,fill:w,clip:O,flags:Os|Xf}})}function Xd(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var RM=Xd(Gs),CM=Xd(zs);function qd(n){let e=yt(n?.alignGaps,0);return(t,i,r,s)=>ss(t,i,(o,a,c,l,h,f,u,m,x,M,d)=>{[r,s]=_l(c,r,s);let p=o.pxRound,v=k=>p(f(k,l,M,m)),A=k=>p(u(k,h,d,x)),y,R;l.ori==0?(y=Gs,R=RM):(y=zs,R=CM);let T=l.dir*(l.ori==0?1:-1),g={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Os},w=g.stroke,O=!1;if(s-r>=M*4){let k=ue=>t.posToVal(ue,l.key,!0),I=null,W=null,Y,V,ce,$=v(a[T==1?r:s]),Q=v(a[r]),ne=v(a[s]),he=k(T==1?Q+1:ne-1);for(let ue=T==1?r:s;ue>=r&&ue<=s;ue+=T){let j=a[ue],_e=(T==1?j<he:j>he)?$:v(j),Ae=c[ue];_e==$?Ae!=null?(V=Ae,I==null?(y(w,_e,A(V)),Y=I=W=V):V<I?I=V:V>W&&(W=V)):Ae===null&&(O=!0):(I!=null&&R(w,$,A(I),A(W),A(Y),A(V)),Ae!=null?(V=Ae,y(w,_e,A(V)),I=W=Y=V):(I=W=null,Ae===null&&(O=!0)),$=_e,he=k($+T))}I!=null&&I!=W&&ce!=$&&R(w,$,A(I),A(W),A(Y),A(V))}else for(let k=T==1?r:s;k>=r&&k<=s;k+=T){let I=c[k];I===null?O=!0:I!=null&&y(w,v(a[k]),A(I))}let[D,G]=su(t,i);if(o.fill!=null||D!=0){let k=g.fill=new Path2D(w),I=o.fillTo(t,i,o.min,o.max,D),W=A(I),Y=v(a[r]),V=v(a[s]);T==-1&&([V,Y]=[Y,V]),y(k,V,W),y(k,Y,W)}if(!o.spanGaps){let k=[];O&&k.push(...ou(a,c,r,s,T,v,e)),g.gaps=k=o.gaps(t,i,r,s,k),g.clip=yl(k,l.ori,m,x,M,d)}return G!=0&&(g.band=G==2?[dr(t,i,r,s,w,-1),dr(t,i,r,s,w,1)]:dr(t,i,r,s,w,G)),g})}function PM(n){let e=yt(n.align,1),t=yt(n.ascDesc,!1),i=yt(n.alignGaps,0),r=yt(n.extend,!1);return(s,o,a,c)=>ss(s,o,(l,h,f,u,m,x,M,d,p,v,A)=>{[a,c]=_l(f,a,c);let y=l.pxRound,{left:R,width:T}=s.bbox,g=Q=>y(x(Q,u,v,d)),w=Q=>y(M(Q,m,A,p)),O=u.ori==0?Gs:zs,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Os},D=L.stroke,G=u.dir*(u.ori==0?1:-1),k=w(f[G==1?a:c]),I=g(h[G==1?a:c]),W=I,Y=I;r&&e==-1&&(Y=R,O(D,Y,k)),O(D,I,k);for(let Q=G==1?a:c;Q>=a&&Q<=c;Q+=G){let ne=f[Q];if(ne==null)continue;let he=g(h[Q]),ue=w(ne);e==1?O(D,he,k):O(D,W,ue),O(D,he,ue),k=ue,W=he}let V=W;r&&e==1&&(V=R+T,O(D,V,k));let[ce,$]=su(s,o);if(l.fill!=null||ce!=0){let Q=L.fill=new Path2D(D),ne=l.fillTo(s,o,l.min,l.max,ce),he=w(ne);O(Q,V,he),O(Q,Y,he)}if(!l.spanGaps){let Q=[];Q.push(...ou(h,f,a,c,G,g,i));let ne=l.width*wt/2,he=t||e==1?ne:-ne,ue=t||e==-1?-ne:ne;Q.forEach(j=>{j[0]+=he,j[1]+=ue}),L.gaps=Q=l.gaps(s,o,a,c,Q),L.clip=yl(Q,u.ori,d,p,v,A)}return $!=0&&(L.band=$==2?[dr(s,o,a,c,D,-1),dr(s,o,a,c,D,1)]:dr(s,o,a,c,D,$)),L})}function od(n,e,t,i,r,s,o=Nt){if(n.length>1){let a=null;for(let c=0,l=1/0;c<n.length;c++)if(e[c]!==void 0){if(a!=null){let h=yi(n[c]-n[a]);h<l&&(l=h,o=yi(t(n[c],i,r,s)-t(n[a],i,r,s)))}a=c}}return o}function LM(n){n=n||Yo;let e=yt(n.size,[.6,Nt,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=_t(r),o=1-e[0],a=yt(e[1],Nt),c=yt(e[2],1),l=yt(n.disp,Yo),h=yt(n.each,m=>{}),{fill:f,stroke:u}=l;return(m,x,M,d)=>ss(m,x,(p,v,A,y,R,T,g,w,O,L,D)=>{let G=p.pxRound,k=t,I=i*wt,W=a*wt,Y=c*wt,V,ce;y.ori==0?[V,ce]=s(m,x):[ce,V]=s(m,x);let $=y.dir*(y.ori==0?1:-1),Q=y.ori==0?wl:au,ne=y.ori==0?h:(Ce,Je,st,be,Dt,He,$e)=>{h(Ce,Je,st,Dt,be,$e,He)},he=yt(m.bands,eu).find(Ce=>Ce.series[0]==x),ue=he!=null?he.dir:0,j=p.fillTo(m,x,p.min,p.max,ue),me=G(g(j,R,D,O)),_e,Ae,ye,qe=L,rt=G(p.width*wt),Ve=!1,dt=null,ft=null,it=null,Xt=null;f!=null&&(rt==0||u!=null)&&(Ve=!0,dt=f.values(m,x,M,d),ft=new Map,new Set(dt).forEach(Ce=>{Ce!=null&&ft.set(Ce,new Path2D)}),rt>0&&(it=u.values(m,x,M,d),Xt=new Map,new Set(it).forEach(Ce=>{Ce!=null&&Xt.set(Ce,new Path2D)})));let{x0:Ut,size:fi}=l;if(Ut!=null&&fi!=null){k=1,v=Ut.values(m,x,M,d),Ut.unit==2&&(v=v.map(st=>m.posToVal(w+st*L,y.key,!0)));let Ce=fi.values(m,x,M,d);fi.unit==2?Ae=Ce[0]*L:Ae=T(Ce[0],y,L,w)-T(0,y,L,w),qe=od(v,A,T,y,L,w,qe),ye=qe-Ae+I}else qe=od(v,A,T,y,L,w,qe),ye=qe*o+I,Ae=qe-ye;ye<1&&(ye=0),rt>=Ae/2&&(rt=0),ye<5&&(G=md);let Pt=ye>0,wi=qe-ye-(Pt?rt:0);Ae=G(Hf(wi,Y,W)),_e=(k==0?Ae/2:k==$?0:Ae)-k*$*((k==0?I/2:0)+(Pt?rt/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},vi=Ve?null:new Path2D,jt=null;if(he!=null)jt=m.data[he.series[1]];else{let{y0:Ce,y1:Je}=l;Ce!=null&&Je!=null&&(A=Je.values(m,x,M,d),jt=Ce.values(m,x,M,d))}let ui=V*Ae,B=ce*Ae;for(let Ce=$==1?M:d;Ce>=M&&Ce<=d;Ce+=$){let Je=A[Ce];if(Je==null)continue;if(jt!=null){let X=jt[Ce]??0;if(Je-X==0)continue;me=g(X,R,D,O)}let st=y.distr!=2||l!=null?v[Ce]:Ce,be=T(st,y,L,w),Dt=g(yt(Je,j),R,D,O),He=G(be-_e),$e=G(Qi(Dt,me)),C=G(zn(Dt,me)),S=$e-C;if(Je!=null){let X=Je<0?B:ui,fe=Je<0?ui:B;Ve?(rt>0&&it[Ce]!=null&&Q(Xt.get(it[Ce]),He,C+pn(rt/2),Ae,Qi(0,S-rt),X,fe),dt[Ce]!=null&&Q(ft.get(dt[Ce]),He,C+pn(rt/2),Ae,Qi(0,S-rt),X,fe)):Q(vi,He,C+pn(rt/2),Ae,Qi(0,S-rt),X,fe),ne(m,x,Ce,He-rt/2,C,Ae+rt,S)}}return rt>0?Mt.stroke=Ve?Xt:vi:Ve||(Mt._fill=p.width==0?p._fill:p._stroke??p._fill,Mt.width=0),Mt.fill=Ve?ft:vi,Mt})}function DM(n,e){let t=yt(e?.alignGaps,0);return(i,r,s,o)=>ss(i,r,(a,c,l,h,f,u,m,x,M,d,p)=>{[s,o]=_l(l,s,o);let v=a.pxRound,A=V=>v(u(V,h,d,x)),y=V=>v(m(V,f,p,M)),R,T,g;h.ori==0?(R=bl,g=Gs,T=Hd):(R=El,g=zs,T=Vd);let w=h.dir*(h.ori==0?1:-1),O=A(c[w==1?s:o]),L=O,D=[],G=[];for(let V=w==1?s:o;V>=s&&V<=o;V+=w)if(l[V]!=null){let $=c[V],Q=A($);D.push(L=Q),G.push(y(l[V]))}let k={stroke:n(D,G,R,g,T,v),fill:null,clip:null,band:null,gaps:null,flags:Os},I=k.stroke,[W,Y]=su(i,r);if(a.fill!=null||W!=0){let V=k.fill=new Path2D(I),ce=a.fillTo(i,r,a.min,a.max,W),$=y(ce);g(V,L,$),g(V,O,$)}if(!a.spanGaps){let V=[];V.push(...ou(c,l,s,o,w,A,t)),k.gaps=V=a.gaps(i,r,s,o,V),k.clip=yl(V,h.ori,x,M,d,p)}return Y!=0&&(k.band=Y==2?[dr(i,r,s,o,I,-1),dr(i,r,s,o,I,1)]:dr(i,r,s,o,I,Y)),k})}function NM(n){return DM(IM,n)}function IM(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let c=Array(o),l=Array(o-1),h=Array(o-1),f=Array(o-1);for(let u=0;u<o-1;u++)h[u]=e[u+1]-e[u],f[u]=n[u+1]-n[u],l[u]=h[u]/f[u];c[0]=l[0];for(let u=1;u<o-1;u++)l[u]===0||l[u-1]===0||l[u-1]>0!=l[u]>0?c[u]=0:(c[u]=3*(f[u-1]+f[u])/((2*f[u]+f[u-1])/l[u-1]+(f[u]+2*f[u-1])/l[u]),isFinite(c[u])||(c[u]=0));c[o-1]=l[o-2];for(let u=0;u<o-1;u++)r(a,n[u]+f[u]/3,e[u]+c[u]*f[u]/3,n[u+1]-f[u]/3,e[u+1]-c[u+1]*f[u]/3,n[u+1],e[u+1])}return a}var qf=new Set;function ad(){for(let n of qf)n.syncRect(!0)}Bs&&(ns(pv,Ns,ad),ns(mv,Ns,ad,!0),ns(ml,Ns,()=>{oi.pxRatio=wt}));var UM=qd(),FM=Wd();function ld(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>Yf(s,o,e,t))}function OM(n,e){return n.map((t,i)=>i==0?{}:gi({},e,t))}function Yf(n,e,t,i){return gi({},e==0?t:i,n)}function Yd(n,e,t){return e==null?Us:[e,t]}var BM=Yd;function GM(n,e,t){return e==null?Us:gl(e,t,Qf,!0)}function Kd(n,e,t,i){return e==null?Us:vl(e,t,n.scales[i].log,!1)}var zM=Kd;function Zd(n,e,t,i){return e==null?Us:Jf(e,t,n.scales[i].log,!1)}var kM=Zd;function HM(n,e,t,i,r){let s=Qi(zh(n),zh(e)),o=e-n,a=Gn(r/i*o,t);do{let c=t[a],l=i*c/o;if(l>=r&&s+(c<5?Dr.get(c):0)<=17)return[c,l]}while(++a<t.length);return[0,0]}function cd(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Si((t=+r)*wt))+"px"),[n,e,t]}function VM(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=It(e[2]*wt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function oi(n,e,t){let i={mode:yt(n.mode,1)},r=i.mode;function s(_,b,P,N){let H=b.valToPct(_);return N+P*(b.dir==-1?1-H:H)}function o(_,b,P,N){let H=b.valToPct(_);return N+P*(b.dir==-1?H:1-H)}function a(_,b,P,N){return b.ori==0?s(_,b,P,N):o(_,b,P,N)}i.valToPosH=s,i.valToPosV=o;let c=!1;i.status=0;let l=i.root=An($_);if(n.id!=null&&(l.id=n.id),dn(l,n.class),n.title){let _=An(j_,l);_.textContent=n.title}let h=Bn("canvas"),f=i.ctx=h.getContext("2d"),u=An(ev,l);ns("click",u,_=>{_.target===x&&(Gt!=Ts||qt!=As)&&Ui.click(i,_)},!0);let m=i.under=An(tv,u);u.appendChild(h);let x=i.over=An(iv,u);n=Fs(n);let M=+yt(n.pxAlign,1),d=sd(M);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let p=n.ms||.001,v=i.series=r==1?ld(n.series||[],Qh,nd,!1):OM(n.series||[null],id),A=i.axes=ld(n.axes||[],Jh,ed,!0),y=i.scales={},R=i.bands=n.bands||[];R.forEach(_=>{_.fill=_t(_.fill||null),_.dir=yt(_.dir,-1)});let T=r==2?v[1].facets[0].scale:v[0].scale,g={axes:cr,series:mt},w=(n.drawOrder||["axes","series"]).map(_=>g[_]);function O(_){let b=_.distr==3?P=>hr(P>0?P:_.clamp(i,P,_.min,_.max,_.key)):_.distr==4?P=>If(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let N=b(P),{_min:H,_max:Z}=_,oe=Z-H;return(N-H)/oe}}function L(_){let b=y[_];if(b==null){let P=(n.scales||Yo)[_]||Yo;if(P.from!=null){L(P.from);let N=gi({},y[P.from],P,{key:_});N.valToPct=O(N),y[_]=N}else{b=y[_]=gi({},_==T?Od:wM,P),b.key=_;let N=b.time,H=b.range,Z=Lr(H);if((_!=T||r==2&&!N)&&(Z&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?Oh:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?Oh:{mode:1,hard:H[1],soft:H[1]}},Z=!1),!Z&&Sl(H))){let oe=H;H=(de,Me,Ne)=>Me==null?Us:gl(Me,Ne,oe)}b.range=_t(H||(N?BM:_==T?b.distr==3?zM:b.distr==4?kM:Yd:b.distr==3?Kd:b.distr==4?Zd:GM)),b.auto=_t(Z?!1:b.auto),b.clamp=_t(b.clamp||EM),b._min=b._max=null,b.valToPct=O(b)}}}L("x"),L("y"),r==1&&v.forEach(_=>{L(_.scale)}),A.forEach(_=>{L(_.scale)});for(let _ in n.scales)L(_);let D=y[T],G=D.distr,k,I;D.ori==0?(dn(l,J_),k=s,I=o):(dn(l,Q_),k=o,I=s);let W={};for(let _ in y){let b=y[_];(b.min!=null||b.max!=null)&&(W[_]={min:b.min,max:b.max},b.min=b.max=null)}let Y=n.tzDate||(_=>new Date(Si(_/p))),V=n.fmtDate||tu,ce=p==1?Jv(Y):eM(Y),$=Kh(Y,Yh(p==1?$v:jv,V)),Q=$h(Y,Zh(iM,V)),ne=[],he=i.legend=gi({},sM,n.legend),ue=i.cursor=gi({},uM,{drag:{y:r==2}},n.cursor),j=he.show,me=ue.show,_e=he.markers;he.idxs=ne,_e.width=_t(_e.width),_e.dash=_t(_e.dash),_e.stroke=_t(_e.stroke),_e.fill=_t(_e.fill);let Ae,ye,qe,rt=[],Ve=[],dt,ft=!1,it={};if(he.live){let _=v[1]?v[1].values:null;ft=_!=null,dt=ft?_(i,1,0):{_:0};for(let b in dt)it[b]=Zf}if(j)if(Ae=Bn("table",lv,l),qe=Bn("tbody",null,Ae),he.mount(i,Ae),ft){ye=Bn("thead",null,Ae,qe);let _=Bn("tr",null,ye);Bn("th",null,_);for(var Xt in dt)Bn("th",Eh,_).textContent=Xt}else dn(Ae,fv),he.live&&dn(Ae,cv);let Ut={show:!0},fi={show:!1};function Pt(_,b){if(b==0&&(ft||!he.live||r==2))return Us;let P=[],N=Bn("tr",uv,qe,qe.childNodes[b]);dn(N,_.class),_.show||dn(N,is);let H=Bn("th",null,N);if(_e.show){let de=An(hv,H);if(b>0){let Me=_e.width(i,b);Me&&(de.style.border=Me+"px "+_e.dash(i,b)+" "+_e.stroke(i,b)),de.style.background=_e.fill(i,b)}}let Z=An(Eh,H);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,b>0&&(_e.show||(Z.style.color=_.width>0?_e.stroke(i,b):_e.fill(i,b)),Mt("click",H,de=>{if(ue._lock)return;je(de);let Me=v.indexOf(_);if((de.ctrlKey||de.metaKey)!=he.isolate){let Ne=v.some((Ue,Oe)=>Oe>0&&Oe!=Me&&Ue.show);v.forEach((Ue,Oe)=>{Oe>0&&Zn(Oe,Ne?Oe==Me?Ut:fi:Ut,!0,mi.setSeries)})}else Zn(Me,{show:!_.show},!0,mi.setSeries)},!1),et&&Mt(Rh,H,de=>{ue._lock||(je(de),Zn(v.indexOf(_),Cs,!0,mi.setSeries))},!1));for(var oe in dt){let de=Bn("td",dv,N);de.textContent="--",P.push(de)}return[N,P]}let wi=new Map;function Mt(_,b,P,N=!0){let H=wi.get(b)||{},Z=ue.bind[_](i,b,P,N);Z&&(ns(_,b,H[_]=Z),wi.set(b,H))}function vi(_,b,P){let N=wi.get(b)||{};for(let H in N)(_==null||H==_)&&(kf(H,b,N[H]),delete N[H]);_==null&&wi.delete(b)}let jt=0,ui=0,B=0,Ce=0,Je=0,st=0,be=Je,Dt=st,He=B,$e=Ce,C=0,S=0,X=0,fe=0;i.bbox={};let se=!1,xe=!1,ve=!1,ee=!1,ie=!1,pe=!1;function F(_,b,P){(P||_!=i.width||b!=i.height)&&re(_,b),ut(!1),ve=!0,xe=!0,Gi()}function re(_,b){i.width=jt=B=_,i.height=ui=Ce=b,Je=st=0,Se(),We();let P=i.bbox;C=P.left=es(Je*wt,.5),S=P.top=es(st*wt,.5),X=P.width=es(B*wt,.5),fe=P.height=es(Ce*wt,.5)}let te=3;function Ee(){let _=!1,b=0;for(;!_;){b++;let P=bs(b),N=Kn(b);_=b==te||P&&N,_||(re(i.width,i.height),xe=!0)}}function ge({width:_,height:b}){F(_,b)}i.setSize=ge;function Se(){let _=!1,b=!1,P=!1,N=!1;A.forEach((H,Z)=>{if(H.show&&H._show){let{side:oe,_size:de}=H,Me=oe%2,Ne=H.label!=null?H.labelSize:0,Ue=de+Ne;Ue>0&&(Me?(B-=Ue,oe==3?(Je+=Ue,N=!0):P=!0):(Ce-=Ue,oe==0?(st+=Ue,_=!0):b=!0))}}),qn[0]=_,qn[1]=P,qn[2]=b,qn[3]=N,B-=Un[1]+Un[3],Je+=Un[3],Ce-=Un[2]+Un[0],st+=Un[0]}function We(){let _=Je+B,b=st+Ce,P=Je,N=st;function H(Z,oe){switch(Z){case 1:return _+=oe,_-oe;case 2:return b+=oe,b-oe;case 3:return P-=oe,P+oe;case 0:return N-=oe,N+oe}}A.forEach((Z,oe)=>{if(Z.show&&Z._show){let de=Z.side;Z._pos=H(de,Z._size),Z.label!=null&&(Z._lpos=H(de,Z.labelSize))}})}if(ue.dataIdx==null){let _=ue.hover,b=_.skip=new Set(_.skip??[]);b.add(void 0);let P=_.prox=_t(_.prox),N=_.bias??=0;ue.dataIdx=(H,Z,oe,de)=>{if(Z==0)return oe;let Me=oe,Ne=P(H,Z,oe,de)??Nt,Ue=Ne>=0&&Ne<Nt,Oe=D.ori==0?B:Ce,nt=ue.left,Et=e[0],St=e[Z];if(b.has(St[oe])){Me=null;let gt=null,Qe=null,Ye;if(N==0||N==-1)for(Ye=oe;gt==null&&Ye-- >0;)b.has(St[Ye])||(gt=Ye);if(N==0||N==1)for(Ye=oe;Qe==null&&Ye++<St.length;)b.has(St[Ye])||(Qe=Ye);if(gt!=null||Qe!=null)if(Ue){let kt=gt==null?-1/0:k(Et[gt],D,Oe,0),ii=Qe==null?1/0:k(Et[Qe],D,Oe,0),Ci=nt-kt,Lt=ii-nt;Ci<=Lt?Ci<=Ne&&(Me=gt):Lt<=Ne&&(Me=Qe)}else Me=Qe==null?gt:gt==null?Qe:oe-gt<=Qe-oe?gt:Qe}else Ue&&yi(nt-k(Et[oe],D,Oe,0))>Ne&&(Me=null);return Me}}let je=_=>{ue.event=_};ue.idxs=ne,ue._lock=!1;let le=ue.points;le.show=_t(le.show),le.size=_t(le.size),le.stroke=_t(le.stroke),le.width=_t(le.width),le.fill=_t(le.fill);let Be=i.focus=gi({},n.focus||{alpha:.3},ue.focus),et=Be.prox>=0,Re=et&&le.one,lt=[],Bt=[],Yi=[];function Io(_,b){let P=le.show(i,b);if(P instanceof HTMLElement)return dn(P,av),dn(P,_.class),jn(P,-10,-10,B,Ce),x.insertBefore(P,lt[b]),P}function Ms(_,b){if(r==1||b>0){let P=r==1&&y[_.scale].time,N=_.value;_.value=P?Vh(N)?$h(Y,Zh(N,V)):N||Q:N||SM,_.label=_.label||(P?dM:hM)}if(Re||b>0){_.width=_.width==null?1:_.width,_.paths=_.paths||UM||wv,_.fillTo=_t(_.fillTo||TM),_.pxAlign=+yt(_.pxAlign,M),_.pxRound=sd(_.pxAlign),_.stroke=_t(_.stroke||null),_.fill=_t(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=yM(Qi(1,_.width),1),N=_.points=gi({},{size:P,width:Qi(1,P*.2),stroke:_.stroke,space:P*2,paths:FM,_stroke:null,_fill:null},_.points);N.show=_t(N.show),N.filter=_t(N.filter),N.fill=_t(N.fill),N.stroke=_t(N.stroke),N.paths=_t(N.paths),N.pxAlign=_.pxAlign}if(j){let P=Pt(_,b);rt.splice(b,0,P[0]),Ve.splice(b,0,P[1]),he.values.push(null)}if(me){ne.splice(b,0,null);let P=null;Re?b==0&&(P=Io(_,b)):b>0&&(P=Io(_,b)),lt.splice(b,0,P),Bt.splice(b,0,0),Yi.splice(b,0,0)}Ri("addSeries",b)}function Sf(_,b){b=b??v.length,_=r==1?Yf(_,b,Qh,nd):Yf(_,b,{},id),v.splice(b,0,_),Ms(v[b],b)}i.addSeries=Sf;function al(_){if(v.splice(_,1),j){he.values.splice(_,1),Ve.splice(_,1);let b=rt.splice(_,1)[0];vi(null,b.firstChild),b.remove()}me&&(ne.splice(_,1),lt.splice(_,1)[0].remove(),Bt.splice(_,1),Yi.splice(_,1)),Ri("delSeries",_)}i.delSeries=al;let qn=[!1,!1,!1,!1];function or(_,b){if(_._show=_.show,_.show){let P=_.side%2,N=y[_.scale];N==null&&(_.scale=P?v[1].scale:T,N=y[_.scale]);let H=N.time;_.size=_t(_.size),_.space=_t(_.space),_.rotate=_t(_.rotate),Lr(_.incrs)&&_.incrs.forEach(oe=>{!Dr.has(oe)&&Dr.set(oe,_d(oe))}),_.incrs=_t(_.incrs||(N.distr==2?Yv:H?p==1?Zv:Qv:ts)),_.splits=_t(_.splits||(H&&N.distr==1?ce:N.distr==3?Vf:N.distr==4?gM:mM)),_.stroke=_t(_.stroke),_.grid.stroke=_t(_.grid.stroke),_.ticks.stroke=_t(_.ticks.stroke),_.border.stroke=_t(_.border.stroke);let Z=_.values;_.values=Lr(Z)&&!Lr(Z[0])?_t(Z):H?Lr(Z)?Kh(Y,Yh(Z,V)):Vh(Z)?tM(Y,Z):Z||$:Z||pM,_.filter=_t(_.filter||(N.distr>=3&&N.log==10?vM:N.distr==3&&N.log==2?MM:gd)),_.font=cd(_.font),_.labelFont=cd(_.labelFont),_._size=_.size(i,null,b,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(qn[b]=!0,_._el=An(nv,u))}}function ar(_,b,P,N){let[H,Z,oe,de]=P,Me=b%2,Ne=0;return Me==0&&(de||Z)&&(Ne=b==0&&!H||b==2&&!oe?Si(Jh.size/3):0),Me==1&&(H||oe)&&(Ne=b==1&&!Z||b==3&&!de?Si(ed.size/2):0),Ne}let Uo=i.padding=(n.padding||[ar,ar,ar,ar]).map(_=>_t(yt(_,ar))),Un=i._padding=Uo.map((_,b)=>_(i,b,qn,0)),ei,ri=null,si=null,Yn=r==1?v[0].idxs:null,cn=null,wr=!1;function Fo(_,b){if(e=_??[],i.data=i._data=e,r==2){ei=0;for(let P=1;P<v.length;P++)ei+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),cn=e[0],ei=cn.length;let P=e;if(G==2){P=e.slice();let N=P[0]=Array(ei);for(let H=0;H<ei;H++)N[H]=H}i._data=e=P}if(ut(!0),Ri("setData"),G==2&&(ve=!0),b!==!1){let P=D;P.auto(i,wr)?Oo():Rr(T,P.min,P.max),ee=ee||ue.left>=0,pe=!0,Gi()}}i.setData=Fo;function Oo(){wr=!0;let _,b;r==1&&(ei>0?(ri=Yn[0]=0,si=Yn[1]=ei-1,_=e[0][ri],b=e[0][si],G==2?(_=ri,b=si):_==b&&(G==3?[_,b]=vl(_,_,D.log,!1):G==4?[_,b]=Jf(_,_,D.log,!1):D.time?b=_+Si(86400/p):[_,b]=gl(_,b,Qf,!0))):(ri=Yn[0]=_=null,si=Yn[1]=b=null)),Rr(T,_,b)}let Ss,Tr,ys,E,z,J,q,K,we,Pe;function Te(_,b,P,N,H,Z){_??=Th,P??=eu,N??="butt",H??=Th,Z??="round",_!=Ss&&(f.strokeStyle=Ss=_),H!=Tr&&(f.fillStyle=Tr=H),b!=ys&&(f.lineWidth=ys=b),Z!=z&&(f.lineJoin=z=Z),N!=J&&(f.lineCap=J=N),P!=E&&f.setLineDash(E=P)}function De(_,b,P,N){b!=Tr&&(f.fillStyle=Tr=b),_!=q&&(f.font=q=_),P!=K&&(f.textAlign=K=P),N!=we&&(f.textBaseline=we=N)}function ze(_,b,P,N,H=0){if(N.length>0&&_.auto(i,wr)&&(b==null||b.min==null)){let Z=yt(ri,0),oe=yt(si,N.length-1),de=P.min==null?vv(N,Z,oe,H,_.distr==3):[P.min,P.max];_.min=zn(_.min,P.min=de[0]),_.max=Qi(_.max,P.max=de[1])}}let tt={min:null,max:null};function pt(){for(let N in y){let H=y[N];W[N]==null&&(H.min==null||W[T]!=null&&H.auto(i,wr))&&(W[N]=tt)}for(let N in y){let H=y[N];W[N]==null&&H.from!=null&&W[H.from]!=null&&(W[N]=tt)}W[T]!=null&&ut(!0);let _={};for(let N in W){let H=W[N];if(H!=null){let Z=_[N]=Fs(y[N],Rv);if(H.min!=null)gi(Z,H);else if(N!=T||r==2)if(ei==0&&Z.from==null){let oe=Z.range(i,null,null,N);Z.min=oe[0],Z.max=oe[1]}else Z.min=Nt,Z.max=-Nt}}if(ei>0){v.forEach((N,H)=>{if(r==1){let Z=N.scale,oe=W[Z];if(oe==null)return;let de=_[Z];if(H==0){let Me=de.range(i,de.min,de.max,Z);de.min=Me[0],de.max=Me[1],ri=Gn(de.min,e[0]),si=Gn(de.max,e[0]),si-ri>1&&(e[0][ri]<de.min&&ri++,e[0][si]>de.max&&si--),N.min=cn[ri],N.max=cn[si]}else N.show&&N.auto&&ze(de,oe,N,e[H],N.sorted);N.idxs[0]=ri,N.idxs[1]=si}else if(H>0&&N.show&&N.auto){let[Z,oe]=N.facets,de=Z.scale,Me=oe.scale,[Ne,Ue]=e[H],Oe=_[de],nt=_[Me];Oe!=null&&ze(Oe,W[de],Z,Ne,Z.sorted),nt!=null&&ze(nt,W[Me],oe,Ue,oe.sorted),N.min=oe.min,N.max=oe.max}});for(let N in _){let H=_[N],Z=W[N];if(H.from==null&&(Z==null||Z.min==null)){let oe=H.range(i,H.min==Nt?null:H.min,H.max==-Nt?null:H.max,N);H.min=oe[0],H.max=oe[1]}}}for(let N in _){let H=_[N];if(H.from!=null){let Z=_[H.from];if(Z.min==null)H.min=H.max=null;else{let oe=H.range(i,Z.min,Z.max,N);H.min=oe[0],H.max=oe[1]}}}let b={},P=!1;for(let N in _){let H=_[N],Z=y[N];if(Z.min!=H.min||Z.max!=H.max){Z.min=H.min,Z.max=H.max;let oe=Z.distr;Z._min=oe==3?hr(Z.min):oe==4?If(Z.min,Z.asinh):oe==100?Z.fwd(Z.min):Z.min,Z._max=oe==3?hr(Z.max):oe==4?If(Z.max,Z.asinh):oe==100?Z.fwd(Z.max):Z.max,b[N]=P=!0}}if(P){v.forEach((N,H)=>{r==2?H>0&&b.y&&(N._paths=null):b[N.scale]&&(N._paths=null)});for(let N in b)ve=!0,Ri("setScale",N);me&&ue.left>=0&&(ee=pe=!0)}for(let N in W)W[N]=null}function Ge(_){let b=Hf(ri-1,0,ei-1),P=Hf(si+1,0,ei-1);for(;_[b]==null&&b>0;)b--;for(;_[P]==null&&P<ei-1;)P++;return[b,P]}function mt(){if(ei>0){let _=v.some(b=>b._focus)&&Pe!=Be.alpha;_&&(f.globalAlpha=Pe=Be.alpha),v.forEach((b,P)=>{if(P>0&&b.show&&($t(P,!1),$t(P,!0),b._paths==null)){let N=Pe;Pe!=b.alpha&&(f.globalAlpha=Pe=b.alpha);let H=r==2?[0,e[P][0].length-1]:Ge(e[P]);b._paths=b.paths(i,P,H[0],H[1]),Pe!=N&&(f.globalAlpha=Pe=N)}}),v.forEach((b,P)=>{if(P>0&&b.show){let N=Pe;Pe!=b.alpha&&(f.globalAlpha=Pe=b.alpha),b._paths!=null&&At(P,!1);{let H=b._paths!=null?b._paths.gaps:null,Z=b.points.show(i,P,ri,si,H),oe=b.points.filter(i,P,Z,H);(Z||oe)&&(b.points._paths=b.points.paths(i,P,ri,si,oe),At(P,!0))}Pe!=N&&(f.globalAlpha=Pe=N),Ri("drawSeries",P)}}),_&&(f.globalAlpha=Pe=1)}}function $t(_,b){let P=b?v[_].points:v[_];P._stroke=P.stroke(i,_),P._fill=P.fill(i,_)}function At(_,b){let P=b?v[_].points:v[_],{stroke:N,fill:H,clip:Z,flags:oe,_stroke:de=P._stroke,_fill:Me=P._fill,_width:Ne=P.width}=P._paths;Ne=It(Ne*wt,3);let Ue=null,Oe=Ne%2/2;b&&Me==null&&(Me=Ne>0?"#fff":de);let nt=P.pxAlign==1&&Oe>0;if(nt&&f.translate(Oe,Oe),!b){let Et=C-Ne/2,St=S-Ne/2,gt=X+Ne,Qe=fe+Ne;Ue=new Path2D,Ue.rect(Et,St,gt,Qe)}b?Fe(de,Ne,P.dash,P.cap,Me,N,H,oe,Z):Rt(_,de,Ne,P.dash,P.cap,Me,N,H,oe,Ue,Z),nt&&f.translate(-Oe,-Oe)}function Rt(_,b,P,N,H,Z,oe,de,Me,Ne,Ue){let Oe=!1;Me!=0&&R.forEach((nt,Et)=>{if(nt.series[0]==_){let St=v[nt.series[1]],gt=e[nt.series[1]],Qe=(St._paths||Yo).band;Lr(Qe)&&(Qe=nt.dir==1?Qe[0]:Qe[1]);let Ye,kt=null;St.show&&Qe&&Sv(gt,ri,si)?(kt=nt.fill(i,Et)||Z,Ye=St._paths.clip):Qe=null,Fe(b,P,N,H,kt,oe,de,Me,Ne,Ue,Ye,Qe),Oe=!0}}),Oe||Fe(b,P,N,H,Z,oe,de,Me,Ne,Ue)}let Mi=Os|Xf;function Fe(_,b,P,N,H,Z,oe,de,Me,Ne,Ue,Oe){Te(_,b,P,N,H),(Me||Ne||Oe)&&(f.save(),Me&&f.clip(Me),Ne&&f.clip(Ne)),Oe?(de&Mi)==Mi?(f.clip(Oe),Ue&&f.clip(Ue),xt(H,oe),hi(_,Z,b)):de&Xf?(xt(H,oe),f.clip(Oe),hi(_,Z,b)):de&Os&&(f.save(),f.clip(Oe),Ue&&f.clip(Ue),xt(H,oe),f.restore(),hi(_,Z,b)):(xt(H,oe),hi(_,Z,b)),(Me||Ne||Oe)&&f.restore()}function hi(_,b,P){P>0&&(b instanceof Map?b.forEach((N,H)=>{f.strokeStyle=Ss=H,f.stroke(N)}):b!=null&&_&&f.stroke(b))}function xt(_,b){b instanceof Map?b.forEach((P,N)=>{f.fillStyle=Tr=N,f.fill(P)}):b!=null&&_&&f.fill(b)}function lr(_,b,P,N){let H=A[_],Z;if(N<=0)Z=[0,0];else{let oe=H._space=H.space(i,_,b,P,N),de=H._incrs=H.incrs(i,_,b,P,N,oe);Z=HM(b,P,de,N,oe)}return H._found=Z}function di(_,b,P,N,H,Z,oe,de,Me,Ne){let Ue=oe%2/2;M==1&&f.translate(Ue,Ue),Te(de,oe,Me,Ne,de),f.beginPath();let Oe,nt,Et,St,gt=H+(N==0||N==3?-Z:Z);P==0?(nt=H,St=gt):(Oe=H,Et=gt);for(let Qe=0;Qe<_.length;Qe++)b[Qe]!=null&&(P==0?Oe=Et=_[Qe]:nt=St=_[Qe],f.moveTo(Oe,nt),f.lineTo(Et,St));f.stroke(),M==1&&f.translate(-Ue,-Ue)}function bs(_){let b=!0;return A.forEach((P,N)=>{if(!P.show)return;let H=y[P.scale];if(H.min==null){P._show&&(b=!1,P._show=!1,ut(!1));return}else P._show||(b=!1,P._show=!0,ut(!1));let Z=P.side,oe=Z%2,{min:de,max:Me}=H,[Ne,Ue]=lr(N,de,Me,oe==0?B:Ce);if(Ue==0)return;let Oe=H.distr==2,nt=P._splits=P.splits(i,N,de,Me,Ne,Ue,Oe),Et=H.distr==2?nt.map(Ye=>cn[Ye]):nt,St=H.distr==2?cn[nt[1]]-cn[nt[0]]:Ne,gt=P._values=P.values(i,P.filter(i,Et,N,Ue,St),N,Ue,St);P._rotate=Z==2?P.rotate(i,gt,N,Ue):0;let Qe=P._size;P._size=Rn(P.size(i,gt,N,_)),Qe!=null&&P._size!=Qe&&(b=!1)}),b}function Kn(_){let b=!0;return Uo.forEach((P,N)=>{let H=P(i,N,qn,_);H!=Un[N]&&(b=!1),Un[N]=H}),b}function cr(){for(let _=0;_<A.length;_++){let b=A[_];if(!b.show||!b._show)continue;let P=b.side,N=P%2,H,Z,oe=b.stroke(i,_),de=P==0||P==3?-1:1,[Me,Ne]=b._found;if(b.label!=null){let $i=b.labelGap*de,hn=Si((b._lpos+$i)*wt);De(b.labelFont[0],oe,"center",P==2?"top":wh),f.save(),N==1?(H=Z=0,f.translate(hn,Si(S+fe/2)),f.rotate((P==3?-pl:pl)/2)):(H=Si(C+X/2),Z=hn);let Jr=pd(b.label)?b.label(i,_,Me,Ne):b.label;f.fillText(Jr,H,Z),f.restore()}if(Ne==0)continue;let Ue=y[b.scale],Oe=N==0?X:fe,nt=N==0?C:S,Et=b._splits,St=Ue.distr==2?Et.map($i=>cn[$i]):Et,gt=Ue.distr==2?cn[Et[1]]-cn[Et[0]]:Me,Qe=b.ticks,Ye=b.border,kt=Qe.show?Qe.size:0,ii=Si(kt*wt),Ci=Si((b.alignTo==2?b._size-kt-b.gap:b.gap)*wt),Lt=b._rotate*-pl/180,ni=d(b._pos*wt),fn=(ii+Ci)*de,Zi=ni+fn;Z=N==0?Zi:0,H=N==1?Zi:0;let wn=b.font[0],Fn=b.align==1?Ls:b.align==2?Lf:Lt>0?Ls:Lt<0?Lf:N==0?"center":P==3?Lf:Ls,Jn=Lt||N==1?"middle":P==2?"top":wh;De(wn,oe,Fn,Jn);let un=b.font[1]*b.lineGap,Tn=Et.map($i=>d(a($i,Ue,Oe,nt))),On=b._values;for(let $i=0;$i<On.length;$i++){let hn=On[$i];if(hn!=null){N==0?H=Tn[$i]:Z=Tn[$i],hn=""+hn;let Jr=hn.indexOf(`
`)==-1?[hn]:hn.split(/\n/gm);for(let Ji=0;Ji<Jr.length;Ji++){let Sh=Jr[Ji];Lt?(f.save(),f.translate(H,Z+Ji*un),f.rotate(Lt),f.fillText(Sh,0,0),f.restore()):f.fillText(Sh,H,Z+Ji*un)}}}Qe.show&&di(Tn,Qe.filter(i,St,_,Ne,gt),N,P,ni,ii,It(Qe.width*wt,3),Qe.stroke(i,_),Qe.dash,Qe.cap);let Qn=b.grid;Qn.show&&di(Tn,Qn.filter(i,St,_,Ne,gt),N,N==0?2:1,N==0?S:C,N==0?fe:X,It(Qn.width*wt,3),Qn.stroke(i,_),Qn.dash,Qn.cap),Ye.show&&di([ni],[1],N==0?1:0,N==0?1:2,N==1?S:C,N==1?fe:X,It(Ye.width*wt,3),Ye.stroke(i,_),Ye.dash,Ye.cap)}Ri("drawAxes")}function ut(_){v.forEach((b,P)=>{P>0&&(b._paths=null,_&&(r==1?(b.min=null,b.max=null):b.facets.forEach(N=>{N.min=null,N.max=null})))})}let ti=!1,Ki=!1,Ct=[];function pi(){Ki=!1;for(let _=0;_<Ct.length;_++)Ri(...Ct[_]);Ct.length=0}function Gi(){ti||(Uv(nh),ti=!0)}function ll(_,b=!1){ti=!0,Ki=b,_(i),nh(),b&&Ct.length>0&&queueMicrotask(pi)}i.batch=ll;function nh(){if(se&&(pt(),se=!1),ve&&(Ee(),ve=!1),xe){if(Vt(m,Ls,Je),Vt(m,"top",st),Vt(m,Vo,B),Vt(m,Wo,Ce),Vt(x,Ls,Je),Vt(x,"top",st),Vt(x,Vo,B),Vt(x,Wo,Ce),Vt(u,Vo,jt),Vt(u,Wo,ui),h.width=Si(jt*wt),h.height=Si(ui*wt),A.forEach(({_el:_,_show:b,_size:P,_pos:N,side:H})=>{if(_!=null)if(b){let Z=H===3||H===0?P:0,oe=H%2==1;Vt(_,oe?"left":"top",N-Z),Vt(_,oe?"width":"height",P),Vt(_,oe?"top":"left",oe?st:Je),Vt(_,oe?"height":"width",oe?Ce:B),zf(_,is)}else dn(_,is)}),Ss=Tr=ys=z=J=q=K=we=E=null,Pe=1,zo(!0),Je!=be||st!=Dt||B!=He||Ce!=$e){ut(!1);let _=B/He,b=Ce/$e;if(me&&!ee&&ue.left>=0){ue.left*=_,ue.top*=b,Es&&jn(Es,Si(ue.left),0,B,Ce),ws&&jn(ws,0,Si(ue.top),B,Ce);for(let P=0;P<lt.length;P++){let N=lt[P];N!=null&&(Bt[P]*=_,Yi[P]*=b,jn(N,Rn(Bt[P]),Rn(Yi[P]),B,Ce))}}if(zt.show&&!ie&&zt.left>=0&&zt.width>0){zt.left*=_,zt.width*=_,zt.top*=b,zt.height*=b;for(let P in Af)Vt(Rs,P,zt[P])}be=Je,Dt=st,He=B,$e=Ce}Ri("setSize"),xe=!1}jt>0&&ui>0&&(f.clearRect(0,0,h.width,h.height),Ri("drawClear"),w.forEach(_=>_()),Ri("draw")),zt.show&&ie&&(cl(zt),ie=!1),me&&ee&&($r(null,!0,!1),ee=!1),he.show&&he.live&&pe&&(wf(),pe=!1),c||(c=!0,i.status=1,Ri("ready")),wr=!1,ti=!1}i.redraw=(_,b)=>{ve=b||!1,_!==!1?Rr(T,D.min,D.max):Gi()};function yf(_,b){let P=y[_];if(P.from==null){if(ei==0){let N=P.range(i,b.min,b.max,_);b.min=N[0],b.max=N[1]}if(b.min>b.max){let N=b.min;b.min=b.max,b.max=N}if(ei>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;_==T&&P.distr==2&&ei>0&&(b.min=Gn(b.min,e[0]),b.max=Gn(b.max,e[0]),b.min==b.max&&b.max++),W[_]=b,se=!0,Gi()}}i.setScale=yf;let bf,Ef,Es,ws,rh,sh,Ts,As,oh,ah,Gt,qt,Ar=!1,Ui=ue.drag,Ti=Ui.x,Ai=Ui.y;me&&(ue.x&&(bf=An(sv,x)),ue.y&&(Ef=An(ov,x)),D.ori==0?(Es=bf,ws=Ef):(Es=Ef,ws=bf),Gt=ue.left,qt=ue.top);let zt=i.select=gi({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Rs=zt.show?An(rv,zt.over?x:m):null;function cl(_,b){if(zt.show){for(let P in _)zt[P]=_[P],P in Af&&Vt(Rs,P,_[P]);b!==!1&&Ri("setSelect")}}i.setSelect=cl;function F_(_){if(v[_].show)j&&zf(rt[_],is);else if(j&&dn(rt[_],is),me){let P=Re?lt[0]:lt[_];P!=null&&jn(P,-10,-10,B,Ce)}}function Rr(_,b,P){yf(_,{min:b,max:P})}function Zn(_,b,P,N){b.focus!=null&&k_(_),b.show!=null&&v.forEach((H,Z)=>{Z>0&&(_==Z||_==null)&&(H.show=b.show,F_(Z),r==2?(Rr(H.facets[0].scale,null,null),Rr(H.facets[1].scale,null,null)):Rr(H.scale,null,null),Gi())}),P!==!1&&Ri("setSeries",_,b),N&&ko("setSeries",i,_,b)}i.setSeries=Zn;function O_(_,b){gi(R[_],b)}function B_(_,b){_.fill=_t(_.fill||null),_.dir=yt(_.dir,-1),b=b??R.length,R.splice(b,0,_)}function G_(_){_==null?R.length=0:R.splice(_,1)}i.addBand=B_,i.setBand=O_,i.delBand=G_;function z_(_,b){v[_].alpha=b,me&&lt[_]!=null&&(lt[_].style.opacity=b),j&&rt[_]&&(rt[_].style.opacity=b)}let fr,Cr,Zr,Cs={focus:!0};function k_(_){if(_!=Zr){let b=_==null,P=Be.alpha!=1;v.forEach((N,H)=>{if(r==1||H>0){let Z=b||H==0||H==_;N._focus=b?null:Z,P&&z_(H,Z?1:Be.alpha)}}),Zr=_,P&&Gi()}}j&&et&&Mt(Ch,Ae,_=>{ue._lock||(je(_),Zr!=null&&Zn(null,Cs,!0,mi.setSeries))});function $n(_,b,P){let N=y[b];P&&(_=_/wt-(N.ori==1?st:Je));let H=B;N.ori==1&&(H=Ce,_=H-_),N.dir==-1&&(_=H-_);let Z=N._min,oe=N._max,de=_/H,Me=Z+(oe-Z)*de,Ne=N.distr;return Ne==3?Is(10,Me):Ne==4?bv(Me,N.asinh):Ne==100?N.bwd(Me):Me}function H_(_,b){let P=$n(_,T,b);return Gn(P,e[0],ri,si)}i.valToIdx=_=>Gn(_,e[0]),i.posToIdx=H_,i.posToVal=$n,i.valToPos=(_,b,P)=>y[b].ori==0?s(_,y[b],P?X:B,P?C:0):o(_,y[b],P?fe:Ce,P?S:0),i.setCursor=(_,b,P)=>{Gt=_.left,qt=_.top,$r(null,b,P)};function lh(_,b){Vt(Rs,Ls,zt.left=_),Vt(Rs,Vo,zt.width=b)}function ch(_,b){Vt(Rs,"top",zt.top=_),Vt(Rs,Wo,zt.height=b)}let Bo=D.ori==0?lh:ch,Go=D.ori==1?lh:ch;function V_(){if(j&&he.live)for(let _=r==2?1:0;_<v.length;_++){if(_==0&&ft)continue;let b=he.values[_],P=0;for(let N in b)Ve[_][P++].firstChild.nodeValue=b[N]}}function wf(_,b){if(_!=null&&(_.idxs?_.idxs.forEach((P,N)=>{ne[N]=P}):Av(_.idx)||ne.fill(_.idx),he.idx=ne[0]),j&&he.live){for(let P=0;P<v.length;P++)(P>0||r==1&&!ft)&&W_(P,ne[P]);V_()}pe=!1,b!==!1&&Ri("setLegend")}i.setLegend=wf;function W_(_,b){let P=v[_],N=_==0&&G==2?cn:e[_],H;ft?H=P.values(i,_,b)??it:(H=P.value(i,b==null?null:N[b],_,b),H=H==null?it:{_:H}),he.values[_]=H}function $r(_,b,P){oh=Gt,ah=qt,[Gt,qt]=ue.move(i,Gt,qt),ue.left=Gt,ue.top=qt,me&&(Es&&jn(Es,Si(Gt),0,B,Ce),ws&&jn(ws,0,Si(qt),B,Ce));let N,H=ri>si;fr=Nt,Cr=null;let Z=D.ori==0?B:Ce,oe=D.ori==1?B:Ce;if(Gt<0||ei==0||H){N=ue.idx=null;for(let de=0;de<v.length;de++){let Me=lt[de];Me!=null&&jn(Me,-10,-10,B,Ce)}et&&Zn(null,Cs,!0,_==null&&mi.setSeries),he.live&&(ne.fill(N),pe=!0)}else{let de,Me,Ne;r==1&&(de=D.ori==0?Gt:qt,Me=$n(de,T),N=ue.idx=Gn(Me,e[0],ri,si),Ne=k(e[0][N],D,Z,0));let Ue=-10,Oe=-10,nt=0,Et=0,St=!0,gt="",Qe="";for(let Ye=r==2?1:0;Ye<v.length;Ye++){let kt=v[Ye],ii=ne[Ye],Ci=ii==null?null:r==1?e[Ye][ii]:e[Ye][1][ii],Lt=ue.dataIdx(i,Ye,N,Me),ni=Lt==null?null:r==1?e[Ye][Lt]:e[Ye][1][Lt];if(pe=pe||ni!=Ci||Lt!=ii,ne[Ye]=Lt,Ye>0&&kt.show){let fn=Lt==null?-10:Lt==N?Ne:k(r==1?e[0][Lt]:e[Ye][0][Lt],D,Z,0),Zi=ni==null?-10:I(ni,r==1?y[kt.scale]:y[kt.facets[1].scale],oe,0);if(et&&ni!=null){let wn=D.ori==1?Gt:qt,Fn=yi(Be.dist(i,Ye,Lt,Zi,wn));if(Fn<fr){let Jn=Be.bias;if(Jn!=0){let un=$n(wn,kt.scale),Tn=ni>=0?1:-1,On=un>=0?1:-1;On==Tn&&(On==1?Jn==1?ni>=un:ni<=un:Jn==1?ni<=un:ni>=un)&&(fr=Fn,Cr=Ye)}else fr=Fn,Cr=Ye}}if(pe||Re){let wn,Fn;D.ori==0?(wn=fn,Fn=Zi):(wn=Zi,Fn=fn);let Jn,un,Tn,On,Qn,$i,hn=!0,Jr=le.bbox;if(Jr!=null){hn=!1;let Ji=Jr(i,Ye);Tn=Ji.left,On=Ji.top,Jn=Ji.width,un=Ji.height}else Tn=wn,On=Fn,Jn=un=le.size(i,Ye);if($i=le.fill(i,Ye),Qn=le.stroke(i,Ye),Re)Ye==Cr&&fr<=Be.prox&&(Ue=Tn,Oe=On,nt=Jn,Et=un,St=hn,gt=$i,Qe=Qn);else{let Ji=lt[Ye];Ji!=null&&(Bt[Ye]=Tn,Yi[Ye]=On,Fh(Ji,Jn,un,hn),Ih(Ji,$i,Qn),jn(Ji,Rn(Tn),Rn(On),B,Ce))}}}}if(Re){let Ye=Be.prox,kt=Zr==null?fr<=Ye:fr>Ye||Cr!=Zr;if(pe||kt){let ii=lt[0];ii!=null&&(Bt[0]=Ue,Yi[0]=Oe,Fh(ii,nt,Et,St),Ih(ii,gt,Qe),jn(ii,Rn(Ue),Rn(Oe),B,Ce))}}}if(zt.show&&Ar)if(_!=null){let[de,Me]=mi.scales,[Ne,Ue]=mi.match,[Oe,nt]=_.cursor.sync.scales,Et=_.cursor.drag;if(Ti=Et._x,Ai=Et._y,Ti||Ai){let{left:St,top:gt,width:Qe,height:Ye}=_.select,kt=_.scales[Oe].ori,ii=_.posToVal,Ci,Lt,ni,fn,Zi,wn=de!=null&&Ne(de,Oe),Fn=Me!=null&&Ue(Me,nt);wn&&Ti?(kt==0?(Ci=St,Lt=Qe):(Ci=gt,Lt=Ye),ni=y[de],fn=k(ii(Ci,Oe),ni,Z,0),Zi=k(ii(Ci+Lt,Oe),ni,Z,0),Bo(zn(fn,Zi),yi(Zi-fn))):Bo(0,Z),Fn&&Ai?(kt==1?(Ci=St,Lt=Qe):(Ci=gt,Lt=Ye),ni=y[Me],fn=I(ii(Ci,nt),ni,oe,0),Zi=I(ii(Ci+Lt,nt),ni,oe,0),Go(zn(fn,Zi),yi(Zi-fn))):Go(0,oe)}else Rf()}else{let de=yi(oh-rh),Me=yi(ah-sh);if(D.ori==1){let nt=de;de=Me,Me=nt}Ti=Ui.x&&de>=Ui.dist,Ai=Ui.y&&Me>=Ui.dist;let Ne=Ui.uni;Ne!=null?Ti&&Ai&&(Ti=de>=Ne,Ai=Me>=Ne,!Ti&&!Ai&&(Me>de?Ai=!0:Ti=!0)):Ui.x&&Ui.y&&(Ti||Ai)&&(Ti=Ai=!0);let Ue,Oe;Ti&&(D.ori==0?(Ue=Ts,Oe=Gt):(Ue=As,Oe=qt),Bo(zn(Ue,Oe),yi(Oe-Ue)),Ai||Go(0,oe)),Ai&&(D.ori==1?(Ue=Ts,Oe=Gt):(Ue=As,Oe=qt),Go(zn(Ue,Oe),yi(Oe-Ue)),Ti||Bo(0,Z)),!Ti&&!Ai&&(Bo(0,0),Go(0,0))}if(Ui._x=Ti,Ui._y=Ai,_==null){if(P){if(Mh!=null){let[de,Me]=mi.scales;mi.values[0]=de!=null?$n(D.ori==0?Gt:qt,de):null,mi.values[1]=Me!=null?$n(D.ori==1?Gt:qt,Me):null}ko(Df,i,Gt,qt,B,Ce,N)}if(et){let de=P&&mi.setSeries,Me=Be.prox;Zr==null?fr<=Me&&Zn(Cr,Cs,!0,de):fr>Me?Zn(null,Cs,!0,de):Cr!=Zr&&Zn(Cr,Cs,!0,de)}}pe&&(he.idx=N,wf()),b!==!1&&Ri("setCursor")}let Pr=null;Object.defineProperty(i,"rect",{get(){return Pr==null&&zo(!1),Pr}});function zo(_=!1){_?Pr=null:(Pr=x.getBoundingClientRect(),Ri("syncRect",Pr))}function fh(_,b,P,N,H,Z,oe){ue._lock||Ar&&_!=null&&_.movementX==0&&_.movementY==0||(Tf(_,b,P,N,H,Z,oe,!1,_!=null),_!=null?$r(null,!0,!0):$r(b,!0,!1))}function Tf(_,b,P,N,H,Z,oe,de,Me){if(Pr==null&&zo(!1),je(_),_!=null)P=_.clientX-Pr.left,N=_.clientY-Pr.top;else{if(P<0||N<0){Gt=-10,qt=-10;return}let[Ne,Ue]=mi.scales,Oe=b.cursor.sync,[nt,Et]=Oe.values,[St,gt]=Oe.scales,[Qe,Ye]=mi.match,kt=b.axes[0].side%2==1,ii=D.ori==0?B:Ce,Ci=D.ori==1?B:Ce,Lt=kt?Z:H,ni=kt?H:Z,fn=kt?N:P,Zi=kt?P:N;if(St!=null?P=Qe(Ne,St)?a(nt,y[Ne],ii,0):-10:P=ii*(fn/Lt),gt!=null?N=Ye(Ue,gt)?a(Et,y[Ue],Ci,0):-10:N=Ci*(Zi/ni),D.ori==1){let wn=P;P=N,N=wn}}Me&&(b==null||b.cursor.event.type==Df)&&((P<=1||P>=B-1)&&(P=es(P,B)),(N<=1||N>=Ce-1)&&(N=es(N,Ce))),de?(rh=P,sh=N,[Ts,As]=ue.move(i,P,N)):(Gt=P,qt=N)}let Af={width:0,height:0,left:0,top:0};function Rf(){cl(Af,!1)}let uh,hh,dh,ph;function mh(_,b,P,N,H,Z,oe){Ar=!0,Ti=Ai=Ui._x=Ui._y=!1,Tf(_,b,P,N,H,Z,oe,!0,!1),_!=null&&(Mt(Nf,Bf,gh,!1),ko(Ah,i,Ts,As,B,Ce,null));let{left:de,top:Me,width:Ne,height:Ue}=zt;uh=de,hh=Me,dh=Ne,ph=Ue}function gh(_,b,P,N,H,Z,oe){Ar=Ui._x=Ui._y=!1,Tf(_,b,P,N,H,Z,oe,!1,!0);let{left:de,top:Me,width:Ne,height:Ue}=zt,Oe=Ne>0||Ue>0,nt=uh!=de||hh!=Me||dh!=Ne||ph!=Ue;if(Oe&&nt&&cl(zt),Ui.setScale&&Oe&&nt){let Et=de,St=Ne,gt=Me,Qe=Ue;if(D.ori==1&&(Et=Me,St=Ue,gt=de,Qe=Ne),Ti&&Rr(T,$n(Et,T),$n(Et+St,T)),Ai)for(let Ye in y){let kt=y[Ye];Ye!=T&&kt.from==null&&kt.min!=Nt&&Rr(Ye,$n(gt+Qe,Ye),$n(gt,Ye))}Rf()}else ue.lock&&(ue._lock=!ue._lock,$r(b,!0,_!=null));_!=null&&(vi(Nf,Bf),ko(Nf,i,Gt,qt,B,Ce,null))}function X_(_,b,P,N,H,Z,oe){if(ue._lock)return;je(_);let de=Ar;if(Ar){let Me=!0,Ne=!0,Ue=10,Oe,nt;D.ori==0?(Oe=Ti,nt=Ai):(Oe=Ai,nt=Ti),Oe&&nt&&(Me=Gt<=Ue||Gt>=B-Ue,Ne=qt<=Ue||qt>=Ce-Ue),Oe&&Me&&(Gt=Gt<Ts?0:B),nt&&Ne&&(qt=qt<As?0:Ce),$r(null,!0,!0),Ar=!1}Gt=-10,qt=-10,ne.fill(null),$r(null,!0,!0),de&&(Ar=de)}function xh(_,b,P,N,H,Z,oe){ue._lock||(je(_),Oo(),Rf(),_!=null&&ko(Ph,i,Gt,qt,B,Ce,null))}function _h(){A.forEach(VM),F(i.width,i.height,!0)}ns(ml,Ns,_h);let Ps={};Ps.mousedown=mh,Ps.mousemove=fh,Ps.mouseup=gh,Ps.dblclick=xh,Ps.setSeries=(_,b,P,N)=>{let H=mi.match[2];P=H(i,b,P),P!=-1&&Zn(P,N,!0,!1)},me&&(Mt(Ah,x,mh),Mt(Df,x,fh),Mt(Rh,x,_=>{je(_),zo(!1)}),Mt(Ch,x,X_),Mt(Ph,x,xh),qf.add(i),i.syncRect=zo);let fl=i.hooks=n.hooks||{};function Ri(_,b,P){Ki?Ct.push([_,b,P]):_ in fl&&fl[_].forEach(N=>{N.call(null,i,b,P)})}(n.plugins||[]).forEach(_=>{for(let b in _.hooks)fl[b]=(fl[b]||[]).concat(_.hooks[b])});let vh=(_,b,P)=>P,mi=gi({key:null,setSeries:!1,filters:{pub:kh,sub:kh},scales:[T,v[1]?v[1].scale:null],match:[Hh,Hh,vh],values:[null,null]},ue.sync);mi.match.length==2&&mi.match.push(vh),ue.sync=mi;let Mh=mi.key,Cf=Bd(Mh);function ko(_,b,P,N,H,Z,oe){mi.filters.pub(_,b,P,N,H,Z,oe)&&Cf.pub(_,b,P,N,H,Z,oe)}Cf.sub(i);function q_(_,b,P,N,H,Z,oe){mi.filters.sub(_,b,P,N,H,Z,oe)&&Ps[_](null,b,P,N,H,Z,oe)}i.pub=q_;function Y_(){Cf.unsub(i),qf.delete(i),wi.clear(),kf(ml,Ns,_h),l.remove(),Ae?.remove(),Ri("destroy")}i.destroy=Y_;function Pf(){Ri("init",n,e),Fo(e||n.data,!1),W[T]?yf(T,W[T]):Oo(),ie=zt.show&&(zt.width>0||zt.height>0),ee=pe=!0,F(n.width,n.height)}return v.forEach(Ms),A.forEach(or),t?t instanceof HTMLElement?(t.appendChild(l),Pf()):t(i,Pf):Pf(),i}oi.assign=gi;oi.fmtNum=jf;oi.rangeNum=gl;oi.rangeLog=vl;oi.rangeAsinh=Jf;oi.orient=ss;oi.pxRatio=wt;oi.join=Iv;oi.fmtDate=tu,oi.tzDate=Xv;oi.sync=Bd;{oi.addGap=AM,oi.clipGaps=yl;let n=oi.paths={points:Wd};n.linear=qd,n.stepped=PM,n.bars=LM,n.spline=NM}var pr=["circumferential","radial","axial"],WM={circumferential:"#d55e00",radial:"#0072b2",axial:"#009e73"},ks={1:{word:"front flank",colour:"#e8b400"},"-1":{word:"back flank",colour:"#b0489a"},2:{word:"both flanks",colour:"#7a5a2a"},0:{word:"no contact",colour:"#8a8f98"}},$d=["#93a9c1","#c1ab8b","#93b5a0","#ad9fc2","#c4a0a0","#8cb0bb"],Jd={shaft:"#b3b9bf",bearing:"#6b7885",housing:"#9fb3c6",carrier:"#b9b39c",spring:"#8d97a1",body:"#a9b6c0"},ep="#c2452d";function tp(n,e,t=!1){return n==="gear"||n==="body"&&t?$d[e%$d.length]:Jd[n]??Jd.body}function Zo(n,e){return getComputedStyle(n).getPropertyValue(`--pp-force-${e}`).trim()||WM[e]}var Qd=["#3a8fd4","#8a68c4","#a88a1e","#2296a0","#d2484f","#6b8e23","#8a8f98"],ip=n=>pr.some(e=>n.startsWith(`${e}_force`));function Tl(n,e,t){let i=pr.find(r=>e.startsWith(`${r}_force`));return i?Zo(n,i):Qd[t%Qd.length]}var jd=["#d2484f","#a88a1e","#8a68c4","#2296a0","#2f9e62"];function Al(n,e){return jd[Math.max(n.indexOf(e),0)%jd.length]}function zi(n,e=4){if(!Number.isFinite(n))return"\u2013";if(n===0)return"0";let t=Math.abs(n),i=t>=1e6||t<1e-4?t.toExponential(e-1).replace("e+","e"):XM(t.toPrecision(e));return(n<0?"\u2212":"")+i}function XM(n){let e=String(Number(n));return n.includes(".")&&!n.includes("e")?n:e}function np(n){let e=n>0?3-Math.floor(Math.log10(n)):0;return e>9||e<-6?t=>zi(t,4):t=>t.toFixed(Math.max(0,e)).replace(/^-(0(\.0*)?)$/,"$1").replace("-","\u2212")}function lu(n,e,t=n){let i=Math.abs(t),[r,s]=i>=1e6?[1e-6,"M"]:i>=1e3?[.001,"k"]:[1,""],o=n*r,a=Math.abs(t*r)>=100?1:Math.abs(t*r)>=10?2:3;return`${o<0?"\u2212":""}${Math.abs(o).toFixed(a)}\u2009${s}${e}`}var qM=[[1,"m"],[.001,"mm"],[1e-6,"\xB5m"],[1e-9,"nm"]],YM=[[1,"s"],[.001,"ms"],[1e-6,"\xB5s"]];function rp(n,e,t){let[i,r]=e.find(([s])=>Math.abs(n)>=s*.999)??e[e.length-1];return`${zi(n/i,t)}\u2009${r}`}var sp=n=>rp(n,qM,1).replace(/\.0+(?=\D)/,""),op=n=>n===0?"0\u2009s":rp(n,YM,3);function $o(n,e){let t=Math.abs(e)<5e-4,i=Math.max(0,Math.min(6,Math.ceil(-Math.log10(Math.max(e,1e-12)*(t?1e3:1)))));return`${(n*(t?1e3:1)).toFixed(i).replace("-","\u2212")}\u2009${t?"ms":"s"}`}function ap(n){if(n>=.999)return"real time";let e=1/n;return`1/${e<10?String(Number(e.toPrecision(2))):String(Math.round(e)).replace(/\B(?=(\d{3})+$)/g,"\u2009")} of real time`}var lp=84;function KM(n){let{data:e}=n.times;if(!n.most||e.length<2)return Float64Array.from(e);let t=e.length;return Float64Array.from(e,(i,r)=>i+(r<t-1?e[r+1]-i:i-e[r-1])/2)}function cp(n,e){let t=n.scale??1;return Float64Array.from(e.data,i=>i*t)}function ZM(n,e){let{times:t,least:i,most:r}=n,s=0,o=t.count;for(;o-s>1;){let c=s+o>>1;t.data[c]<=e?s=c:o=c}let a=n.scale??1;return{least:i.data[s]*a,most:(r??i).data[s]*a}}var Rl=class{constructor(e,t,i,r){this.channels=e,this.marks=t,this.kinds=[...new Set(t.map(s=>s.kind))],this.full=i,this.x=i,this.seek=r,this.time=i[0],this.drawn=[],this.element=ae("div",{className:"ppv-plots"}),this.names=new Set(e.flat().filter(s=>s.first).map(s=>s.name)),this.order=[...new Set(e.flat().map(s=>s.name))],this.onRemove=()=>{}}show(e,t){t?this.names.add(e):this.names.delete(e),this.build()}#e(){let e=new Map;for(let t of this.order){if(!this.names.has(t))continue;let i=this.channels.map(s=>s.find(o=>o.name===t)),r=(i.find(Boolean).shown_unit??i.find(Boolean).unit)||"1";e.has(r)||e.set(r,[]),e.get(r).push({name:t,found:i})}return e}build(){for(let{plot:t}of this.drawn)t.destroy();this.drawn=[],this.element.replaceChildren();let e=this.#e();this.ratio=window.devicePixelRatio||1,this.turns=[...e.values()].flat().map(({name:t})=>t).filter(t=>!ip(t));for(let[t,i]of e){let r=ae("div",{className:"ppv-plot"}),s=ae("div",{className:"ppv-caption"}),o=ae("div",{className:"ppv-box"});r.append(s,o),this.element.append(r);let a=this.#t(t,i,o,s);this.drawn.push({...a,box:o})}e.size||this.element.append(ae("p",{className:"ppv-none"},this.order.length?"Choose a curve.":"This scene has no curves.")),this.resize(),this.cursor(this.time)}#t(e,t,i,r){let s=[],o=[{}],a=[],c=[],l=getComputedStyle(this.element);t.forEach(({name:p,found:v})=>{let A=Tl(this.element,p,this.turns.indexOf(p)),y=ae("output",{}),R=v.find(Boolean);r.append(ae("span",{className:"ppv-curve"},ae("i",{style:`background:${A}`}),ae("span",{},R.label??p),y,ae("small",{},e==="1"?"":e),Ht("\xD7",`Remove ${R.label??p}`,()=>{this.show(p,!1),this.onRemove()})));let T=Math.max(...v.filter(Boolean).map(g=>(g.scale??1)*Math.max(...[g.least,g.most??g.least].map(({data:w})=>w.reduce((O,L)=>Math.max(O,Math.abs(L)),0)))));c.push({values:y,found:v,digits:np(T)}),v.forEach((g,w)=>{if(!g)return;let L={stroke:A,width:1.4,dash:w?[6,4]:void 0,points:{show:!1},spanGaps:!0},D=[KM(g),cp(g,g.least)];g.most&&(D.push(cp(g,g.most)),a.push({series:[o.length+1,o.length],fill:`color-mix(in srgb, ${A} 30%, transparent)`}),o.push({...L,width:1})),o.push({...L,width:g.most?1:1.4}),s.push(D)})});let f=s.every(([p])=>p.length===s[0][0].length&&p.every((v,A)=>v===s[0][0][A]))?[s[0][0],...s.flatMap(([,...p])=>p)]:oi.join(s.map(p=>p.map(v=>Array.from(v)))),u=l.getPropertyValue("--v-soft").trim()||"#666",m=l.getPropertyValue("--v-grid").trim()||"#ddd",x={stroke:u,grid:{stroke:m,width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},M=new oi({width:300,height:lp,padding:[6,30,0,0],series:o,bands:a,legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,range:()=>this.x},y:{range:(p,v,A)=>$M(v,A)}},axes:[{...x,size:22,gap:3,values:(p,v)=>fp(v,"s")},{...x,size:62,gap:4,space:24,values:(p,v)=>fp(v)}],hooks:{draw:[p=>this.#i(p)]}},f,i),d=ae("div",{className:"ppv-cursor"});return M.over.append(d),this.#n(M),{plot:M,line:d,shows:c}}#i(e){let{left:t,top:i,width:r}=e.bbox,s=-9;for(let o of this.marks){let a=e.valToPos(o.time,"x",!0);a<t||a>t+r||a-s<1||(s=a,e.ctx.fillStyle=Al(this.kinds,o.kind),e.ctx.fillRect(a-this.ratio/2,i,1.2*this.ratio,6*this.ratio))}}#n(e){let{over:t}=e,i=s=>e.posToVal(s.clientX-t.getBoundingClientRect().left,"x"),r=!1;t.addEventListener("pointerdown",s=>{s.button||(r=!0,t.setPointerCapture?.(s.pointerId),this.seek(i(s)))}),t.addEventListener("pointermove",s=>r&&this.seek(i(s)));for(let s of["pointerup","pointercancel"])t.addEventListener(s,()=>r=!1);t.addEventListener("dblclick",()=>this.zoom(this.full)),t.addEventListener("wheel",s=>{if(!s.ctrlKey&&!s.shiftKey&&s.deltaY>0&&this.x===this.full)return;s.preventDefault();let o=i(s),a=Math.exp(Math.max(-1,Math.min(1,(s.deltaY||s.deltaX)*.002)));this.zoom([o+(this.x[0]-o)*a,o+(this.x[1]-o)*a])},{passive:!1})}zoom([e,t]){let[i,r]=this.full,s=t-e>=r-i;this.x=s?this.full:[Math.max(i,e),Math.min(r,t)];for(let{plot:o}of this.drawn)o.setData(o.data);this.cursor(this.time)}resize(){let e=this.element.clientHeight,i=Math.max(lp,Math.min(260,Math.floor(e/Math.max(1,this.drawn.length))-20-4));for(let{plot:r,box:s}of this.drawn)r.setSize({width:Math.max(120,s.clientWidth),height:i});this.cursor(this.time)}cursor(e){this.time=e;for(let{plot:t,line:i,shows:r}of this.drawn){let s=t.valToPos(e,"x");i.hidden=!(s>=-.5&&s<=t.over.clientWidth+.5),i.style.transform=`translateX(${s}px)`;for(let{values:o,found:a,digits:c}of r){let l=a.filter(Boolean).map(h=>{let{least:f,most:u}=ZM(h,e);return f===u?c(f):`${c(f)} \u2026 ${c(u)}`}).join(" | ");o.textContent!==l&&(o.textContent=l)}}}};function $M(n,e){if(!(e>=n))return[0,1];let t=.06*(e-n||Math.abs(e)||1);return[n-t,e+t]}function fp(n,e=""){let t=Math.max(...n.map(Math.abs)),i=n.length>1?Math.abs(n[1]-n[0]):t,r=Math.max(0,Math.min(12,-Math.floor(Math.log10(i||1)+1e-9)));return r<12&&Math.abs(i*10**r-Math.round(i*10**r))>1e-6&&r++,n.map((s,o)=>{let a=t>=1e6||t>0&&t<1e-4?s.toExponential(2):s.toFixed(r);return(o===n.length-1&&e?`${a} ${e}`:a).replace(/^-(0(\.0+)?)$/,"$1").replace("-","\u2212")})}var Cl=class{constructor(e,t){this.spectra=e,this.names=[...new Set(e.flat().map(r=>r.channel))];let i=r=>t.flat().find(s=>s.name===r)?.label??r;this.name=this.names[0],this.box=ae("div",{className:"ppv-box"}),this.read=ae("output",{}),this.choice=ur("spectrum of",this.names.map(r=>[r,i(r)]),r=>{this.name=r,this.build()}),this.log=!0,this.element=ae("div",{className:"ppv-spectra"},ae("div",{className:"ppv-caption"},this.choice.row,this.read),this.box),this.element.hidden=!0}build(){this.plot?.destroy();let e=this.spectra.map(f=>f.find(u=>u.channel===this.name)),t=e.filter(Boolean).map(({frequency:f,amplitude:u})=>[Array.from(f.data),Array.from(u.data,m=>m>0?m:null)]),i=getComputedStyle(this.element),r=i.getPropertyValue("--v-soft").trim()||"#666",s=i.getPropertyValue("--v-grid").trim()||"#ddd",o={stroke:r,grid:{stroke:s,width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},a=Tl(this.element,this.name,0),c=e.find(Boolean)?.unit??"",l=e.flatMap((f,u)=>f?[{stroke:a,width:1.2,dash:u?[6,4]:void 0,points:{show:!1},spanGaps:!0}]:[]),h=Math.max(...t.flatMap(([,f])=>f.map(u=>u??0)),1e-300);this.plot=new oi({width:300,height:160,padding:[6,44,0,0],legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},series:[{},...l],scales:{x:{time:!1},y:{distr:3,range:(f,u)=>[Math.max(u,h*1e-8),h*1.6]}},axes:[{...o,size:22,gap:3,values:(f,u)=>u.map((m,x)=>x===u.length-1?`${m} Hz`:String(m))},{...o,size:62,gap:4,space:28,values:(f,u)=>u.map(m=>m===null?"":zi(m,2))}],hooks:{setCursor:[f=>{let u=f.cursor.idx,m=u==null?[]:f.data.slice(1).map(x=>zi(x[u]??NaN,3));this.read.textContent=m.length?`${zi(f.data[0][u],5)} Hz: ${m.join(" | ")} ${c}`:""}]}},t.length>1?oi.join(t):t[0],this.box),this.resize()}resize(){this.element.hidden||!this.plot||this.plot.setSize({width:Math.max(120,this.box.clientWidth),height:Math.max(110,this.element.parentElement.clientHeight-28)})}};var Pl=class{constructor(e,t,i,r){let s=e.map(o=>o.channels);this.plots=new Rl(s,i,t,r),this.spectra=new Cl(e.map(o=>o.spectra),s),this.labels=new Map(s.flat().map(o=>[o.name,o.label??o.name])),this.search=ae("input",{type:"search",placeholder:`add a curve (${this.labels.size})`,"aria-label":"Search channels",title:"Channels, by any words of their names"}),this.list=ae("div",{className:"ppv-list",role:"listbox","aria-label":"Channels",hidden:!0}),this.search.addEventListener("focus",()=>this.fill()),this.search.addEventListener("input",()=>this.fill()),this.search.addEventListener("keydown",o=>{if(o.key==="Escape"&&this.close(),o.key==="Enter"||o.key==="ArrowDown"){let a=this.list.querySelector("button");o.key==="Enter"?a?.click():a?.focus(),o.preventDefault()}o.stopPropagation()}),this.list.addEventListener("keydown",o=>{let a={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[o.key];a&&(document.activeElement?.[a]??this.search).focus(),o.key==="Escape"&&this.close(),(a||o.key==="Escape")&&o.preventDefault(),o.stopPropagation()}),this.picker=ae("div",{className:"ppv-picker"},this.search,this.list),this.picker.addEventListener("focusout",o=>{this.picker.contains(o.relatedTarget)||this.close()}),this.tab=Ht("Spectrum","Curves over time or spectrum",()=>this.turn()),this.tab.hidden=!this.spectra.names.length,this.plots.onRemove=()=>this.list.hidden||this.fill(),this.body=ae("div",{className:"ppv-curves-body"},this.plots.element,this.spectra.element),this.element=ae("div",{className:"ppv-curves"},ae("div",{className:"ppv-bar"},this.picker,this.tab),this.body),this.element.hidden=!this.labels.size&&!this.spectra.names.length}matches(){let e=this.search.value.toLowerCase().split(/\s+/).filter(Boolean);return[...this.labels].filter(([t,i])=>{let r=`${t} ${i}`.toLowerCase();return e.every(s=>r.includes(s))})}fill(){let e=this.matches();this.list.replaceChildren(...e.slice(0,200).map(([t,i])=>{let r=this.plots.names.has(t);return ae("button",{type:"button",role:"option","aria-selected":String(r),title:t,onclick:s=>{this.plots.show(t,!this.plots.names.has(t)),s.currentTarget.setAttribute("aria-selected",String(this.plots.names.has(t)))}},i)})),e.length||this.list.append(ae("p",{},"No channel has these words.")),e.length>200&&this.list.append(ae("p",{},`${e.length-200} more: search for words of their names.`)),this.list.hidden=!1}close(){this.list.hidden=!0}turn(){if(!this.spectra.names.length)return;let e=this.spectra.element.hidden;this.spectra.element.hidden=!e,this.plots.element.hidden=e,this.tab.textContent=e?"Curves":"Spectrum",this.picker.style.visibility=e?"hidden":"",e?this.spectra.build():this.resize()}build(){this.element.hidden||(this.plots.build(),this.spectra.element.hidden||this.spectra.build())}resize(){this.element.hidden||(this.plots.element.hidden||this.plots.resize(),this.spectra.resize())}};var Ll=class{constructor(e,t,i){this.stage=e,this.label=ae("div",{className:"ppv-label",hidden:!0}),this.at=null,this.waiting=!1;let{canvas:r}=e;r.addEventListener("pointermove",s=>{this.at=t.dragging||s.pointerType==="touch"?null:{x:s.clientX,y:s.clientY},this.waiting||setTimeout(()=>this.#e(),60),this.waiting=!0}),r.addEventListener("pointerleave",()=>{this.at=null,this.label.hidden=!0}),r.addEventListener("dblclick",s=>{let o=e.hit(s.clientX,s.clientY);o&&i(o.part.solid.body)})}#e(){this.waiting=!1;let e=this.at&&this.stage.hit(this.at.x,this.at.y);if(this.label.hidden=!e,!e)return;let{solid:t}=e.part;this.label.textContent=JM(t);let i=this.stage.canvas.getBoundingClientRect(),r=Math.min(this.at.x-i.left+14,i.width-this.label.offsetWidth-4);this.label.style.transform=`translate(${r}px, ${Math.max(0,this.at.y-i.top-26)}px)`}};function JM(n){let e=n.name.replaceAll("_"," ");return n.teeth?`${e}, ${n.kind} of ${n.teeth} teeth`:e===n.kind?e:`${e}, ${n.kind}`}function er(n,e){let t=n.length;if(t<2||e<=n[0])return{low:0,share:0};if(e>=n[t-1])return{low:t-2,share:1};let i=0,r=t-1;for(;r-i>1;){let o=i+r>>1;n[o]<=e?i=o:r=o}let s=n[i+1]-n[i];return{low:i,share:s>0?(e-n[i])/s:0}}function ki(n,e,t=0){let{data:i,width:r,count:s}=n;if(s===1)return i[t];let o=e.low*r+t;return e.share?i[o]+e.share*(i[o+r]-i[o]):i[o]}function Hs(n){let e=new Float64Array(n.width);for(let t=0;t<n.data.length;t++)e[t%n.width]+=n.data[t];return e.map(t=>t/Math.max(n.count,1))}var Jo=1e-4;function Qo(n){let e=10**Math.floor(Math.log10(n)),t=n/e;return e*(t<1.5?1:t<3.5?2:t<7.5?5:10)}var Dl=class{constructor(e,t){this.times=e,this.poses=t,this.first=e.length?e[0]:0,this.last=e.length?e[e.length-1]:0,this.time=this.first,this.playing=!1,this.loop="record",this.window=[this.first,this.last],this.body=-1,this.speed=this.#e()}#e(){let e=this.last-this.first,t=0,i=[er(this.times,this.first),er(this.times,this.last)];this.poses?.bodies.forEach((s,o)=>{t=Math.max(t,Math.abs(this.poses.angle(o,i[1])-this.poses.angle(o,i[0])))});let r=e>0?t>1?2*Math.PI*e/t/3:e/10:1;return Qo(Math.max(Jo,Math.min(1,r)))}seek(e){this.time=Math.max(this.first,Math.min(this.last,e))}advance(e){if(!this.playing)return;let[t,i]=this.window,r=this.time+e*this.speed;r<t&&(r=t),r>i&&(r=i>t?t+(r-t)%(i-t):t),this.time=r}step(e){this.playing=!1;let{low:t,share:i}=er(this.times,this.time),r=t+i,s=e>0?Math.floor(r+1e-9)+e:Math.ceil(r-1e-9)+e;this.time=this.times[Math.max(0,Math.min(this.times.length-1,s))]??0}get frame(){let{low:e,share:t}=er(this.times,this.time);return e+t}reference(e,t){let i=s=>this.poses&&Math.abs(this.poses.angle(s,er(this.times,this.last))-this.poses.angle(s,er(this.times,this.first)))>0;if(e>=0&&i(e))return e;let r=t.find(s=>s.teeth&&i(s.body));return r?r.body:this.poses?.bodies.findIndex((s,o)=>i(o))??-1}repeat(e,t,i){if(this.loop="record",this.window=[this.first,this.last],e==="record")return"";let r=this.reference(t,i);if(r<0)return"No body of this scene turns.";let s=i.find(f=>f.body===r&&f.teeth)?.teeth;if(e==="cycle"&&!s)return"The followed body is not a gear.";let o=2*Math.PI/(e==="cycle"?s:1),a=f=>this.poses.angle(r,er(this.times,f));if(Math.abs(a(this.last)-a(this.first))<o)return"The record is shorter than that.";let l=this.time;Math.abs(a(this.last)-a(l))<o&&(l=this.#t(f=>Math.abs(a(this.last)-a(f))<=o,this.first,this.last));let h=this.#t(f=>Math.abs(a(f)-a(l))>=o,l,this.last);return this.loop=e,this.body=r,this.window=[l,h],this.seek(l),""}#t(e,t,i){for(let r=0;r<60;r++){let s=(t+i)/2;e(s)?i=s:t=s}return i}};var up=[["space","play, pause"],["\u2190 \u2192","one frame back, on"],["Home, End","start, end"],["+ \u2212","faster, slower"],["[ ]","mark before, next mark"],["f","show all"],["1 \u2026 9, 0","follow a body, none"],["s","section"],["m","vibrations \xD71, \xD710, \xD7100, \xD71000"],["drag","turn; right button or shift: move"],["wheel","zoom to the pointer"],["double click","follow the body of a part"]];function hp(n){let e={" ":()=>n.toggle(),ArrowLeft:()=>n.step(-1),ArrowRight:()=>n.step(1),Home:()=>n.seek(n.player.window[0]),End:()=>n.seek(n.player.window[1]),"+":()=>cu(n,2.1),"=":()=>cu(n,2.1),"-":()=>cu(n,.47619047619047616),"[":()=>n.transport.toMark(-1),"]":()=>n.transport.toMark(1),f:()=>n.views?.fit(),s:()=>n.section?.turn(!n.section.on),m:()=>QM(n),Escape:()=>n.panels.close()};n.root.tabIndex=-1,document.addEventListener("keydown",t=>{if(t.ctrlKey||t.metaKey||t.altKey||t.defaultPrevented)return;let{target:i}=t,r=n.root.contains(i),s=i===document.body&&n.fills;if(!(!r&&!s||i.matches?.("select, input[type=search], input[type=text]")||i.matches?.("input[type=range]")&&i!==n.transport.range&&/^(Arrow|Home|End)/.test(t.key))&&!(t.key===" "&&i.matches?.("button, input[type=checkbox]"))){if(/^[0-9]$/.test(t.key))n.follow(Number(t.key)-1);else if(e[t.key])e[t.key]();else return;t.preventDefault()}})}function cu(n,e){let{player:t,transport:i}=n;t.speed=Math.max(Jo,Math.min(1,Qo(t.speed*e))),i.speed.set(t.speed)}function QM(n){if(!n.magnification)return;let e=n.stage.pictures[0].poses.magnification,t=e>=1e3?1:e>=100?1e3:e>=10?100:10;n.magnification.set(t),n.magnify(t)}var Nl=class{constructor(e){this.arrows=e,this.columns=pr.filter(i=>e.some(r=>r.components?.[i])),this.rows=e.map(i=>{let r=i.state?ae("span",{className:"ppv-state"}):null,s=this.columns.map(a=>ae("td",{className:`ppv-${a}`})),o=i.name.replaceAll("_"," ");return{state:r,cells:s,said:null,row:ae("tr",{},ae("th",{scope:"row",title:`${i.kind} ${o}`},r,o),...s)}});let t=ae("tr",{},ae("td"),...this.columns.map(i=>ae("th",{scope:"col",className:`ppv-${i}`},ae("i"),i)));if(this.states=ae("div",{className:"ppv-states"}),e.some(i=>i.state)){let i=new Set(e.flatMap(r=>[...r.state?.data??[]]).map(r=>r===255?-1:r));for(let{word:r,colour:s}of[1,-1,2,0].filter(o=>i.has(o)).map(o=>ks[o]))this.states.append(ae("span",{},ae("i",{style:`background:${s}`}),r))}this.element=ae("div",{className:"ppv-legend",tabindex:"0",role:"region","aria-label":"Forces now"},ae("table",{},ae("thead",{},t),ae("tbody",{},...this.rows.map(({row:i})=>i))),this.states),this.element.hidden=!e.length}update(e,t,i){this.element.hidden=i||!e.some(r=>t.has(r.kind)),!this.element.hidden&&e.forEach((r,s)=>{let{row:o,cells:a,state:c}=this.rows[s];if(o.hidden=!t.has(r.kind),!o.hidden&&(this.columns.forEach((l,h)=>{let f=l in r.values?lu(r.values[l],r.unit,this.arrows[s].size||r.values[l]):"";a[h].textContent!==f&&(a[h].textContent=f)}),c&&this.rows[s].said!==r.state)){let{word:l,colour:h}=ks[r.state]??ks[0];this.rows[s].said=r.state,c.style.background=h,c.title=l,c.setAttribute("aria-label",l)}})}lines(e,t){return e.map((i,r)=>({each:i,size:this.arrows[r].size})).filter(({each:i})=>t.has(i.kind)).map(({each:i,size:r})=>({name:i.name.replaceAll("_"," "),values:this.columns.filter(s=>s in i.values).map(s=>({part:s,text:lu(i.values[s],i.unit,r||i.values[s])}))}))}};var jM=1.6,eS=.06,Il=class{constructor(e,t,i){this.modes=e,this.changed=i,this.stage=t,this.number=-1,this.phase=0,this.amplitude=1,this.unit=e.map(s=>this.#t(s)),this.buttons=e.map((s,o)=>Ht("",`Swing in ${s.name}`,()=>this.choose(this.number===o?-1:o),{"aria-pressed":"false"})),this.buttons.forEach((s,o)=>s.append(ae("span",{},e[o].name),ae("span",{},this.#e(e[o])))),this.stop=Ht("back to the record","End the mode shape",()=>this.choose(-1)),this.stop.hidden=!0;let r=Qr({label:"amplitude",title:"Amplitude of the mode shape",least:.05,most:20,value:1,show:s=>`\xD7 ${zi(s,2)}`,changed:s=>{this.amplitude=s,this.changed()}});this.rows=[ae("div",{className:"ppv-modes"},...this.buttons),r.row,this.stop]}#e({frequency:e,damping:t}){return`${zi(e,4)} Hz${t==null?"":`, ${zi(100*t,2)} %`}`}#t(e){let{solids:t,bounds:i}=this.stage.pictures[0],r=0,s=(o,a)=>{let c=0;for(let l=0;l<6;l++)c+=o?o.data[6*a+l]**2:0;return Math.sqrt(c)};this.stage.pictures[0].data.bodies.forEach((o,a)=>{let c=t.reachOf(a);r=Math.max(r,s(e.position,a)+s(e.turn,a)*(c||.1*i.radius))});for(let{sway:o}of t.parts)r=Math.max(r,o?.largest(e)??0);return r>0?eS*i.radius/r:0}get active(){return this.number>=0}get words(){return this.active?`${this.modes[this.number].name}, ${this.#e(this.modes[this.number])}`:""}choose(e){this.number=e,this.phase=0,this.buttons.forEach((t,i)=>t.setAttribute("aria-pressed",String(i===e))),this.stop.hidden=e<0,this.changed()}advance(e){this.active&&(this.phase=(this.phase+2*Math.PI*e/jM)%(2*Math.PI))}pose({poses:e}){e.ofMode(this.modes[this.number],this.phase,this.amplitude*this.unit[this.number])}};var dp=0,fu=1,pp=2;var Vs=1,mp=2,os=3,nn=0,Jt=1,ji=2,tr=0,Nr=1,uu=2,hu=3,du=4,gp=5;var Ir=100,xp=101,_p=102,vp=103,Mp=104,Sp=200,yp=201,bp=202,Ep=203,Ul=204,Fl=205,wp=206,Tp=207,Ap=208,Rp=209,Cp=210,Pp=211,Lp=212,Dp=213,Np=214,jo=0,ea=1,ta=2,Ur=3,ia=4,na=5,ra=6,sa=7,Ws=0,Ip=1,Up=2,gn=0,Ol=1,Bl=2,Gl=3,zl=4,kl=5,Hl=6,Vl=7;var pu=300,ir=301,Fr=302,Wl=303,Xl=304,oa=1e3,rn=1001,aa=1002,Yt=1003,Fp=1004;var la=1005;var xi=1006,ql=1007;var xn=1008;var ai=1009,Yl=1010,Kl=1011,mr=1012,Xs=1013,Pi=1014,li=1015,Li=1016,qs=1017,Ys=1018,kn=1020,Zl=35902,$l=35899,Jl=1021,Ql=1022,Di=1023,sn=1026,_n=1027,Ks=1028,Zs=1029,vn=1030,$s=1031;var Js=1033,Qs=33776,js=33777,eo=33778,to=33779,ca=35840,fa=35841,ua=35842,ha=35843,da=36196,pa=37492,ma=37496,ga=37488,xa=37489,as=37490,_a=37491,va=37808,Ma=37809,Sa=37810,ya=37811,ba=37812,Ea=37813,wa=37814,Ta=37815,Aa=37816,Ra=37817,Ca=37818,Pa=37819,La=37820,Da=37821,Na=36492,Ia=36494,Ua=36495,Fa=36283,Oa=36284,ls=36285,Ba=36286;var Op=3200;var Ga=0,Bp=1,Cn="",en="srgb",cs="srgb-linear",fs="linear",vt="srgb";var jl=7680;var Gp=519,zp=512,kp=513,Hp=514,ec=515,Vp=516,Wp=517,tc=518,ic=519,Xp=35044;var mu="300 es",Fi=2e3,gr=2001;function Yp(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function no(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Kp(){let n=no("canvas");return n.style.display="block",n}var qp={},io=null;function gu(...n){let e="THREE."+n.shift();io?io("log",e,...n):console.log(e,...n)}function Zp(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ke(...n){n=Zp(n);let e="THREE."+n.shift();if(io)io("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function ht(...n){n=Zp(n);let e="THREE."+n.shift();if(io)io("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function us(...n){let e=n.join(" ");e in qp||(qp[e]=!0,ke(...n))}function $p(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var Jp={[jo]:jo,[ta]:ra,[ia]:ia,[Ur]:na,[ea]:ea,[ra]:ta,[sa]:sa,[na]:Ur};var Hi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}};var Vi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var nc=Math.PI/180,za=180/Math.PI;function nr(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Vi[n&255]+Vi[n>>8&255]+Vi[n>>16&255]+Vi[n>>24&255]+"-"+Vi[e&255]+Vi[e>>8&255]+"-"+Vi[e>>16&15|64]+Vi[e>>24&255]+"-"+Vi[t&63|128]+Vi[t>>8&255]+"-"+Vi[t>>16&255]+Vi[t>>24&255]+Vi[i&255]+Vi[i>>8&255]+Vi[i>>16&255]+Vi[i>>24&255]).toLowerCase()}function ct(n,e,t){return Math.max(e,Math.min(t,n))}function Qp(n,e){return(n%e+e)%e}function rc(n,e,t){return(1-t)*n+t*e}function jp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function sc(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function em(n,e){if(e.constructor===Float32Array)return n;let t=sc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function tm(n,e){if(e.constructor===Float32Array)return n;let t=sc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Ze=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};var Wt=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let c=i[r+0],l=i[r+1],h=i[r+2],f=i[r+3],u=s[o+0],m=s[o+1],x=s[o+2],M=s[o+3];if(f!==M||c!==u||l!==m||h!==x){let d=c*u+l*m+h*x+f*M;d<0&&(u=-u,m=-m,x=-x,M=-M,d=-d);let p=1-a;if(d<.9995){let v=Math.acos(d),A=Math.sin(v);p=Math.sin(p*v)/A,a=Math.sin(a*v)/A,c=c*p+u*a,l=l*p+m*a,h=h*p+x*a,f=f*p+M*a}else{c=c*p+u*a,l=l*p+m*a,h=h*p+x*a,f=f*p+M*a;let v=1/Math.sqrt(c*c+l*l+h*h+f*f);c*=v,l*=v,h*=v,f*=v}}e[t]=c,e[t+1]=l,e[t+2]=h,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],c=i[r+1],l=i[r+2],h=i[r+3],f=s[o],u=s[o+1],m=s[o+2],x=s[o+3];return e[t]=a*x+h*f+c*m-l*u,e[t+1]=c*x+h*u+l*f-a*m,e[t+2]=l*x+h*m+a*u-c*f,e[t+3]=h*x-a*f-c*u-l*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,c=Math.sin,l=a(i/2),h=a(r/2),f=a(s/2),u=c(i/2),m=c(r/2),x=c(s/2);switch(o){case"XYZ":this._x=u*h*f+l*m*x,this._y=l*m*f-u*h*x,this._z=l*h*x+u*m*f,this._w=l*h*f-u*m*x;break;case"YXZ":this._x=u*h*f+l*m*x,this._y=l*m*f-u*h*x,this._z=l*h*x-u*m*f,this._w=l*h*f+u*m*x;break;case"ZXY":this._x=u*h*f-l*m*x,this._y=l*m*f+u*h*x,this._z=l*h*x+u*m*f,this._w=l*h*f-u*m*x;break;case"ZYX":this._x=u*h*f-l*m*x,this._y=l*m*f+u*h*x,this._z=l*h*x-u*m*f,this._w=l*h*f+u*m*x;break;case"YZX":this._x=u*h*f+l*m*x,this._y=l*m*f+u*h*x,this._z=l*h*x-u*m*f,this._w=l*h*f-u*m*x;break;case"XZY":this._x=u*h*f-l*m*x,this._y=l*m*f-u*h*x,this._z=l*h*x+u*m*f,this._w=l*h*f+u*m*x;break;default:ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],c=t[9],l=t[2],h=t[6],f=t[10],u=i+a+f;if(u>0){let m=.5/Math.sqrt(u+1);this._w=.25/m,this._x=(h-c)*m,this._y=(s-l)*m,this._z=(o-r)*m}else if(i>a&&i>f){let m=2*Math.sqrt(1+i-a-f);this._w=(h-c)/m,this._x=.25*m,this._y=(r+o)/m,this._z=(s+l)/m}else if(a>f){let m=2*Math.sqrt(1+a-i-f);this._w=(s-l)/m,this._x=(r+o)/m,this._y=.25*m,this._z=(c+h)/m}else{let m=2*Math.sqrt(1+f-i-a);this._w=(o-r)/m,this._x=(s+l)/m,this._y=(c+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,c=t._y,l=t._z,h=t._w;return this._x=i*h+o*a+r*l-s*c,this._y=r*h+o*c+s*a-i*l,this._z=s*h+o*l+i*c-r*a,this._w=o*h-i*a-r*c-s*l,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let c=1-t;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,t=Math.sin(t*l)/h,this._x=this._x*c+i*t,this._y=this._y*c+r*t,this._z=this._z*c+s*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+i*t,this._y=this._y*c+r*t,this._z=this._z*c+s*t,this._w=this._w*c+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}};var U=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(im.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(im.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,c=e.w,l=2*(o*r-a*i),h=2*(a*t-s*r),f=2*(s*i-o*t);return this.x=t+c*l+o*f-a*h,this.y=i+c*h+a*l-s*f,this.z=r+c*f+s*h-o*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,c=t.z;return this.x=r*c-s*a,this.y=s*o-i*c,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return xu.copy(this).projectOnVector(e),this.sub(xu)}reflect(e){return this.sub(xu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},xu=new U,im=new Wt;var Ke=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,c,l)}set(e,t,i,r,s,o,a,c,l){let h=this.elements;return h[0]=e,h[1]=r,h[2]=a,h[3]=t,h[4]=s,h[5]=c,h[6]=i,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],h=i[4],f=i[7],u=i[2],m=i[5],x=i[8],M=r[0],d=r[3],p=r[6],v=r[1],A=r[4],y=r[7],R=r[2],T=r[5],g=r[8];return s[0]=o*M+a*v+c*R,s[3]=o*d+a*A+c*T,s[6]=o*p+a*y+c*g,s[1]=l*M+h*v+f*R,s[4]=l*d+h*A+f*T,s[7]=l*p+h*y+f*g,s[2]=u*M+m*v+x*R,s[5]=u*d+m*A+x*T,s[8]=u*p+m*y+x*g,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8];return t*o*h-t*a*l-i*s*h+i*a*c+r*s*l-r*o*c}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],f=h*o-a*l,u=a*c-h*s,m=l*s-o*c,x=t*f+i*u+r*m;if(x===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/x;return e[0]=f*M,e[1]=(r*l-h*i)*M,e[2]=(a*i-r*o)*M,e[3]=u*M,e[4]=(h*t-r*c)*M,e[5]=(r*s-a*t)*M,e[6]=m*M,e[7]=(i*c-l*t)*M,e[8]=(o*t-i*s)*M,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let c=Math.cos(s),l=Math.sin(s);return this.set(i*c,i*l,-i*(c*o+l*a)+o+e,-r*l,r*c,-r*(-l*o+c*a)+a+t,0,0,1),this}scale(e,t){return us("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(_u.makeScale(e,t)),this}rotate(e){return us("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(_u.makeRotation(-e)),this}translate(e,t){return us("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(_u.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},_u=new Ke;var nm=new Ke().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),rm=new Ke().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function tS(){let n={enabled:!0,workingColorSpace:cs,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===vt&&(r.r=Hn(r.r),r.g=Hn(r.g),r.b=Hn(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===vt&&(r.r=hs(r.r),r.g=hs(r.g),r.b=hs(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Cn?fs:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[cs]:{primaries:e,whitePoint:i,transfer:fs,toXYZ:nm,fromXYZ:rm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:en},outputColorSpaceConfig:{drawingBufferColorSpace:en}},[en]:{primaries:e,whitePoint:i,transfer:vt,toXYZ:nm,fromXYZ:rm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:en}}}),n}var ot=tS();function Hn(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function hs(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ro,oc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{ro===void 0&&(ro=no("canvas")),ro.width=e.width,ro.height=e.height;let r=ro.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=ro}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=no("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Hn(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Hn(t[i]/255)*255):t[i]=Hn(t[i]);return{data:t,width:e.width,height:e.height}}else return ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}};var iS=0,Or=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:iS++}),this.uuid=nr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(vu(r[o].image)):s.push(vu(r[o]))}else s=vu(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function vu(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?oc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ke("Texture: Unable to serialize Texture."),{})}var nS=0,Mu=new U,ci=class n extends Hi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=rn,r=rn,s=xi,o=xn,a=Di,c=ai,l=n.DEFAULT_ANISOTROPY,h=Cn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:nS++}),this.uuid=nr(),this.name="",this.source=new Or(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Ze(0,0),this.repeat=new Ze(1,1),this.center=new Ze(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ke,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Mu).x}get height(){return this.source.getSize(Mu).y}get depth(){return this.source.getSize(Mu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){ke(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==pu)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case oa:e.x=e.x-Math.floor(e.x);break;case rn:e.x=e.x<0?0:1;break;case aa:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case oa:e.y=e.y-Math.floor(e.y);break;case rn:e.y=e.y<0?0:1;break;case aa:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ci.DEFAULT_IMAGE=null;ci.DEFAULT_MAPPING=pu;ci.DEFAULT_ANISOTROPY=1;var bt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,c=e.elements,l=c[0],h=c[4],f=c[8],u=c[1],m=c[5],x=c[9],M=c[2],d=c[6],p=c[10];if(Math.abs(h-u)<.01&&Math.abs(f-M)<.01&&Math.abs(x-d)<.01){if(Math.abs(h+u)<.1&&Math.abs(f+M)<.1&&Math.abs(x+d)<.1&&Math.abs(l+m+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(l+1)/2,y=(m+1)/2,R=(p+1)/2,T=(h+u)/4,g=(f+M)/4,w=(x+d)/4;return A>y&&A>R?A<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(A),r=T/i,s=g/i):y>R?y<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(y),i=T/r,s=w/r):R<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(R),i=g/s,r=w/s),this.set(i,r,s,t),this}let v=Math.sqrt((d-x)*(d-x)+(f-M)*(f-M)+(u-h)*(u-h));return Math.abs(v)<.001&&(v=1),this.x=(d-x)/v,this.y=(f-M)/v,this.z=(u-h)/v,this.w=Math.acos((l+m+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};var ac=class extends Hi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:xi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new bt(0,0,e,t),this.scissorTest=!1,this.viewport=new bt(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new ci({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:xi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Or(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Oi=class extends ac{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}};var so=class extends ci{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Yt,this.minFilter=Yt,this.wrapR=rn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var lc=class extends ci{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Yt,this.minFilter=Yt,this.wrapR=rn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Ie=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,c,l,h,f,u,m,x,M,d){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,c,l,h,f,u,m,x,M,d)}set(e,t,i,r,s,o,a,c,l,h,f,u,m,x,M,d){let p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=r,p[1]=s,p[5]=o,p[9]=a,p[13]=c,p[2]=l,p[6]=h,p[10]=f,p[14]=u,p[3]=m,p[7]=x,p[11]=M,p[15]=d,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/oo.setFromMatrixColumn(e,0).length(),s=1/oo.setFromMatrixColumn(e,1).length(),o=1/oo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(r),l=Math.sin(r),h=Math.cos(s),f=Math.sin(s);if(e.order==="XYZ"){let u=o*h,m=o*f,x=a*h,M=a*f;t[0]=c*h,t[4]=-c*f,t[8]=l,t[1]=m+x*l,t[5]=u-M*l,t[9]=-a*c,t[2]=M-u*l,t[6]=x+m*l,t[10]=o*c}else if(e.order==="YXZ"){let u=c*h,m=c*f,x=l*h,M=l*f;t[0]=u+M*a,t[4]=x*a-m,t[8]=o*l,t[1]=o*f,t[5]=o*h,t[9]=-a,t[2]=m*a-x,t[6]=M+u*a,t[10]=o*c}else if(e.order==="ZXY"){let u=c*h,m=c*f,x=l*h,M=l*f;t[0]=u-M*a,t[4]=-o*f,t[8]=x+m*a,t[1]=m+x*a,t[5]=o*h,t[9]=M-u*a,t[2]=-o*l,t[6]=a,t[10]=o*c}else if(e.order==="ZYX"){let u=o*h,m=o*f,x=a*h,M=a*f;t[0]=c*h,t[4]=x*l-m,t[8]=u*l+M,t[1]=c*f,t[5]=M*l+u,t[9]=m*l-x,t[2]=-l,t[6]=a*c,t[10]=o*c}else if(e.order==="YZX"){let u=o*c,m=o*l,x=a*c,M=a*l;t[0]=c*h,t[4]=M-u*f,t[8]=x*f+m,t[1]=f,t[5]=o*h,t[9]=-a*h,t[2]=-l*h,t[6]=m*f+x,t[10]=u-M*f}else if(e.order==="XZY"){let u=o*c,m=o*l,x=a*c,M=a*l;t[0]=c*h,t[4]=-f,t[8]=l*h,t[1]=u*f+M,t[5]=o*h,t[9]=m*f-x,t[2]=x*f-m,t[6]=a*h,t[10]=M*f+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(rS,e,sS)}lookAt(e,t,i){let r=this.elements;return Mn.subVectors(e,t),Mn.lengthSq()===0&&(Mn.z=1),Mn.normalize(),Br.crossVectors(i,Mn),Br.lengthSq()===0&&(Math.abs(i.z)===1?Mn.x+=1e-4:Mn.z+=1e-4,Mn.normalize(),Br.crossVectors(i,Mn)),Br.normalize(),cc.crossVectors(Mn,Br),r[0]=Br.x,r[4]=cc.x,r[8]=Mn.x,r[1]=Br.y,r[5]=cc.y,r[9]=Mn.y,r[2]=Br.z,r[6]=cc.z,r[10]=Mn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],h=i[1],f=i[5],u=i[9],m=i[13],x=i[2],M=i[6],d=i[10],p=i[14],v=i[3],A=i[7],y=i[11],R=i[15],T=r[0],g=r[4],w=r[8],O=r[12],L=r[1],D=r[5],G=r[9],k=r[13],I=r[2],W=r[6],Y=r[10],V=r[14],ce=r[3],$=r[7],Q=r[11],ne=r[15];return s[0]=o*T+a*L+c*I+l*ce,s[4]=o*g+a*D+c*W+l*$,s[8]=o*w+a*G+c*Y+l*Q,s[12]=o*O+a*k+c*V+l*ne,s[1]=h*T+f*L+u*I+m*ce,s[5]=h*g+f*D+u*W+m*$,s[9]=h*w+f*G+u*Y+m*Q,s[13]=h*O+f*k+u*V+m*ne,s[2]=x*T+M*L+d*I+p*ce,s[6]=x*g+M*D+d*W+p*$,s[10]=x*w+M*G+d*Y+p*Q,s[14]=x*O+M*k+d*V+p*ne,s[3]=v*T+A*L+y*I+R*ce,s[7]=v*g+A*D+y*W+R*$,s[11]=v*w+A*G+y*Y+R*Q,s[15]=v*O+A*k+y*V+R*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],c=e[9],l=e[13],h=e[2],f=e[6],u=e[10],m=e[14],x=e[3],M=e[7],d=e[11],p=e[15],v=c*m-l*u,A=a*m-l*f,y=a*u-c*f,R=o*m-l*h,T=o*u-c*h,g=o*f-a*h;return t*(M*v-d*A+p*y)-i*(x*v-d*R+p*T)+r*(x*A-M*R+p*g)-s*(x*y-M*T+d*g)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],c=e[2],l=e[6],h=e[10];return t*(o*h-a*l)-i*(s*h-a*c)+r*(s*l-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],f=e[9],u=e[10],m=e[11],x=e[12],M=e[13],d=e[14],p=e[15],v=t*a-i*o,A=t*c-r*o,y=t*l-s*o,R=i*c-r*a,T=i*l-s*a,g=r*l-s*c,w=h*M-f*x,O=h*d-u*x,L=h*p-m*x,D=f*d-u*M,G=f*p-m*M,k=u*p-m*d,I=v*k-A*G+y*D+R*L-T*O+g*w;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/I;return e[0]=(a*k-c*G+l*D)*W,e[1]=(r*G-i*k-s*D)*W,e[2]=(M*g-d*T+p*R)*W,e[3]=(u*T-f*g-m*R)*W,e[4]=(c*L-o*k-l*O)*W,e[5]=(t*k-r*L+s*O)*W,e[6]=(d*y-x*g-p*A)*W,e[7]=(h*g-u*y+m*A)*W,e[8]=(o*G-a*L+l*w)*W,e[9]=(i*L-t*G-s*w)*W,e[10]=(x*T-M*y+p*v)*W,e[11]=(f*y-h*T-m*v)*W,e[12]=(a*O-o*D-c*w)*W,e[13]=(t*D-i*O+r*w)*W,e[14]=(M*A-x*R-d*v)*W,e[15]=(h*R-f*A+u*v)*W,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,c=e.z,l=s*o,h=s*a;return this.set(l*o+i,l*a-r*c,l*c+r*a,0,l*a+r*c,h*a+i,h*c-r*o,0,l*c-r*a,h*c+r*o,s*c*c+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,c=t._w,l=s+s,h=o+o,f=a+a,u=s*l,m=s*h,x=s*f,M=o*h,d=o*f,p=a*f,v=c*l,A=c*h,y=c*f,R=i.x,T=i.y,g=i.z;return r[0]=(1-(M+p))*R,r[1]=(m+y)*R,r[2]=(x-A)*R,r[3]=0,r[4]=(m-y)*T,r[5]=(1-(u+p))*T,r[6]=(d+v)*T,r[7]=0,r[8]=(x+A)*g,r[9]=(d-v)*g,r[10]=(1-(u+M))*g,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=oo.set(r[0],r[1],r[2]).length(),a=oo.set(r[4],r[5],r[6]).length(),c=oo.set(r[8],r[9],r[10]).length();s<0&&(o=-o),Vn.copy(this);let l=1/o,h=1/a,f=1/c;return Vn.elements[0]*=l,Vn.elements[1]*=l,Vn.elements[2]*=l,Vn.elements[4]*=h,Vn.elements[5]*=h,Vn.elements[6]*=h,Vn.elements[8]*=f,Vn.elements[9]*=f,Vn.elements[10]*=f,t.setFromRotationMatrix(Vn),i.x=o,i.y=a,i.z=c,this}makePerspective(e,t,i,r,s,o,a=Fi,c=!1){let l=this.elements,h=2*s/(t-e),f=2*s/(i-r),u=(t+e)/(t-e),m=(i+r)/(i-r),x,M;if(c)x=s/(o-s),M=o*s/(o-s);else if(a===Fi)x=-(o+s)/(o-s),M=-2*o*s/(o-s);else if(a===gr)x=-o/(o-s),M=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=f,l[9]=m,l[13]=0,l[2]=0,l[6]=0,l[10]=x,l[14]=M,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=Fi,c=!1){let l=this.elements,h=2/(t-e),f=2/(i-r),u=-(t+e)/(t-e),m=-(i+r)/(i-r),x,M;if(c)x=1/(o-s),M=o/(o-s);else if(a===Fi)x=-2/(o-s),M=-(o+s)/(o-s);else if(a===gr)x=-1/(o-s),M=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=u,l[1]=0,l[5]=f,l[9]=0,l[13]=m,l[2]=0,l[6]=0,l[10]=x,l[14]=M,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},oo=new U,Vn=new Ie,rS=new U(0,0,0),sS=new U(1,1,1),Br=new U,cc=new U,Mn=new U;var sm=new Ie,om=new Wt,Pn=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],c=r[1],l=r[5],h=r[9],f=r[2],u=r[6],m=r[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(u,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,s),this._z=0);break;case"ZXY":this._x=Math.asin(ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-f,m),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,s));break;case"ZYX":this._y=Math.asin(-ct(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(u,m),this._z=Math.atan2(c,s)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ct(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-f,s)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,l),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-h,m),this._y=0);break;default:ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return sm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(sm,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return om.setFromEuler(this),this.setFromQuaternion(om,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Pn.DEFAULT_ORDER="XYZ";var Gr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}};var oS=0,am=new U,ao=new Wt,xr=new Ie,fc=new U,ka=new U,aS=new U,lS=new Wt,lm=new U(1,0,0),cm=new U(0,1,0),fm=new U(0,0,1),um={type:"added"},cS={type:"removed"},lo={type:"childadded",child:null},Su={type:"childremoved",child:null},Kt=class n extends Hi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:oS++}),this.uuid=nr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new U,t=new Pn,i=new Wt,r=new U(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new Ie},normalMatrix:{value:new Ke}}),this.matrix=new Ie,this.matrixWorld=new Ie,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Gr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ao.setFromAxisAngle(e,t),this.quaternion.multiply(ao),this}rotateOnWorldAxis(e,t){return ao.setFromAxisAngle(e,t),this.quaternion.premultiply(ao),this}rotateX(e){return this.rotateOnAxis(lm,e)}rotateY(e){return this.rotateOnAxis(cm,e)}rotateZ(e){return this.rotateOnAxis(fm,e)}translateOnAxis(e,t){return am.copy(e).applyQuaternion(this.quaternion),this.position.add(am.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(lm,e)}translateY(e){return this.translateOnAxis(cm,e)}translateZ(e){return this.translateOnAxis(fm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(xr.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?fc.copy(e):fc.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),ka.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?xr.lookAt(ka,fc,this.up):xr.lookAt(fc,ka,this.up),this.quaternion.setFromRotationMatrix(xr),r&&(xr.extractRotation(r.matrixWorld),ao.setFromRotationMatrix(xr),this.quaternion.premultiply(ao.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ht("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(um),lo.child=e,this.dispatchEvent(lo),lo.child=null):ht("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(cS),Su.child=e,this.dispatchEvent(Su),Su.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),xr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),xr.multiply(e.parent.matrixWorld)),e.applyMatrix4(xr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(um),lo.child=e,this.dispatchEvent(lo),lo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ka,e,aS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ka,lS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let f=c[l];s(e.shapes,f)}else s(e.shapes,c)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(s(e.materials,this.material[c]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];r.animations.push(s(e.animations,c))}}if(t){let a=o(e.geometries),c=o(e.materials),l=o(e.textures),h=o(e.images),f=o(e.shapes),u=o(e.skeletons),m=o(e.animations),x=o(e.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),h.length>0&&(i.images=h),f.length>0&&(i.shapes=f),u.length>0&&(i.skeletons=u),m.length>0&&(i.animations=m),x.length>0&&(i.nodes=x)}return i.object=r,i;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Kt.DEFAULT_UP=new U(0,1,0);Kt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Kt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Sn=class extends Kt{constructor(){super(),this.isGroup=!0,this.type="Group"}};var fS={type:"move"},co=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Sn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Sn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Sn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){o=!0;for(let M of e.hand.values()){let d=t.getJointPose(M,i),p=this._getHandJoint(l,M);d!==null&&(p.matrix.fromArray(d.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=d.radius),p.visible=d!==null}let h=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],u=h.position.distanceTo(f.position),m=.02,x=.005;l.inputState.pinching&&u>m+x?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&u<=m-x&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(c.matrix.fromArray(s.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,s.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(s.linearVelocity)):c.hasLinearVelocity=!1,s.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(s.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(fS)))}return a!==null&&(a.visible=r!==null),c!==null&&(c.visible=s!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Sn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}};var hm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},zr={h:0,s:0,l:0},uc={h:0,s:0,l:0};function yu(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Xe=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=en){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,ot.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=ot.workingColorSpace){return this.r=e,this.g=t,this.b=i,ot.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=ot.workingColorSpace){if(e=Qp(e,1),t=ct(t,0,1),i=ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=yu(o,s,e+1/3),this.g=yu(o,s,e),this.b=yu(o,s,e-1/3)}return ot.colorSpaceToWorking(this,r),this}setStyle(e,t=en){function i(s){s!==void 0&&parseFloat(s)<1&&ke("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:ke("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=en){let i=hm[e.toLowerCase()];return i!==void 0?this.setHex(i,t):ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Hn(e.r),this.g=Hn(e.g),this.b=Hn(e.b),this}copyLinearToSRGB(e){return this.r=hs(e.r),this.g=hs(e.g),this.b=hs(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=en){return ot.workingToColorSpace(Wi.copy(this),e),Math.round(ct(Wi.r*255,0,255))*65536+Math.round(ct(Wi.g*255,0,255))*256+Math.round(ct(Wi.b*255,0,255))}getHexString(e=en){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=ot.workingColorSpace){ot.workingToColorSpace(Wi.copy(this),t);let i=Wi.r,r=Wi.g,s=Wi.b,o=Math.max(i,r,s),a=Math.min(i,r,s),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let f=o-a;switch(l=h<=.5?f/(o+a):f/(2-o-a),o){case i:c=(r-s)/f+(r<s?6:0);break;case r:c=(s-i)/f+2;break;case s:c=(i-r)/f+4;break}c/=6}return e.h=c,e.s=l,e.l=h,e}getRGB(e,t=ot.workingColorSpace){return ot.workingToColorSpace(Wi.copy(this),t),e.r=Wi.r,e.g=Wi.g,e.b=Wi.b,e}getStyle(e=en){ot.workingToColorSpace(Wi.copy(this),e);let t=Wi.r,i=Wi.g,r=Wi.b;return e!==en?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(zr),this.setHSL(zr.h+e,zr.s+t,zr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(zr),e.getHSL(uc);let i=rc(zr.h,uc.h,t),r=rc(zr.s,uc.s,t),s=rc(zr.l,uc.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Wi=new Xe;Xe.NAMES=hm;var fo=class extends Kt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Pn,this.environmentIntensity=1,this.environmentRotation=new Pn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}};var Wn=new U,_r=new U,bu=new U,vr=new U,uo=new U,ho=new U,dm=new U,Eu=new U,wu=new U,Tu=new U,Au=new bt,Ru=new bt,Cu=new bt,kr=class n{constructor(e=new U,t=new U,i=new U){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),Wn.subVectors(e,t),r.cross(Wn);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){Wn.subVectors(r,t),_r.subVectors(i,t),bu.subVectors(e,t);let o=Wn.dot(Wn),a=Wn.dot(_r),c=Wn.dot(bu),l=_r.dot(_r),h=_r.dot(bu),f=o*l-a*a;if(f===0)return s.set(0,0,0),null;let u=1/f,m=(l*c-a*h)*u,x=(o*h-a*c)*u;return s.set(1-m-x,x,m)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,vr)===null?!1:vr.x>=0&&vr.y>=0&&vr.x+vr.y<=1}static getInterpolation(e,t,i,r,s,o,a,c){return this.getBarycoord(e,t,i,r,vr)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(s,vr.x),c.addScaledVector(o,vr.y),c.addScaledVector(a,vr.z),c)}static getInterpolatedAttribute(e,t,i,r,s,o){return Au.setScalar(0),Ru.setScalar(0),Cu.setScalar(0),Au.fromBufferAttribute(e,t),Ru.fromBufferAttribute(e,i),Cu.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(Au,s.x),o.addScaledVector(Ru,s.y),o.addScaledVector(Cu,s.z),o}static isFrontFacing(e,t,i,r){return Wn.subVectors(i,t),_r.subVectors(e,t),Wn.cross(_r).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Wn.subVectors(this.c,this.b),_r.subVectors(this.a,this.b),Wn.cross(_r).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;uo.subVectors(r,i),ho.subVectors(s,i),Eu.subVectors(e,i);let c=uo.dot(Eu),l=ho.dot(Eu);if(c<=0&&l<=0)return t.copy(i);wu.subVectors(e,r);let h=uo.dot(wu),f=ho.dot(wu);if(h>=0&&f<=h)return t.copy(r);let u=c*f-h*l;if(u<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),t.copy(i).addScaledVector(uo,o);Tu.subVectors(e,s);let m=uo.dot(Tu),x=ho.dot(Tu);if(x>=0&&m<=x)return t.copy(s);let M=m*l-c*x;if(M<=0&&l>=0&&x<=0)return a=l/(l-x),t.copy(i).addScaledVector(ho,a);let d=h*x-m*f;if(d<=0&&f-h>=0&&m-x>=0)return dm.subVectors(s,r),a=(f-h)/(f-h+(m-x)),t.copy(r).addScaledVector(dm,a);let p=1/(d+M+u);return o=M*p,a=u*p,t.copy(i).addScaledVector(uo,o).addScaledVector(ho,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}};var Ln=class{constructor(e=new U(1/0,1/0,1/0),t=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Xn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Xn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Xn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Xn):Xn.fromBufferAttribute(s,o),Xn.applyMatrix4(e.matrixWorld),this.expandByPoint(Xn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),hc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),hc.copy(i.boundingBox)),hc.applyMatrix4(e.matrixWorld),this.union(hc)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Xn),Xn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ha),dc.subVectors(this.max,Ha),po.subVectors(e.a,Ha),mo.subVectors(e.b,Ha),go.subVectors(e.c,Ha),Hr.subVectors(mo,po),Vr.subVectors(go,mo),ds.subVectors(po,go);let t=[0,-Hr.z,Hr.y,0,-Vr.z,Vr.y,0,-ds.z,ds.y,Hr.z,0,-Hr.x,Vr.z,0,-Vr.x,ds.z,0,-ds.x,-Hr.y,Hr.x,0,-Vr.y,Vr.x,0,-ds.y,ds.x,0];return!Pu(t,po,mo,go,dc)||(t=[1,0,0,0,1,0,0,0,1],!Pu(t,po,mo,go,dc))?!1:(pc.crossVectors(Hr,Vr),t=[pc.x,pc.y,pc.z],Pu(t,po,mo,go,dc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Xn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Xn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Mr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Mr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Mr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Mr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Mr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Mr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Mr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Mr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Mr),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Mr=[new U,new U,new U,new U,new U,new U,new U,new U],Xn=new U,hc=new Ln,po=new U,mo=new U,go=new U,Hr=new U,Vr=new U,ds=new U,Ha=new U,dc=new U,pc=new U,ps=new U;function Pu(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){ps.fromArray(n,s);let a=r.x*Math.abs(ps.x)+r.y*Math.abs(ps.y)+r.z*Math.abs(ps.z),c=e.dot(ps),l=t.dot(ps),h=i.dot(ps);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var _i=new U,mc=new Ze,uS=0,Zt=class extends Hi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:uS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Xp,this.updateRanges=[],this.gpuType=li,this.version=0,this._normalizationScale=e!==void 0?sc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)mc.fromBufferAttribute(this,t),mc.applyMatrix3(e),this.setXY(t,mc.x,mc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyMatrix3(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyMatrix4(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyNormalMatrix(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.transformDirection(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):em(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):tm(e,this.array)}};var xo=class extends Zt{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var _o=class extends Zt{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Ft=class extends Zt{constructor(e,t,i){super(new Float32Array(e),t,i)}};var hS=new Ln,Va=new U,Lu=new U,on=class{constructor(e=new U,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):hS.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Va.subVectors(e,this.center);let t=Va.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(Va,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Lu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Va.copy(e.center).add(Lu)),this.expandByPoint(Va.copy(e.center).sub(Lu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}};var dS=0,Dn=new Ie,Du=new Kt,vo=new U,yn=new Ln,Wa=new Ln,Ni=new U,Qt=class n extends Hi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:dS++}),this.uuid=nr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Yp(e)?_o:xo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new Ke().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Dn.makeRotationFromQuaternion(e),this.applyMatrix4(Dn),this}rotateX(e){return Dn.makeRotationX(e),this.applyMatrix4(Dn),this}rotateY(e){return Dn.makeRotationY(e),this.applyMatrix4(Dn),this}rotateZ(e){return Dn.makeRotationZ(e),this.applyMatrix4(Dn),this}translate(e,t,i){return Dn.makeTranslation(e,t,i),this.applyMatrix4(Dn),this}scale(e,t,i){return Dn.makeScale(e,t,i),this.applyMatrix4(Dn),this}lookAt(e){return Du.lookAt(e),Du.updateMatrix(),this.applyMatrix4(Du.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(vo).negate(),this.translate(vo.x,vo.y,vo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ft(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ln);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ht("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];yn.setFromBufferAttribute(s),this.morphTargetsRelative?(Ni.addVectors(this.boundingBox.min,yn.min),this.boundingBox.expandByPoint(Ni),Ni.addVectors(this.boundingBox.max,yn.max),this.boundingBox.expandByPoint(Ni)):(this.boundingBox.expandByPoint(yn.min),this.boundingBox.expandByPoint(yn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ht('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new on);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ht("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(e){let i=this.boundingSphere.center;if(yn.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];Wa.setFromBufferAttribute(a),this.morphTargetsRelative?(Ni.addVectors(yn.min,Wa.min),yn.expandByPoint(Ni),Ni.addVectors(yn.max,Wa.max),yn.expandByPoint(Ni)):(yn.expandByPoint(Wa.min),yn.expandByPoint(Wa.max))}yn.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)Ni.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(Ni));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)Ni.fromBufferAttribute(a,l),c&&(vo.fromBufferAttribute(e,l),Ni.add(vo)),r=Math.max(r,i.distanceToSquared(Ni))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&ht('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ht("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Zt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let O=0;O<i.count;O++)a[O]=new U,c[O]=new U;let h=new U,f=new U,u=new U,m=new Ze,x=new Ze,M=new Ze,d=new U,p=new U;function v(O,L,D){l[O]=l[L]=l[D]=1,h.fromBufferAttribute(i,O),f.fromBufferAttribute(i,L),u.fromBufferAttribute(i,D),m.fromBufferAttribute(s,O),x.fromBufferAttribute(s,L),M.fromBufferAttribute(s,D),f.sub(h),u.sub(h),x.sub(m),M.sub(m);let G=1/(x.x*M.y-M.x*x.y);isFinite(G)&&(d.copy(f).multiplyScalar(M.y).addScaledVector(u,-x.y).multiplyScalar(G),p.copy(u).multiplyScalar(x.x).addScaledVector(f,-M.x).multiplyScalar(G),a[O].add(d),a[L].add(d),a[D].add(d),c[O].add(p),c[L].add(p),c[D].add(p))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let O=0,L=A.length;O<L;++O){let D=A[O],G=D.start,k=D.count;for(let I=G,W=G+k;I<W;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let y=new U,R=new U,T=new U,g=new U;function w(O){T.fromBufferAttribute(r,O),g.copy(T);let L=a[O];y.copy(L),y.sub(T.multiplyScalar(T.dot(L))).normalize(),R.crossVectors(g,L);let G=R.dot(c[O])<0?-1:1;o.setXYZW(O,y.x,y.y,y.z,G)}for(let O=0,L=i.count;O<L;++O)l[O]&&w(O);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Zt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let u=0,m=i.count;u<m;u++)i.setXYZ(u,0,0,0);let r=new U,s=new U,o=new U,a=new U,c=new U,l=new U,h=new U,f=new U;if(e)for(let u=0,m=e.count;u<m;u+=3){let x=e.getX(u+0),M=e.getX(u+1),d=e.getX(u+2);r.fromBufferAttribute(t,x),s.fromBufferAttribute(t,M),o.fromBufferAttribute(t,d),h.subVectors(o,s),f.subVectors(r,s),h.cross(f),a.fromBufferAttribute(i,x),c.fromBufferAttribute(i,M),l.fromBufferAttribute(i,d),a.add(h),c.add(h),l.add(h),i.setXYZ(x,a.x,a.y,a.z),i.setXYZ(M,c.x,c.y,c.z),i.setXYZ(d,l.x,l.y,l.z)}else for(let u=0,m=t.count;u<m;u+=3)r.fromBufferAttribute(t,u+0),s.fromBufferAttribute(t,u+1),o.fromBufferAttribute(t,u+2),h.subVectors(o,s),f.subVectors(r,s),h.cross(f),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Ni.fromBufferAttribute(e,t),Ni.normalize(),e.setXYZ(t,Ni.x,Ni.y,Ni.z)}toNonIndexed(){function e(a,c){let l=a.array,h=a.itemSize,f=a.normalized,u=new l.constructor(c.length*h),m=0,x=0;for(let M=0,d=c.length;M<d;M++){a.isInterleavedBufferAttribute?m=c[M]*a.data.stride+a.offset:m=c[M]*h;for(let p=0;p<h;p++)u[x++]=l[m++]}return new Zt(u,h,f)}if(this.index===null)return ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let c=r[a],l=e(c,i);t.setAttribute(a,l)}let s=this.morphAttributes;for(let a in s){let c=[],l=s[a];for(let h=0,f=l.length;h<f;h++){let u=l[h],m=e(u,i);c.push(m)}t.morphAttributes[a]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let c in i){let l=i[c];e.data.attributes[c]=l.toJSON(e.data)}let r={},s=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let f=0,u=l.length;f<u;f++){let m=l[f];h.push(m.toJSON(e.data))}h.length>0&&(r[c]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let l in r){let h=r[l];this.setAttribute(l,h.clone(t))}let s=e.morphAttributes;for(let l in s){let h=[],f=s[l];for(let u=0,m=f.length;u<m;u++)h.push(f[u].clone(t));this.morphAttributes[l]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let l=0,h=o.length;l<h;l++){let f=o[l];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Nu=new U,pS=new U,mS=new Ke,Xi=class{constructor(e=new U(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=Nu.subVectors(i,t).cross(pS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(Nu),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||mS.getNormalMatrix(e),r=this.coplanarPoint(Nu).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}};var gS=0,Nn=class extends Hi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:gS++}),this.uuid=nr(),this.name="",this.type="Material",this.blending=Nr,this.side=nn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ul,this.blendDst=Fl,this.blendEquation=Ir,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Xe(0,0,0),this.blendAlpha=0,this.depthFunc=Ur,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Gp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=jl,this.stencilZFail=jl,this.stencilZPass=jl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){ke(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let c=s[a];delete c.metadata,o.push(c)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Xe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Xi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ze().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ze().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Sr=new U,Iu=new U,gc=new U,xc=new U,Mo=class{constructor(e=new U,t=new U(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Sr)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Sr.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Sr.copy(this.origin).addScaledVector(this.direction,t),Sr.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){Iu.copy(e).add(t).multiplyScalar(.5),gc.copy(t).sub(e).normalize(),xc.copy(this.origin).sub(Iu);let s=e.distanceTo(t)*.5,o=-this.direction.dot(gc),a=xc.dot(this.direction),c=-xc.dot(gc),l=xc.lengthSq(),h=Math.abs(1-o*o),f,u,m,x;if(h>0)if(f=o*c-a,u=o*a-c,x=s*h,f>=0)if(u>=-x)if(u<=x){let M=1/h;f*=M,u*=M,m=f*(f+o*u+2*a)+u*(o*f+u+2*c)+l}else u=s,f=Math.max(0,-(o*u+a)),m=-f*f+u*(u+2*c)+l;else u=-s,f=Math.max(0,-(o*u+a)),m=-f*f+u*(u+2*c)+l;else u<=-x?(f=Math.max(0,-(-o*s+a)),u=f>0?-s:Math.min(Math.max(-s,-c),s),m=-f*f+u*(u+2*c)+l):u<=x?(f=0,u=Math.min(Math.max(-s,-c),s),m=u*(u+2*c)+l):(f=Math.max(0,-(o*s+a)),u=f>0?s:Math.min(Math.max(-s,-c),s),m=-f*f+u*(u+2*c)+l);else u=o>0?-s:s,f=Math.max(0,-(o*u+a)),m=-f*f+u*(u+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,f),r&&r.copy(Iu).addScaledVector(gc,u),m}intersectSphere(e,t){if(e.radius<0)return null;Sr.subVectors(e.center,this.origin);let i=Sr.dot(this.direction),r=Sr.dot(Sr)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,c,l=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,u=this.origin;return l>=0?(i=(e.min.x-u.x)*l,r=(e.max.x-u.x)*l):(i=(e.max.x-u.x)*l,r=(e.min.x-u.x)*l),h>=0?(s=(e.min.y-u.y)*h,o=(e.max.y-u.y)*h):(s=(e.max.y-u.y)*h,o=(e.min.y-u.y)*h),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),f>=0?(a=(e.min.z-u.z)*f,c=(e.max.z-u.z)*f):(a=(e.max.z-u.z)*f,c=(e.min.z-u.z)*f),i>c||a>r)||((a>i||i!==i)&&(i=a),(c<r||r!==r)&&(r=c),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,Sr)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,f=e.x-o.x,u=e.y-o.y,m=e.z-o.z,x=t.x-o.x,M=t.y-o.y,d=t.z-o.z,p=i.x-o.x,v=i.y-o.y,A=i.z-o.z,y=Math.abs(c),R=Math.abs(l),T=Math.abs(h),g,w,O,L,D,G,k,I,W,Y,V,ce;if(y>=R&&y>=T?(O=c,G=f,W=x,ce=p,c>=0?(g=l,w=h,L=u,D=m,k=M,I=d,Y=v,V=A):(g=h,w=l,L=m,D=u,k=d,I=M,Y=A,V=v)):R>=T?(O=l,G=u,W=M,ce=v,l>=0?(g=h,w=c,L=m,D=f,k=d,I=x,Y=A,V=p):(g=c,w=h,L=f,D=m,k=x,I=d,Y=p,V=A)):(O=h,G=m,W=d,ce=A,h>=0?(g=c,w=l,L=f,D=u,k=x,I=M,Y=p,V=v):(g=l,w=c,L=u,D=f,k=M,I=x,Y=v,V=p)),O===0)return null;let $=g/O,Q=w/O,ne=1/O,he=L-$*G,ue=D-Q*G,j=k-$*W,me=I-Q*W,_e=Y-$*ce,Ae=V-Q*ce,ye=_e*me-Ae*j,qe=he*Ae-ue*_e,rt=j*ue-me*he;if(r){if(ye<0||qe<0||rt<0)return null}else if((ye<0||qe<0||rt<0)&&(ye>0||qe>0||rt>0))return null;let Ve=ye+qe+rt;if(Ve===0)return null;let dt=ne*(ye*G+qe*W+rt*ce);return(Ve>0?dt<0:dt>0)?null:this.at(dt/Ve,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}};var _c=class extends Nn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=Ws,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var pm=new Ie,ms=new Mo,vc=new on,mm=new U,Mc=new U,Sc=new U,yc=new U,Uu=new U,bc=new U,gm=new U,Ec=new U,Ot=class extends Kt{constructor(e=new Qt,t=new _c){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){bc.set(0,0,0);for(let c=0,l=s.length;c<l;c++){let h=a[c],f=s[c];h!==0&&(Uu.fromBufferAttribute(f,e),o?bc.addScaledVector(Uu,h):bc.addScaledVector(Uu.sub(t),h))}t.add(bc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),vc.copy(i.boundingSphere),vc.applyMatrix4(s),ms.copy(e.ray).recast(e.near),!(vc.containsPoint(ms.origin)===!1&&(ms.intersectSphere(vc,mm)===null||ms.origin.distanceToSquared(mm)>(e.far-e.near)**2))&&(pm.copy(s).invert(),ms.copy(e.ray).applyMatrix4(pm),!(i.boundingBox!==null&&ms.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,ms)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,c=s.attributes.position,l=s.attributes.uv,h=s.attributes.uv1,f=s.attributes.normal,u=s.groups,m=s.drawRange;if(a!==null)if(Array.isArray(o))for(let x=0,M=u.length;x<M;x++){let d=u[x],p=o[d.materialIndex],v=Math.max(d.start,m.start),A=Math.min(a.count,Math.min(d.start+d.count,m.start+m.count));for(let y=v,R=A;y<R;y+=3){let T=a.getX(y),g=a.getX(y+1),w=a.getX(y+2);r=wc(this,p,e,i,l,h,f,T,g,w),r&&(r.faceIndex=Math.floor(y/3),r.face.materialIndex=d.materialIndex,t.push(r))}}else{let x=Math.max(0,m.start),M=Math.min(a.count,m.start+m.count);for(let d=x,p=M;d<p;d+=3){let v=a.getX(d),A=a.getX(d+1),y=a.getX(d+2);r=wc(this,o,e,i,l,h,f,v,A,y),r&&(r.faceIndex=Math.floor(d/3),t.push(r))}}else if(c!==void 0)if(Array.isArray(o))for(let x=0,M=u.length;x<M;x++){let d=u[x],p=o[d.materialIndex],v=Math.max(d.start,m.start),A=Math.min(c.count,Math.min(d.start+d.count,m.start+m.count));for(let y=v,R=A;y<R;y+=3){let T=y,g=y+1,w=y+2;r=wc(this,p,e,i,l,h,f,T,g,w),r&&(r.faceIndex=Math.floor(y/3),r.face.materialIndex=d.materialIndex,t.push(r))}}else{let x=Math.max(0,m.start),M=Math.min(c.count,m.start+m.count);for(let d=x,p=M;d<p;d+=3){let v=d,A=d+1,y=d+2;r=wc(this,o,e,i,l,h,f,v,A,y),r&&(r.faceIndex=Math.floor(d/3),t.push(r))}}}};function xS(n,e,t,i,r,s,o,a){let c;if(e.side===Jt?c=i.intersectTriangle(o,s,r,!0,a):c=i.intersectTriangle(r,s,o,e.side===nn,a),c===null)return null;Ec.copy(a),Ec.applyMatrix4(n.matrixWorld);let l=t.ray.origin.distanceTo(Ec);return l<t.near||l>t.far?null:{distance:l,point:Ec.clone(),object:n}}function wc(n,e,t,i,r,s,o,a,c,l){n.getVertexPosition(a,Mc),n.getVertexPosition(c,Sc),n.getVertexPosition(l,yc);let h=xS(n,e,t,i,Mc,Sc,yc,gm);if(h){let f=new U;kr.getBarycoord(gm,Mc,Sc,yc,f),r&&(h.uv=kr.getInterpolatedAttribute(r,a,c,l,f,new Ze)),s&&(h.uv1=kr.getInterpolatedAttribute(s,a,c,l,f,new Ze)),o&&(h.normal=kr.getInterpolatedAttribute(o,a,c,l,f,new U),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:c,c:l,normal:new U,materialIndex:0};kr.getNormal(Mc,Sc,yc,u.normal),h.face=u,h.barycoord=f}return h}var yr=class extends ci{constructor(e=null,t=1,i=1,r,s,o,a,c,l=Yt,h=Yt,f,u){super(null,o,a,c,l,h,r,s,f,u),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Wr=class extends Zt{constructor(e,t,i,r=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var So=new Ie,xm=new Ie,Tc=[],_m=new Ln,_S=new Ie,Xa=new Ot,qa=new on,Ya=class extends Ot{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Wr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<i;r++)this.setMatrixAt(r,_S)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Ln),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,So),_m.copy(e.boundingBox).applyMatrix4(So),this.boundingBox.union(_m)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new on),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,So),qa.copy(e.boundingSphere).applyMatrix4(So),this.boundingSphere.union(qa)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,r=this.morphTexture.source.data.data,s=i.length+1,o=e*s+1;for(let a=0;a<i.length;a++)i[a]=r[o+a]}raycast(e,t){let i=this.matrixWorld,r=this.count;if(Xa.geometry=this.geometry,Xa.material=this.material,Xa.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),qa.copy(this.boundingSphere),qa.applyMatrix4(i),e.ray.intersectsSphere(qa)!==!1))for(let s=0;s<r;s++){this.getMatrixAt(s,So),xm.multiplyMatrices(i,So),Xa.matrixWorld=xm,Xa.raycast(e,Tc);for(let o=0,a=Tc.length;o<a;o++){let c=Tc[o];c.instanceId=s,c.object=this,t.push(c)}Tc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Wr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,r=i.length+1;this.morphTexture===null&&(this.morphTexture=new yr(new Float32Array(r*this.count),r,this.count,Ks,li));let s=this.morphTexture.source.data.data,o=0;for(let l=0;l<i.length;l++)o+=i[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=r*e;return s[c]=a,s.set(i,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}};var gs=new on,vS=new Ze(.5,.5),Ac=new U,an=class{constructor(e=new Xi,t=new Xi,i=new Xi,r=new Xi,s=new Xi,o=new Xi){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Fi,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],c=s[2],l=s[3],h=s[4],f=s[5],u=s[6],m=s[7],x=s[8],M=s[9],d=s[10],p=s[11],v=s[12],A=s[13],y=s[14],R=s[15];if(r[0].setComponents(l-o,m-h,p-x,R-v).normalize(),r[1].setComponents(l+o,m+h,p+x,R+v).normalize(),r[2].setComponents(l+a,m+f,p+M,R+A).normalize(),r[3].setComponents(l-a,m-f,p-M,R-A).normalize(),i)r[4].setComponents(c,u,d,y).normalize(),r[5].setComponents(l-c,m-u,p-d,R-y).normalize();else if(r[4].setComponents(l-c,m-u,p-d,R-y).normalize(),t===Fi)r[5].setComponents(l+c,m+u,p+d,R+y).normalize();else if(t===gr)r[5].setComponents(c,u,d,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),gs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),gs.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(gs)}intersectsSprite(e){gs.center.set(0,0,0);let t=vS.distanceTo(e.center);return gs.radius=.7071067811865476+t,gs.applyMatrix4(e.matrixWorld),this.intersectsSphere(gs)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(Ac.x=r.normal.x>0?e.max.x:e.min.x,Ac.y=r.normal.y>0?e.max.y:e.min.y,Ac.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(Ac)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var vm=new Ie,Rc=class n{constructor(){this.coordinateSystem=Fi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];vm.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new an),i[r].setFromProjectionMatrix(vm,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new an),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var yo=class extends ci{constructor(e=[],t=ir,i,r,s,o,a,c,l,h){super(e,t,i,r,s,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var bn=class extends ci{constructor(e,t,i=Pi,r,s,o,a=Yt,c=Yt,l,h=sn,f=1){if(h!==sn&&h!==_n)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:f};super(u,r,s,o,a,c,h,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Or(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}};var bo=class extends bn{constructor(e,t=Pi,i=ir,r,s,o=Yt,a=Yt,c,l=sn){let h={width:e,height:e,depth:1},f=[h,h,h,h,h,h];super(e,e,t,i,r,s,o,a,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}};var Eo=class extends ci{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var Xr=class n extends Qt{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let c=[],l=[],h=[],f=[],u=0,m=0;x("z","y","x",-1,-1,i,t,e,o,s,0),x("z","y","x",1,-1,i,t,-e,o,s,1),x("x","z","y",1,1,e,i,t,r,o,2),x("x","z","y",1,-1,e,i,-t,r,o,3),x("x","y","z",1,-1,e,t,i,r,s,4),x("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(c),this.setAttribute("position",new Ft(l,3)),this.setAttribute("normal",new Ft(h,3)),this.setAttribute("uv",new Ft(f,2));function x(M,d,p,v,A,y,R,T,g,w,O){let L=y/g,D=R/w,G=y/2,k=R/2,I=T/2,W=g+1,Y=w+1,V=0,ce=0,$=new U;for(let Q=0;Q<Y;Q++){let ne=Q*D-k;for(let he=0;he<W;he++){let ue=he*L-G;$[M]=ue*v,$[d]=ne*A,$[p]=I,l.push($.x,$.y,$.z),$[M]=0,$[d]=0,$[p]=T>0?1:-1,h.push($.x,$.y,$.z),f.push(he/g),f.push(1-Q/w),V+=1}}for(let Q=0;Q<w;Q++)for(let ne=0;ne<g;ne++){let he=u+ne+W*Q,ue=u+ne+W*(Q+1),j=u+(ne+1)+W*(Q+1),me=u+(ne+1)+W*Q;c.push(he,ue,me),c.push(ue,j,me),ce+=6}a.addGroup(m,ce,O),m+=ce,u+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var wo=class n extends Qt{constructor(e=1,t=1,i=1,r=32,s=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:c};let l=this;r=Math.floor(r),s=Math.floor(s);let h=[],f=[],u=[],m=[],x=0,M=[],d=i/2,p=0;v(),o===!1&&(e>0&&A(!0),t>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new Ft(f,3)),this.setAttribute("normal",new Ft(u,3)),this.setAttribute("uv",new Ft(m,2));function v(){let y=new U,R=new U,T=0,g=(t-e)/i;for(let w=0;w<=s;w++){let O=[],L=w/s,D=L*(t-e)+e;for(let G=0;G<=r;G++){let k=G/r,I=k*c+a,W=Math.sin(I),Y=Math.cos(I);R.x=D*W,R.y=-L*i+d,R.z=D*Y,f.push(R.x,R.y,R.z),y.set(W,g,Y).normalize(),u.push(y.x,y.y,y.z),m.push(k,1-L),O.push(x++)}M.push(O)}for(let w=0;w<r;w++)for(let O=0;O<s;O++){let L=M[O][w],D=M[O+1][w],G=M[O+1][w+1],k=M[O][w+1];(e>0||O!==0)&&(h.push(L,D,k),T+=3),(t>0||O!==s-1)&&(h.push(D,G,k),T+=3)}l.addGroup(p,T,0),p+=T}function A(y){let R=x,T=new Ze,g=new U,w=0,O=y===!0?e:t,L=y===!0?1:-1;for(let G=1;G<=r;G++)f.push(0,d*L,0),u.push(0,L,0),m.push(.5,.5),x++;let D=x;for(let G=0;G<=r;G++){let I=G/r*c+a,W=Math.cos(I),Y=Math.sin(I);g.x=O*Y,g.y=d*L,g.z=O*W,f.push(g.x,g.y,g.z),u.push(0,L,0),T.x=W*.5+.5,T.y=Y*.5*L+.5,m.push(T.x,T.y),x++}for(let G=0;G<r;G++){let k=R+G,I=D+G;y===!0?h.push(I,I+1,k):h.push(I+1,I,k),w+=3}l.addGroup(p,w,y===!0?1:2),p+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Cc=class n extends wo{constructor(e=1,t=1,i=32,r=1,s=!1,o=0,a=Math.PI*2){super(0,e,t,i,r,s,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:r,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var To=class n extends Qt{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),c=Math.floor(r),l=a+1,h=c+1,f=e/a,u=t/c,m=[],x=[],M=[],d=[];for(let p=0;p<h;p++){let v=p*u-o;for(let A=0;A<l;A++){let y=A*f-s;x.push(y,-v,0),M.push(0,0,1),d.push(A/a),d.push(1-p/c)}}for(let p=0;p<c;p++)for(let v=0;v<a;v++){let A=v+l*p,y=v+l*(p+1),R=v+1+l*(p+1),T=v+1+l*p;m.push(A,y,T),m.push(y,R,T)}this.setIndex(m),this.setAttribute("position",new Ft(x,3)),this.setAttribute("normal",new Ft(M,3)),this.setAttribute("uv",new Ft(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Pc=class n extends Qt{constructor(e=1,t=32,i=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let c=Math.min(o+a,Math.PI),l=0,h=[],f=new U,u=new U,m=[],x=[],M=[],d=[];for(let p=0;p<=i;p++){let v=[],A=p/i,y=o+A*a,R=e*Math.cos(y),T=Math.sqrt(e*e-R*R),g=0;p===0&&o===0?g=.5/t:p===i&&c===Math.PI&&(g=-.5/t);for(let w=0;w<=t;w++){let O=w/t,L=r+O*s;f.x=-T*Math.cos(L),f.y=R,f.z=T*Math.sin(L),x.push(f.x,f.y,f.z),u.copy(f).normalize(),M.push(u.x,u.y,u.z),d.push(O+g,1-A),v.push(l++)}h.push(v)}for(let p=0;p<i;p++)for(let v=0;v<t;v++){let A=h[p][v+1],y=h[p][v],R=h[p+1][v],T=h[p+1][v+1];(p!==0||o>0)&&m.push(A,y,T),(p!==i-1||c<Math.PI)&&m.push(y,R,T)}this.setIndex(m),this.setAttribute("position",new Ft(x,3)),this.setAttribute("normal",new Ft(M,3)),this.setAttribute("uv",new Ft(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function br(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(Mm(r))r.isRenderTargetTexture?(ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(Mm(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function qi(n){let e={};for(let t=0;t<n.length;t++){let i=br(n[t]);for(let r in i)e[r]=i[r]}return e}function Mm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Sm(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Lc(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:ot.workingColorSpace}var ym={clone:br,merge:qi};var bm=`
void main() {
gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}
`;var Em=`
void main() {
gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}
`;var tn=class extends Nn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=bm,this.fragmentShader=Em,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=br(e.uniforms),this.uniformsGroups=Sm(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new Xe().setHex(r.value);break;case"v2":this.uniforms[i].value=new Ze().fromArray(r.value);break;case"v3":this.uniforms[i].value=new U().fromArray(r.value);break;case"v4":this.uniforms[i].value=new bt().fromArray(r.value);break;case"m3":this.uniforms[i].value=new Ke().fromArray(r.value);break;case"m4":this.uniforms[i].value=new Ie().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}};var Dc=class extends tn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var xs=class extends Nn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Xe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ga,this.normalScale=new Ze(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=Ws,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Nc=class extends Nn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Op,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}};var Ic=class extends Nn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var Ao=class extends Kt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Xe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Ka=class extends Ao{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Kt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Xe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}};var Fu=new Ie,wm=new U,Tm=new U,Uc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ze(512,512),this.mapType=ai,this.map=null,this.mapPass=null,this.matrix=new Ie,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new an,this._frameExtents=new Ze(1,1),this._viewportCount=1,this._viewports=[new bt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;wm.setFromMatrixPosition(e.matrixWorld),t.position.copy(wm),Tm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Tm),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,r){Fu.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Fu,e.coordinateSystem,e.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,c=r?r.x/s.x:0,l=r?r.y/s.y:0;e.coordinateSystem===gr||e.reversedDepth?t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),t.multiply(Fu)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var Fc=new U,Oc=new Wt,rr=new U,Ro=class extends Kt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ie,this.projectionMatrix=new Ie,this.projectionMatrixInverse=new Ie,this.coordinateSystem=Fi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Fc,Oc,rr),rr.x===1&&rr.y===1&&rr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fc,Oc,rr.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Fc,Oc,rr),rr.x===1&&rr.y===1&&rr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fc,Oc,rr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}};var qr=new U,Am=new Ze,Rm=new Ze,Ii=class extends Ro{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=za*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(nc*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return za*2*Math.atan(Math.tan(nc*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){qr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(qr.x,qr.y).multiplyScalar(-e/qr.z),qr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(qr.x,qr.y).multiplyScalar(-e/qr.z)}getViewSize(e,t){return this.getViewBounds(e,Am,Rm),t.subVectors(Rm,Am)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(nc*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;s+=o.offsetX*r/c,t-=o.offsetY*i/l,r*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Co=class extends Ro{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,c=r-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=l*this.view.offsetX,o=s+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Bc=class extends Uc{constructor(){super(new Co(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}};var Za=class extends Ao{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Kt.DEFAULT_UP),this.updateMatrix(),this.target=new Kt,this.shadow=new Bc}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Po=-90,Lo=1,_s=class extends Kt{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Ii(Po,Lo,e,t);r.layers=this.layers,this.add(r);let s=new Ii(Po,Lo,e,t);s.layers=this.layers,this.add(s);let o=new Ii(Po,Lo,e,t);o.layers=this.layers,this.add(o);let a=new Ii(Po,Lo,e,t);a.layers=this.layers,this.add(a);let c=new Ii(Po,Lo,e,t);c.layers=this.layers,this.add(c);let l=new Ii(Po,Lo,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,c]=t;for(let l of t)this.remove(l);if(e===Fi)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===gr)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,c,l,h]=this.children,f=e.getRenderTarget(),u=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),x=e.xr.enabled;e.xr.enabled=!1;let M=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let d=!1;e.isWebGLRenderer===!0?d=e.state.buffers.depth.getReversed():d=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(i,4,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),i.texture.mipmapsAutoUpdate=M,e.setRenderTarget(i,5,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(f,u,m),e.xr.enabled=x,i.texture.needsPMREMUpdate=!0}};var Gc=class extends Ii{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Cm=new Ie,$a=class{constructor(e,t,i=0,r=1/0){this.ray=new Mo(e,t),this.near=i,this.far=r,this.camera=null,this.layers=new Gr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):ht("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Cm.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Cm),this}intersectObject(e,t=!0,i=[]){return Ou(e,this,i,t),i.sort(Pm),i}intersectObjects(e,t=!0,i=[]){for(let r=0,s=e.length;r<s;r++)Ou(e[r],this,i,t);return i.sort(Pm),i}};function Pm(n,e){return n.distance-e.distance}function Ou(n,e,t,i){let r=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(r=!1),r===!0&&i===!0){let s=n.children;for(let o=0,a=s.length;o<a;o++)Ou(s[o],e,t,!0)}}function Bu(n,e,t,i){let r=MS(i);switch(t){case Jl:return n*e;case Ks:return n*e/r.components*r.byteLength;case Zs:return n*e/r.components*r.byteLength;case vn:return n*e*2/r.components*r.byteLength;case $s:return n*e*2/r.components*r.byteLength;case Ql:return n*e*3/r.components*r.byteLength;case Di:return n*e*4/r.components*r.byteLength;case Js:return n*e*4/r.components*r.byteLength;case Qs:case js:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case eo:case to:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case fa:case ha:return Math.max(n,16)*Math.max(e,8)/4;case ca:case ua:return Math.max(n,8)*Math.max(e,8)/2;case da:case pa:case ga:case xa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case ma:case as:case _a:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case va:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ma:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Sa:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case ya:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case ba:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Ea:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case wa:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Ta:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Aa:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Ra:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Ca:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Pa:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case La:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Da:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Na:case Ia:case Ua:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Fa:case Oa:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ls:case Ba:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function MS(n){switch(n){case ai:case Yl:return{byteLength:1,components:1};case mr:case Kl:case Li:return{byteLength:2,components:1};case qs:case Ys:return{byteLength:2,components:4};case Pi:case Xs:case li:return{byteLength:4,components:1};case Zl:case $l:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function zc(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function Lm(n){let e=new WeakMap;function t(a,c){let l=a.array,h=a.usage,f=l.byteLength,u=n.createBuffer();n.bindBuffer(c,u),n.bufferData(c,l,h),a.onUploadCallback();let m;if(l instanceof Float32Array)m=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)m=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?m=n.HALF_FLOAT:m=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)m=n.SHORT;else if(l instanceof Uint32Array)m=n.UNSIGNED_INT;else if(l instanceof Int32Array)m=n.INT;else if(l instanceof Int8Array)m=n.BYTE;else if(l instanceof Uint8Array)m=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)m=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:u,type:m,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,c,l){let h=c.array,f=c.updateRanges;if(n.bindBuffer(l,a),f.length===0)n.bufferSubData(l,0,h);else{f.sort((m,x)=>m.start-x.start);let u=0;for(let m=1;m<f.length;m++){let x=f[u],M=f[m];M.start<=x.start+x.count+1?x.count=Math.max(x.count,M.start+M.count-x.start):(++u,f[u]=M)}f.length=u+1;for(let m=0,x=f.length;m<x;m++){let M=f[m];n.bufferSubData(l,M.start*h.BYTES_PER_ELEMENT,h,M.start,M.count)}c.clearUpdateRanges()}c.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=e.get(a);c&&(n.deleteBuffer(c.buffer),e.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=e.get(a);if(l===void 0)e.set(a,t(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:r,remove:s,update:o}}var Dm=`
#ifdef USE_ALPHAHASH
if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif
`;var Nm=`
#ifdef USE_ALPHAHASH
const float ALPHA_HASH_SCALE = 0.05;
float hash2D( vec2 value ) {
return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
}
float hash3D( vec3 value ) {
return hash2D( vec2( hash2D( value.xy ), value.z ) );
}
float getAlphaHashThreshold( vec3 position ) {
float maxDeriv = max(
length( dFdx( position.xyz ) ),
length( dFdy( position.xyz ) )
);
float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
vec2 pixScales = vec2(
exp2( floor( log2( pixScale ) ) ),
exp2( ceil( log2( pixScale ) ) )
);
vec2 alpha = vec2(
hash3D( floor( pixScales.x * position.xyz ) ),
hash3D( floor( pixScales.y * position.xyz ) )
);
float lerpFactor = fract( log2( pixScale ) );
float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
float a = min( lerpFactor, 1.0 - lerpFactor );
vec3 cases = vec3(
x * x / ( 2.0 * a * ( 1.0 - a ) ),
( x - 0.5 * a ) / ( 1.0 - a ),
1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
);
float threshold = ( x < ( 1.0 - a ) )
? ( ( x < a ) ? cases.x : cases.y )
: cases.z;
return clamp( threshold , 1.0e-6, 1.0 );
}
#endif
`;var Im=`
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif
`;var Um=`
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif
`;var Fm=`
#ifdef USE_ALPHATEST
#ifdef ALPHA_TO_COVERAGE
diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
if ( diffuseColor.a == 0.0 ) discard;
#else
if ( diffuseColor.a < alphaTest ) discard;
#endif
#endif
`;var Om=`
#ifdef USE_ALPHATEST
uniform float alphaTest;
#endif
`;var Bm=`
#ifdef USE_AOMAP
float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
reflectedLight.indirectDiffuse *= ambientOcclusion;
#if defined( USE_CLEARCOAT )
clearcoatSpecularIndirect *= ambientOcclusion;
#endif
#if defined( USE_SHEEN )
sheenSpecularIndirect *= ambientOcclusion;
#endif
#if defined( USE_ENVMAP ) && defined( STANDARD )
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
#endif
#endif
`;var Gm=`
#ifdef USE_AOMAP
uniform sampler2D aoMap;
uniform float aoMapIntensity;
#endif
`;var zm=`
#ifdef USE_BATCHING
#if ! defined( GL_ANGLE_multi_draw )
#define gl_DrawID _gl_DrawID
uniform int _gl_DrawID;
#endif
uniform highp sampler2D batchingTexture;
uniform highp usampler2D batchingIdTexture;
mat4 getBatchingMatrix( const in float i ) {
int size = textureSize( batchingTexture, 0 ).x;
int j = int( i ) * 4;
int x = j % size;
int y = j / size;
vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
return mat4( v1, v2, v3, v4 );
}
float getIndirectIndex( const in int i ) {
int size = textureSize( batchingIdTexture, 0 ).x;
int x = i % size;
int y = i / size;
return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
}
#endif
#ifdef USE_BATCHING_COLOR
uniform sampler2D batchingColorTexture;
vec4 getBatchingColor( const in float i ) {
int size = textureSize( batchingColorTexture, 0 ).x;
int j = int( i );
int x = j % size;
int y = j / size;
return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
}
#endif
`;var km=`
#ifdef USE_BATCHING
mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif
`;var Hm=`
vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
vPosition = vec3( position );
#endif
`;var Vm=`
vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
vec3 objectTangent = vec3( tangent.xyz );
#endif
`;var Wm=`
float G_BlinnPhong_Implicit(  ) {
return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
vec3 halfDir = normalize( lightDir + viewDir );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( specularColor, 1.0, dotVH );
float G = G_BlinnPhong_Implicit(  );
float D = D_BlinnPhong( shininess, dotNH );
return F * ( G * D );
}
`;var Xm=`
#ifdef USE_IRIDESCENCE
const mat3 XYZ_TO_REC709 = mat3(
3.2404542, -0.9692660,  0.0556434,
-1.5371385,  1.8760108, -0.2040259,
-0.4985314,  0.0415560,  1.0572252
);
vec3 Fresnel0ToIor( vec3 fresnel0 ) {
vec3 sqrtF0 = sqrt( fresnel0 );
return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
}
vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
}
float IorToFresnel0( float transmittedIor, float incidentIor ) {
return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
}
vec3 evalSensitivity( float OPD, vec3 shift ) {
float phase = 2.0 * PI * OPD * 1.0e-9;
vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
xyz /= 1.0685e-7;
vec3 rgb = XYZ_TO_REC709 * xyz;
return rgb;
}
vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
vec3 I;
float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
float cosTheta2Sq = 1.0 - sinTheta2Sq;
if ( cosTheta2Sq < 0.0 ) {
return vec3( 1.0 );
}
float cosTheta2 = sqrt( cosTheta2Sq );
float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
float R12 = F_Schlick( R0, 1.0, cosTheta1 );
float T121 = 1.0 - R12;
float phi12 = 0.0;
if ( iridescenceIOR < outsideIOR ) phi12 = PI;
float phi21 = PI - phi12;
vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );
vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
vec3 phi23 = vec3( 0.0 );
if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
vec3 phi = vec3( phi21 ) + phi23;
vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
vec3 r123 = sqrt( R123 );
vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
vec3 C0 = R12 + Rs;
I = C0;
vec3 Cm = Rs - T121;
for ( int m = 1; m <= 2; ++ m ) {
Cm *= r123;
vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
I += Cm * Sm;
}
return max( I, vec3( 0.0 ) );
}
#endif
`;var qm=`
#ifdef USE_BUMPMAP
uniform sampler2D bumpMap;
uniform float bumpScale;
vec2 dHdxy_fwd() {
vec2 dSTdx = dFdx( vBumpMapUv );
vec2 dSTdy = dFdy( vBumpMapUv );
float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
return vec2( dBx, dBy );
}
vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
vec3 vN = surf_norm;
vec3 R1 = cross( vSigmaY, vN );
vec3 R2 = cross( vN, vSigmaX );
float fDet = dot( vSigmaX, R1 ) * faceDirection;
vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
return normalize( abs( fDet ) * surf_norm - vGrad );
}
#endif
`;var Ym=`
#if NUM_CLIPPING_PLANES > 0
vec4 plane;
#ifdef ALPHA_TO_COVERAGE
float distanceToPlane, distanceGradient;
float clipOpacity = 1.0;
#pragma unroll_loop_start
for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
distanceGradient = fwidth( distanceToPlane ) / 2.0;
clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
if ( clipOpacity == 0.0 ) discard;
}
#pragma unroll_loop_end
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
float unionClipOpacity = 1.0;
#pragma unroll_loop_start
for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
distanceGradient = fwidth( distanceToPlane ) / 2.0;
unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
}
#pragma unroll_loop_end
clipOpacity *= 1.0 - unionClipOpacity;
#endif
diffuseColor.a *= clipOpacity;
if ( diffuseColor.a == 0.0 ) discard;
#else
#pragma unroll_loop_start
for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
}
#pragma unroll_loop_end
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
bool clipped = true;
#pragma unroll_loop_start
for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
}
#pragma unroll_loop_end
if ( clipped ) discard;
#endif
#endif
#endif
`;var Km=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif
`;var Zm=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
#endif
`;var $m=`
#if NUM_CLIPPING_PLANES > 0
vClipPosition = - mvPosition.xyz;
#endif
`;var Jm=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
diffuseColor *= vColor;
#endif
`;var Qm=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
varying vec4 vColor;
#endif
`;var jm=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
varying vec4 vColor;
#endif
`;var eg=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
vColor *= color;
#elif defined( USE_COLOR )
vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif
`;var tg=`
#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
const highp float a = 12.9898, b = 78.233, c = 43758.5453;
highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
float precisionSafeLength( vec3 v ) { return length( v ); }
#else
float precisionSafeLength( vec3 v ) {
float maxComponent = max3( abs( v ) );
return length( v / maxComponent ) * maxComponent;
}
#endif
struct IncidentLight {
vec3 color;
vec3 direction;
bool visible;
};
struct ReflectedLight {
vec3 directDiffuse;
vec3 directSpecular;
vec3 indirectDiffuse;
vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
`;var ig=`
vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
mat3 bm = mat3( batchingMatrix );
transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
transformedNormal = bm * transformedNormal;
#ifdef USE_TANGENT
transformedTangent = bm * transformedTangent;
#endif
#endif
#ifdef USE_INSTANCING
mat3 im = mat3( instanceMatrix );
transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
transformedNormal = im * transformedNormal;
#ifdef USE_TANGENT
transformedTangent = im * transformedTangent;
#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif
`;var ng=`
#ifdef USE_DISPLACEMENTMAP
uniform sampler2D displacementMap;
uniform float displacementScale;
uniform float displacementBias;
#endif
`;var rg=`
#ifdef USE_DISPLACEMENTMAP
transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif
`;var sg=`
#ifdef USE_EMISSIVEMAP
vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
emissiveColor = sRGBTransferEOTF( emissiveColor );
#endif
totalEmissiveRadiance *= emissiveColor.rgb;
#endif
`;var og=`
#ifdef USE_EMISSIVEMAP
uniform sampler2D emissiveMap;
#endif
`;var ag=`
gl_FragColor = linearToOutputTexel( gl_FragColor );
`;var lg=`
vec4 LinearTransferOETF( in vec4 value ) {
return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}
`;var cg=`
#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
vec3 cameraToFrag;
if ( isOrthographic ) {
cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
} else {
cameraToFrag = normalize( vWorldPosition - cameraPosition );
}
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
#ifdef ENVMAP_MODE_REFLECTION
vec3 reflectVec = reflect( cameraToFrag, worldNormal );
#else
vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
#endif
#else
vec3 reflectVec = vReflect;
#endif
#ifdef ENVMAP_TYPE_CUBE
vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
#ifdef ENVMAP_BLENDING_MULTIPLY
outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
#elif defined( ENVMAP_BLENDING_MIX )
outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
#elif defined( ENVMAP_BLENDING_ADD )
outgoingLight += envColor.xyz * specularStrength * reflectivity;
#endif
#endif
#endif
`;var fg=`
#ifdef USE_ENVMAP
uniform float envMapIntensity;
uniform mat3 envMapRotation;
uniform samplerCube envMap;
#ifdef ENVMAP_TYPE_PMREM
float roughnessToMip( const in float roughness ) {
float r = clamp( roughness, 0.0, 1.0 );
return ENVMAP_MAX_LOD * r * ( 2.0 - r );
}
#endif
#endif
`;var ug=`
#ifdef USE_ENVMAP
uniform float reflectivity;
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS
varying vec3 vWorldPosition;
uniform float refractionRatio;
#else
varying vec3 vReflect;
#endif
#endif
`;var hg=`
#ifdef USE_ENVMAP
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS
varying vec3 vWorldPosition;
#else
varying vec3 vReflect;
uniform float refractionRatio;
#endif
#endif
`;var dg=`
#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
vWorldPosition = worldPosition.xyz;
#else
vec3 cameraToVertex;
if ( isOrthographic ) {
cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
} else {
cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
}
vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
#ifdef ENVMAP_MODE_REFLECTION
vReflect = reflect( cameraToVertex, worldNormal );
#else
vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
#endif
#endif
#endif
`;var pg=`
#ifdef USE_FOG
vFogDepth = - mvPosition.z;
#endif
`;var mg=`
#ifdef USE_FOG
varying float vFogDepth;
#endif
`;var gg=`
#ifdef USE_FOG
#ifdef FOG_EXP2
float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
#else
float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
#endif
gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif
`;var xg=`
#ifdef USE_FOG
uniform vec3 fogColor;
varying float vFogDepth;
#ifdef FOG_EXP2
uniform float fogDensity;
#else
uniform float fogNear;
uniform float fogFar;
#endif
#endif
`;var _g=`
#ifdef USE_GRADIENTMAP
uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
float dotNL = dot( normal, lightDirection );
vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
#ifdef USE_GRADIENTMAP
return vec3( texture2D( gradientMap, coord ).r );
#else
vec2 fw = fwidth( coord ) * 0.5;
return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
#endif
}
`;var vg=`
#ifdef USE_LIGHTMAP
uniform sampler2D lightMap;
uniform float lightMapIntensity;
#endif
`;var Mg=`
LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;
`;var Sg=`
varying vec3 vViewPosition;
struct LambertMaterial {
vec3 diffuseColor;
float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert
`;var yg=`
uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
float x = normal.x, y = normal.y, z = normal.z;
vec3 result = shCoefficients[ 0 ] * 0.886227;
result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
vec3 irradiance = ambientLightColor;
return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
if ( cutoffDistance > 0.0 ) {
distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
}
return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
struct SunLight {
vec3 direction;
vec3 color;
};
uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
light.color = sunLight.color;
light.direction = sunLight.direction;
light.visible = true;
}
#endif
#if NUM_DIR_LIGHTS > 0
struct DirectionalLight {
vec3 direction;
vec3 color;
};
uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
light.color = directionalLight.color;
light.direction = directionalLight.direction;
light.visible = true;
}
#endif
#if NUM_POINT_LIGHTS > 0
struct PointLight {
vec3 position;
vec3 color;
float distance;
float decay;
};
uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
vec3 lVector = pointLight.position - geometryPosition;
light.direction = normalize( lVector );
float lightDistance = length( lVector );
light.color = pointLight.color;
light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
light.visible = ( light.color != vec3( 0.0 ) );
}
#endif
#if NUM_SPOT_LIGHTS > 0
struct SpotLight {
vec3 position;
vec3 direction;
vec3 color;
float distance;
float decay;
float coneCos;
float penumbraCos;
};
uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
vec3 lVector = spotLight.position - geometryPosition;
light.direction = normalize( lVector );
float angleCos = dot( light.direction, spotLight.direction );
float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
if ( spotAttenuation > 0.0 ) {
float lightDistance = length( lVector );
light.color = spotLight.color * spotAttenuation;
light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
light.visible = ( light.color != vec3( 0.0 ) );
} else {
light.color = vec3( 0.0 );
light.visible = false;
}
}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
struct RectAreaLight {
vec3 color;
vec3 position;
vec3 halfWidth;
vec3 halfHeight;
};
uniform sampler2D ltc_1;
uniform sampler2D ltc_2;
uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
struct HemisphereLight {
vec3 direction;
vec3 skyColor;
vec3 groundColor;
};
uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
float dotNL = dot( normal, hemiLight.direction );
float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
return irradiance;
}
#endif
#include <lightprobes_pars_fragment>
`;var bg=`
#ifdef USE_ENVMAP
vec3 getIBLIrradiance( const in vec3 normal ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
return PI * envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 reflectVec = reflect( - viewDir, normal );
reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
return envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
#ifdef USE_RETROREFLECTION
vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
return envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
#endif
#ifdef USE_ANISOTROPY
vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 bentNormal = cross( bitangent, viewDir );
bentNormal = normalize( cross( bentNormal, bitangent ) );
bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
return getIBLRadiance( viewDir, bentNormal, roughness );
#else
return vec3( 0.0 );
#endif
}
#ifdef USE_RETROREFLECTION
vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 bentNormal = cross( bitangent, viewDir );
bentNormal = normalize( cross( bentNormal, bitangent ) );
bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
return getIBLRetroRadiance( viewDir, bentNormal, roughness );
#else
return vec3( 0.0 );
#endif
}
#endif
#endif
#endif
`;var Eg=`
ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;
`;var wg=`
varying vec3 vViewPosition;
struct ToonMaterial {
vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon
`;var Tg=`
BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;
`;var Ag=`
varying vec3 vViewPosition;
struct BlinnPhongMaterial {
vec3 diffuseColor;
vec3 specularColor;
float specularShininess;
float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong
`;var Rg=`
PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
float diffuseRoughnessFactor = diffuseRoughness;
#ifdef USE_DIFFUSE_ROUGHNESSMAP
diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
#endif
material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
material.ior = ior;
#ifdef USE_SPECULAR
float specularIntensityFactor = specularIntensity;
vec3 specularColorFactor = specularColor;
#ifdef USE_SPECULAR_COLORMAP
specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
#endif
material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
#else
float specularIntensityFactor = 1.0;
vec3 specularColorFactor = vec3( 1.0 );
material.specularF90 = 1.0;
#endif
material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
material.specularColor = vec3( 0.04 );
material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
material.clearcoat = clearcoat;
material.clearcoatRoughness = clearcoatRoughness;
material.clearcoatF0 = vec3( 0.04 );
material.clearcoatF90 = 1.0;
#ifdef USE_CLEARCOATMAP
material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
#endif
material.clearcoat = saturate( material.clearcoat );
material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
material.clearcoatRoughness += geometryRoughness;
material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
material.iridescence = iridescence;
material.iridescenceIOR = iridescenceIOR;
#ifdef USE_IRIDESCENCEMAP
material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
#else
material.iridescenceThickness = iridescenceThicknessMaximum;
#endif
#endif
#ifdef USE_SHEEN
material.sheenColor = sheenColor;
#ifdef USE_SHEEN_COLORMAP
material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
#endif
material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
#ifdef USE_SHEEN_ROUGHNESSMAP
material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
#endif
#endif
#ifdef USE_ANISOTROPY
#ifdef USE_ANISOTROPYMAP
mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
#else
vec2 anisotropyV = anisotropyVector;
#endif
material.anisotropy = length( anisotropyV );
if( material.anisotropy == 0.0 ) {
anisotropyV = vec2( 1.0, 0.0 );
} else {
anisotropyV /= material.anisotropy;
material.anisotropy = saturate( material.anisotropy );
}
material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif
`;var Cg=`
uniform sampler2D dfgLUT;
struct PhysicalMaterial {
vec3 diffuseColor;
vec3 diffuseContribution;
vec3 specularColor;
vec3 specularColorBlended;
float roughness;
float metalness;
float specularF90;
float dispersion;
vec2 dfg;
vec3 multiScatteringCompensation;
#ifdef USE_DIFFUSE_ROUGHNESS
float diffuseRoughness;
#endif
#ifdef USE_RETROREFLECTION
float retroreflectivity;
#endif
#ifdef USE_CLEARCOAT
float clearcoat;
float clearcoatRoughness;
vec3 clearcoatF0;
float clearcoatF90;
#endif
#ifdef USE_IRIDESCENCE
float iridescence;
float iridescenceIOR;
float iridescenceThickness;
vec3 iridescenceFresnel;
vec3 iridescenceF0Dielectric;
vec3 iridescenceF0Metallic;
#endif
#ifdef USE_SHEEN
vec3 sheenColor;
float sheenRoughness;
#endif
#ifdef IOR
float ior;
#endif
#ifdef USE_TRANSMISSION
float transmission;
float transmissionAlpha;
float thickness;
float attenuationDistance;
vec3 attenuationColor;
#endif
#ifdef USE_ANISOTROPY
float anisotropy;
float alphaT;
vec3 anisotropyT;
vec3 anisotropyB;
#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
float x2 = x * x;
float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
const float EON_EPSILON = 1e-7;
float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
float muComp = 1.0 - mu;
float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
return A * ( 1.0 + roughness * gOverPi );
}
vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
vec3 rho = saturate( diffuseColor );
if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float s = dot( lightDir, viewDir ) - dotNL * dotNV;
float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
* max( EON_EPSILON, 1.0 - albedoV )
* max( EON_EPSILON, 1.0 - albedoL )
/ max( EON_EPSILON, 1.0 - averageAlbedo );
return singleScatter + multiScatter;
}
vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
vec3 rho = saturate( diffuseColor );
if ( roughness <= EON_EPSILON ) return rho;
float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
float a2 = pow2( alpha );
float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
float a2 = pow2( alpha );
float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
float a2 = alphaT * alphaB;
highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
highp float v2 = dot( v, v );
float w2 = a2 / v2;
return RECIPROCAL_PI * a2 * pow2 ( w2 );
}
#endif
#ifdef USE_CLEARCOAT
vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
vec3 f0 = material.clearcoatF0;
float f90 = material.clearcoatF90;
float roughness = max( material.clearcoatRoughness, 0.045 );
float alpha = pow2( roughness );
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( f0, f90, dotVH );
float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
float D = D_GGX( alpha, dotNH );
return F * ( V * D );
}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
vec3 f0 = material.specularColorBlended;
float f90 = material.specularF90;
float roughness = max( material.roughness, 0.045 );
float alpha = pow2( roughness );
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( f0, f90, dotVH );
#ifdef USE_IRIDESCENCE
F = mix( F, material.iridescenceFresnel, material.iridescence );
#endif
#ifdef USE_ANISOTROPY
float dotTL = dot( material.anisotropyT, lightDir );
float dotTV = dot( material.anisotropyT, viewDir );
float dotTH = dot( material.anisotropyT, halfDir );
float dotBL = dot( material.anisotropyB, lightDir );
float dotBV = dot( material.anisotropyB, viewDir );
float dotBH = dot( material.anisotropyB, halfDir );
float alphaT = max( material.alphaT, alpha );
float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
#else
float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
float D = D_GGX( alpha, dotNH );
#endif
return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
const float LUT_SIZE = 64.0;
const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
const float LUT_BIAS = 0.5 / LUT_SIZE;
float dotNV = saturate( dot( N, V ) );
vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
uv = uv * LUT_SCALE + LUT_BIAS;
return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
float l = length( f );
return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
float x = dot( v1, v2 );
float y = abs( x );
float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
float b = 3.4175940 + ( 4.1616724 + y ) * y;
float v = a / b;
float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
vec3 lightNormal = cross( v1, v2 );
if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
vec3 T1, T2;
T1 = normalize( V - N * dot( V, N ) );
T2 = - cross( N, T1 );
mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
vec3 coords[ 4 ];
coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
coords[ 0 ] = normalize( coords[ 0 ] );
coords[ 1 ] = normalize( coords[ 1 ] );
coords[ 2 ] = normalize( coords[ 2 ] );
coords[ 3 ] = normalize( coords[ 3 ] );
vec3 vectorFormFactor = vec3( 0.0 );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
float alpha = pow2( roughness );
float invAlpha = 1.0 / alpha;
float cos2h = dotNH * dotNH;
float sin2h = max( 1.0 - cos2h, 0.0078125 );
return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float D = D_Charlie( sheenRoughness, dotNH );
float V = V_Neubelt( dotNV, dotNL );
return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
float dotNV = saturate( dot( normal, viewDir ) );
float r2 = roughness * roughness;
float rInv = 1.0 / ( roughness + 0.1 );
float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
float DG = exp( a * dotNV + b );
return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
float dotNV = saturate( dot( normal, viewDir ) );
vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
#ifdef USE_IRIDESCENCE
vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
#else
vec3 Fr = specularColor;
#endif
vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
float Ess = fab.x + fab.y;
float Ems = 1.0 - Ess;
vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;
vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
singleScatter += FssEss;
multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
vec3 normal = geometryNormal;
vec3 viewDir = geometryViewDir;
vec3 position = geometryPosition;
vec3 lightPos = rectAreaLight.position;
vec3 halfWidth = rectAreaLight.halfWidth;
vec3 halfHeight = rectAreaLight.halfHeight;
vec3 lightColor = rectAreaLight.color;
float roughness = material.roughness;
vec3 rectCoords[ 4 ];
rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;
rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
vec2 uv = LTC_Uv( normal, viewDir, roughness );
vec4 t1 = texture2D( ltc_1, uv );
vec4 t2 = texture2D( ltc_2, uv );
mat3 mInv = mat3(
vec3( t1.x, 0, t1.y ),
vec3(    0, 1,    0 ),
vec3( t1.z, 0, t1.w )
);
vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
#ifdef USE_CLEARCOAT
vec3 Ncc = geometryClearcoatNormal;
vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
mat3 mInvClearcoat = mat3(
vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
vec3(             0, 1,             0 ),
vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
);
vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
#endif
}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
#ifdef USE_CLEARCOAT
float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
vec3 ccIrradiance = dotNLcc * directLight.color;
clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
#endif
#ifdef USE_SHEEN
sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
irradiance *= sheenEnergyComp;
#endif
vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
#ifdef USE_RETROREFLECTION
vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
#endif
reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
vec3 halfDir = normalize( directLight.direction + geometryViewDir );
float dotVH = saturate( dot( geometryViewDir, halfDir ) );
vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
#ifdef USE_RETROREFLECTION
vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
F = mix( F, retroF, saturate( material.retroreflectivity ) );
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
#else
vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
#endif
reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
vec3 singleScattering = vec3( 0.0 );
vec3 multiScattering = vec3( 0.0 );
#ifdef USE_IRIDESCENCE
computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
#else
computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
#else
vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
#endif
#ifdef USE_SHEEN
float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
diffuse *= sheenEnergyComp;
#endif
reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
#ifdef USE_CLEARCOAT
clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
#endif
#ifdef USE_SHEEN
sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
#endif
vec3 singleScatteringDielectric = vec3( 0.0 );
vec3 multiScatteringDielectric = vec3( 0.0 );
vec3 singleScatteringMetallic = vec3( 0.0 );
vec3 multiScatteringMetallic = vec3( 0.0 );
#ifdef USE_IRIDESCENCE
computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
#else
computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
#endif
vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
#ifdef USE_DIFFUSE_ROUGHNESS
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
#else
vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
#endif
vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
vec3 indirectSpecular = radiance * singleScattering;
indirectSpecular += multiScattering * cosineWeightedIrradiance;
vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
#ifdef USE_SHEEN
float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
indirectSpecular *= sheenEnergyComp;
indirectDiffuse *= sheenEnergyComp;
#endif
reflectedLight.indirectSpecular += indirectSpecular;
reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}
`;var Pg=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
float dotNVi = saturate( dot( normal, geometryViewDir ) );
if ( material.iridescenceThickness == 0.0 ) {
material.iridescence = 0.0;
} else {
material.iridescence = saturate( material.iridescence );
}
if ( material.iridescence > 0.0 ) {
vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
}
#endif
#ifdef STANDARD
float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
float EssMs = material.dfg.x + material.dfg.y;
material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
PointLight pointLight;
#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
PointLightShadow pointLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
pointLight = pointLights[ i ];
getPointLightInfo( pointLight, geometryPosition, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
pointLightShadow = pointLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
SpotLight spotLight;
vec4 spotColor;
vec3 spotLightCoord;
bool inSpotLightMap;
#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
SpotLightShadow spotLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
spotLight = spotLights[ i ];
getSpotLightInfo( spotLight, geometryPosition, directLight );
#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
#else
#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#endif
#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
#endif
#undef SPOT_LIGHT_MAP_INDEX
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
spotLightShadow = spotLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
SunLight sunLight;
#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
SunLightShadow sunLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
sunLight = sunLights[ i ];
getSunLightInfo( sunLight, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
sunLightShadow = sunLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
DirectionalLight directionalLight;
#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
DirectionalLightShadow directionalLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
directionalLight = directionalLights[ i ];
getDirectionalLightInfo( directionalLight, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
directionalLightShadow = directionalLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
RectAreaLight rectAreaLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
rectAreaLight = rectAreaLights[ i ];
RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
vec3 iblIrradiance = vec3( 0.0 );
vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
#if defined( USE_LIGHT_PROBES )
irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
#endif
#if ( NUM_HEMI_LIGHTS > 0 )
#pragma unroll_loop_start
for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
}
#pragma unroll_loop_end
#endif
#if NUM_LIGHT_PROBE_GRIDS > 0
vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
int probeGrid = - 1;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
}
#pragma unroll_loop_end
#pragma unroll_loop_start
for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
}
#pragma unroll_loop_end
#endif
#endif
#if defined( RE_IndirectSpecular )
vec3 radiance = vec3( 0.0 );
vec3 clearcoatRadiance = vec3( 0.0 );
#endif
`;var Lg=`
#if defined( RE_IndirectDiffuse )
#ifdef USE_LIGHTMAP
vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
irradiance += lightMapIrradiance;
#endif
#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
iblIrradiance += getIBLIrradiance( geometryNormal );
#endif
#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
#ifdef USE_ANISOTROPY
vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
#else
vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
#endif
#ifdef USE_RETROREFLECTION
#ifdef USE_ANISOTROPY
vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
#else
vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
#endif
iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
#endif
radiance += iblRadiance;
#ifdef USE_CLEARCOAT
clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
#endif
#endif
`;var Dg=`
#if defined( RE_IndirectDiffuse )
#if defined( LAMBERT ) || defined( PHONG )
irradiance += iblIrradiance;
#endif
RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
`;var Ng=`
#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
vec3 spacing = ( probesMax - probesMin ) / probesResolution;
vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
vec3 margin = spacing * 0.01;
return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
vec3 res = probesResolution;
vec3 gridRange = probesMax - probesMin;
vec3 probeSpacing = gridRange / res;
vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
float nz          = res.z;
float paddedSlices = nz + 2.0;
float atlasDepth  = 7.0 * paddedSlices;
float uvZBase     = uvw.z * nz + 1.0;
vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
vec3 c0 = s0.xyz;
vec3 c1 = vec3( s0.w, s1.xy );
vec3 c2 = vec3( s1.zw, s2.x );
vec3 c3 = s2.yzw;
vec3 c4 = s3.xyz;
vec3 c5 = vec3( s3.w, s4.xy );
vec3 c6 = vec3( s4.zw, s5.x );
vec3 c7 = s5.yzw;
vec3 c8 = s6.xyz;
float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
vec3 result = c0 * 0.886227;
result += c1 * 2.0 * 0.511664 * y;
result += c2 * 2.0 * 0.511664 * z;
result += c3 * 2.0 * 0.511664 * x;
result += c4 * 2.0 * 0.429043 * x * y;
result += c5 * 2.0 * 0.429043 * y * z;
result += c6 * ( 0.743125 * z * z - 0.247708 );
result += c7 * 2.0 * 0.429043 * x * z;
result += c8 * 0.429043 * ( x * x - y * y );
return max( result, vec3( 0.0 ) );
}
#endif
`;var Ig=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif
`;var Ug=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
uniform float logDepthBufFC;
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var Fg=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var Og=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
vFragDepth = 1.0 + gl_Position.w;
vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif
`;var Bg=`
#ifdef USE_MAP
vec4 sampledDiffuseColor = texture2D( map, vMapUv );
#ifdef DECODE_VIDEO_TEXTURE
sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
#endif
diffuseColor *= sampledDiffuseColor;
#endif
`;var Gg=`
#ifdef USE_MAP
uniform sampler2D map;
#endif
`;var zg=`
#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
#if defined( USE_POINTS_UV )
vec2 uv = vUv;
#else
vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
#endif
#endif
#ifdef USE_MAP
diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif
`;var kg=`
#if defined( USE_POINTS_UV )
varying vec2 vUv;
#else
#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
uniform mat3 uvTransform;
#endif
#endif
#ifdef USE_MAP
uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif
`;var Hg=`
float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
metalnessFactor *= texelMetalness.b;
#endif
`;var Vg=`
#ifdef USE_METALNESSMAP
uniform sampler2D metalnessMap;
#endif
`;var Wg=`
#ifdef USE_INSTANCING_MORPH
float morphTargetInfluences[ MORPHTARGETS_COUNT ];
float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
}
#endif
`;var Xg=`
#if defined( USE_MORPHCOLORS )
#if defined( USE_COLOR_ALPHA )
vColor *= morphTargetBaseInfluence;
#elif defined( USE_COLOR )
vColor.rgb *= morphTargetBaseInfluence;
#endif
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
#if defined( USE_COLOR_ALPHA )
if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
#elif defined( USE_COLOR )
if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
#endif
}
#endif
`;var qg=`
#ifdef USE_MORPHNORMALS
objectNormal *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var Yg=`
#ifdef USE_MORPHTARGETS
#ifndef USE_INSTANCING_MORPH
uniform float morphTargetBaseInfluence;
uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
#endif
uniform sampler2DArray morphTargetsTexture;
uniform ivec2 morphTargetsTextureSize;
vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
int y = texelIndex / morphTargetsTextureSize.x;
int x = texelIndex - y * morphTargetsTextureSize.x;
ivec3 morphUV = ivec3( x, y, morphTargetIndex );
return texelFetch( morphTargetsTexture, morphUV, 0 );
}
#endif
`;var Kg=`
#ifdef USE_MORPHTARGETS
transformed *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var Zg=`
float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
vec3 fdx = dFdx( vViewPosition );
vec3 fdy = dFdy( vViewPosition );
vec3 normal = normalize( cross( fdx, fdy ) );
#else
vec3 normal = normalize( vNormal );
#ifdef DOUBLE_SIDED
normal *= faceDirection;
#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
#ifdef USE_TANGENT
mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
#else
mat3 tbn = getTangentFrame( - vViewPosition, normal,
#if defined( USE_NORMALMAP )
vNormalMapUv
#elif defined( USE_CLEARCOAT_NORMALMAP )
vClearcoatNormalMapUv
#else
vUv
#endif
);
#endif
#ifdef DOUBLE_SIDED
tbn[0] *= faceDirection;
tbn[1] *= faceDirection;
#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
#ifdef USE_TANGENT
mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
#else
mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
#endif
#ifdef DOUBLE_SIDED
tbn2[0] *= faceDirection;
tbn2[1] *= faceDirection;
#endif
#endif
vec3 nonPerturbedNormal = normal;
`;var $g=`
#ifdef USE_NORMALMAP_OBJECTSPACE
normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
#ifdef FLIP_SIDED
normal = - normal;
#endif
#ifdef DOUBLE_SIDED
normal = normal * faceDirection;
#endif
normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
#if defined( USE_PACKED_NORMALMAP )
mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
#endif
mapN.xy *= normalScale;
normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif
`;var Jg=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var Qg=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var jg=`
#ifndef FLAT_SHADED
vNormal = normalize( transformedNormal );
#ifdef USE_TANGENT
vTangent = normalize( transformedTangent );
vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
#ifdef FLIP_SIDED
vBitangent = - vBitangent;
#endif
#endif
#endif
`;var e0=`
#ifdef USE_NORMALMAP
uniform sampler2D normalMap;
uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
vec3 q0 = dFdx( eye_pos.xyz );
vec3 q1 = dFdy( eye_pos.xyz );
vec2 st0 = dFdx( uv.st );
vec2 st1 = dFdy( uv.st );
vec3 N = surf_norm;
vec3 q1perp = cross( q1, N );
vec3 q0perp = cross( N, q0 );
vec3 T = q1perp * st0.x + q0perp * st1.x;
vec3 B = q1perp * st0.y + q0perp * st1.y;
float det = max( dot( T, T ), dot( B, B ) );
float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
return mat3( T * scale, B * scale, N );
}
#endif
`;var t0=`
#ifdef USE_CLEARCOAT
vec3 clearcoatNormal = nonPerturbedNormal;
#endif
`;var i0=`
#ifdef USE_CLEARCOAT_NORMALMAP
vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
clearcoatMapN.xy *= clearcoatNormalScale;
clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif
`;var n0=`
#ifdef USE_CLEARCOATMAP
uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
uniform sampler2D clearcoatNormalMap;
uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
uniform sampler2D clearcoatRoughnessMap;
#endif
`;var r0=`
#ifdef USE_IRIDESCENCEMAP
uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform sampler2D iridescenceThicknessMap;
#endif
`;var s0=`
#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );
`;var o0=`
vec3 packNormalToRGB( const in vec3 normal ) {
return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;
const float UnpackDownscale = 255. / 256.;
const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
if( v <= 0.0 )
return vec4( 0., 0., 0., 0. );
if( v >= 1.0 )
return vec4( 1., 1., 1., 1. );
float vuf;
float af = modf( v * PackFactors.a, vuf );
float bf = modf( vuf * ShiftRight8, vuf );
float gf = modf( vuf * ShiftRight8, vuf );
return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
if( v <= 0.0 )
return vec3( 0., 0., 0. );
if( v >= 1.0 )
return vec3( 1., 1., 1. );
float vuf;
float bf = modf( v * PackFactors.b, vuf );
float gf = modf( vuf * ShiftRight8, vuf );
return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
if( v <= 0.0 )
return vec2( 0., 0. );
if( v >= 1.0 )
return vec2( 1., 1. );
float vuf;
float gf = modf( v * 256., vuf );
return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
#ifdef USE_REVERSED_DEPTH_BUFFER
return depth * ( far - near ) - far;
#else
return depth * ( near - far ) - near;
#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
#ifdef USE_REVERSED_DEPTH_BUFFER
return ( near * far ) / ( ( near - far ) * depth - near );
#else
return ( near * far ) / ( ( far - near ) * depth - far );
#endif
}
`;var a0=`
#ifdef PREMULTIPLIED_ALPHA
gl_FragColor.rgb *= gl_FragColor.a;
#endif
`;var l0=`
vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;
`;var c0=`
#ifdef DITHERING
gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif
`;var f0=`
#ifdef DITHERING
vec3 dithering( vec3 color ) {
float grid_position = rand( gl_FragCoord.xy );
vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
return color + dither_shift_RGB;
}
#endif
`;var u0=`
float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
roughnessFactor *= texelRoughness.g;
#endif
`;var h0=`
#ifdef USE_ROUGHNESSMAP
uniform sampler2D roughnessMap;
#endif
`;var d0=`
#if NUM_SPOT_LIGHT_COORDS > 0
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
#define SUN_LIGHT_CASCADES 2
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#else
uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#endif
uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
struct SunLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#else
uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#endif
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#else
uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
struct SpotLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#elif defined( SHADOWMAP_TYPE_BASIC )
uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#endif
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
float shadowCameraNear;
float shadowCameraFar;
};
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float interleavedGradientNoise( vec2 position ) {
return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
}
vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
const float goldenAngle = 2.399963229728653;
float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
float theta = float( sampleIndex ) * goldenAngle + phi;
return vec2( cos( theta ), sin( theta ) ) * r;
}
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
vec2 radius = shadowRadius * texelSize;
float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
shadow = (
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
) * 0.2;
}
return mix( 1.0, shadow, shadowIntensity );
}
#elif defined( SHADOWMAP_TYPE_VSM )
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
float mean = distribution.x;
float variance = distribution.y * distribution.y;
#ifdef USE_REVERSED_DEPTH_BUFFER
float hard_shadow = step( mean, shadowCoord.z );
#else
float hard_shadow = step( shadowCoord.z, mean );
#endif
if ( hard_shadow == 1.0 ) {
shadow = 1.0;
} else {
variance = max( variance, 0.0000001 );
float d = shadowCoord.z - mean;
float p_max = variance / ( variance + d * d );
p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
shadow = max( hard_shadow, p_max );
}
}
return mix( 1.0, shadow, shadowIntensity );
}
#else
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
float depth = texture2D( shadowMap, shadowCoord.xy ).r;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadow = step( depth, shadowCoord.z );
#else
shadow = step( shadowCoord.z, depth );
#endif
}
return mix( 1.0, shadow, shadowIntensity );
}
#endif
#if NUM_SUN_LIGHT_SHADOWS > 0
float getSunShadow(
#if defined( SHADOWMAP_TYPE_PCF )
sampler2DShadow shadowMap,
#else
sampler2D shadowMap,
#endif
SunLightShadow sunLightShadow,
int shadowIndex
) {
vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
float viewDepth = vSunShadowWorldPosition.w;
int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
float shadow = 1.0;
for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
float cascadeShadow = getShadow(
shadowMap,
sunLightShadow.shadowMapSize,
sunLightShadow.shadowIntensity,
sunLightShadow.shadowBias,
sunLightShadow.shadowRadius,
sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
);
shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
}
}
return shadow;
}
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
float shadow = 1.0;
vec3 lightToPosition = shadowCoord.xyz;
vec3 bd3D = normalize( lightToPosition );
vec3 absVec = abs( lightToPosition );
float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
float lightDistance = length( lightToPosition );
float depthRange = shadowCameraFar - shadowCameraNear;
#ifdef USE_REVERSED_DEPTH_BUFFER
float depthA = - shadowCameraNear / depthRange - shadowBias;
float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
#else
float depthA = shadowCameraFar / depthRange + shadowBias;
float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
#endif
float texelSize = shadowRadius / shadowMapSize.x;
vec3 absDir = abs( bd3D );
vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
tangent = normalize( cross( bd3D, tangent ) );
vec3 bitangent = cross( bd3D, tangent );
float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
shadow = 0.0;
for ( int i = 0; i < 5; i ++ ) {
vec2 offset = vogelDiskSample( i, 5, phi );
vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
vec3 absDirection = abs( direction );
float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
shadow += texture( shadowMap, vec4( direction, dp ) );
}
shadow *= 0.2;
}
return mix( 1.0, shadow, shadowIntensity );
}
#elif defined( SHADOWMAP_TYPE_BASIC )
float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
float shadow = 1.0;
vec3 lightToPosition = shadowCoord.xyz;
vec3 absVec = abs( lightToPosition );
float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
dp += shadowBias;
vec3 bd3D = normalize( lightToPosition );
float depth = textureCube( shadowMap, bd3D ).r;
#ifdef USE_REVERSED_DEPTH_BUFFER
depth = 1.0 - depth;
#endif
shadow = step( dp, depth );
}
return mix( 1.0, shadow, shadowIntensity );
}
#endif
#endif
#endif
`;var p0=`
#if NUM_SPOT_LIGHT_COORDS > 0
uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
struct SpotLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
float shadowCameraNear;
float shadowCameraFar;
};
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#endif
`;var m0=`
#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
#ifdef HAS_NORMAL
vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
#else
vec3 shadowWorldNormal = vec3( 0.0 );
#endif
vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
#if NUM_SUN_LIGHT_SHADOWS > 0
vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
vSunShadowWorldNormal = shadowWorldNormal;
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
shadowWorldPosition = worldPosition;
#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
#endif
vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
`;var g0=`
float getShadowMask() {
float shadow = 1.0;
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
SunLightShadow sunLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
sunLight = sunLightShadows[ i ];
shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
DirectionalLightShadow directionalLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
directionalLight = directionalLightShadows[ i ];
shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
SpotLightShadow spotLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
spotLight = spotLightShadows[ i ];
shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
PointLightShadow pointLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
pointLight = pointLightShadows[ i ];
shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
}
#pragma unroll_loop_end
#endif
#endif
return shadow;
}
`;var x0=`
#ifdef USE_SKINNING
mat4 boneMatX = getBoneMatrix( skinIndex.x );
mat4 boneMatY = getBoneMatrix( skinIndex.y );
mat4 boneMatZ = getBoneMatrix( skinIndex.z );
mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif
`;var _0=`
#ifdef USE_SKINNING
uniform mat4 bindMatrix;
uniform mat4 bindMatrixInverse;
uniform highp sampler2D boneTexture;
mat4 getBoneMatrix( const in float i ) {
int size = textureSize( boneTexture, 0 ).x;
int j = int( i ) * 4;
int x = j % size;
int y = j / size;
vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
return mat4( v1, v2, v3, v4 );
}
#endif
`;var v0=`
#ifdef USE_SKINNING
vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
vec4 skinned = vec4( 0.0 );
skinned += boneMatX * skinVertex * skinWeight.x;
skinned += boneMatY * skinVertex * skinWeight.y;
skinned += boneMatZ * skinVertex * skinWeight.z;
skinned += boneMatW * skinVertex * skinWeight.w;
transformed = ( bindMatrixInverse * skinned ).xyz;
#endif
`;var M0=`
#ifdef USE_SKINNING
mat4 skinMatrix = mat4( 0.0 );
skinMatrix += skinWeight.x * boneMatX;
skinMatrix += skinWeight.y * boneMatY;
skinMatrix += skinWeight.z * boneMatZ;
skinMatrix += skinWeight.w * boneMatW;
skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
#ifdef USE_TANGENT
objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
#endif
#endif
`;var S0=`
float specularStrength;
#ifdef USE_SPECULARMAP
vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
specularStrength = texelSpecular.r;
#else
specularStrength = 1.0;
#endif
`;var y0=`
#ifdef USE_SPECULARMAP
uniform sampler2D specularMap;
#endif
`;var b0=`
#if defined( TONE_MAPPING )
gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif
`;var E0=`
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
color *= toneMappingExposure;
return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
color *= toneMappingExposure;
color = max( vec3( 0.0 ), color - 0.004 );
return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
const mat3 ACESInputMat = mat3(
vec3( 0.59719, 0.07600, 0.02840 ),
vec3( 0.35458, 0.90834, 0.13383 ),
vec3( 0.04823, 0.01566, 0.83777 )
);
const mat3 ACESOutputMat = mat3(
vec3(  1.60475, -0.10208, -0.00327 ),
vec3( -0.53108,  1.10813, -0.07276 ),
vec3( -0.07367, -0.00605,  1.07602 )
);
color *= toneMappingExposure / 0.6;
color = ACESInputMat * color;
color = RRTAndODTFit( color );
color = ACESOutputMat * color;
return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
vec3( 1.6605, - 0.1246, - 0.0182 ),
vec3( - 0.5876, 1.1329, - 0.1006 ),
vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
vec3( 0.6274, 0.0691, 0.0164 ),
vec3( 0.3293, 0.9195, 0.0880 ),
vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
vec3 x2 = x * x;
vec3 x4 = x2 * x2;
return + 15.5 * x4 * x2
- 40.14 * x4 * x
+ 31.96 * x4
- 6.868 * x2 * x
+ 0.4298 * x2
+ 0.1191 * x
- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
const mat3 AgXInsetMatrix = mat3(
vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
);
const mat3 AgXOutsetMatrix = mat3(
vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
);
const float AgxMinEv = - 12.47393;
const float AgxMaxEv = 4.026069;
color *= toneMappingExposure;
color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
color = AgXInsetMatrix * color;
color = max( color, 1e-10 );
color = log2( color );
color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
color = clamp( color, 0.0, 1.0 );
color = agxDefaultContrastApprox( color );
color = AgXOutsetMatrix * color;
color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
color = clamp( color, 0.0, 1.0 );
return color;
}
vec3 NeutralToneMapping( vec3 color ) {
const float StartCompression = 0.8 - 0.04;
const float Desaturation = 0.15;
color *= toneMappingExposure;
float x = min( color.r, min( color.g, color.b ) );
float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
color -= offset;
float peak = max( color.r, max( color.g, color.b ) );
if ( peak < StartCompression ) return color;
float d = 1. - StartCompression;
float newPeak = 1. - d * d / ( peak + d - StartCompression );
color *= newPeak / peak;
float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }
`;var w0=`
#ifdef USE_TRANSMISSION
material.transmission = transmission;
material.transmissionAlpha = 1.0;
material.thickness = thickness;
material.attenuationDistance = attenuationDistance;
material.attenuationColor = attenuationColor;
#ifdef USE_TRANSMISSIONMAP
material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
#endif
#ifdef USE_THICKNESSMAP
material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
#endif
vec3 pos = vWorldPosition;
vec3 v = normalize( cameraPosition - pos );
vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec4 transmitted = getIBLVolumeRefraction(
n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
material.attenuationColor, material.attenuationDistance );
material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif
`;var T0=`
#ifdef USE_TRANSMISSION
uniform float transmission;
uniform float thickness;
uniform float attenuationDistance;
uniform vec3 attenuationColor;
#ifdef USE_TRANSMISSIONMAP
uniform sampler2D transmissionMap;
#endif
#ifdef USE_THICKNESSMAP
uniform sampler2D thicknessMap;
#endif
uniform vec2 transmissionSamplerSize;
uniform sampler2D transmissionSamplerMap;
uniform mat4 modelMatrix;
uniform mat4 projectionMatrix;
varying vec3 vWorldPosition;
float w0( float a ) {
return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
}
float w1( float a ) {
return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
}
float w2( float a ){
return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
}
float w3( float a ) {
return ( 1.0 / 6.0 ) * ( a * a * a );
}
float g0( float a ) {
return w0( a ) + w1( a );
}
float g1( float a ) {
return w2( a ) + w3( a );
}
float h0( float a ) {
return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
}
float h1( float a ) {
return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
}
vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
uv = uv * texelSize.zw + 0.5;
vec2 iuv = floor( uv );
vec2 fuv = fract( uv );
float g0x = g0( fuv.x );
float g1x = g1( fuv.x );
float h0x = h0( fuv.x );
float h1x = h1( fuv.x );
float h0y = h0( fuv.y );
float h1y = h1( fuv.y );
vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
}
vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
vec2 fLodSizeInv = 1.0 / fLodSize;
vec2 cLodSizeInv = 1.0 / cLodSize;
vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
return mix( fSample, cSample, fract( lod ) );
}
vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
vec3 modelScale;
modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
return normalize( refractionVector ) * thickness * modelScale;
}
float applyIorToRoughness( const in float roughness, const in float ior ) {
return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
}
vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
}
vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
if ( isinf( attenuationDistance ) ) {
return vec3( 1.0 );
} else {
vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );
return transmittance;
}
}
vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
const in vec3 attenuationColor, const in float attenuationDistance ) {
vec4 transmittedLight;
vec3 transmittance;
#ifdef USE_DISPERSION
float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
for ( int i = 0; i < 3; i ++ ) {
vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
vec3 refractedRayExit = position + transmissionRay;
vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
vec2 refractionCoords = ndcPos.xy / ndcPos.w;
refractionCoords += 1.0;
refractionCoords /= 2.0;
vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
transmittedLight[ i ] = transmissionSample[ i ];
transmittedLight.a += transmissionSample.a;
transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
}
transmittedLight.a /= 3.0;
#else
vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
vec3 refractedRayExit = position + transmissionRay;
vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
vec2 refractionCoords = ndcPos.xy / ndcPos.w;
refractionCoords += 1.0;
refractionCoords /= 2.0;
transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
#endif
vec3 attenuatedColor = transmittance * transmittedLight.rgb;
vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
}
#endif
`;var A0=`
#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif
`;var R0=`
#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
uniform mat3 mapTransform;
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
uniform mat3 alphaMapTransform;
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
uniform mat3 lightMapTransform;
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
uniform mat3 aoMapTransform;
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
uniform mat3 bumpMapTransform;
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
uniform mat3 normalMapTransform;
varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
uniform mat3 displacementMapTransform;
varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
uniform mat3 emissiveMapTransform;
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
uniform mat3 metalnessMapTransform;
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
uniform mat3 roughnessMapTransform;
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
uniform mat3 diffuseRoughnessMapTransform;
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
uniform mat3 anisotropyMapTransform;
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
uniform mat3 clearcoatMapTransform;
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
uniform mat3 clearcoatNormalMapTransform;
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
uniform mat3 clearcoatRoughnessMapTransform;
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
uniform mat3 sheenColorMapTransform;
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
uniform mat3 sheenRoughnessMapTransform;
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
uniform mat3 iridescenceMapTransform;
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform mat3 iridescenceThicknessMapTransform;
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
uniform mat3 specularMapTransform;
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
uniform mat3 specularColorMapTransform;
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
uniform mat3 specularIntensityMapTransform;
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif
`;var C0=`
#if defined( USE_UV ) || defined( USE_ANISOTROPY )
vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif
`;var P0=`
#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
vec4 worldPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
worldPosition = batchingMatrix * worldPosition;
#endif
#ifdef USE_INSTANCING
worldPosition = instanceMatrix * worldPosition;
#endif
worldPosition = modelMatrix * worldPosition;
#endif
`;var L0=`
varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
gl_Position = vec4( position.xy, 1.0, 1.0 );
}
`,D0=`
uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
vec4 texColor = texture2D( t2D, vUv );
#ifdef DECODE_VIDEO_TEXTURE
texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
#endif
texColor.rgb *= backgroundIntensity;
gl_FragColor = texColor;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}
`;var N0=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,I0=`
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
#ifdef ENVMAP_TYPE_PMREM
vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
#else
vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
#endif
texColor.rgb *= backgroundIntensity;
gl_FragColor = texColor;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}
`;var U0=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,F0=`
uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
gl_FragColor = texColor;
gl_FragColor.a *= opacity;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}
`;var O0=`
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <skinbase_vertex>
#include <morphinstance_vertex>
#ifdef USE_DISPLACEMENTMAP
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vHighPrecisionZW = gl_Position.zw;
}
`,B0=`
#if DEPTH_PACKING == 3200
uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
vec4 diffuseColor = vec4( 1.0 );
#include <clipping_planes_fragment>
#if DEPTH_PACKING == 3200
diffuseColor.a = opacity;
#endif
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <logdepthbuf_fragment>
#ifdef USE_REVERSED_DEPTH_BUFFER
float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
#else
float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
#endif
#if DEPTH_PACKING == 3200
gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
#elif DEPTH_PACKING == 3201
gl_FragColor = packDepthToRGBA( fragCoordZ );
#elif DEPTH_PACKING == 3202
gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
#elif DEPTH_PACKING == 3203
gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
#endif
}
`;var G0=`
#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <skinbase_vertex>
#include <morphinstance_vertex>
#ifdef USE_DISPLACEMENTMAP
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <worldpos_vertex>
#include <clipping_planes_vertex>
vWorldPosition = worldPosition.xyz;
}
`,z0=`
#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( 1.0 );
#include <clipping_planes_fragment>
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
float dist = length( vWorldPosition - referencePosition );
dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
dist = saturate( dist );
gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}
`;var k0=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
}
`,H0=`
uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
vec3 direction = normalize( vWorldDirection );
vec2 sampleUV = equirectUv( direction );
gl_FragColor = texture2D( tEquirect, sampleUV );
#include <tonemapping_fragment>
#include <colorspace_fragment>
}
`;var V0=`
uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
vLineDistance = scale * lineDistance;
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
}
`,W0=`
uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
if ( mod( vLineDistance, totalSize ) > dashSize ) {
discard;
}
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}
`;var X0=`
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <worldpos_vertex>
#include <envmap_vertex>
#include <fog_vertex>
}
`,q0=`
uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
#ifdef USE_LIGHTMAP
vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
#else
reflectedLight.indirectDiffuse += vec3( 1.0 );
#endif
#include <aomap_fragment>
reflectedLight.indirectDiffuse *= diffuseColor.rgb;
vec3 outgoingLight = reflectedLight.indirectDiffuse;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}
`;var Y0=`
#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <envmap_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}
`,K0=`
#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_lambert_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}
`;var Z0=`
#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
vViewPosition = - mvPosition.xyz;
}
`,$0=`
#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
vec3 viewDir = normalize( vViewPosition );
vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
vec3 y = cross( viewDir, x );
vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
#ifdef USE_MATCAP
vec4 matcapColor = texture2D( matcap, uv );
#else
vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
#endif
vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}
`;var J0=`
#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
vViewPosition = - mvPosition.xyz;
#endif
}
`,Q0=`
#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
#ifdef OPAQUE
gl_FragColor.a = 1.0;
#endif
}
`;var j0=`
#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <envmap_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}
`,ex=`
#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_phong_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}
`;var tx=`
#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
#ifdef USE_TRANSMISSION
vWorldPosition = worldPosition.xyz;
#endif
}
`,ix=`
#define STANDARD
#ifdef PHYSICAL
#define IOR
#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
uniform float ior;
#endif
#ifdef USE_SPECULAR
uniform float specularIntensity;
uniform vec3 specularColor;
#ifdef USE_SPECULAR_COLORMAP
uniform sampler2D specularColorMap;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
uniform sampler2D specularIntensityMap;
#endif
#endif
#ifdef USE_CLEARCOAT
uniform float clearcoat;
uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
uniform float diffuseRoughness;
#ifdef USE_DIFFUSE_ROUGHNESSMAP
uniform sampler2D diffuseRoughnessMap;
#endif
#endif
#ifdef USE_DISPERSION
uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
uniform float iridescence;
uniform float iridescenceIOR;
uniform float iridescenceThicknessMinimum;
uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
uniform vec3 sheenColor;
uniform float sheenRoughness;
#ifdef USE_SHEEN_COLORMAP
uniform sampler2D sheenColorMap;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
uniform sampler2D sheenRoughnessMap;
#endif
#endif
#ifdef USE_ANISOTROPY
uniform vec2 anisotropyVector;
#ifdef USE_ANISOTROPYMAP
uniform sampler2D anisotropyMap;
#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <roughnessmap_fragment>
#include <metalnessmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <clearcoat_normal_fragment_begin>
#include <clearcoat_normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_physical_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
#include <transmission_fragment>
vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
#ifdef USE_SHEEN
outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
#endif
#ifdef USE_CLEARCOAT
float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
#endif
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}
`;var nx=`
#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}
`,rx=`
#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_toon_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}
`;var sx=`
uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
varying vec2 vUv;
uniform mat3 uvTransform;
#endif
void main() {
#ifdef USE_POINTS_UV
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
#endif
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <project_vertex>
gl_PointSize = size;
#ifdef USE_SIZEATTENUATION
bool isPerspective = isPerspectiveMatrix( projectionMatrix );
if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
#endif
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <worldpos_vertex>
#include <fog_vertex>
}
`,ox=`
uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_particle_fragment>
#include <color_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}
`;var ax=`
#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}
`,lx=`
uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
#include <logdepthbuf_fragment>
gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}
`;var cx=`
uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
vec4 mvPosition = modelViewMatrix[ 3 ];
vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
#ifndef USE_SIZEATTENUATION
bool isPerspective = isPerspectiveMatrix( projectionMatrix );
if ( isPerspective ) scale *= - mvPosition.z;
#endif
vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
vec2 rotatedPosition;
rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
mvPosition.xy += rotatedPosition;
gl_Position = projectionMatrix * mvPosition;
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
}
`,fx=`
uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
}
`;var at={alphahash_fragment:Dm,alphahash_pars_fragment:Nm,alphamap_fragment:Im,alphamap_pars_fragment:Um,alphatest_fragment:Fm,alphatest_pars_fragment:Om,aomap_fragment:Bm,aomap_pars_fragment:Gm,batching_pars_vertex:zm,batching_vertex:km,begin_vertex:Hm,beginnormal_vertex:Vm,bsdfs:Wm,iridescence_fragment:Xm,bumpmap_pars_fragment:qm,clipping_planes_fragment:Ym,clipping_planes_pars_fragment:Km,clipping_planes_pars_vertex:Zm,clipping_planes_vertex:$m,color_fragment:Jm,color_pars_fragment:Qm,color_pars_vertex:jm,color_vertex:eg,common:tg,defaultnormal_vertex:ig,displacementmap_pars_vertex:ng,displacementmap_vertex:rg,emissivemap_fragment:sg,emissivemap_pars_fragment:og,colorspace_fragment:ag,colorspace_pars_fragment:lg,envmap_fragment:cg,envmap_common_pars_fragment:fg,envmap_pars_fragment:ug,envmap_pars_vertex:hg,envmap_physical_pars_fragment:bg,envmap_vertex:dg,fog_vertex:pg,fog_pars_vertex:mg,fog_fragment:gg,fog_pars_fragment:xg,gradientmap_pars_fragment:_g,lightmap_pars_fragment:vg,lights_lambert_fragment:Mg,lights_lambert_pars_fragment:Sg,lights_pars_begin:yg,lights_toon_fragment:Eg,lights_toon_pars_fragment:wg,lights_phong_fragment:Tg,lights_phong_pars_fragment:Ag,lights_physical_fragment:Rg,lights_physical_pars_fragment:Cg,lights_fragment_begin:Pg,lights_fragment_maps:Lg,lights_fragment_end:Dg,lightprobes_pars_fragment:Ng,logdepthbuf_fragment:Ig,logdepthbuf_pars_fragment:Ug,logdepthbuf_pars_vertex:Fg,logdepthbuf_vertex:Og,map_fragment:Bg,map_pars_fragment:Gg,map_particle_fragment:zg,map_particle_pars_fragment:kg,metalnessmap_fragment:Hg,metalnessmap_pars_fragment:Vg,morphinstance_vertex:Wg,morphcolor_vertex:Xg,morphnormal_vertex:qg,morphtarget_pars_vertex:Yg,morphtarget_vertex:Kg,normal_fragment_begin:Zg,normal_fragment_maps:$g,normal_pars_fragment:Jg,normal_pars_vertex:Qg,normal_vertex:jg,normalmap_pars_fragment:e0,clearcoat_normal_fragment_begin:t0,clearcoat_normal_fragment_maps:i0,clearcoat_pars_fragment:n0,iridescence_pars_fragment:r0,opaque_fragment:s0,packing:o0,premultiplied_alpha_fragment:a0,project_vertex:l0,dithering_fragment:c0,dithering_pars_fragment:f0,roughnessmap_fragment:u0,roughnessmap_pars_fragment:h0,shadowmap_pars_fragment:d0,shadowmap_pars_vertex:p0,shadowmap_vertex:m0,shadowmask_pars_fragment:g0,skinbase_vertex:x0,skinning_pars_vertex:_0,skinning_vertex:v0,skinnormal_vertex:M0,specularmap_fragment:S0,specularmap_pars_fragment:y0,tonemapping_fragment:b0,tonemapping_pars_fragment:E0,transmission_fragment:w0,transmission_pars_fragment:T0,uv_pars_fragment:A0,uv_pars_vertex:R0,uv_vertex:C0,worldpos_vertex:P0,background_vert:L0,background_frag:D0,backgroundCube_vert:N0,backgroundCube_frag:I0,cube_vert:U0,cube_frag:F0,depth_vert:O0,depth_frag:B0,distance_vert:G0,distance_frag:z0,equirect_vert:k0,equirect_frag:H0,linedashed_vert:V0,linedashed_frag:W0,meshbasic_vert:X0,meshbasic_frag:q0,meshlambert_vert:Y0,meshlambert_frag:K0,meshmatcap_vert:Z0,meshmatcap_frag:$0,meshnormal_vert:J0,meshnormal_frag:Q0,meshphong_vert:j0,meshphong_frag:ex,meshphysical_vert:tx,meshphysical_frag:ix,meshtoon_vert:nx,meshtoon_frag:rx,points_vert:sx,points_frag:ox,shadow_vert:ax,shadow_frag:lx,sprite_vert:cx,sprite_frag:fx};var Le={common:{diffuse:{value:new Xe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ke},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ke}},envmap:{envMap:{value:null},envMapRotation:{value:new Ke},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ke}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ke}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ke},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ke},normalScale:{value:new Ze(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ke},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ke}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ke}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ke}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Xe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Xe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0},uvTransform:{value:new Ke}},sprite:{diffuse:{value:new Xe(16777215)},opacity:{value:1},center:{value:new Ze(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ke},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0}}};var In={basic:{uniforms:qi([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:at.meshbasic_vert,fragmentShader:at.meshbasic_frag},lambert:{uniforms:qi([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)},envMapIntensity:{value:1}}]),vertexShader:at.meshlambert_vert,fragmentShader:at.meshlambert_frag},phong:{uniforms:qi([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)},specular:{value:new Xe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:at.meshphong_vert,fragmentShader:at.meshphong_frag},standard:{uniforms:qi([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag},toon:{uniforms:qi([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)}}]),vertexShader:at.meshtoon_vert,fragmentShader:at.meshtoon_frag},matcap:{uniforms:qi([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:at.meshmatcap_vert,fragmentShader:at.meshmatcap_frag},points:{uniforms:qi([Le.points,Le.fog]),vertexShader:at.points_vert,fragmentShader:at.points_frag},dashed:{uniforms:qi([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:at.linedashed_vert,fragmentShader:at.linedashed_frag},depth:{uniforms:qi([Le.common,Le.displacementmap]),vertexShader:at.depth_vert,fragmentShader:at.depth_frag},normal:{uniforms:qi([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:at.meshnormal_vert,fragmentShader:at.meshnormal_frag},sprite:{uniforms:qi([Le.sprite,Le.fog]),vertexShader:at.sprite_vert,fragmentShader:at.sprite_frag},background:{uniforms:{uvTransform:{value:new Ke},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:at.background_vert,fragmentShader:at.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ke}},vertexShader:at.backgroundCube_vert,fragmentShader:at.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:at.cube_vert,fragmentShader:at.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:at.equirect_vert,fragmentShader:at.equirect_frag},distance:{uniforms:qi([Le.common,Le.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:at.distance_vert,fragmentShader:at.distance_frag},shadow:{uniforms:qi([Le.lights,Le.fog,{color:{value:new Xe(0)},opacity:{value:1}}]),vertexShader:at.shadow_vert,fragmentShader:at.shadow_frag}};In.physical={uniforms:qi([In.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ke},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ke},clearcoatNormalScale:{value:new Ze(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ke},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ke},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ke},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ke},sheen:{value:0},sheenColor:{value:new Xe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ke},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ke},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ke},transmissionSamplerSize:{value:new Ze},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ke},attenuationDistance:{value:0},attenuationColor:{value:new Xe(0)},specularColor:{value:new Xe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ke},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ke},anisotropyVector:{value:new Ze},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ke}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag};var kc={r:0,b:0,g:0},BS=new Ie,ux=new Ke;ux.set(-1,0,0,0,1,0,0,0,1);function hx(n,e,t,i,r,s){let o=new Xe(0),a=r===!0?0:1,c,l,h=null,f=0,u=null;function m(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let y=v.backgroundBlurriness>0;A=e.get(A,y)}return A}function x(v){let A=!1,y=m(v);y===null?d(o,a):y&&y.isColor&&(d(y,1),A=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,s):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function M(v,A){let y=m(A);y&&y.isCubeTexture?(l===void 0&&(l=new Ot(new Xr(1,1,1),new tn({name:"BackgroundCubeMaterial",uniforms:br(In.backgroundCube.uniforms),vertexShader:In.backgroundCube.vertexShader,fragmentShader:In.backgroundCube.fragmentShader,side:Jt,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(R,T,g){this.matrixWorld.copyPosition(g.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=y,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(BS.makeRotationFromEuler(A.backgroundRotation)).transpose(),y.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(ux),l.material.toneMapped=ot.getTransfer(y.colorSpace)!==vt,(h!==y||f!==y.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=y,f=y.version,u=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null)):y&&y.isTexture&&(c===void 0&&(c=new Ot(new To(2,2),new tn({name:"BackgroundMaterial",uniforms:br(In.background.uniforms),vertexShader:In.background.vertexShader,fragmentShader:In.background.fragmentShader,side:nn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=y,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=ot.getTransfer(y.colorSpace)!==vt,y.matrixAutoUpdate===!0&&y.updateMatrix(),c.material.uniforms.uvTransform.value.copy(y.matrix),(h!==y||f!==y.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=y,f=y.version,u=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null))}function d(v,A){v.getRGB(kc,Lc(n)),t.buffers.color.setClear(kc.r,kc.g,kc.b,A,s)}function p(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,d(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,d(o,a)},render:x,addToRenderList:M,dispose:p}}function dx(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=u(null),s=r,o=!1;function a(D,G,k,I,W){let Y=!1,V=f(D,I,k,G);s!==V&&(s=V,l(s.object)),Y=m(D,I,k,W),Y&&x(D,I,k,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,y(D,G,k,I),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function c(){return n.createVertexArray()}function l(D){return n.bindVertexArray(D)}function h(D){return n.deleteVertexArray(D)}function f(D,G,k,I){let W=I.wireframe===!0,Y=i[G.id];Y===void 0&&(Y={},i[G.id]=Y);let V=D.isInstancedMesh===!0?D.id:0,ce=Y[V];ce===void 0&&(ce={},Y[V]=ce);let $=ce[k.id];$===void 0&&($={},ce[k.id]=$);let Q=$[W];return Q===void 0&&(Q=u(c()),$[W]=Q),Q}function u(D){let G=[],k=[],I=[];for(let W=0;W<t;W++)G[W]=0,k[W]=0,I[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:k,attributeDivisors:I,object:D,attributes:{},index:null}}function m(D,G,k,I){let W=s.attributes,Y=G.attributes,V=0,ce=k.getAttributes();for(let $ in ce)if(ce[$].location>=0){let ne=W[$],he=Y[$];if(he===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(he=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(he=D.instanceColor)),ne===void 0||ne.attribute!==he||he&&ne.data!==he.data)return!0;V++}return s.attributesNum!==V||s.index!==I}function x(D,G,k,I){let W={},Y=G.attributes,V=0,ce=k.getAttributes();for(let $ in ce)if(ce[$].location>=0){let ne=Y[$];ne===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(ne=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(ne=D.instanceColor));let he={};he.attribute=ne,ne&&ne.data&&(he.data=ne.data),W[$]=he,V++}s.attributes=W,s.attributesNum=V,s.index=I}function M(){let D=s.newAttributes;for(let G=0,k=D.length;G<k;G++)D[G]=0}function d(D){p(D,0)}function p(D,G){let k=s.newAttributes,I=s.enabledAttributes,W=s.attributeDivisors;k[D]=1,I[D]===0&&(n.enableVertexAttribArray(D),I[D]=1),W[D]!==G&&(n.vertexAttribDivisor(D,G),W[D]=G)}function v(){let D=s.newAttributes,G=s.enabledAttributes;for(let k=0,I=G.length;k<I;k++)G[k]!==D[k]&&(n.disableVertexAttribArray(k),G[k]=0)}function A(D,G,k,I,W,Y,V){V===!0?n.vertexAttribIPointer(D,G,k,W,Y):n.vertexAttribPointer(D,G,k,I,W,Y)}function y(D,G,k,I){M();let W=I.attributes,Y=k.getAttributes(),V=G.defaultAttributeValues;for(let ce in Y){let $=Y[ce];if($.location>=0){let Q=W[ce];if(Q===void 0&&(ce==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),ce==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let ne=Q.normalized,he=Q.itemSize,ue=e.get(Q);if(ue===void 0)continue;let j=ue.buffer,me=ue.type,_e=ue.bytesPerElement,Ae=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===Xs;if(Q.isInterleavedBufferAttribute){let ye=Q.data,qe=ye.isInterleavedBuffer===!0?ye.stride:ye.itemSize,rt=Q.offset;if(ye.isInstancedInterleavedBuffer||ye.isInstancedBufferAttribute){for(let Ve=0;Ve<$.locationSize;Ve++)p($.location+Ve,ye.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ye.meshPerAttribute*ye.count)}else for(let Ve=0;Ve<$.locationSize;Ve++)d($.location+Ve);n.bindBuffer(n.ARRAY_BUFFER,j);for(let Ve=0;Ve<$.locationSize;Ve++)A($.location+Ve,he/$.locationSize,me,ne,qe*_e,(rt+he/$.locationSize*Ve)*_e,Ae)}else{if(Q.isInstancedBufferAttribute){for(let ye=0;ye<$.locationSize;ye++)p($.location+ye,Q.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ye=0;ye<$.locationSize;ye++)d($.location+ye);n.bindBuffer(n.ARRAY_BUFFER,j);for(let ye=0;ye<$.locationSize;ye++)A($.location+ye,he/$.locationSize,me,ne,he*_e,he/$.locationSize*ye*_e,Ae)}}else if(V!==void 0){let ne=V[ce];if(ne!==void 0)switch(ne.length){case 2:n.vertexAttrib2fv($.location,ne);break;case 3:n.vertexAttrib3fv($.location,ne);break;case 4:n.vertexAttrib4fv($.location,ne);break;default:n.vertexAttrib1fv($.location,ne)}}}}v()}function R(){O();for(let D in i){let G=i[D];for(let k in G){let I=G[k];for(let W in I){let Y=I[W];for(let V in Y)h(Y[V].object),delete Y[V];delete I[W]}}delete i[D]}}function T(D){if(i[D.id]===void 0)return;let G=i[D.id];for(let k in G){let I=G[k];for(let W in I){let Y=I[W];for(let V in Y)h(Y[V].object),delete Y[V];delete I[W]}}delete i[D.id]}function g(D){for(let G in i){let k=i[G];for(let I in k){let W=k[I];if(W[D.id]===void 0)continue;let Y=W[D.id];for(let V in Y)h(Y[V].object),delete Y[V];delete W[D.id]}}}function w(D){for(let G in i){let k=i[G],I=D.isInstancedMesh===!0?D.id:0,W=k[I];if(W!==void 0){for(let Y in W){let V=W[Y];for(let ce in V)h(V[ce].object),delete V[ce];delete W[Y]}delete k[I],Object.keys(k).length===0&&delete i[G]}}}function O(){L(),o=!0,s!==r&&(s=r,l(s.object))}function L(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:O,resetDefaultState:L,dispose:R,releaseStatesOfGeometry:T,releaseStatesOfObject:w,releaseStatesOfProgram:g,initAttributes:M,enableAttribute:d,disableUnusedAttributes:v}}function px(n,e,t){let i;function r(c){i=c}function s(c,l){n.drawArrays(i,c,l),t.update(l,i,1)}function o(c,l,h){h!==0&&(n.drawArraysInstanced(i,c,l,h),t.update(l,i,h))}function a(c,l,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,h);let u=0;for(let m=0;m<h;m++)u+=l[m];t.update(u,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function mx(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let g=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(g.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(g){return!(g!==Di&&i.convert(g)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(g){let w=g===Li&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(g!==ai&&g!==li&&!w&&i.convert(g)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(g){if(g==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";g="mediump"}return g==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp",h=c(l);h!==l&&(ke("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=n.getParameter(n.MAX_TEXTURE_SIZE),d=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),y=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:u,reversedDepthBuffer:f,maxTextures:m,maxVertexTextures:x,maxTextureSize:M,maxCubemapSize:d,maxAttributes:p,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:y,maxSamples:R,samples:T}}function gx(n){let e=this,t=null,i=0,r=!1,s=!1,o=new Xi,a=new Ke,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,u){let m=f.length!==0||u||i!==0||r;return r=u,i=f.length,m},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(f,u){t=h(f,u,0)},this.setState=function(f,u,m){let x=f.clippingPlanes,M=f.clipIntersection,d=f.clipShadows,p=n.get(f);if(!r||x===null||x.length===0||s&&!d)s?h(null):l();else{let v=s?0:i,A=v*4,y=p.clippingState||null;c.value=y,y=h(x,u,A,m);for(let R=0;R!==A;++R)y[R]=t[R];p.clippingState=y,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=v}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(f,u,m,x){let M=f!==null?f.length:0,d=null;if(M!==0){if(d=c.value,x!==!0||d===null){let p=m+M*4,v=u.matrixWorldInverse;a.getNormalMatrix(v),(d===null||d.length<p)&&(d=new Float32Array(p));for(let A=0,y=m;A!==M;++A,y+=4)o.copy(f[A]).applyMatrix4(v,a),o.normal.toArray(d,y),d[y+3]=o.constant}c.value=d,c.needsUpdate=!0}return e.numPlanes=M,e.numIntersection=0,d}}var Yr=class extends Oi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new yo(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},r=new Xr(5,5,5),s=new tn({name:"CubemapFromEquirect",uniforms:br(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Jt,blending:tr});s.uniforms.tEquirect.value=t;let o=new Ot(r,s),a=t.minFilter;return t.minFilter===xn&&(t.minFilter=xi),new _s(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}};var xx=256,GS=3,zS=20,Sx=256,yx=16,kS=3,HS=new U,VS=new Xe,Ja=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new _s(1,10,null),this._boxMesh=new Ot(new Xr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=HS}=s,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let f=c.autoClear,u=c.autoClearColor,m=c.autoClearDepth,x=c.autoClearStencil,M=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,M===null&&(e.background=c.getClearColor(VS));let d=new _s(i,r,h);return d.position.copy(a),d.update(c,e),c.autoClear=f,c.autoClearColor=u,c.autoClearDepth=m,c.autoClearStencil=x,e.background=M,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,t)),this._applyPMREM(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Mx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=vx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(xx,jp(e))}_fromTexture(e,t){e.mapping===ir||e.mapping===Fr?this._setSize(e.image.length===0?xx:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=_x(e,!1,!1),i=Math.log2(e)-GS;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=_x(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===ir||e.mapping===Fr?(this._cubemapMaterial===null&&(this._cubemapMaterial=Mx()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=vx()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=WS(),this._integrationMaterial=XS());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/yx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-kS)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let c=a>0?Math.log2(t)+.5*Math.log2(6/(Sx*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=qS());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function _x(n,e,t){return new Yr(n,{minFilter:xn,generateMipmaps:e,type:Li,colorSpace:cs,depthBuffer:t})}function Qa(n,e,t){return new tn({name:n,uniforms:e,vertexShader:at.cube_vert,fragmentShader:t,side:Jt,blending:tr,depthTest:!1,depthWrite:!1})}function WS(){return Qa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Sx}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function XS(){return Qa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:yx}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function qS(){return Qa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${zS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function vx(){return Qa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Mx(){return Qa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function bx(n){let e=new WeakMap,t=new WeakMap,i=null;function r(u,m=!1){return u==null?null:m?o(u):s(u)}function s(u){if(u&&u.isTexture){let m=u.mapping;if(m===Wl||m===Xl)if(e.has(u)){let x=e.get(u).texture;return a(x,u.mapping)}else{let x=u.image;if(x&&x.height>0){let M=new Yr(x.height);return M.fromEquirectangularTexture(n,u),e.set(u,M),u.addEventListener("dispose",l),a(M.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let m=u.mapping,x=m===Wl||m===Xl,M=m===ir||m===Fr;if(x||M){let d=t.get(u),p=d!==void 0?d.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==p)return i===null&&(i=new Ja(n)),d=x?i.fromEquirectangular(u,d):i.fromCubemap(u,d),d.texture.pmremVersion=u.pmremVersion,t.set(u,d),d.texture;if(d!==void 0)return d.texture;{let v=u.image;return x&&v&&v.height>0||M&&v&&c(v)?(i===null&&(i=new Ja(n)),d=x?i.fromEquirectangular(u):i.fromCubemap(u),d.texture.pmremVersion=u.pmremVersion,t.set(u,d),u.addEventListener("dispose",h),d.texture):null}}}return u}function a(u,m){return m===Wl?u.mapping=ir:m===Xl&&(u.mapping=Fr),u}function c(u){let m=0,x=6;for(let M=0;M<x;M++)u[M]!==void 0&&m++;return m===x}function l(u){let m=u.target;m.removeEventListener("dispose",l);let x=e.get(m);x!==void 0&&(e.delete(m),x.dispose())}function h(u){let m=u.target;m.removeEventListener("dispose",h);let x=t.get(m);x!==void 0&&(t.delete(m),x.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:f}}function Ex(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&us("WebGLRenderer: "+i+" extension not supported."),r}}}function wx(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(x=>delete r[x]);function a(x){c(x.target)}function c(x){x.index!==null&&e.remove(x.index);for(let d in x.attributes)e.remove(x.attributes[d]);x.removeEventListener("dispose",a),delete r[x.id],o.unregister(x);let M=s.get(x);M&&(e.remove(M),s.delete(x)),i.releaseStatesOfGeometry(x),x.isInstancedBufferGeometry===!0&&delete x._maxInstanceCount,t.memory.geometries--}function l(x,M){return r[M.id]!==void 0||(M.addEventListener("dispose",a),r[M.id]=new WeakRef(M),o.register(M,M.id,M),t.memory.geometries++),M}function h(x){let M=x.attributes;for(let d in M)e.update(M[d],n.ARRAY_BUFFER)}function f(x){let M=x.index,d=x.attributes.position,p=0;if(d===void 0)return;let v=M!==null?M.array.length:d.array.length/3-1,A=d.count>=65535?_o:xo,y=new A(Math.ceil(v/3)*6,1),R=y.array;if(M!==null){let g=M.array;p=M.version;for(let w=0,O=0;w<v;w+=3){let L=g[w+0],D=g[w+1],G=g[w+2];R[O++]=L,R[O++]=D,R[O++]=D,R[O++]=G,R[O++]=G,R[O++]=L}}else{p=d.version;for(let g=0,w=0;g<v;g+=3){let O=g+0,L=g+1,D=g+2;R[w++]=O,R[w++]=L,R[w++]=L,R[w++]=D,R[w++]=D,R[w++]=O}}y.version=p;let T=s.get(x);T&&e.remove(T),s.set(x,y)}function u(x){let M=s.get(x);if(M){let d=x.index;d!==null&&M.version<d.version&&f(x)}else f(x);return s.get(x)}function m(){for(let x in r){let M=r[x].deref();M!==void 0&&c(M)}}return{get:l,update:h,getWireframeAttribute:u,dispose:m}}function Tx(n,e,t){let i;function r(f){i=f}let s,o;function a(f){s=f.type,o=f.bytesPerElement}function c(f,u){n.drawElements(i,u,s,f*o),t.update(u,i,1)}function l(f,u,m){m!==0&&(n.drawElementsInstanced(i,u,s,f*o,m),t.update(u,i,m))}function h(f,u,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,s,f,0,m);let M=0;for(let d=0;d<m;d++)M+=u[d];t.update(M,i,1)}this.setMode=r,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function Ax(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:ht("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function Rx(n,e,t){let i=new WeakMap,r=new bt;function s(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=h!==void 0?h.length:0,u=i.get(a);if(u===void 0||u.count!==f){let O=function(){g.dispose(),i.delete(a),a.removeEventListener("dispose",O)};u!==void 0&&u.texture.dispose();let m=a.morphAttributes.position!==void 0,x=a.morphAttributes.normal!==void 0,M=a.morphAttributes.color!==void 0,d=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;m===!0&&(A=1),x===!0&&(A=2),M===!0&&(A=3);let y=a.attributes.position.count*A,R=1;y>e.maxTextureSize&&(R=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);let T=new Float32Array(y*R*4*f),g=new so(T,y,R,f);g.type=li,g.needsUpdate=!0;let w=A*4;for(let L=0;L<f;L++){let D=d[L],G=p[L],k=v[L],I=y*R*4*L;for(let W=0;W<D.count;W++){let Y=W*w;m===!0&&(r.fromBufferAttribute(D,W),T[I+Y+0]=r.x,T[I+Y+1]=r.y,T[I+Y+2]=r.z,T[I+Y+3]=0),x===!0&&(r.fromBufferAttribute(G,W),T[I+Y+4]=r.x,T[I+Y+5]=r.y,T[I+Y+6]=r.z,T[I+Y+7]=0),M===!0&&(r.fromBufferAttribute(k,W),T[I+Y+8]=r.x,T[I+Y+9]=r.y,T[I+Y+10]=r.z,T[I+Y+11]=k.itemSize===4?r.w:1)}}u={count:f,texture:g,size:new Ze(y,R)},i.set(a,u),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let m=0;for(let M=0;M<l.length;M++)m+=l[M];let x=a.morphTargetsRelative?1:1-m;c.getUniforms().setValue(n,"morphTargetBaseInfluence",x),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",u.texture,t),c.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:s}}function Cx(n,e,t,i,r){let s=new WeakMap;function o(l){let h=r.render.frame,f=l.geometry,u=e.get(l,f);if(s.get(u)!==h&&(e.update(u),s.set(u,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),s.get(l)!==h&&(t.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,h))),l.isSkinnedMesh){let m=l.skeleton;s.get(m)!==h&&(m.update(),s.set(m,h))}return u}function a(){s=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var YS={[Ol]:"LINEAR_TONE_MAPPING",[Bl]:"REINHARD_TONE_MAPPING",[Gl]:"CINEON_TONE_MAPPING",[zl]:"ACES_FILMIC_TONE_MAPPING",[Hl]:"AGX_TONE_MAPPING",[Vl]:"NEUTRAL_TONE_MAPPING",[kl]:"CUSTOM_TONE_MAPPING"};function Px(n,e,t,i,r,s){let o=new Oi(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new Qt;h.setAttribute("position",new Ft([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ft([0,2,0,0,2,0],2));let f=new Dc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new Ot(h,f),m=new Co(-1,1,1,-1,0,1),x=null,M=null,d=!1,p,v=null,A=[],y=!1;this.setSize=function(R,T){o.setSize(R,T),a!==null&&a.setSize(R,T),c!==null&&c.setSize(R,T);for(let g=0;g<A.length;g++){let w=A[g];w.setSize&&w.setSize(R,T)}},this.setEffects=function(R){A=R,y=A.length>0&&A[0].isRenderPass===!0;let T=o.width,g=o.height;A.length>0&&a===null&&(a=new Oi(T,g,{type:Li,depthBuffer:!1,stencilBuffer:!1}),c=new Oi(T,g,{type:Li,depthBuffer:!1,stencilBuffer:!1}));let w=r===!0&&A.some(O=>O.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&l===null&&(l=new bn(T,g),s===!0&&(l.format=_n,l.type=kn)),o.dispose(),o.depthTexture=w?l:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let O=0;O<A.length;O++){let L=A[O];L.setSize&&L.setSize(T,g),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(l)}},this.begin=function(R,T){if(d||R.toneMapping===gn&&A.length===0)return!1;if(v=T,T!==null){let g=T.width,w=T.height;(o.width!==g||o.height!==w)&&this.setSize(g,w)}return y===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=gn,!0},this.hasRenderPass=function(){return y},this.end=function(R,T){R.toneMapping=p,d=!0;let g=o,w=a;for(let O=0;O<A.length;O++){let L=A[O];L.enabled!==!1&&(L.render(R,w,g,T),L.needsSwap!==!1&&(g=w,w=w===a?c:a))}if(x!==R.outputColorSpace||M!==R.toneMapping){x=R.outputColorSpace,M=R.toneMapping,f.defines={},ot.getTransfer(x)===vt&&(f.defines.SRGB_TRANSFER="");let O=YS[M];O&&(f.defines[O]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=g.texture,R.setRenderTarget(v),R.render(u,m),v=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),f.dispose()}}var Ox=new ci,Bx=new bn(1,1),Gx=new bo(1),zx=new so,kx=new lc,Hx=new yo,Lx=[],Dx=[],Nx=new Float32Array(16),Ix=new Float32Array(9),Ux=new Float32Array(4);function Do(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=Lx[r];if(s===void 0&&(s=new Float32Array(r),Lx[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function bi(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Ei(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Hc(n,e){let t=Dx[e];t===void 0&&(t=new Int32Array(e),Dx[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function KS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function ZS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bi(t,e))return;n.uniform2fv(this.addr,e),Ei(t,e)}}function $S(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(bi(t,e))return;n.uniform3fv(this.addr,e),Ei(t,e)}}function JS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bi(t,e))return;n.uniform4fv(this.addr,e),Ei(t,e)}}function QS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(bi(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Ei(t,e)}else{if(bi(t,i))return;Ux.set(i),n.uniformMatrix2fv(this.addr,!1,Ux),Ei(t,i)}}function jS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(bi(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Ei(t,e)}else{if(bi(t,i))return;Ix.set(i),n.uniformMatrix3fv(this.addr,!1,Ix),Ei(t,i)}}function ey(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(bi(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Ei(t,e)}else{if(bi(t,i))return;Nx.set(i),n.uniformMatrix4fv(this.addr,!1,Nx),Ei(t,i)}}function ty(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function iy(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bi(t,e))return;n.uniform2iv(this.addr,e),Ei(t,e)}}function ny(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(bi(t,e))return;n.uniform3iv(this.addr,e),Ei(t,e)}}function ry(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bi(t,e))return;n.uniform4iv(this.addr,e),Ei(t,e)}}function sy(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function oy(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bi(t,e))return;n.uniform2uiv(this.addr,e),Ei(t,e)}}function ay(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(bi(t,e))return;n.uniform3uiv(this.addr,e),Ei(t,e)}}function ly(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bi(t,e))return;n.uniform4uiv(this.addr,e),Ei(t,e)}}function Vc(n){return n.version===0&&(n.compareFunction=ic,n.needsUpdate=!0),n}function cy(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=Vc(Bx):s=Ox,t.setTexture2D(e||s,r)}function fy(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||kx,r)}function uy(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=Vc(Gx):s=Hx,t.setTextureCube(e||s,r)}function hy(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||zx,r)}function dy(n){switch(n){case 5126:return KS;case 35664:return ZS;case 35665:return $S;case 35666:return JS;case 35674:return QS;case 35675:return jS;case 35676:return ey;case 5124:case 35670:return ty;case 35667:case 35671:return iy;case 35668:case 35672:return ny;case 35669:case 35673:return ry;case 5125:return sy;case 36294:return oy;case 36295:return ay;case 36296:return ly;case 35678:case 36198:case 36298:case 36306:case 35682:return cy;case 35679:case 36299:case 36307:return fy;case 35680:case 36300:case 36308:case 36293:return uy;case 36289:case 36303:case 36311:case 36292:return hy}}function py(n,e){n.uniform1fv(this.addr,e)}function my(n,e){let t=Do(e,this.size,2);n.uniform2fv(this.addr,t)}function gy(n,e){let t=Do(e,this.size,3);n.uniform3fv(this.addr,t)}function xy(n,e){let t=Do(e,this.size,4);n.uniform4fv(this.addr,t)}function _y(n,e){let t=Do(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function vy(n,e){let t=Do(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function My(n,e){let t=Do(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Sy(n,e){n.uniform1iv(this.addr,e)}function yy(n,e){n.uniform2iv(this.addr,e)}function by(n,e){n.uniform3iv(this.addr,e)}function Ey(n,e){n.uniform4iv(this.addr,e)}function wy(n,e){n.uniform1uiv(this.addr,e)}function Ty(n,e){n.uniform2uiv(this.addr,e)}function Ay(n,e){n.uniform3uiv(this.addr,e)}function Ry(n,e){n.uniform4uiv(this.addr,e)}function Cy(n,e,t){let i=this.cache,r=e.length,s=Hc(t,r);bi(i,s)||(n.uniform1iv(this.addr,s),Ei(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=Vc(Bx):o=Ox;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function Py(n,e,t){let i=this.cache,r=e.length,s=Hc(t,r);bi(i,s)||(n.uniform1iv(this.addr,s),Ei(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||kx,s[o])}function Ly(n,e,t){let i=this.cache,r=e.length,s=Hc(t,r);bi(i,s)||(n.uniform1iv(this.addr,s),Ei(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Vc(Gx):o=Hx;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function Dy(n,e,t){let i=this.cache,r=e.length,s=Hc(t,r);bi(i,s)||(n.uniform1iv(this.addr,s),Ei(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||zx,s[o])}function Ny(n){switch(n){case 5126:return py;case 35664:return my;case 35665:return gy;case 35666:return xy;case 35674:return _y;case 35675:return vy;case 35676:return My;case 5124:case 35670:return Sy;case 35667:case 35671:return yy;case 35668:case 35672:return by;case 35669:case 35673:return Ey;case 5125:return wy;case 36294:return Ty;case 36295:return Ay;case 36296:return Ry;case 35678:case 36198:case 36298:case 36306:case 35682:return Cy;case 35679:case 36299:case 36307:return Py;case 35680:case 36300:case 36308:case 36293:return Ly;case 36289:case 36303:case 36311:case 36292:return Dy}}var ku=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=dy(t.type)}},Hu=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Ny(t.type)}},Vu=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},zu=/(\w+)(\])?(\[|\.)?/g;function Fx(n,e){n.seq.push(e),n.map[e.id]=e}function Iy(n,e,t){let i=n.name,r=i.length;for(zu.lastIndex=0;;){let s=zu.exec(i),o=zu.lastIndex,a=s[1],c=s[2]==="]",l=s[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===r){Fx(t,l===void 0?new ku(a,n,e):new Hu(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new Vu(a),Fx(t,f)),t=f}}}var Kr=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),c=e.getUniformLocation(t,a.name);Iy(a,c,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],c=i[a.id];c.needsUpdate!==!1&&a.setValue(e,c.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function Wu(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var Uy=37297,Fy=0;function Oy(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Vx=new Ke;function By(n){ot._getMatrix(Vx,ot.workingColorSpace,n);let e=`mat3( ${Vx.elements.map(t=>t.toFixed(4))} )`;switch(ot.getTransfer(n)){case fs:return[e,"LinearTransferOETF"];case vt:return[e,"sRGBTransferOETF"];default:return ke("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Wx(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+Oy(n.getShaderSource(e),a)}else return s}function Gy(n,e){let t=By(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var zy={[Ol]:"Linear",[Bl]:"Reinhard",[Gl]:"Cineon",[zl]:"ACESFilmic",[Hl]:"AgX",[Vl]:"Neutral",[kl]:"Custom"};function ky(n,e){let t=zy[e];return t===void 0?(ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Wc=new U;function Hy(){ot.getLuminanceCoefficients(Wc);let n=Wc.x.toFixed(4),e=Wc.y.toFixed(4),t=Wc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Vy(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ja).join(`
`)}function Wy(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function Xy(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function ja(n){return n!==""}function Xx(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function qx(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var qy=/^[ \t]*#include +<([\w\d./]+)>/gm;function Xu(n){return n.replace(qy,Yy)}function Yy(n,e){let t=at[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Xu(t)}var Ky=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Yx(n){return n.replace(Ky,Zy)}function Zy(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function Kx(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var $y={[Vs]:"SHADOWMAP_TYPE_PCF",[os]:"SHADOWMAP_TYPE_VSM"};function Jy(n){return $y[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Qy={[Fr]:"ENVMAP_MODE_REFRACTION"};function jy(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Qy[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var eb={[Ws]:"ENVMAP_BLENDING_MULTIPLY",[Ip]:"ENVMAP_BLENDING_MIX",[Up]:"ENVMAP_BLENDING_ADD"};function tb(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":eb[n.combine]||"ENVMAP_BLENDING_NONE"}function Zx(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,c=Jy(t),l=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=jy(t),f=tb(t),u=Vy(t),m=Wy(s),x=r.createProgram(),M,d,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(M=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(ja).join(`
`),M.length>0&&(M+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(ja).join(`
`),d.length>0&&(d+=`
`)):(M=[Kx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ja).join(`
`),d=[Kx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+h:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==gn?"#define TONE_MAPPING":"",t.toneMapping!==gn?at.tonemapping_pars_fragment:"",t.toneMapping!==gn?ky("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",at.colorspace_pars_fragment,Gy("linearToOutputTexel",t.outputColorSpace),Hy(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ja).join(`
`)),o=Xu(o),o=Xx(o,t),o=qx(o,t),a=Xu(a),a=Xx(a,t),a=qx(a,t),o=Yx(o),a=Yx(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,M=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+M,d=["#define varying in",t.glslVersion===mu?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===mu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let v=p+M+o,A=p+d+a,y=Wu(r,r.VERTEX_SHADER,v),R=Wu(r,r.FRAGMENT_SHADER,A);r.attachShader(x,y),r.attachShader(x,R),t.index0AttributeName!==void 0?r.bindAttribLocation(x,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(x,0,"position"),r.linkProgram(x);function T(L){if(n.debug.checkShaderErrors){let D=r.getProgramInfoLog(x)||"",G=r.getShaderInfoLog(y)||"",k=r.getShaderInfoLog(R)||"",I=D.trim(),W=G.trim(),Y=k.trim(),V=!0,ce=!0;if(r.getProgramParameter(x,r.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,x,y,R);else{let $=Wx(r,y,"vertex"),Q=Wx(r,R,"fragment");ht("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(x,r.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+I+`
`+$+`
`+Q)}else I!==""?ke("WebGLProgram: Program Info Log:",I):(W===""||Y==="")&&(ce=!1);ce&&(L.diagnostics={runnable:V,programLog:I,vertexShader:{log:W,prefix:M},fragmentShader:{log:Y,prefix:d}})}r.deleteShader(y),r.deleteShader(R),g=new Kr(r,x),w=Xy(r,x)}let g;this.getUniforms=function(){return g===void 0&&T(this),g};let w;this.getAttributes=function(){return w===void 0&&T(this),w};let O=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=r.getProgramParameter(x,Uy)),O},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(x),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Fy++,this.cacheKey=e,this.usedTimes=1,this.program=x,this.vertexShader=y,this.fragmentShader=R,this}var ib=0,Xc=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new qu(e),t.set(e,i)),i}},qu=class{constructor(e){this.id=ib++,this.code=e,this.usedTimes=0}};function nb(n){return n===vn||n===as||n===ls}function $x(n,e,t,i,r,s){let o=new Gr,a=new Xc,c=new Set,l=[],h=new Map,f=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(g){return c.add(g),g===0?"uv":`uv${g}`}function x(g,w,O,L,D,G){let k=L.fog,I=D.geometry,W=g.isMeshStandardMaterial||g.isMeshLambertMaterial||g.isMeshPhongMaterial?L.environment:null,Y=g.isMeshStandardMaterial||g.isMeshLambertMaterial&&!g.envMap||g.isMeshPhongMaterial&&!g.envMap,V=e.get(g.envMap||W,Y),ce=u[g.type],$=i.precision;g.precision!==null&&($=i.getMaxPrecision(g.precision),$!==g.precision&&ke("WebGLProgram.getParameters:",g.precision,"not supported, using",$,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ne=Q!==void 0?Q.length:0,he=0;I.morphAttributes.position!==void 0&&(he=1),I.morphAttributes.normal!==void 0&&(he=2),I.morphAttributes.color!==void 0&&(he=3);let ue,j,me,_e;if(ce){let Re=In[ce];ue=Re.vertexShader,j=Re.fragmentShader}else{ue=g.vertexShader,j=g.fragmentShader;let Re=a.getVertexShaderStage(g),lt=a.getFragmentShaderStage(g);a.update(g,Re,lt),me=Re.id,_e=lt.id}let Ae=n.getRenderTarget(),ye=n.state.buffers.depth.getReversed(),qe=D.isInstancedMesh===!0,rt=D.isBatchedMesh===!0,Ve=!!g.map,dt=!!g.matcap,ft=!!V,it=ft&&V.isPMREMTexture===!0,Xt=!!g.aoMap,Ut=!!g.lightMap,fi=!!g.bumpMap&&g.wireframe===!1,Pt=!!g.normalMap,wi=!!g.displacementMap,Mt=!!g.emissiveMap,vi=!!g.metalnessMap,jt=!!g.roughnessMap,ui=g.anisotropy>0,B=g.clearcoat>0,Ce=g.diffuseRoughness>0,Je=g.dispersion>0,st=g.retroreflectivity>0,be=g.iridescence>0,Dt=g.sheen>0,He=g.transmission>0,$e=ui&&!!g.anisotropyMap,C=B&&!!g.clearcoatMap,S=B&&!!g.clearcoatNormalMap,X=B&&!!g.clearcoatRoughnessMap,fe=Ce&&!!g.diffuseRoughnessMap,se=be&&!!g.iridescenceMap,xe=be&&!!g.iridescenceThicknessMap,ve=Dt&&!!g.sheenColorMap,ee=Dt&&!!g.sheenRoughnessMap,ie=!!g.specularMap,pe=!!g.specularColorMap,F=!!g.specularIntensityMap,re=He&&!!g.transmissionMap,te=He&&!!g.thicknessMap,Ee=!!g.gradientMap,ge=!!g.alphaMap,Se=g.alphaTest>0,We=!!g.alphaHash,je=!!g.extensions,le=gn;g.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(le=n.toneMapping);let Be=it?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,et={shaderID:ce,shaderType:g.type,shaderName:g.name,vertexShader:ue,fragmentShader:j,defines:g.defines,customVertexShaderID:me,customFragmentShaderID:_e,isRawShaderMaterial:g.isRawShaderMaterial===!0,glslVersion:g.glslVersion,precision:$,batching:rt,batchingColor:rt&&D._colorsTexture!==null,instancing:qe,instancingColor:qe&&D.instanceColor!==null,instancingMorph:qe&&D.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:ot.workingColorSpace,alphaToCoverage:!!g.alphaToCoverage,map:Ve,matcap:dt,envMap:ft,envMapMode:ft&&V.mapping,envMapPMREM:it,envMapMaxLod:it?Be.length-1:null,envMapSize:it?Be[0].width:null,aoMap:Xt,lightMap:Ut,bumpMap:fi,normalMap:Pt,displacementMap:wi,emissiveMap:Mt,normalMapObjectSpace:Pt&&g.normalMapType===Bp,normalMapTangentSpace:Pt&&g.normalMapType===Ga,packedNormalMap:Pt&&g.normalMapType===Ga&&nb(g.normalMap.format),metalnessMap:vi,roughnessMap:jt,anisotropy:ui,anisotropyMap:$e,clearcoat:B,clearcoatMap:C,clearcoatNormalMap:S,clearcoatRoughnessMap:X,diffuseRoughness:Ce,diffuseRoughnessMap:fe,dispersion:Je,retroreflection:st,iridescence:be,iridescenceMap:se,iridescenceThicknessMap:xe,sheen:Dt,sheenColorMap:ve,sheenRoughnessMap:ee,specularMap:ie,specularColorMap:pe,specularIntensityMap:F,transmission:He,transmissionMap:re,thicknessMap:te,gradientMap:Ee,opaque:g.transparent===!1&&g.blending===Nr&&g.alphaToCoverage===!1,alphaMap:ge,alphaTest:Se,alphaHash:We,combine:g.combine,mapUv:Ve&&m(g.map.channel),aoMapUv:Xt&&m(g.aoMap.channel),lightMapUv:Ut&&m(g.lightMap.channel),bumpMapUv:fi&&m(g.bumpMap.channel),normalMapUv:Pt&&m(g.normalMap.channel),displacementMapUv:wi&&m(g.displacementMap.channel),emissiveMapUv:Mt&&m(g.emissiveMap.channel),metalnessMapUv:vi&&m(g.metalnessMap.channel),roughnessMapUv:jt&&m(g.roughnessMap.channel),anisotropyMapUv:$e&&m(g.anisotropyMap.channel),clearcoatMapUv:C&&m(g.clearcoatMap.channel),clearcoatNormalMapUv:S&&m(g.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&m(g.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:fe&&m(g.diffuseRoughnessMap.channel),iridescenceMapUv:se&&m(g.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&m(g.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&m(g.sheenColorMap.channel),sheenRoughnessMapUv:ee&&m(g.sheenRoughnessMap.channel),specularMapUv:ie&&m(g.specularMap.channel),specularColorMapUv:pe&&m(g.specularColorMap.channel),specularIntensityMapUv:F&&m(g.specularIntensityMap.channel),transmissionMapUv:re&&m(g.transmissionMap.channel),thicknessMapUv:te&&m(g.thicknessMap.channel),alphaMapUv:ge&&m(g.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Pt||ui),vertexNormals:!!I.attributes.normal,vertexColors:g.vertexColors,vertexAlphas:g.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!I.attributes.uv&&(Ve||ge),fog:!!k,useFog:g.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:g.wireframe===!1&&(g.flatShading===!0||I.attributes.normal===void 0&&Pt===!1&&(g.isMeshLambertMaterial||g.isMeshPhongMaterial||g.isMeshStandardMaterial||g.isMeshPhysicalMaterial)),sizeAttenuation:g.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:ye,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:he,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:G.filter(Re=>Re.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:g.dithering,shadowMapEnabled:n.shadowMap.enabled&&O.length>0,shadowMapType:n.shadowMap.type,toneMapping:le,decodeVideoTexture:Ve&&g.map.isVideoTexture===!0&&ot.getTransfer(g.map.colorSpace)===vt,decodeVideoTextureEmissive:Mt&&g.emissiveMap.isVideoTexture===!0&&ot.getTransfer(g.emissiveMap.colorSpace)===vt,premultipliedAlpha:g.premultipliedAlpha,doubleSided:g.side===ji,flipSided:g.side===Jt,useDepthPacking:g.depthPacking>=0,depthPacking:g.depthPacking||0,index0AttributeName:g.index0AttributeName,extensionClipCullDistance:je&&g.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&g.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:g.customProgramCacheKey()};return et.vertexUv1s=c.has(1),et.vertexUv2s=c.has(2),et.vertexUv3s=c.has(3),c.clear(),et}function M(g){let w=[];if(g.shaderID?w.push(g.shaderID):(w.push(g.customVertexShaderID),w.push(g.customFragmentShaderID)),g.defines!==void 0)for(let O in g.defines)w.push(O),w.push(g.defines[O]);return g.isRawShaderMaterial===!1&&(d(w,g),p(w,g),w.push(n.outputColorSpace)),w.push(g.customProgramCacheKey),w.join()}function d(g,w){g.push(w.precision),g.push(w.outputColorSpace),g.push(w.envMapMode),g.push(w.envMapPMREM),g.push(w.envMapMaxLod),g.push(w.envMapSize),g.push(w.mapUv),g.push(w.alphaMapUv),g.push(w.lightMapUv),g.push(w.aoMapUv),g.push(w.bumpMapUv),g.push(w.normalMapUv),g.push(w.displacementMapUv),g.push(w.emissiveMapUv),g.push(w.metalnessMapUv),g.push(w.roughnessMapUv),g.push(w.anisotropyMapUv),g.push(w.clearcoatMapUv),g.push(w.clearcoatNormalMapUv),g.push(w.clearcoatRoughnessMapUv),g.push(w.diffuseRoughnessMapUv),g.push(w.iridescenceMapUv),g.push(w.iridescenceThicknessMapUv),g.push(w.sheenColorMapUv),g.push(w.sheenRoughnessMapUv),g.push(w.specularMapUv),g.push(w.specularColorMapUv),g.push(w.specularIntensityMapUv),g.push(w.transmissionMapUv),g.push(w.thicknessMapUv),g.push(w.combine),g.push(w.fogExp2),g.push(w.sizeAttenuation),g.push(w.morphTargetsCount),g.push(w.numSunLights),g.push(w.numDirLights),g.push(w.numPointLights),g.push(w.numSpotLights),g.push(w.numSpotLightMaps),g.push(w.numHemiLights),g.push(w.numRectAreaLights),g.push(w.numSunLightShadows),g.push(w.numDirLightShadows),g.push(w.numPointLightShadows),g.push(w.numSpotLightShadows),g.push(w.numSpotLightShadowsWithMaps),g.push(w.numLightProbes),g.push(w.numLightProbeGrids),g.push(w.shadowMapType),g.push(w.toneMapping),g.push(w.numClippingPlanes),g.push(w.numClipIntersection),g.push(w.depthPacking)}function p(g,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),g.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),g.push(o.mask)}function v(g){let w=u[g.type],O;if(w){let L=In[w];O=ym.clone(L.uniforms)}else O=g.uniforms;return O}function A(g,w){let O=h.get(w);return O!==void 0?++O.usedTimes:(O=new Zx(n,w,g,r),l.push(O),h.set(w,O)),O}function y(g){if(--g.usedTimes===0){let w=l.indexOf(g);l[w]=l[l.length-1],l.pop(),h.delete(g.cacheKey),g.destroy()}}function R(g){a.remove(g)}function T(){a.dispose()}return{getParameters:x,getProgramCacheKey:M,getUniforms:v,acquireProgram:A,releaseProgram:y,releaseShaderCache:R,programs:l,dispose:T}}function Jx(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,c){n.get(o)[a]=c}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function rb(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Qx(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function jx(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(u){let m=0;return u.isInstancedMesh&&(m+=2),u.isSkinnedMesh&&(m+=1),m}function a(u,m,x,M,d,p){let v=n[e];return v===void 0?(v={id:u.id,object:u,geometry:m,material:x,materialVariant:o(u),groupOrder:M,renderOrder:u.renderOrder,z:d,group:p},n[e]=v):(v.id=u.id,v.object=u,v.geometry=m,v.material=x,v.materialVariant=o(u),v.groupOrder=M,v.renderOrder=u.renderOrder,v.z=d,v.group=p),e++,v}function c(u,m,x,M,d,p,v){v.reversedDepth===!0&&(d=-d);let A=a(u,m,x,M,d,p);x.transmission>0?i.push(A):x.transparent===!0?r.push(A):t.push(A)}function l(u,m,x,M,d,p){let v=a(u,m,x,M,d,p);x.transmission>0?i.unshift(v):x.transparent===!0?r.unshift(v):t.unshift(v)}function h(u,m){t.length>1&&t.sort(u||rb),i.length>1&&i.sort(m||Qx),r.length>1&&r.sort(m||Qx)}function f(){for(let u=e,m=n.length;u<m;u++){let x=n[u];if(x.id===null)break;x.id=null,x.object=null,x.geometry=null,x.material=null,x.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:c,unshift:l,finish:f,sort:h}}function e_(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new jx,n.set(i,[o])):r>=s.length?(o=new jx,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function sb(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new U,color:new Xe};break;case"SpotLight":t={position:new U,direction:new U,color:new Xe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new U,color:new Xe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new U,skyColor:new Xe,groundColor:new Xe};break;case"RectAreaLight":t={color:new Xe,position:new U,halfWidth:new U,halfHeight:new U};break}return n[e.id]=t,t}}}function ob(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var ab=0;function lb(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function t_(n){let e=new sb,t=ob(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new U);let r=new U,s=new Ie,o=new Ie;function a(l){let h=0,f=0,u=0;for(let G=0;G<9;G++)i.probe[G].set(0,0,0);let m=0,x=0,M=0,d=0,p=0,v=0,A=0,y=0,R=0,T=0,g=0,w=0,O=0,L=0;l.sort(lb);for(let G=0,k=l.length;G<k;G++){let I=l[G],W=I.color,Y=I.intensity,V=I.distance,ce=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===vn?ce=I.shadow.map.texture:ce=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=W.r*Y,f+=W.g*Y,u+=W.b*Y;else if(I.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(I.sh.coefficients[$],Y);L++}else if(I.isSunLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ne=t.get(I);ne.shadowIntensity=Q.intensity,ne.shadowBias=Q.bias,ne.shadowNormalBias=Q.normalBias,ne.shadowRadius=Q.radius,ne.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[x]=ne,i.sunShadowMap[x]=ce;let he=Q.getViewportCount();for(let ue=0;ue<he;ue++)i.sunShadowMatrix[M+ue]=Q.getMatrix(ue),i.sunShadowCascade[M+ue]=Q._cascadeData[ue];M+=he,x++}i.sun[m]=$,m++}else if(I.isDirectionalLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ne=t.get(I);ne.shadowIntensity=Q.intensity,ne.shadowBias=Q.bias,ne.shadowNormalBias=Q.normalBias,ne.shadowRadius=Q.radius,ne.shadowMapSize=Q.mapSize,i.directionalShadow[d]=ne,i.directionalShadowMap[d]=ce,i.directionalShadowMatrix[d]=I.shadow.matrix,R++}i.directional[d]=$,d++}else if(I.isSpotLight){let $=e.get(I);$.position.setFromMatrixPosition(I.matrixWorld),$.color.copy(W).multiplyScalar(Y),$.distance=V,$.coneCos=Math.cos(I.angle),$.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),$.decay=I.decay,i.spot[v]=$;let Q=I.shadow;if(I.map&&(i.spotLightMap[w]=I.map,w++,Q.updateMatrices(I),I.castShadow&&O++),i.spotLightMatrix[v]=Q.matrix,I.castShadow){let ne=t.get(I);ne.shadowIntensity=Q.intensity,ne.shadowBias=Q.bias,ne.shadowNormalBias=Q.normalBias,ne.shadowRadius=Q.radius,ne.shadowMapSize=Q.mapSize,i.spotShadow[v]=ne,i.spotShadowMap[v]=ce,g++}v++}else if(I.isRectAreaLight){let $=e.get(I);$.color.copy(W).multiplyScalar(Y),$.halfWidth.set(I.width*.5,0,0),$.halfHeight.set(0,I.height*.5,0),i.rectArea[A]=$,A++}else if(I.isPointLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),$.distance=I.distance,$.decay=I.decay,I.castShadow){let Q=I.shadow,ne=t.get(I);ne.shadowIntensity=Q.intensity,ne.shadowBias=Q.bias,ne.shadowNormalBias=Q.normalBias,ne.shadowRadius=Q.radius,ne.shadowMapSize=Q.mapSize,ne.shadowCameraNear=Q.camera.near,ne.shadowCameraFar=Q.camera.far,i.pointShadow[p]=ne,i.pointShadowMap[p]=ce,i.pointShadowMatrix[p]=I.shadow.matrix,T++}i.point[p]=$,p++}else if(I.isHemisphereLight){let $=e.get(I);$.skyColor.copy(I.color).multiplyScalar(Y),$.groundColor.copy(I.groundColor).multiplyScalar(Y),i.hemi[y]=$,y++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=f,i.ambient[2]=u;let D=i.hash;(D.sunLength!==m||D.directionalLength!==d||D.pointLength!==p||D.spotLength!==v||D.rectAreaLength!==A||D.hemiLength!==y||D.numSunShadows!==x||D.numDirectionalShadows!==R||D.numPointShadows!==T||D.numSpotShadows!==g||D.numSpotMaps!==w||D.numLightProbes!==L)&&(i.sun.length=m,i.directional.length=d,i.spot.length=v,i.rectArea.length=A,i.point.length=p,i.hemi.length=y,i.sunShadow.length=x,i.sunShadowMap.length=x,i.sunShadowMatrix.length=M,i.sunShadowCascade.length=M,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=g,i.spotShadowMap.length=g,i.spotLightMatrix.length=g+w-O,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=O,i.numLightProbes=L,D.sunLength=m,D.directionalLength=d,D.pointLength=p,D.spotLength=v,D.rectAreaLength=A,D.hemiLength=y,D.numSunShadows=x,D.numDirectionalShadows=R,D.numPointShadows=T,D.numSpotShadows=g,D.numSpotMaps=w,D.numLightProbes=L,i.version=ab++)}function c(l,h){let f=0,u=0,m=0,x=0,M=0,d=0,p=h.matrixWorldInverse;for(let v=0,A=l.length;v<A;v++){let y=l[v];if(y.isSunLight){let R=i.sun[f];R.direction.setFromMatrixPosition(y.matrixWorld),R.direction.transformDirection(p),f++}else if(y.isDirectionalLight){let R=i.directional[u];R.direction.setFromMatrixPosition(y.matrixWorld),r.setFromMatrixPosition(y.target.matrixWorld),R.direction.sub(r),R.direction.transformDirection(p),u++}else if(y.isSpotLight){let R=i.spot[x];R.position.setFromMatrixPosition(y.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(y.matrixWorld),r.setFromMatrixPosition(y.target.matrixWorld),R.direction.sub(r),R.direction.transformDirection(p),x++}else if(y.isRectAreaLight){let R=i.rectArea[M];R.position.setFromMatrixPosition(y.matrixWorld),R.position.applyMatrix4(p),o.identity(),s.copy(y.matrixWorld),s.premultiply(p),o.extractRotation(s),R.halfWidth.set(y.width*.5,0,0),R.halfHeight.set(0,y.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),M++}else if(y.isPointLight){let R=i.point[m];R.position.setFromMatrixPosition(y.matrixWorld),R.position.applyMatrix4(p),m++}else if(y.isHemisphereLight){let R=i.hemi[d];R.direction.setFromMatrixPosition(y.matrixWorld),R.direction.transformDirection(p),d++}}}return{setup:a,setupView:c,state:i}}function i_(n){let e=new t_(n),t=[],i=[],r=[];function s(f){h.camera=f,t.length=0,i.length=0,r.length=0}function o(f){f.isLightProbeGrid?r.push(f):t.push(f)}function a(f){i.push(f)}function c(){e.setup(t),r.sort((f,u)=>f.priority-u.priority||f.id-u.id)}function l(f){e.setupView(t,f)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function n_(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new i_(n),e.set(r,[a])):s>=o.length?(a=new i_(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var r_=`
void main() {
gl_Position = vec4( position, 1.0 );
}
`,s_=`
uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
const float samples = float( VSM_SAMPLES );
float mean = 0.0;
float squared_mean = 0.0;
float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
for ( float i = 0.0; i < samples; i ++ ) {
float uvOffset = uvStart + i * uvStride;
#ifdef HORIZONTAL_PASS
vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
mean += distribution.x;
squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
#else
float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
mean += depth;
squared_mean += depth * depth;
#endif
}
mean = mean / samples;
squared_mean = squared_mean / samples;
float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}
`;var fb=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],ub=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],o_=new Ie,el=new U,Yu=new U;function a_(n,e,t){let i=new an,r=new Ze,s=new Ze,o=new bt,a=new Nc,c=new Ic,l={},h=t.maxTextureSize,f={[nn]:Jt,[Jt]:nn,[ji]:ji},u=new tn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ze},radius:{value:4}},vertexShader:r_,fragmentShader:s_}),m=u.clone();m.defines.HORIZONTAL_PASS=1;let x=new Qt;x.setAttribute("position",new Zt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new Ot(x,u),d=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Vs;let p=this.type;this.render=function(T,g,w){if(d.enabled===!1||d.autoUpdate===!1&&d.needsUpdate===!1||T.length===0)return;this.type===mp&&(ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Vs);let O=n.getRenderTarget(),L=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),G=n.state;G.setBlending(tr),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let k=p!==this.type;k&&g.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(W=>W.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,W=T.length;I<W;I++){let Y=T[I],V=Y.shadow;if(V===void 0){ke("WebGLShadowMap:",Y,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;r.copy(V.mapSize);let ce=V.getFrameExtents();r.multiply(ce),s.copy(V.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/ce.x),r.x=s.x*ce.x,V.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/ce.y),r.y=s.y*ce.y,V.mapSize.y=s.y));let $=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=$,V.map===null||k===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===os){if(Y.isPointLight){ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new Oi(r.x,r.y,{format:vn,type:Li,minFilter:xi,magFilter:xi,generateMipmaps:!1}),V.map.texture.name=Y.name+".shadowMap",V.map.depthTexture=new bn(r.x,r.y,li),V.map.depthTexture.name=Y.name+".shadowMapDepth",V.map.depthTexture.format=sn,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Yt,V.map.depthTexture.magFilter=Yt}else Y.isPointLight?(V.map=new Yr(r.x),V.map.depthTexture=new bo(r.x,Pi)):(V.map=new Oi(r.x,r.y),V.map.depthTexture=new bn(r.x,r.y,Pi)),V.map.depthTexture.name=Y.name+".shadowMap",V.map.depthTexture.format=sn,this.type===Vs?(V.map.depthTexture.compareFunction=$?tc:ec,V.map.depthTexture.minFilter=xi,V.map.depthTexture.magFilter=xi):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Yt,V.map.depthTexture.magFilter=Yt);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==r.x||V.map.height!==r.y)&&V.map.setSize(r.x,r.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();Y.isPointLight!==!0&&V.updateMatrices(Y,w);let ne=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:w.layers;for(let he=0;he<Q;he++){let ue=V.getCamera(he);if(Y.isPointLight){let j=V.camera,me=V.matrix,_e=Y.distance||j.far;_e!==j.far&&(j.far=_e,j.updateProjectionMatrix()),el.setFromMatrixPosition(Y.matrixWorld),j.position.copy(el),Yu.copy(j.position),Yu.add(fb[he]),j.up.copy(ub[he]),j.lookAt(Yu),j.updateMatrixWorld(),me.makeTranslation(-el.x,-el.y,-el.z),o_.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),V._frustum.setFromProjectionMatrix(o_,j.coordinateSystem,j.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,he),n.clear();else{he===0&&(n.setRenderTarget(V.map),n.clear());let j=V.getViewport(he);o.set(s.x*j.x,s.y*j.y,s.x*j.z,s.y*j.w),G.viewport(o)}i=V.getFrustum(he),y(g,w,ue,Y,ne,this.type)}V.isPointLightShadow!==!0&&this.type===os&&v(V,w),V.needsUpdate=!1}p=this.type,d.needsUpdate=!1,n.setRenderTarget(O,L,D)};function v(T,g){let w=e.update(M);u.defines.VSM_SAMPLES!==T.blurSamples&&(u.defines.VSM_SAMPLES=T.blurSamples,m.defines.VSM_SAMPLES=T.blurSamples,u.needsUpdate=!0,m.needsUpdate=!0),T.mapPass===null?T.mapPass=new Oi(r.x,r.y,{format:vn,type:Li}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),u.uniforms.shadow_pass.value=T.map.depthTexture,u.uniforms.resolution.value.set(T.map.width,T.map.height),u.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(g,null,w,u,M,null),m.uniforms.shadow_pass.value=T.mapPass.texture,m.uniforms.resolution.value.set(T.map.width,T.map.height),m.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(g,null,w,m,M,null)}function A(T,g,w,O){let L=null,D=w.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(D!==void 0)L=D;else if(L=w.isPointLight===!0?c:a,n.localClippingEnabled&&g.clipShadows===!0&&Array.isArray(g.clippingPlanes)&&g.clippingPlanes.length!==0||g.displacementMap&&g.displacementScale!==0||g.alphaMap&&g.alphaTest>0||g.map&&g.alphaTest>0||g.alphaToCoverage===!0){let G=L.uuid,k=g.uuid,I=l[G];I===void 0&&(I={},l[G]=I);let W=I[k];W===void 0&&(W=L.clone(),I[k]=W,g.addEventListener("dispose",R)),L=W}if(L.visible=g.visible,L.wireframe=g.wireframe,O===os?L.side=g.shadowSide!==null?g.shadowSide:g.side:L.side=g.shadowSide!==null?g.shadowSide:f[g.side],L.alphaMap=g.alphaMap,L.alphaTest=g.alphaToCoverage===!0?.5:g.alphaTest,L.map=g.map,L.clipShadows=g.clipShadows,L.clippingPlanes=g.clippingPlanes,L.clipIntersection=g.clipIntersection,L.displacementMap=g.displacementMap,L.displacementScale=g.displacementScale,L.displacementBias=g.displacementBias,L.wireframeLinewidth=g.wireframeLinewidth,L.linewidth=g.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let G=n.properties.get(L);G.light=w}return L}function y(T,g,w,O,L,D){if(T.visible===!1)return;if(T.layers.test(L)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&D===os)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,T.matrixWorld);let I=e.update(T),W=T.material;if(Array.isArray(W)){let Y=I.groups;for(let V=0,ce=Y.length;V<ce;V++){let $=Y[V],Q=W[$.materialIndex];if(Q&&Q.visible){let ne=A(T,Q,O,D);T.onBeforeShadow(n,T,g,w,I,ne,$),n.renderBufferDirect(w,null,I,ne,T,$),T.onAfterShadow(n,T,g,w,I,ne,$)}}}else if(W.visible){let Y=A(T,W,O,D);T.onBeforeShadow(n,T,g,w,I,Y,null),n.renderBufferDirect(w,null,I,Y,T,null),T.onAfterShadow(n,T,g,w,I,Y,null)}}let k=T.children;for(let I=0,W=k.length;I<W;I++)y(k[I],g,w,O,L,D)}function R(T){T.target.removeEventListener("dispose",R);for(let w in l){let O=l[w],L=T.target.uuid;L in O&&(O[L].dispose(),delete O[L])}}}function l_(n,e){function t(){let F=!1,re=new bt,te=null,Ee=new bt(0,0,0,0);return{setMask:function(ge){te!==ge&&!F&&(n.colorMask(ge,ge,ge,ge),te=ge)},setLocked:function(ge){F=ge},setClear:function(ge,Se,We,je,le){le===!0&&(ge*=je,Se*=je,We*=je),re.set(ge,Se,We,je),Ee.equals(re)===!1&&(n.clearColor(ge,Se,We,je),Ee.copy(re))},reset:function(){F=!1,te=null,Ee.set(-1,0,0,0)}}}function i(){let F=!1,re=!1,te=null,Ee=null,ge=null;return{setReversed:function(Se){if(re!==Se){let We=e.get("EXT_clip_control");Se?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let je=ge;ge=null,this.setClear(je)}},getReversed:function(){return re},setTest:function(Se){Se?ye(n.DEPTH_TEST):qe(n.DEPTH_TEST)},setMask:function(Se){te!==Se&&!F&&(n.depthMask(Se),te=Se)},setFunc:function(Se){if(re&&(Se=Jp[Se]),Ee!==Se){switch(Se){case jo:n.depthFunc(n.NEVER);break;case ea:n.depthFunc(n.ALWAYS);break;case ta:n.depthFunc(n.LESS);break;case Ur:n.depthFunc(n.LEQUAL);break;case ia:n.depthFunc(n.EQUAL);break;case na:n.depthFunc(n.GEQUAL);break;case ra:n.depthFunc(n.GREATER);break;case sa:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ee=Se}},setLocked:function(Se){F=Se},setClear:function(Se){ge!==Se&&(ge=Se,re&&(Se=1-Se),n.clearDepth(Se))},reset:function(){F=!1,te=null,Ee=null,ge=null,re=!1}}}function r(){let F=!1,re=null,te=null,Ee=null,ge=null,Se=null,We=null,je=null,le=null;return{setTest:function(Be){F||(Be?ye(n.STENCIL_TEST):qe(n.STENCIL_TEST))},setMask:function(Be){re!==Be&&!F&&(n.stencilMask(Be),re=Be)},setFunc:function(Be,et,Re){(te!==Be||Ee!==et||ge!==Re)&&(n.stencilFunc(Be,et,Re),te=Be,Ee=et,ge=Re)},setOp:function(Be,et,Re){(Se!==Be||We!==et||je!==Re)&&(n.stencilOp(Be,et,Re),Se=Be,We=et,je=Re)},setLocked:function(Be){F=Be},setClear:function(Be){le!==Be&&(n.clearStencil(Be),le=Be)},reset:function(){F=!1,re=null,te=null,Ee=null,ge=null,Se=null,We=null,je=null,le=null}}}let s=new t,o=new i,a=new r,c={},l=new WeakMap,h={},f={},u={},m=new WeakMap,x=[],M=null,d=!1,p=null,v=null,A=null,y=null,R=null,T=null,g=null,w=new Xe(0,0,0),O=0,L=!1,D=null,G=null,k=null,I=null,W=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ce=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec($)[1]),V=ce>=1):$.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),V=ce>=2);let Q=null,ne={},he=n.getParameter(n.SCISSOR_BOX),ue=n.getParameter(n.VIEWPORT),j=new bt().fromArray(he),me=new bt().fromArray(ue);function _e(F,re,te,Ee){let ge=new Uint8Array(4),Se=n.createTexture();n.bindTexture(F,Se),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<te;We++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ee,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(re+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return Se}let Ae={};Ae[n.TEXTURE_2D]=_e(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=_e(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=_e(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=_e(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ye(n.DEPTH_TEST),o.setFunc(Ur),fi(!1),Pt(fu),ye(n.CULL_FACE),Xt(tr);function ye(F){h[F]!==!0&&(n.enable(F),h[F]=!0)}function qe(F){h[F]!==!1&&(n.disable(F),h[F]=!1)}function rt(F,re){return u[F]!==re?(n.bindFramebuffer(F,re),u[F]=re,F===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=re),F===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Ve(F,re){let te=x,Ee=!1;if(F){te=m.get(re),te===void 0&&(te=[],m.set(re,te));let ge=F.textures;if(te.length!==ge.length||te[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,We=ge.length;Se<We;Se++)te[Se]=n.COLOR_ATTACHMENT0+Se;te.length=ge.length,Ee=!0}}else te[0]!==n.BACK&&(te[0]=n.BACK,Ee=!0);Ee&&n.drawBuffers(te)}function dt(F){return M!==F?(n.useProgram(F),M=F,!0):!1}let ft={[Ir]:n.FUNC_ADD,[xp]:n.FUNC_SUBTRACT,[_p]:n.FUNC_REVERSE_SUBTRACT};ft[vp]=n.MIN,ft[Mp]=n.MAX;let it={[Sp]:n.ZERO,[yp]:n.ONE,[bp]:n.SRC_COLOR,[Ul]:n.SRC_ALPHA,[Cp]:n.SRC_ALPHA_SATURATE,[Ap]:n.DST_COLOR,[wp]:n.DST_ALPHA,[Ep]:n.ONE_MINUS_SRC_COLOR,[Fl]:n.ONE_MINUS_SRC_ALPHA,[Rp]:n.ONE_MINUS_DST_COLOR,[Tp]:n.ONE_MINUS_DST_ALPHA,[Pp]:n.CONSTANT_COLOR,[Lp]:n.ONE_MINUS_CONSTANT_COLOR,[Dp]:n.CONSTANT_ALPHA,[Np]:n.ONE_MINUS_CONSTANT_ALPHA};function Xt(F,re,te,Ee,ge,Se,We,je,le,Be){if(F===tr){d===!0&&(qe(n.BLEND),d=!1);return}if(d===!1&&(ye(n.BLEND),d=!0),F!==gp){if(F!==p||Be!==L){if((v!==Ir||R!==Ir)&&(n.blendEquation(n.FUNC_ADD),v=Ir,R=Ir),Be)switch(F){case Nr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case uu:n.blendFunc(n.ONE,n.ONE);break;case hu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case du:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ht("WebGLState: Invalid blending: ",F);break}else switch(F){case Nr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case uu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case hu:ht("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case du:ht("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ht("WebGLState: Invalid blending: ",F);break}A=null,y=null,T=null,g=null,w.set(0,0,0),O=0,p=F,L=Be}return}ge=ge||re,Se=Se||te,We=We||Ee,(re!==v||ge!==R)&&(n.blendEquationSeparate(ft[re],ft[ge]),v=re,R=ge),(te!==A||Ee!==y||Se!==T||We!==g)&&(n.blendFuncSeparate(it[te],it[Ee],it[Se],it[We]),A=te,y=Ee,T=Se,g=We),(je.equals(w)===!1||le!==O)&&(n.blendColor(je.r,je.g,je.b,le),w.copy(je),O=le),p=F,L=!1}function Ut(F,re){F.side===ji?qe(n.CULL_FACE):ye(n.CULL_FACE);let te=F.side===Jt;re&&(te=!te),fi(te),F.blending===Nr&&F.transparent===!1?Xt(tr):Xt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),s.setMask(F.colorWrite);let Ee=F.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),Mt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?ye(n.SAMPLE_ALPHA_TO_COVERAGE):qe(n.SAMPLE_ALPHA_TO_COVERAGE)}function fi(F){D!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),D=F)}function Pt(F){F!==dp?(ye(n.CULL_FACE),F!==G&&(F===fu?n.cullFace(n.BACK):F===pp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):qe(n.CULL_FACE),G=F}function wi(F){F!==k&&(V&&n.lineWidth(F),k=F)}function Mt(F,re,te){F?(ye(n.POLYGON_OFFSET_FILL),(I!==re||W!==te)&&(I=re,W=te,o.getReversed()&&(re=-re,te=-te),n.polygonOffset(re,te))):qe(n.POLYGON_OFFSET_FILL)}function vi(F){F?ye(n.SCISSOR_TEST):qe(n.SCISSOR_TEST)}function jt(F){F===void 0&&(F=n.TEXTURE0+Y-1),Q!==F&&(n.activeTexture(F),Q=F)}function ui(F,re,te){te===void 0&&(Q===null?te=n.TEXTURE0+Y-1:te=Q);let Ee=ne[te];Ee===void 0&&(Ee={type:void 0,texture:void 0},ne[te]=Ee),(Ee.type!==F||Ee.texture!==re)&&(Q!==te&&(n.activeTexture(te),Q=te),n.bindTexture(F,re||Ae[F]),Ee.type=F,Ee.texture=re)}function B(){let F=ne[Q];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Ce(){try{n.compressedTexImage2D(...arguments)}catch(F){ht("WebGLState:",F)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(F){ht("WebGLState:",F)}}function st(){try{n.texSubImage2D(...arguments)}catch(F){ht("WebGLState:",F)}}function be(){try{n.texSubImage3D(...arguments)}catch(F){ht("WebGLState:",F)}}function Dt(){try{n.compressedTexSubImage2D(...arguments)}catch(F){ht("WebGLState:",F)}}function He(){try{n.compressedTexSubImage3D(...arguments)}catch(F){ht("WebGLState:",F)}}function $e(){try{n.texStorage2D(...arguments)}catch(F){ht("WebGLState:",F)}}function C(){try{n.texStorage3D(...arguments)}catch(F){ht("WebGLState:",F)}}function S(){try{n.texImage2D(...arguments)}catch(F){ht("WebGLState:",F)}}function X(){try{n.texImage3D(...arguments)}catch(F){ht("WebGLState:",F)}}function fe(F){return f[F]!==void 0?f[F]:n.getParameter(F)}function se(F,re){f[F]!==re&&(n.pixelStorei(F,re),f[F]=re)}function xe(F){j.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),j.copy(F))}function ve(F){me.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),me.copy(F))}function ee(F,re){let te=l.get(re);te===void 0&&(te=new WeakMap,l.set(re,te));let Ee=te.get(F);Ee===void 0&&(Ee=n.getUniformBlockIndex(re,F.name),n.uniformBlockBinding(re,Ee,Ee),te.set(F,Ee))}function ie(F,re,te){let ge=l.get(re).get(F);c[ge]!==te&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,te),c[ge]=te)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},f={},Q=null,ne={},u={},c={},m=new WeakMap,x=[],M=null,d=!1,p=null,v=null,A=null,y=null,R=null,T=null,g=null,w=new Xe(0,0,0),O=0,L=!1,D=null,G=null,k=null,I=null,W=null,j.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:ye,disable:qe,bindFramebuffer:rt,drawBuffers:Ve,useProgram:dt,setBlending:Xt,setMaterial:Ut,setFlipSided:fi,setCullFace:Pt,setLineWidth:wi,setPolygonOffset:Mt,setScissorTest:vi,activeTexture:jt,bindTexture:ui,unbindTexture:B,compressedTexImage2D:Ce,compressedTexImage3D:Je,texImage2D:S,texImage3D:X,pixelStorei:se,getParameter:fe,updateUBOMapping:ee,uniformBlockBinding:ie,texStorage2D:$e,texStorage3D:C,texSubImage2D:st,texSubImage3D:be,compressedTexSubImage2D:Dt,compressedTexSubImage3D:He,scissor:xe,viewport:ve,reset:pe}}function c_(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Ze,h=new WeakMap,f=new Set,u,m=new WeakMap,x=new Set,M=new FinalizationRegistry(C=>x.delete(C)),d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(C,S){return d?new OffscreenCanvas(C,S):no("canvas")}function v(C,S,X){let fe=1,se=$e(C);if((se.width>X||se.height>X)&&(fe=X/Math.max(se.width,se.height)),fe<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let xe=Math.floor(fe*se.width),ve=Math.floor(fe*se.height);u===void 0&&(u=p(xe,ve));let ee=S?p(xe,ve):u;return ee.width=xe,ee.height=ve,ee.getContext("2d").drawImage(C,0,0,xe,ve),ke("WebGLRenderer: Texture has been resized from ("+se.width+"x"+se.height+") to ("+xe+"x"+ve+")."),ee}else return"data"in C&&ke("WebGLRenderer: Image in DataTexture is too big ("+se.width+"x"+se.height+")."),C;return C}function A(C){return C.generateMipmaps}function y(C){n.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?n.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(C,S,X,fe,se,xe=!1){if(C!==null){if(n[C]!==void 0)return n[C];ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ve;fe&&(ve=e.get("EXT_texture_norm16"),ve||ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=S;if(S===n.RED&&(X===n.FLOAT&&(ee=n.R32F),X===n.HALF_FLOAT&&(ee=n.R16F),X===n.UNSIGNED_BYTE&&(ee=n.R8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.R16_EXT),X===n.SHORT&&ve&&(ee=ve.R16_SNORM_EXT)),S===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.R8UI),X===n.UNSIGNED_SHORT&&(ee=n.R16UI),X===n.UNSIGNED_INT&&(ee=n.R32UI),X===n.BYTE&&(ee=n.R8I),X===n.SHORT&&(ee=n.R16I),X===n.INT&&(ee=n.R32I)),S===n.RG&&(X===n.FLOAT&&(ee=n.RG32F),X===n.HALF_FLOAT&&(ee=n.RG16F),X===n.UNSIGNED_BYTE&&(ee=n.RG8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RG16_EXT),X===n.SHORT&&ve&&(ee=ve.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RG8UI),X===n.UNSIGNED_SHORT&&(ee=n.RG16UI),X===n.UNSIGNED_INT&&(ee=n.RG32UI),X===n.BYTE&&(ee=n.RG8I),X===n.SHORT&&(ee=n.RG16I),X===n.INT&&(ee=n.RG32I)),S===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGB8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGB16UI),X===n.UNSIGNED_INT&&(ee=n.RGB32UI),X===n.BYTE&&(ee=n.RGB8I),X===n.SHORT&&(ee=n.RGB16I),X===n.INT&&(ee=n.RGB32I)),S===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGBA16UI),X===n.UNSIGNED_INT&&(ee=n.RGBA32UI),X===n.BYTE&&(ee=n.RGBA8I),X===n.SHORT&&(ee=n.RGBA16I),X===n.INT&&(ee=n.RGBA32I)),S===n.RGB&&(X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGB16_EXT),X===n.SHORT&&ve&&(ee=ve.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(ee=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(ee=n.R11F_G11F_B10F)),S===n.RGBA){let ie=xe?fs:ot.getTransfer(se);X===n.FLOAT&&(ee=n.RGBA32F),X===n.HALF_FLOAT&&(ee=n.RGBA16F),X===n.UNSIGNED_BYTE&&(ee=ie===vt?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGBA16_EXT),X===n.SHORT&&ve&&(ee=ve.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(ee=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(ee=n.RGB5_A1)}return(ee===n.R16F||ee===n.R32F||ee===n.RG16F||ee===n.RG32F||ee===n.RGBA16F||ee===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function g(C,S){let X;return C?S===null||S===Pi||S===kn?X=n.DEPTH24_STENCIL8:S===li?X=n.DEPTH32F_STENCIL8:S===mr&&(X=n.DEPTH24_STENCIL8,ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Pi||S===kn?X=n.DEPTH_COMPONENT24:S===li?X=n.DEPTH_COMPONENT32F:S===mr&&(X=n.DEPTH_COMPONENT16),X}function w(C,S){return A(C)===!0||C.isFramebufferTexture&&C.minFilter!==Yt&&C.minFilter!==xi?Math.log2(Math.max(S.width,S.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?S.mipmaps.length:1}function O(C){let S=new WeakRef(C);i.get(C).__ref=S,x.add(S),M.register(C,S,S)}function L(C){let S=i.get(C).__ref;S!==void 0&&(x.delete(S),M.unregister(S))}function D(C){k(C.target)}function G(C){I(C.target)}function k(C){C.removeEventListener("dispose",D),L(C),Y(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&f.delete(C)}function I(C){C.removeEventListener("dispose",G),L(C),ce(C)}function W(){for(let C of x){let S=C.deref();S!==void 0&&(S.isRenderTarget===!0?I(S):k(S))}x.clear(),f.clear()}function Y(C){let S=i.get(C);if(S.__webglInit===void 0)return;let X=C.source,fe=m.get(X);if(fe){let se=fe[S.__cacheKey];se.usedTimes--,se.usedTimes===0&&V(C),Object.keys(fe).length===0&&m.delete(X)}i.remove(C)}function V(C){let S=i.get(C);n.deleteTexture(S.__webglTexture);let X=C.source,fe=m.get(X);delete fe[S.__cacheKey],o.memory.textures--}function ce(C){let S=i.get(C);S.__depthDisposeCallback&&S.__depthDisposeCallback();let X=C.depthTexture;if(X&&X.renderTarget===C&&k(X),C.isWebGLCubeRenderTarget)for(let se=0;se<6;se++){if(Array.isArray(S.__webglFramebuffer[se]))for(let xe=0;xe<S.__webglFramebuffer[se].length;xe++)n.deleteFramebuffer(S.__webglFramebuffer[se][xe]);else n.deleteFramebuffer(S.__webglFramebuffer[se]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[se])}else{if(Array.isArray(S.__webglFramebuffer))for(let se=0;se<S.__webglFramebuffer.length;se++)n.deleteFramebuffer(S.__webglFramebuffer[se]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let se=0;se<S.__webglColorRenderbuffer.length;se++)S.__webglColorRenderbuffer[se]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[se]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let fe=C.textures;for(let se=0,xe=fe.length;se<xe;se++){let ve=i.get(fe[se]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(fe[se])}i.remove(C)}let $=0;function Q(){$=0}function ne(){return $}function he(C){$=C}function ue(){let C=$;return C>=r.maxTextures&&ke("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+r.maxTextures),$+=1,C}function j(C){let S=[];return S.push(C.wrapS),S.push(C.wrapT),S.push(C.wrapR||0),S.push(C.magFilter),S.push(C.minFilter),S.push(C.anisotropy),S.push(C.internalFormat),S.push(C.format),S.push(C.type),S.push(C.generateMipmaps),S.push(C.mipmapsAutoUpdate),S.push(C.premultiplyAlpha),S.push(C.flipY),S.push(C.unpackAlignment),S.push(C.colorSpace),S.join()}function me(C,S){let X=i.get(C);if(C.isVideoTexture&&Dt(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&X.__version!==C.version){let fe=C.image;if(fe===null)ke("WebGLRenderer: Texture marked for update but no image data found.");else if(fe.complete===!1)ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Ut(X,C,S);return}}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+S)}function _e(C,S){let X=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){Ut(X,C,S);return}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+S)}function Ae(C,S){let X=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){Ut(X,C,S);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+S)}function ye(C,S){let X=i.get(C);if(C.version>0&&X.__version!==C.version){fi(X,C,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+S)}let qe={[oa]:n.REPEAT,[rn]:n.CLAMP_TO_EDGE,[aa]:n.MIRRORED_REPEAT},rt={[Yt]:n.NEAREST,[Fp]:n.NEAREST_MIPMAP_NEAREST,[la]:n.NEAREST_MIPMAP_LINEAR,[xi]:n.LINEAR,[ql]:n.LINEAR_MIPMAP_NEAREST,[xn]:n.LINEAR_MIPMAP_LINEAR},Ve={[zp]:n.NEVER,[ic]:n.ALWAYS,[kp]:n.LESS,[ec]:n.LEQUAL,[Hp]:n.EQUAL,[tc]:n.GEQUAL,[Vp]:n.GREATER,[Wp]:n.NOTEQUAL};function dt(C,S){if(S.type===li&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===xi||S.magFilter===ql||S.magFilter===la||S.magFilter===xn||S.minFilter===xi||S.minFilter===ql||S.minFilter===la||S.minFilter===xn)&&ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(C,n.TEXTURE_WRAP_S,qe[S.wrapS]),n.texParameteri(C,n.TEXTURE_WRAP_T,qe[S.wrapT]),(C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY)&&n.texParameteri(C,n.TEXTURE_WRAP_R,qe[S.wrapR]),n.texParameteri(C,n.TEXTURE_MAG_FILTER,rt[S.magFilter]),n.texParameteri(C,n.TEXTURE_MIN_FILTER,rt[S.minFilter]),S.compareFunction&&(n.texParameteri(C,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(C,n.TEXTURE_COMPARE_FUNC,Ve[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Yt||S.minFilter!==la&&S.minFilter!==xn||S.type===li&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(C,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,r.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function ft(C,S){let X=!1;C.__webglInit===void 0&&(C.__webglInit=!0,S.addEventListener("dispose",D),O(S));let fe=S.source,se=m.get(fe);se===void 0&&(se={},m.set(fe,se));let xe=j(S);if(xe!==C.__cacheKey){se[xe]===void 0&&(se[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),se[xe].usedTimes++;let ve=se[C.__cacheKey];ve!==void 0&&(se[C.__cacheKey].usedTimes--,ve.usedTimes===0&&V(S)),C.__cacheKey=xe,C.__webglTexture=se[xe].texture}return X}function it(C,S,X){return Math.floor(Math.floor(C/X)/S)}function Xt(C,S,X,fe){let xe=C.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,X,fe,S.data);else{xe.sort((F,re)=>F.start-re.start);let ve=0;for(let F=1;F<xe.length;F++){let re=xe[ve],te=xe[F],Ee=re.start+re.count,ge=it(te.start,S.width,4),Se=it(re.start,S.width,4);te.start<=Ee+1&&ge===Se&&it(te.start+te.count-1,S.width,4)===ge?re.count=Math.max(re.count,te.start+te.count-re.start):(++ve,xe[ve]=te)}xe.length=ve+1;let ee=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let F=0,re=xe.length;F<re;F++){let te=xe[F],Ee=Math.floor(te.start/4),ge=Math.ceil(te.count/4),Se=Ee%S.width,We=Math.floor(Ee/S.width),je=ge,le=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,Se,We,je,le,X,fe,S.data)}C.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ee),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Ut(C,S,X){let fe=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(fe=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(fe=n.TEXTURE_3D);let se=ft(C,S),xe=S.source;t.bindTexture(fe,C.__webglTexture,n.TEXTURE0+X);let ve=i.get(xe);if(xe.version!==ve.__version||se===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let le=ot.getPrimaries(ot.workingColorSpace),Be=S.colorSpace===Cn?null:ot.getPrimaries(S.colorSpace),et=S.colorSpace===Cn||le===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let ie=v(S.image,!1,r.maxTextureSize);ie=He(S,ie);let pe=s.convert(S.format,S.colorSpace),F=s.convert(S.type),re=T(S.internalFormat,pe,F,S.normalized,S.colorSpace,S.isVideoTexture);dt(fe,S);let te,Ee=S.mipmaps,ge=S.isVideoTexture!==!0,Se=ve.__version===void 0||se===!0,We=xe.dataReady,je=w(S,ie);if(S.isDepthTexture)re=g(S.format===_n,S.type),Se&&(ge?t.texStorage2D(n.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,F,null));else if(S.isDataTexture)if(Ee.length>0){ge&&Se&&t.texStorage2D(n.TEXTURE_2D,je,re,Ee[0].width,Ee[0].height);for(let le=0,Be=Ee.length;le<Be;le++)te=Ee[le],ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,pe,F,te.data):t.texImage2D(n.TEXTURE_2D,le,re,te.width,te.height,0,pe,F,te.data);S.generateMipmaps=!1}else ge?(Se&&t.texStorage2D(n.TEXTURE_2D,je,re,ie.width,ie.height),We&&Xt(S,ie,pe,F)):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,F,ie.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){ge&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,re,Ee[0].width,Ee[0].height,ie.depth);for(let le=0,Be=Ee.length;le<Be;le++)if(te=Ee[le],S.format!==Di)if(pe!==null)if(ge){if(We)if(S.layerUpdates.size>0){let et=Bu(te.width,te.height,S.format,S.type);for(let Re of S.layerUpdates){let lt=te.data.subarray(Re*et/te.data.BYTES_PER_ELEMENT,(Re+1)*et/te.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,Re,te.width,te.height,1,pe,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ie.depth,pe,te.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,le,re,te.width,te.height,ie.depth,0,te.data,0,0);else ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ie.depth,pe,F,te.data):t.texImage3D(n.TEXTURE_2D_ARRAY,le,re,te.width,te.height,ie.depth,0,pe,F,te.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{ge&&Se&&t.texStorage2D(n.TEXTURE_2D,je,re,Ee[0].width,Ee[0].height);for(let le=0,Be=Ee.length;le<Be;le++)te=Ee[le],S.format!==Di?pe!==null?ge?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,pe,te.data):t.compressedTexImage2D(n.TEXTURE_2D,le,re,te.width,te.height,0,te.data):ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,pe,F,te.data):t.texImage2D(n.TEXTURE_2D,le,re,te.width,te.height,0,pe,F,te.data)}else if(S.isDataArrayTexture)if(ge){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,re,ie.width,ie.height,ie.depth),We)if(S.layerUpdates.size>0){let le=Bu(ie.width,ie.height,S.format,S.type);for(let Be of S.layerUpdates){let et=ie.data.subarray(Be*le/ie.data.BYTES_PER_ELEMENT,(Be+1)*le/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,ie.width,ie.height,1,pe,F,et)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,pe,F,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,pe,F,ie.data);else if(S.isData3DTexture)ge?(Se&&t.texStorage3D(n.TEXTURE_3D,je,re,ie.width,ie.height,ie.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,pe,F,ie.data)):t.texImage3D(n.TEXTURE_3D,0,re,ie.width,ie.height,ie.depth,0,pe,F,ie.data);else if(S.isFramebufferTexture){if(Se)if(ge)t.texStorage2D(n.TEXTURE_2D,je,re,ie.width,ie.height);else{let le=ie.width,Be=ie.height;for(let et=0;et<je;et++)t.texImage2D(n.TEXTURE_2D,et,re,le,Be,0,pe,F,null),le>>=1,Be>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let le=n.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),ie.parentNode!==le){le.appendChild(ie),f.add(S),le.onpaint=Be=>{let et=Be.changedElements;for(let Re of f)et.includes(Re.image)&&(Re.needsUpdate=!0)},le.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let et=n.RGBA,Re=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Re,lt,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(ge&&Se){let le=$e(Ee[0]);t.texStorage2D(n.TEXTURE_2D,je,re,le.width,le.height)}for(let le=0,Be=Ee.length;le<Be;le++)te=Ee[le],ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,pe,F,te):t.texImage2D(n.TEXTURE_2D,le,re,pe,F,te);S.generateMipmaps=!1}else if(ge){if(Se){let le=$e(ie);t.texStorage2D(n.TEXTURE_2D,je,re,le.width,le.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,F,ie)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,F,ie);A(S)&&S.mipmapsAutoUpdate===!0&&y(fe),ve.__version=xe.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function fi(C,S,X){if(S.image.length!==6)return;let fe=ft(C,S),se=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,C.__webglTexture,n.TEXTURE0+X);let xe=i.get(se);if(se.version!==xe.__version||fe===!0){t.activeTexture(n.TEXTURE0+X);let ve=ot.getPrimaries(ot.workingColorSpace),ee=S.colorSpace===Cn?null:ot.getPrimaries(S.colorSpace),ie=S.colorSpace===Cn||ve===ee?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let pe=S.isCompressedTexture||S.image[0].isCompressedTexture,F=S.image[0]&&S.image[0].isDataTexture,re=[];for(let Re=0;Re<6;Re++)!pe&&!F?re[Re]=v(S.image[Re],!0,r.maxCubemapSize):re[Re]=F?S.image[Re].image:S.image[Re],re[Re]=He(S,re[Re]);let te=re[0],Ee=s.convert(S.format,S.colorSpace),ge=s.convert(S.type),Se=T(S.internalFormat,Ee,ge,S.normalized,S.colorSpace),We=S.isVideoTexture!==!0,je=xe.__version===void 0||fe===!0,le=se.dataReady,Be=w(S,te);dt(n.TEXTURE_CUBE_MAP,S);let et;if(S.isDepthTexture){if(Se=g(S.format===_n,S.type),je)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,te.width,te.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,te.width,te.height,0,Ee,ge,null)}else if(pe){We&&je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,te.width,te.height);for(let Re=0;Re<6;Re++){et=re[Re].mipmaps;for(let lt=0;lt<et.length;lt++){let Bt=et[lt];S.format!==Di?Ee!==null?We?le&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Bt.width,Bt.height,Ee,Bt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Se,Bt.width,Bt.height,0,Bt.data):ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Bt.width,Bt.height,Ee,ge,Bt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Se,Bt.width,Bt.height,0,Ee,ge,Bt.data)}}}else{if(et=S.mipmaps,We&&je){et.length>0&&Be++;let Re=$e(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(F){We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,re[Re].width,re[Re].height,Ee,ge,re[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,re[Re].width,re[Re].height,0,Ee,ge,re[Re].data);for(let lt=0;lt<et.length;lt++){let Yi=et[lt].image[Re].image;We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,Yi.width,Yi.height,Ee,ge,Yi.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Se,Yi.width,Yi.height,0,Ee,ge,Yi.data)}}else{We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Ee,ge,re[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,Ee,ge,re[Re]);for(let lt=0;lt<et.length;lt++){let Bt=et[lt];We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,Ee,ge,Bt.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Se,Ee,ge,Bt.image[Re])}}}A(S)&&S.mipmapsAutoUpdate===!0&&y(n.TEXTURE_CUBE_MAP),xe.__version=se.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function Pt(C,S,X,fe,se,xe){let ve=s.convert(X.format,X.colorSpace),ee=s.convert(X.type),ie=T(X.internalFormat,ve,ee,X.normalized,X.colorSpace),pe=i.get(S),F=i.get(X);if(F.__renderTarget=S,!pe.__hasExternalTextures){let re=Math.max(1,S.width>>xe),te=Math.max(1,S.height>>xe);se===n.TEXTURE_3D||se===n.TEXTURE_2D_ARRAY?t.texImage3D(se,xe,ie,re,te,S.depth,0,ve,ee,null):t.texImage2D(se,xe,ie,re,te,0,ve,ee,null)}t.bindFramebuffer(n.FRAMEBUFFER,C),be(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,fe,se,F.__webglTexture,0,st(S)):(se===n.TEXTURE_2D||se>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&se<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,fe,se,F.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function wi(C,S,X){if(n.bindRenderbuffer(n.RENDERBUFFER,C),S.depthBuffer){let fe=S.depthTexture,se=fe&&fe.isDepthTexture?fe.type:null,xe=g(S.stencilBuffer,se),ve=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;be(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(S),xe,S.width,S.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(S),xe,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,xe,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,C)}else{let fe=S.textures;for(let se=0;se<fe.length;se++){let xe=fe[se],ve=s.convert(xe.format,xe.colorSpace),ee=s.convert(xe.type),ie=T(xe.internalFormat,ve,ee,xe.normalized,xe.colorSpace);be(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(S),ie,S.width,S.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(S),ie,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ie,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Mt(C,S,X){let fe=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,C),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let se=i.get(S.depthTexture);se.__renderTarget=S;let xe=fe?S.depthTexture.image[0]:S.depthTexture.image;(!se.__webglTexture||xe.width!==S.width||xe.height!==S.height)&&(xe.width=S.width,xe.height=S.height,S.depthTexture.needsUpdate=!0),fe?ye(S.depthTexture,0):me(S.depthTexture,0);let ve=se.__webglTexture,ee=st(S),ie=fe?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,pe=S.depthTexture.format===_n?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===sn)be(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ve,0);else if(S.depthTexture.format===_n)be(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function vi(C){let S=i.get(C),X=C.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==C.depthTexture){let fe=C.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),fe){let se=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,fe.removeEventListener("dispose",se)};fe.addEventListener("dispose",se),S.__depthDisposeCallback=se}S.__boundDepthTexture=fe}if(C.depthTexture&&!S.__autoAllocateDepthBuffer)if(X)for(let fe=0;fe<6;fe++)Mt(S.__webglFramebuffer[fe],C,fe);else C.texture.mipmaps.length>0?Mt(S.__webglFramebuffer[0],C,0):Mt(S.__webglFramebuffer,C,0);else if(X){S.__webglDepthbuffer=[];for(let fe=0;fe<6;fe++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[fe]),S.__webglDepthbuffer[fe]===void 0)S.__webglDepthbuffer[fe]=n.createRenderbuffer(),wi(S.__webglDepthbuffer[fe],C,!1);else{let se=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=S.__webglDepthbuffer[fe];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,se,n.RENDERBUFFER,xe)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),wi(S.__webglDepthbuffer,C,!1);else{let se=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,se,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function jt(C,S,X){let fe=i.get(C);S!==void 0&&Pt(fe.__webglFramebuffer,C,C.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&vi(C)}function ui(C){let S=C.texture,X=i.get(C),fe=i.get(S);C.addEventListener("dispose",G),O(C);let se=C.textures,xe=C.isWebGLCubeRenderTarget===!0,ve=se.length>1;if(ve||(fe.__webglTexture===void 0&&(fe.__webglTexture=n.createTexture()),fe.__version=S.version,o.memory.textures++),xe){X.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(S.mipmaps.length>0){X.__webglFramebuffer[ee]=[];for(let ie=0;ie<S.mipmaps.length;ie++)X.__webglFramebuffer[ee][ie]=n.createFramebuffer()}else X.__webglFramebuffer[ee]=n.createFramebuffer()}else{if(S.mipmaps.length>0){X.__webglFramebuffer=[];for(let ee=0;ee<S.mipmaps.length;ee++)X.__webglFramebuffer[ee]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(ve)for(let ee=0,ie=se.length;ee<ie;ee++){let pe=i.get(se[ee]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(C.samples>0&&be(C)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let ee=0;ee<se.length;ee++){let ie=se[ee];X.__webglColorRenderbuffer[ee]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[ee]);let pe=s.convert(ie.format,ie.colorSpace),F=s.convert(ie.type),re=T(ie.internalFormat,pe,F,ie.normalized,ie.colorSpace,C.isXRRenderTarget===!0),te=st(C);n.renderbufferStorageMultisample(n.RENDERBUFFER,te,re,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ee,n.RENDERBUFFER,X.__webglColorRenderbuffer[ee])}n.bindRenderbuffer(n.RENDERBUFFER,null),C.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),wi(X.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,fe.__webglTexture),dt(n.TEXTURE_CUBE_MAP,S);for(let ee=0;ee<6;ee++)if(S.mipmaps.length>0)for(let ie=0;ie<S.mipmaps.length;ie++)Pt(X.__webglFramebuffer[ee][ie],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ie);else Pt(X.__webglFramebuffer[ee],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);A(S)?y(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ee=0,ie=se.length;ee<ie;ee++){let pe=se[ee],F=i.get(pe),re=n.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(re=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,F.__webglTexture),dt(re,pe),Pt(X.__webglFramebuffer,C,pe,n.COLOR_ATTACHMENT0+ee,re,0),A(pe)&&y(re)}t.unbindTexture()}else{let ee=n.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(ee=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ee,fe.__webglTexture),dt(ee,S),S.mipmaps.length>0)for(let ie=0;ie<S.mipmaps.length;ie++)Pt(X.__webglFramebuffer[ie],C,S,n.COLOR_ATTACHMENT0,ee,ie);else Pt(X.__webglFramebuffer,C,S,n.COLOR_ATTACHMENT0,ee,0);A(S)?y(ee):S.mipmaps.length>0&&n.texParameteri(ee,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&vi(C)}function B(C){let S=C.textures;for(let X=0,fe=S.length;X<fe;X++){let se=S[X];if(A(se)&&se.mipmapsAutoUpdate===!0){let xe=R(C),ve=i.get(se).__webglTexture;t.bindTexture(xe,ve),y(xe),t.unbindTexture()}}}let Ce=[];function Je(C){if(C.samples>0){if(be(C)===!1){let S=C.textures,X=C.width,fe=C.height,se=n.COLOR_BUFFER_BIT,xe=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(C),ee=S.length>1;if(ee)for(let pe=0;pe<S.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let pe=0;pe<S.length;pe++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(se|=n.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(se|=n.STENCIL_BUFFER_BIT)),ee){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let F=i.get(S[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,X,fe,0,0,X,fe,se,n.NEAREST),c===!0&&(Ce.length=0,Ce.push(n.COLOR_ATTACHMENT0+pe),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ce.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ee)for(let pe=0;pe<S.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let F=i.get(S[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&c){let S=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function st(C){return Math.min(r.maxSamples,C.samples)}function be(C){let S=i.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Dt(C){let S=o.render.frame;h.get(C)!==S&&(h.set(C,S),C.update())}function He(C,S){let X=C.colorSpace,fe=C.format,se=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||X!==cs&&X!==Cn&&(ot.getTransfer(X)===vt?(fe!==Di||se!==ai)&&ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ht("WebGLTextures: Unsupported texture color space:",X)),S}function $e(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(l.width=C.naturalWidth||C.width,l.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(l.width=C.displayWidth,l.height=C.displayHeight):(l.width=C.width,l.height=C.height),l}this.allocateTextureUnit=ue,this.resetTextureUnits=Q,this.getTextureUnits=ne,this.setTextureUnits=he,this.setTexture2D=me,this.setTexture2DArray=_e,this.setTexture3D=Ae,this.setTextureCube=ye,this.rebindTextures=jt,this.setupRenderTarget=ui,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=vi,this.setupFrameBufferTexture=Pt,this.useMultisampledRTT=be,this.dispose=W}function f_(n,e){function t(i,r=Cn){let s,o=ot.getTransfer(r);if(i===ai)return n.UNSIGNED_BYTE;if(i===qs)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ys)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Zl)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===$l)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Yl)return n.BYTE;if(i===Kl)return n.SHORT;if(i===mr)return n.UNSIGNED_SHORT;if(i===Xs)return n.INT;if(i===Pi)return n.UNSIGNED_INT;if(i===li)return n.FLOAT;if(i===Li)return n.HALF_FLOAT;if(i===Jl)return n.ALPHA;if(i===Ql)return n.RGB;if(i===Di)return n.RGBA;if(i===sn)return n.DEPTH_COMPONENT;if(i===_n)return n.DEPTH_STENCIL;if(i===Ks)return n.RED;if(i===Zs)return n.RED_INTEGER;if(i===vn)return n.RG;if(i===$s)return n.RG_INTEGER;if(i===Js)return n.RGBA_INTEGER;if(i===Qs||i===js||i===eo||i===to)if(o===vt)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===Qs)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===js)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===eo)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===to)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===Qs)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===js)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===eo)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===to)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ca||i===fa||i===ua||i===ha)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===ca)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===fa)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ua)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ha)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===da||i===pa||i===ma||i===ga||i===xa||i===as||i===_a)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===da||i===pa)return o===vt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===ma)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===ga)return s.COMPRESSED_R11_EAC;if(i===xa)return s.COMPRESSED_SIGNED_R11_EAC;if(i===as)return s.COMPRESSED_RG11_EAC;if(i===_a)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===va||i===Ma||i===Sa||i===ya||i===ba||i===Ea||i===wa||i===Ta||i===Aa||i===Ra||i===Ca||i===Pa||i===La||i===Da)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===va)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ma)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Sa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ya)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ba)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ea)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===wa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ta)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Aa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ra)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ca)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Pa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===La)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Da)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Na||i===Ia||i===Ua)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===Na)return o===vt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Ia)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ua)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Fa||i===Oa||i===ls||i===Ba)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===Fa)return s.COMPRESSED_RED_RGTC1_EXT;if(i===Oa)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ls)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Ba)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===kn?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var hb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,db=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,qc=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Eo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new tn({vertexShader:hb,fragmentShader:db,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ot(new To(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}};var Yc=class extends Hi{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",c=1,l=null,h=null,f=null,u=null,m=null,x=null,M=typeof XRWebGLBinding<"u",d=new qc,p={},v=t.getContextAttributes(),A=null,y=null,R=[],T=[],g=new Ze,w=null,O=null,L=new Ii;L.viewport=new bt;let D=new Ii;D.viewport=new bt;let G=[L,D],k=new Gc,I=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let me=R[j];return me===void 0&&(me=new co,R[j]=me),me.getTargetRaySpace()},this.getControllerGrip=function(j){let me=R[j];return me===void 0&&(me=new co,R[j]=me),me.getGripSpace()},this.getHand=function(j){let me=R[j];return me===void 0&&(me=new co,R[j]=me),me.getHandSpace()};function Y(j){let me=T.indexOf(j.inputSource);if(me===-1)return;let _e=R[me];_e!==void 0&&(_e.update(j.inputSource,j.frame,l||o),_e.dispatchEvent({type:j.type,data:j.inputSource}))}function V(){r.removeEventListener("select",Y),r.removeEventListener("selectstart",Y),r.removeEventListener("selectend",Y),r.removeEventListener("squeeze",Y),r.removeEventListener("squeezestart",Y),r.removeEventListener("squeezeend",Y),r.removeEventListener("end",V),r.removeEventListener("inputsourceschange",ce);for(let j=0;j<R.length;j++){let me=T[j];me!==null&&(T[j]=null,R[j].disconnect(me))}I=null,W=null,d.reset();for(let j in p)delete p[j];if(e.setRenderTarget(A),m=null,u=null,f=null,r=null,y=null,ue.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(g.width,g.height,!1),O!==null){let j=O.camera;j.fov=O.fov,j.zoom=O.zoom,j.updateProjectionMatrix(),O=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){s=j,i.isPresenting===!0&&ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,i.isPresenting===!0&&ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(j){l=j},this.getBaseLayer=function(){return u!==null?u:m},this.getBinding=function(){return f===null&&M&&(f=new XRWebGLBinding(r,t)),f},this.getFrame=function(){return x},this.getSession=function(){return r},this.setSession=async function(j){if(r=j,r!==null){if(A=e.getRenderTarget(),r.addEventListener("select",Y),r.addEventListener("selectstart",Y),r.addEventListener("selectend",Y),r.addEventListener("squeeze",Y),r.addEventListener("squeezestart",Y),r.addEventListener("squeezeend",Y),r.addEventListener("end",V),r.addEventListener("inputsourceschange",ce),v.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(g),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,Ae=null,ye=null;v.depth&&(ye=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=v.stencil?_n:sn,Ae=v.stencil?kn:Pi);let qe={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:s};f=this.getBinding(),u=f.createProjectionLayer(qe),r.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),y=new Oi(u.textureWidth,u.textureHeight,{format:Di,type:ai,depthTexture:new bn(u.textureWidth,u.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let _e={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:s};m=new XRWebGLLayer(r,t,_e),r.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),y=new Oi(m.framebufferWidth,m.framebufferHeight,{format:Di,type:ai,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await r.requestReferenceSpace(a),ue.setContext(r),ue.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return d.getDepthTexture()};function ce(j){for(let me=0;me<j.removed.length;me++){let _e=j.removed[me],Ae=T.indexOf(_e);Ae>=0&&(T[Ae]=null,R[Ae].disconnect(_e))}for(let me=0;me<j.added.length;me++){let _e=j.added[me],Ae=T.indexOf(_e);if(Ae===-1){for(let qe=0;qe<R.length;qe++)if(qe>=T.length){T.push(_e),Ae=qe;break}else if(T[qe]===null){T[qe]=_e,Ae=qe;break}if(Ae===-1)break}let ye=R[Ae];ye&&ye.connect(_e)}}function $(j,me){me===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(me.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(r===null)return;let me=j.near,_e=j.far;d.texture!==null&&(d.depthNear>0&&(me=d.depthNear),d.depthFar>0&&(_e=d.depthFar)),k.near=D.near=L.near=me,k.far=D.far=L.far=_e,(I!==k.near||W!==k.far)&&(r.updateRenderState({depthNear:k.near,depthFar:k.far}),I=k.near,W=k.far),k.layers.mask=j.layers.mask|6,L.layers.mask=k.layers.mask&-5,D.layers.mask=k.layers.mask&-3;let Ae=j.parent,ye=k.cameras;$(k,Ae);for(let qe=0;qe<ye.length;qe++)$(ye[qe],Ae);k.projectionMatrix.copy(L.projectionMatrix),k.projectionMatrixInverse.copy(L.projectionMatrixInverse),O===null&&j.isPerspectiveCamera&&(O={camera:j,fov:j.fov,zoom:j.zoom}),Q(j,k,Ae)};function Q(j,me,_e){_e===null?j.matrix.copy(me.matrixWorld):(j.matrix.copy(_e.matrixWorld),j.matrix.invert(),j.matrix.multiply(me.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(me.projectionMatrix),j.projectionMatrixInverse.copy(me.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=za*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(u===null&&m===null))return c},this.setFoveation=function(j){c=j,u!==null&&(u.fixedFoveation=j),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=j)},this.hasDepthSensing=function(){return d.texture!==null},this.getDepthSensingMesh=function(){return d.getMesh(k)},this.getCameraTexture=function(j){return p[j]};let ne=null;function he(j,me){if(h=me.getViewerPose(l||o),x=me,h!==null){let _e=h.views;m!==null&&(e.setRenderTargetFramebuffer(y,m.framebuffer),e.setRenderTarget(y));let Ae=!1;_e.length!==k.cameras.length&&(k.cameras.length=0,Ae=!0);for(let Ve=0;Ve<_e.length;Ve++){let dt=_e[Ve],ft=null;if(m!==null)ft=m.getViewport(dt);else{let Xt=f.getViewSubImage(u,dt);ft=Xt.viewport,Ve===0&&(e.setRenderTargetTextures(y,Xt.colorTexture,Xt.depthStencilTexture),e.setRenderTarget(y))}let it=G[Ve];it===void 0&&(it=new Ii,it.layers.enable(Ve),it.viewport=new bt,G[Ve]=it),it.matrix.fromArray(dt.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(dt.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ft.x,ft.y,ft.width,ft.height),Ve===0&&(k.matrix.copy(it.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),Ae===!0&&k.cameras.push(it)}let ye=r.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&M){f=i.getBinding();let Ve=f.getDepthInformation(_e[0]);Ve&&Ve.isValid&&Ve.texture&&d.init(Ve,r.renderState)}if(ye&&ye.includes("camera-access")&&M){e.state.unbindTexture(),f=i.getBinding();for(let Ve=0;Ve<_e.length;Ve++){let dt=_e[Ve].camera;if(dt){let ft=p[dt];ft||(ft=new Eo,p[dt]=ft);let it=f.getCameraImage(dt);ft.sourceTexture=it}}}}for(let _e=0;_e<R.length;_e++){let Ae=T[_e],ye=R[_e];Ae!==null&&ye!==void 0&&ye.update(Ae,me,l||o)}ne&&ne(j,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),x=null}let ue=new zc;ue.setAnimationLoop(he),this.setAnimationLoop=function(j){ne=j},this.dispose=function(){}}};var pb=new Ie,u_=new Ke;u_.set(-1,0,0,0,1,0,0,0,1);function h_(n,e){function t(d,p){d.matrixAutoUpdate===!0&&d.updateMatrix(),p.value.copy(d.matrix)}function i(d,p){p.color.getRGB(d.fogColor.value,Lc(n)),p.isFog?(d.fogNear.value=p.near,d.fogFar.value=p.far):p.isFogExp2&&(d.fogDensity.value=p.density)}function r(d,p,v,A,y){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?s(d,p):p.isMeshLambertMaterial?(s(d,p),p.envMap&&(d.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(s(d,p),f(d,p)):p.isMeshPhongMaterial?(s(d,p),h(d,p),p.envMap&&(d.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(s(d,p),u(d,p),p.isMeshPhysicalMaterial&&m(d,p,y)):p.isMeshMatcapMaterial?(s(d,p),x(d,p)):p.isMeshDepthMaterial?s(d,p):p.isMeshDistanceMaterial?(s(d,p),M(d,p)):p.isMeshNormalMaterial?s(d,p):p.isLineBasicMaterial?(o(d,p),p.isLineDashedMaterial&&a(d,p)):p.isPointsMaterial?c(d,p,v,A):p.isSpriteMaterial?l(d,p):p.isShadowMaterial?(d.color.value.copy(p.color),d.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function s(d,p){d.opacity.value=p.opacity,p.color&&d.diffuse.value.copy(p.color),p.emissive&&d.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(d.map.value=p.map,t(p.map,d.mapTransform)),p.alphaMap&&(d.alphaMap.value=p.alphaMap,t(p.alphaMap,d.alphaMapTransform)),p.bumpMap&&(d.bumpMap.value=p.bumpMap,t(p.bumpMap,d.bumpMapTransform),d.bumpScale.value=p.bumpScale,p.side===Jt&&(d.bumpScale.value*=-1)),p.normalMap&&(d.normalMap.value=p.normalMap,t(p.normalMap,d.normalMapTransform),d.normalScale.value.copy(p.normalScale),p.side===Jt&&d.normalScale.value.negate()),p.displacementMap&&(d.displacementMap.value=p.displacementMap,t(p.displacementMap,d.displacementMapTransform),d.displacementScale.value=p.displacementScale,d.displacementBias.value=p.displacementBias),p.emissiveMap&&(d.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,d.emissiveMapTransform)),p.specularMap&&(d.specularMap.value=p.specularMap,t(p.specularMap,d.specularMapTransform)),p.alphaTest>0&&(d.alphaTest.value=p.alphaTest);let v=e.get(p),A=v.envMap,y=v.envMapRotation;A&&(d.envMap.value=A,d.envMapRotation.value.setFromMatrix4(pb.makeRotationFromEuler(y)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&d.envMapRotation.value.premultiply(u_),d.reflectivity.value=p.reflectivity,d.ior.value=p.ior,d.refractionRatio.value=p.refractionRatio),p.lightMap&&(d.lightMap.value=p.lightMap,d.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,d.lightMapTransform)),p.aoMap&&(d.aoMap.value=p.aoMap,d.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,d.aoMapTransform))}function o(d,p){d.diffuse.value.copy(p.color),d.opacity.value=p.opacity,p.map&&(d.map.value=p.map,t(p.map,d.mapTransform))}function a(d,p){d.dashSize.value=p.dashSize,d.totalSize.value=p.dashSize+p.gapSize,d.scale.value=p.scale}function c(d,p,v,A){d.diffuse.value.copy(p.color),d.opacity.value=p.opacity,d.size.value=p.size*v,d.scale.value=A*.5,p.map&&(d.map.value=p.map,t(p.map,d.uvTransform)),p.alphaMap&&(d.alphaMap.value=p.alphaMap,t(p.alphaMap,d.alphaMapTransform)),p.alphaTest>0&&(d.alphaTest.value=p.alphaTest)}function l(d,p){d.diffuse.value.copy(p.color),d.opacity.value=p.opacity,d.rotation.value=p.rotation,p.map&&(d.map.value=p.map,t(p.map,d.mapTransform)),p.alphaMap&&(d.alphaMap.value=p.alphaMap,t(p.alphaMap,d.alphaMapTransform)),p.alphaTest>0&&(d.alphaTest.value=p.alphaTest)}function h(d,p){d.specular.value.copy(p.specular),d.shininess.value=Math.max(p.shininess,1e-4)}function f(d,p){p.gradientMap&&(d.gradientMap.value=p.gradientMap)}function u(d,p){d.metalness.value=p.metalness,p.metalnessMap&&(d.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,d.metalnessMapTransform)),d.roughness.value=p.roughness,p.roughnessMap&&(d.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,d.roughnessMapTransform)),p.envMap&&(d.envMapIntensity.value=p.envMapIntensity)}function m(d,p,v){d.ior.value=p.ior,p.diffuseRoughness>0&&(d.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(d.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,d.diffuseRoughnessMapTransform))),p.sheen>0&&(d.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),d.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(d.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,d.sheenColorMapTransform)),p.sheenRoughnessMap&&(d.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,d.sheenRoughnessMapTransform))),p.clearcoat>0&&(d.clearcoat.value=p.clearcoat,d.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(d.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,d.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(d.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,d.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(d.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,d.clearcoatNormalMapTransform),d.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Jt&&d.clearcoatNormalScale.value.negate())),p.dispersion>0&&(d.dispersion.value=p.dispersion),p.retroreflectivity>0&&(d.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(d.iridescence.value=p.iridescence,d.iridescenceIOR.value=p.iridescenceIOR,d.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,d.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(d.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,d.iridescenceMapTransform)),p.iridescenceThicknessMap&&(d.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,d.iridescenceThicknessMapTransform))),p.transmission>0&&(d.transmission.value=p.transmission,d.transmissionSamplerMap.value=v.texture,d.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(d.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,d.transmissionMapTransform)),d.thickness.value=p.thickness,p.thicknessMap&&(d.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,d.thicknessMapTransform)),d.attenuationDistance.value=p.attenuationDistance,d.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(d.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(d.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,d.anisotropyMapTransform))),d.specularIntensity.value=p.specularIntensity,d.specularColor.value.copy(p.specularColor),p.specularColorMap&&(d.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,d.specularColorMapTransform)),p.specularIntensityMap&&(d.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,d.specularIntensityMapTransform))}function x(d,p){p.matcap&&(d.matcap.value=p.matcap)}function M(d,p){let v=e.get(p).light;d.referencePosition.value.setFromMatrixPosition(v.matrixWorld),d.nearDistance.value=v.shadow.camera.near,d.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function d_(n,e,t,i){let r={},s={};function o(v,A){let y=A.program;i.uniformBlockBinding(v,y,r[v.id])}function a(v,A){let y=r[v.id];y===void 0&&(x(v),y=c(v),r[v.id]=y,v.addEventListener("dispose",d));let R=A.program;i.updateUBOMapping(v,R);let T=e.render.frame;s[v.id]!==T&&(l(v),s[v.id]=T)}function c(v){let A=n.createBuffer(),y=v.__size,R=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,y,R),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function l(v){let A=r[v.id],y=v.uniforms,R=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let T=0,g=y.length;T<g;T++){let w=y[T];if(Array.isArray(w))for(let O=0,L=w.length;O<L;O++)h(w[O],T,O,R);else h(w,T,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(v,A,y,R){if(u(v,A,y,R)===!0){let T=v.__offset,g=v.value;if(Array.isArray(g)){let w=0;for(let O=0;O<g.length;O++){let L=g[O],D=M(L,!0);f(L,v.__data,w),w+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else f(g,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,v.__data)}}function f(v,A,y){typeof v=="number"||typeof v=="boolean"?A[y]=v:v.isMatrix3?(A[y]=v.elements[0],A[y+1]=v.elements[1],A[y+2]=v.elements[2],A[y+3]=0,A[y+4]=v.elements[3],A[y+5]=v.elements[4],A[y+6]=v.elements[5],A[y+7]=0,A[y+8]=v.elements[6],A[y+9]=v.elements[7],A[y+10]=v.elements[8],A[y+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-y),y):v.toArray(A,y)}function u(v,A,y,R){let T=v.value,g=A+"_"+y;if(Array.isArray(T)){R[g]===void 0&&(R[g]=[]);let w=R[g],O=!1;for(let L=0;L<T.length;L++)m(T[L],w,L)===!0&&(O=!0);return O}return m(T,R,g)}function m(v,A,y){if(A[y]===void 0)return typeof v=="number"||typeof v=="boolean"?A[y]=v:ArrayBuffer.isView(v)?A[y]=v.slice():A[y]=v.clone(),!0;{let R=A[y];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return A[y]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function x(v){let A=v.uniforms,y=0,R=16;for(let g=0,w=A.length;g<w;g++){let O=Array.isArray(A[g])?A[g]:[A[g]];for(let L=0,D=O.length;L<D;L++){let G=O[L],k=Array.isArray(G.value)?G.value:[G.value],I=Array.isArray(A[g])||Array.isArray(G.value),W=y;for(let V=0,ce=k.length;V<ce;V++){let $=k[V],Q=M($,I),ne=y%R,he=ne%Q.boundary,ue=ne+he;y+=he,ue!==0&&R-ue<Q.storage&&(y+=R-ue),V===0&&(W=y),y+=Q.storage}let Y=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new Y((y-W)/Float32Array.BYTES_PER_ELEMENT),G.__offset=W}}let T=y%R;return T>0&&(y+=R-T),v.__size=y,v.__cache={},this}function M(v,A){let y={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(y.boundary=4,y.storage=4):v.isVector2?(y.boundary=8,y.storage=8):v.isVector3||v.isColor?(y.boundary=16,y.storage=12):v.isVector4?(y.boundary=16,y.storage=16):v.isMatrix3?(y.boundary=16,y.storage=48):v.isMatrix4?(y.boundary=16,y.storage=64):v.isTexture?ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(y.boundary=16,y.storage=v.byteLength):ke("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(y.boundary=16,y.storage=Math.ceil(y.storage/16)*16),y}function d(v){let A=v.target;A.removeEventListener("dispose",d),n.deleteBuffer(r[A.id]),delete r[A.id],delete s[A.id]}function p(){for(let v in r)n.deleteBuffer(r[v]);r={},s={}}return{bind:o,update:a,dispose:p}}var mb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),sr=null;function p_(){return sr===null&&(sr=new yr(mb,16,16,vn,Li),sr.name="DFG_LUT",sr.minFilter=xi,sr.magFilter=xi,sr.wrapS=rn,sr.wrapT=rn,sr.generateMipmaps=!1,sr.needsUpdate=!0),sr}var tl=class{constructor(e={}){let{canvas:t=Kp(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:u=!1,outputBufferType:m=ai}=e;this.isWebGLRenderer=!0;let x;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");x=i.getContextAttributes().alpha}else x=o;let M=m,d=new Set([Js,$s,Zs]),p=new Set([ai,Pi,mr,kn,qs,Ys]),v=new Uint32Array(4),A=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},R=null,T=null,g=[],w=[],O=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=gn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,D=!1,G=null,k=null,I=null,W=null;this._outputColorSpace=en;let Y=0,V=0,ce=null,$=-1,Q=null,ne=new bt,he=new bt,ue=null,j=new Xe(0),me=0,_e=t.width,Ae=t.height,ye=1,qe=null,rt=null,Ve=new bt(0,0,_e,Ae),dt=new bt(0,0,_e,Ae),ft=!1,it=new an,Xt=new Rc,Ut=!1,fi=!1,Pt=new Ie,wi=new U,Mt=new bt,vi={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},jt=!1;function ui(){return ce===null?ye:1}let B=i;function Ce(E,z){return t.getContext(E,z)}let Je,st,be,Dt,He,$e,C,S,X,fe,se,xe,ve,ee,ie,pe,F,re,te,Ee,ge,Se,We;try{let E={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Re,!1),B===null){let z="webgl2";if(B=Ce(z,E),B===null)throw Ce(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(E){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),ht("WebGLRenderer: "+E.message),E}function je(){Je=new Ex(B),Je.init(),ge=new f_(B,Je),st=new mx(B,Je,e,ge),be=new l_(B,Je),st.reversedDepthBuffer&&u&&be.buffers.depth.setReversed(!0),k=B.createFramebuffer(),I=B.createFramebuffer(),W=B.createFramebuffer(),Dt=new Ax(B),He=new Jx,$e=new c_(B,Je,be,He,st,ge,Dt),C=new bx(L),S=new Lm(B),Se=new dx(B,S),X=new wx(B,S,Dt,Se),fe=new Cx(B,X,S,Se,Dt),re=new Rx(B,st,$e),ie=new gx(He),se=new $x(L,C,Je,st,Se,ie),xe=new h_(L,He),ve=new e_,ee=new n_(Je),F=new hx(L,C,be,fe,x,c),pe=new a_(L,fe,st),We=new d_(B,Dt,st,be),te=new px(B,Je,Dt),Ee=new Tx(B,Je,Dt),Dt.programs=se.programs,L.capabilities=st,L.extensions=Je,L.properties=He,L.renderLists=ve,L.shadowMap=pe,L.state=be,L.info=Dt}M!==ai&&(O=new Px(M,t.width,t.height,a,r,s));let le=new Yc(L,B);this.xr=le,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let E=Je.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Je.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return ye},this.setPixelRatio=function(E){E!==void 0&&(ye=E,this.setSize(_e,Ae,!1))},this.getSize=function(E){return E.set(_e,Ae)},this.setSize=function(E,z,J=!0){if(le.isPresenting){ke("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=E,Ae=z,t.width=Math.floor(E*ye),t.height=Math.floor(z*ye),J===!0&&(t.style.width=E+"px",t.style.height=z+"px"),O!==null&&O.setSize(t.width,t.height),this.setViewport(0,0,E,z)},this.getDrawingBufferSize=function(E){return E.set(_e*ye,Ae*ye).floor()},this.setDrawingBufferSize=function(E,z,J){_e=E,Ae=z,ye=J,t.width=Math.floor(E*J),t.height=Math.floor(z*J),this.setViewport(0,0,E,z)},this.setEffects=function(E){if(M===ai){ht("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let z=0;z<E.length;z++)if(E[z].isOutputPass===!0){ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(ne)},this.getViewport=function(E){return E.copy(Ve)},this.setViewport=function(E,z,J,q){E.isVector4?Ve.set(E.x,E.y,E.z,E.w):Ve.set(E,z,J,q),be.viewport(ne.copy(Ve).multiplyScalar(ui()).round())},this.getScissor=function(E){return E.copy(dt)},this.setScissor=function(E,z,J,q){E.isVector4?dt.set(E.x,E.y,E.z,E.w):dt.set(E,z,J,q),be.scissor(he.copy(dt).multiplyScalar(ui()).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(E){be.setScissorTest(ft=E)},this.setOpaqueSort=function(E){qe=E},this.setTransparentSort=function(E){rt=E},this.getClearColor=function(E){return E.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(E=!0,z=!0,J=!0){let q=0;if(E){let K=!1;if(ce!==null){let we=ce.texture.format;K=d.has(we)}if(K){let we=ce.texture.type,Pe=p.has(we),Te=F.getClearColor(),De=F.getClearAlpha(),ze=Te.r,tt=Te.g,pt=Te.b;Pe?(v[0]=ze,v[1]=tt,v[2]=pt,v[3]=De,B.clearBufferuiv(B.COLOR,0,v)):(A[0]=ze,A[1]=tt,A[2]=pt,A[3]=De,B.clearBufferiv(B.COLOR,0,A))}else q|=B.COLOR_BUFFER_BIT}z&&(q|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),J&&(q|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&B.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),G=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),F.dispose(),ve.dispose(),ee.dispose(),$e.dispose(),He.dispose(),C.dispose(),fe.dispose(),X.dispose(),Se.dispose(),We.dispose(),se.dispose(),le.dispose(),le.removeEventListener("sessionstart",al),le.removeEventListener("sessionend",qn),or.stop()};function Be(E){E.preventDefault(),gu("WebGLRenderer: Context Lost."),D=!0}function et(){gu("WebGLRenderer: Context Restored."),D=!1;let E=Dt.autoReset,z=pe.enabled,J=pe.autoUpdate,q=pe.needsUpdate,K=pe.type;je(),Dt.autoReset=E,pe.enabled=z,pe.autoUpdate=J,pe.needsUpdate=q,pe.type=K}function Re(E){ht("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function lt(E){let z=E.target;z.removeEventListener("dispose",lt),Bt(z)}function Bt(E){Yi(E),He.remove(E)}function Yi(E){let z=He.get(E).programs;z!==void 0&&(z.forEach(function(J){se.releaseProgram(J)}),E.isShaderMaterial&&se.releaseShaderCache(E))}this.renderBufferDirect=function(E,z,J,q,K,we){z===null&&(z=vi);let Pe=K.isMesh&&K.matrixWorld.determinantAffine()<0,Te=Oo(E,z,J,q,K);be.setMaterial(q,Pe);let De=J.index,ze=1;if(q.wireframe===!0){if(De=X.getWireframeAttribute(J),De===void 0)return;ze=2}let tt=J.drawRange,pt=J.attributes.position,Ge=tt.start*ze,mt=(tt.start+tt.count)*ze;we!==null&&(Ge=Math.max(Ge,we.start*ze),mt=Math.min(mt,(we.start+we.count)*ze)),De!==null?(Ge=Math.max(Ge,0),mt=Math.min(mt,De.count)):pt!=null&&(Ge=Math.max(Ge,0),mt=Math.min(mt,pt.count));let $t=mt-Ge;if($t<0||$t===1/0)return;Se.setup(K,q,Te,J,De);let At,Rt=te;if(De!==null&&(At=S.get(De),Rt=Ee,Rt.setIndex(At)),K.isMesh)q.wireframe===!0?(be.setLineWidth(q.wireframeLinewidth*ui()),Rt.setMode(B.LINES)):Rt.setMode(B.TRIANGLES);else if(K.isLine){let Mi=q.linewidth;Mi===void 0&&(Mi=1),be.setLineWidth(Mi*ui()),K.isLineSegments?Rt.setMode(B.LINES):K.isLineLoop?Rt.setMode(B.LINE_LOOP):Rt.setMode(B.LINE_STRIP)}else K.isPoints?Rt.setMode(B.POINTS):K.isSprite&&Rt.setMode(B.TRIANGLES);if(K.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Rt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let Mi=K._multiDrawStarts,Fe=K._multiDrawCounts,hi=K._multiDrawCount,xt=De?S.get(De).bytesPerElement:1,lr=He.get(q).currentProgram.getUniforms();for(let di=0;di<hi;di++)lr.setValue(B,"_gl_DrawID",di),Rt.render(Mi[di]/xt,Fe[di])}else if(K.isInstancedMesh)Rt.renderInstances(Ge,$t,K.count);else if(J.isInstancedBufferGeometry){let Mi=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,Fe=Math.min(J.instanceCount,Mi);Rt.renderInstances(Ge,$t,Fe)}else Rt.render(Ge,$t)};function Io(E,z,J,q){G!==null&&E.isNodeMaterial&&G.setObject(q,E),Ut===!0&&ie.setState(E,J,!1),E.transparent===!0&&E.side===ji&&E.forceSinglePass===!1?(E.side=Jt,E.needsUpdate=!0,Yn(E,z,q),E.side=nn,E.needsUpdate=!0,Yn(E,z,q),E.side=ji):Yn(E,z,q)}this.compile=function(E,z,J=null){J===null&&(J=E),G!==null&&G.renderStart(E,z,J),T=ee.get(J),T.init(z),w.push(T),J.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),E!==J&&E.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),T.setupLights(),G!==null&&G.updateLights(T.state.lightsArray),fi=this.localClippingEnabled,Ut=ie.init(this.clippingPlanes,fi),Ut===!0&&ie.setGlobalState(this.clippingPlanes,z),G!==null&&pe.render(T.state.shadowsArray,J,z);let q=new Set;return E.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let we=K.material;if(we)if(Array.isArray(we))for(let Pe=0;Pe<we.length;Pe++){let Te=we[Pe];Io(Te,J,z,K),q.add(Te)}else Io(we,J,z,K),q.add(we)}),T=w.pop(),G!==null&&G.renderEnd(),q},this.compileAsync=function(E,z,J=null){let q=this.compile(E,z,J);return new Promise(K=>{function we(){if(q.forEach(function(Pe){let De=He.get(Pe).currentProgram;(De===void 0||De.isReady())&&q.delete(Pe)}),q.size===0){K(E);return}setTimeout(we,10)}Je.get("KHR_parallel_shader_compile")!==null?we():setTimeout(we,10)})};let Ms=null;function Sf(E){Ms&&Ms(E)}function al(){or.stop()}function qn(){or.start()}let or=new zc;or.setAnimationLoop(Sf),typeof self<"u"&&or.setContext(self),this.setAnimationLoop=function(E){Ms=E,le.setAnimationLoop(E),E===null?or.stop():or.start()},le.addEventListener("sessionstart",al),le.addEventListener("sessionend",qn),this.render=function(E,z){if(z!==void 0&&z.isCamera!==!0){ht("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;G!==null&&G.renderStart(E,z);let J=le.enabled===!0&&le.isPresenting===!0,q=O!==null&&(ce===null||J)&&O.begin(L,ce);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(z),z=le.getCamera()),E.isScene===!0&&E.onBeforeRender(L,E,z,ce),T=ee.get(E,w.length),T.init(z),T.state.textureUnits=$e.getTextureUnits(),w.push(T),Pt.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Xt.setFromArrayCamera(z):it.setFromProjectionMatrix(Pt,Fi,z.reversedDepth),fi=this.localClippingEnabled,Ut=ie.init(this.clippingPlanes,fi),R=ve.get(E,g.length),R.init(),g.push(R),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Pe=L.xr.getDepthSensingMesh();Pe!==null&&ar(Pe,z,-1/0,L.sortObjects)}ar(E,z,0,L.sortObjects),R.finish(),G!==null&&G.updateLights(T.state.lightsArray),L.sortObjects===!0&&R.sort(qe,rt),jt=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,jt&&F.addToRenderList(R,E),this.info.autoReset===!0&&this.info.reset(),Ut===!0&&ie.beginShadows();let K=T.state.shadowsArray;if(pe.render(K,E,z),Ut===!0&&ie.endShadows(),(q&&O.hasRenderPass())===!1){let Pe=R.opaque,Te=R.transmissive;if(T.setupLights(),z.isArrayCamera){let De=z.cameras;if(Te.length>0)for(let ze=0,tt=De.length;ze<tt;ze++){let pt=De[ze];Un(Pe,Te,E,pt)}jt&&F.render(E);for(let ze=0,tt=De.length;ze<tt;ze++){let pt=De[ze];Uo(R,E,pt,pt.viewport)}}else Te.length>0&&Un(Pe,Te,E,z),jt&&F.render(E),Uo(R,E,z)}ce!==null&&V===0&&($e.updateMultisampleRenderTarget(ce),$e.updateRenderTargetMipmap(ce)),q&&O.end(L),E.isScene===!0&&E.onAfterRender(L,E,z),Se.resetDefaultState(),$=-1,Q=null,w.pop(),w.length>0?(T=w[w.length-1],$e.setTextureUnits(T.state.textureUnits),Ut===!0&&ie.setGlobalState(L.clippingPlanes,T.state.camera)):T=null,g.pop(),g.length>0?R=g[g.length-1]:R=null,G!==null&&G.renderEnd()};function ar(E,z,J,q){if(E.visible===!1)return;if(E.layers.test(z.layers)){if(E.isGroup)J=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(z);else if(E.isLight)T.pushLight(E),E.castShadow&&T.pushShadow(E);else if(E.isSprite){let Pe=z.isArrayCamera?Xt:it;if(!E.frustumCulled||E.intersectsFrustum(Pe)){q&&Mt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Pt);let Te=fe.update(E),De=E.material;De.visible&&R.push(E,Te,De,J,Mt.z,null,z)}}else if(E.isMesh||E.isLine||E.isPoints){let Pe=z.isArrayCamera?Xt:it;if(!E.frustumCulled||E.intersectsFrustum(Pe)){let Te=fe.update(E),De=E.material;if(q&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Mt.copy(E.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),Mt.copy(Te.boundingSphere.center)),Mt.applyMatrix4(E.matrixWorld).applyMatrix4(Pt)),Array.isArray(De)){let ze=Te.groups;for(let tt=0,pt=ze.length;tt<pt;tt++){let Ge=ze[tt],mt=De[Ge.materialIndex];mt&&mt.visible&&R.push(E,Te,mt,J,Mt.z,Ge,z)}}else De.visible&&R.push(E,Te,De,J,Mt.z,null,z)}}}let we=E.children;for(let Pe=0,Te=we.length;Pe<Te;Pe++)ar(we[Pe],z,J,q)}function Uo(E,z,J,q){let{opaque:K,transmissive:we,transparent:Pe}=E;T.setupLightsView(J),Ut===!0&&ie.setGlobalState(L.clippingPlanes,J),q&&be.viewport(ne.copy(q)),K.length>0&&ei(K,z,J),we.length>0&&ei(we,z,J),Pe.length>0&&ei(Pe,z,J),be.buffers.depth.setTest(!0),be.buffers.depth.setMask(!0),be.buffers.color.setMask(!0),be.setPolygonOffset(!1)}function Un(E,z,J,q){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[q.id]===void 0){let Ge=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[q.id]=new Oi(1,1,{generateMipmaps:!0,type:Ge?Li:ai,minFilter:xn,samples:Math.max(4,st.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ot.workingColorSpace})}let we=T.state.transmissionRenderTarget[q.id],Pe=q.viewport||ne;we.setSize(Pe.z*L.transmissionResolutionScale,Pe.w*L.transmissionResolutionScale);let Te=L.getRenderTarget(),De=L.getActiveCubeFace(),ze=L.getActiveMipmapLevel();L.setRenderTarget(we),L.getClearColor(j),me=L.getClearAlpha(),me<1&&L.setClearColor(16777215,.5),L.clear(),jt&&F.render(J);let tt=L.toneMapping;L.toneMapping=gn;let pt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),T.setupLightsView(q),Ut===!0&&ie.setGlobalState(L.clippingPlanes,q),ei(E,J,q),$e.updateMultisampleRenderTarget(we),$e.updateRenderTargetMipmap(we),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let mt=0,$t=z.length;mt<$t;mt++){let At=z[mt],{object:Rt,geometry:Mi,material:Fe,group:hi}=At;if(Fe.side===ji&&Rt.layers.test(q.layers)){let xt=Fe.side;Fe.side=Jt,Fe.needsUpdate=!0,ri(Rt,J,q,Mi,Fe,hi),Fe.side=xt,Fe.needsUpdate=!0,Ge=!0}}Ge===!0&&($e.updateMultisampleRenderTarget(we),$e.updateRenderTargetMipmap(we))}L.setRenderTarget(Te,De,ze),L.setClearColor(j,me),pt!==void 0&&(q.viewport=pt),L.toneMapping=tt}function ei(E,z,J){let q=z.isScene===!0?z.overrideMaterial:null;for(let K=0,we=E.length;K<we;K++){let Pe=E[K],{object:Te,geometry:De,group:ze}=Pe,tt=Pe.material;tt.allowOverride===!0&&q!==null&&(tt=q),Te.layers.test(J.layers)&&ri(Te,z,J,De,tt,ze)}}function ri(E,z,J,q,K,we){G!==null&&K.isNodeMaterial&&G.setObject(E,K),E.onBeforeRender(L,z,J,q,K,we),E.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),K.onBeforeRender(L,z,J,q,E,we),K.transparent===!0&&K.side===ji&&K.forceSinglePass===!1?(K.side=Jt,K.needsUpdate=!0,L.renderBufferDirect(J,z,q,K,E,we),K.side=nn,K.needsUpdate=!0,L.renderBufferDirect(J,z,q,K,E,we),K.side=ji):L.renderBufferDirect(J,z,q,K,E,we),E.onAfterRender(L,z,J,q,K,we)}function si(E){let z=0;for(let J of E)J.texture!==null&&z++;return z}function Yn(E,z,J){z.isScene!==!0&&(z=vi);let q=He.get(E),K=T.state.lights,we=T.state.shadowsArray,Pe=K.state.version,Te=se.getParameters(E,K.state,we,z,J,T.state.lightProbeGridArray),De=se.getProgramCacheKey(Te),ze=q.programs;q.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?z.environment:null,q.fog=z.fog;let tt=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;q.envMap=C.get(E.envMap||q.environment,tt),q.envMapRotation=q.environment!==null&&E.envMap===null?z.environmentRotation:E.envMapRotation,ze===void 0&&(E.addEventListener("dispose",lt),ze=new Map,q.programs=ze,q.programVariants=new Map);let pt=ze.get(De);if(pt!==void 0){if(q.currentProgram===pt&&q.lightsStateVersion===Pe)return Fo(E,Te),pt}else Te.uniforms=se.getUniforms(E),G!==null&&E.isNodeMaterial&&G.build(E,J,Te),E.onBeforeCompile(Te,L),pt=se.acquireProgram(Te,De),ze.set(De,pt),q.uniforms=Te.uniforms;let Ge=q.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Ge.clippingPlanes=ie.uniform),Fo(E,Te),q.needsLights=Tr(E),q.lightsStateVersion=Pe,q.needsLights&&(Ge.ambientLightColor.value=K.state.ambient,Ge.lightProbe.value=K.state.probe,Ge.sunLights.value=K.state.sun,Ge.sunLightShadows.value=K.state.sunShadow,Ge.directionalLights.value=K.state.directional,Ge.directionalLightShadows.value=K.state.directionalShadow,Ge.spotLights.value=K.state.spot,Ge.spotLightShadows.value=K.state.spotShadow,Ge.rectAreaLights.value=K.state.rectArea,Ge.ltc_1.value=K.state.rectAreaLTC1,Ge.ltc_2.value=K.state.rectAreaLTC2,Ge.pointLights.value=K.state.point,Ge.pointLightShadows.value=K.state.pointShadow,Ge.hemisphereLights.value=K.state.hemi,Ge.sunShadowMatrix.value=K.state.sunShadowMatrix,Ge.sunShadowCascade.value=K.state.sunShadowCascade,Ge.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Ge.spotLightMatrix.value=K.state.spotLightMatrix,Ge.spotLightMap.value=K.state.spotLightMap,Ge.pointShadowMatrix.value=K.state.pointShadowMatrix),q.numLightProbeGrids=si(T.state.lightProbeGridArray),q.currentProgram=pt,q.uniformsList=null,pt}function cn(E,z,J,q,K){let we=He.get(E),Pe=we.currentProgram.id+","+q+","+K,Te=we.programVariants.get(Pe);return Te===void 0?(Te=Yn(E,z,J),we.programVariants.set(Pe,Te)):(we.currentProgram=Te,we.uniformsList=null,we.outputColorSpace=q,we.toneMapping=K),Te}function wr(E){if(E.uniformsList===null){let z=E.currentProgram.getUniforms();E.uniformsList=Kr.seqWithValue(z.seq,E.uniforms)}return E.uniformsList}function Fo(E,z){let J=He.get(E);J.outputColorSpace=z.outputColorSpace,J.batching=z.batching,J.batchingColor=z.batchingColor,J.instancing=z.instancing,J.instancingColor=z.instancingColor,J.instancingMorph=z.instancingMorph,J.skinning=z.skinning,J.morphTargets=z.morphTargets,J.morphNormals=z.morphNormals,J.morphColors=z.morphColors,J.morphTargetsCount=z.morphTargetsCount,J.numClippingPlanes=z.numClippingPlanes,J.numIntersection=z.numClipIntersection,J.vertexAlphas=z.vertexAlphas,J.vertexTangents=z.vertexTangents,J.toneMapping=z.toneMapping}function Oo(E,z,J,q,K){z.isScene!==!0&&(z=vi),$e.resetTextureUnits();let we=z.fog,Pe=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?z.environment:null,Te=ce===null?L.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:ot.workingColorSpace,De=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,ze=C.get(q.envMap||Pe,De),tt=q.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,pt=!!J.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Ge=!!J.morphAttributes.position,mt=!!J.morphAttributes.normal,$t=!!J.morphAttributes.color,At=gn;q.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(At=L.toneMapping);let Rt=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,Mi=Rt!==void 0?Rt.length:0,Fe=He.get(q),hi=T.state.lights;if(Ut===!0&&(fi===!0||E!==Q)){let Ct=E===Q&&q.id===$;ie.setState(q,E,Ct)}let xt=!1,lr=!1;q.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==hi.state.version||K.isBatchedMesh&&Fe.batching===!1||!K.isBatchedMesh&&Fe.batching===!0||K.isBatchedMesh&&Fe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Fe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Fe.instancing===!1||!K.isInstancedMesh&&Fe.instancing===!0||K.isSkinnedMesh&&Fe.skinning===!1||!K.isSkinnedMesh&&Fe.skinning===!0||K.isInstancedMesh&&Fe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Fe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Fe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Fe.instancingMorph===!1&&K.morphTexture!==null||Fe.envMap!==ze||q.fog===!0&&Fe.fog!==we||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ie.numPlanes||Fe.numIntersection!==ie.numIntersection)||Fe.vertexAlphas!==tt||Fe.vertexTangents!==pt||Fe.morphTargets!==Ge||Fe.morphNormals!==mt||Fe.morphColors!==$t||Fe.morphTargetsCount!==Mi||Fe.numLightProbeGrids!==si(T.state.lightProbeGridArray)?xt=!0:(Fe.outputColorSpace!==Te||Fe.toneMapping!==At)&&(lr=!0):(xt=!0,Fe.__version=q.version);let di=Fe.currentProgram;(xt===!0||lr===!0)&&(di=lr===!0?cn(q,z,K,Te,At):Yn(q,z,K),G&&q.isNodeMaterial&&G.onUpdateProgram(q,di,Fe));let bs=!1,Kn=!1,cr=!1,ut=di.getUniforms(),ti=Fe.uniforms;if(be.useProgram(di.program)&&(bs=!0,Kn=!0,cr=!0),q.id!==$&&($=q.id,Kn=!0),bs||Q!==E){be.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ut.setValue(B,"projectionMatrix",E.projectionMatrix),ut.setValue(B,"viewMatrix",E.matrixWorldInverse);let pi=ut.map.cameraPosition;pi!==void 0&&pi.setValue(B,wi.setFromMatrixPosition(E.matrixWorld)),st.logarithmicDepthBuffer&&ut.setValue(B,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&ut.setValue(B,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&(Q=E,Kn=!0,cr=!0)}if(Fe.needsLights&&(hi.state.sunShadowMap.length>0&&ut.setValue(B,"sunShadowMap",hi.state.sunShadowMap,$e),hi.state.directionalShadowMap.length>0&&ut.setValue(B,"directionalShadowMap",hi.state.directionalShadowMap,$e),hi.state.spotShadowMap.length>0&&ut.setValue(B,"spotShadowMap",hi.state.spotShadowMap,$e),hi.state.pointShadowMap.length>0&&ut.setValue(B,"pointShadowMap",hi.state.pointShadowMap,$e)),K.isSkinnedMesh){ut.setOptional(B,K,"bindMatrix"),ut.setOptional(B,K,"bindMatrixInverse");let Ct=K.skeleton;Ct&&(Ct.boneTexture===null&&Ct.computeBoneTexture(),ut.setValue(B,"boneTexture",Ct.boneTexture,$e))}K.isBatchedMesh&&(ut.setOptional(B,K,"batchingTexture"),ut.setValue(B,"batchingTexture",K._matricesTexture,$e),ut.setOptional(B,K,"batchingIdTexture"),ut.setValue(B,"batchingIdTexture",K._indirectTexture,$e),ut.setOptional(B,K,"batchingColorTexture"),K._colorsTexture!==null&&ut.setValue(B,"batchingColorTexture",K._colorsTexture,$e));let Ki=J.morphAttributes;if((Ki.position!==void 0||Ki.normal!==void 0||Ki.color!==void 0)&&re.update(K,J,di),(Kn||Fe.receiveShadow!==K.receiveShadow)&&(Fe.receiveShadow=K.receiveShadow,ut.setValue(B,"receiveShadow",K.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&z.environment!==null&&(ti.envMapIntensity.value=z.environmentIntensity),ti.dfgLUT!==void 0&&(ti.dfgLUT.value=p_()),Kn){if(ut.setValue(B,"toneMappingExposure",L.toneMappingExposure),Fe.needsLights&&Ss(ti,cr),we&&q.fog===!0&&xe.refreshFogUniforms(ti,we),xe.refreshMaterialUniforms(ti,q,ye,Ae,T.state.transmissionRenderTarget[E.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Ct=y,pi=0;for(let Gi of T.state.lightProbeGridArray)Gi.texture!==null&&(Ct.textures[pi]=Gi.texture,Ct.min[pi]=Gi.boundingBox.min,Ct.max[pi]=Gi.boundingBox.max,Ct.resolution[pi]=Gi.resolution,pi++);for(let Gi in Ct)Ct[Gi].length=pi;ti.probesSH.value=Ct.textures,ti.probesMin.value=Ct.min,ti.probesMax.value=Ct.max,ti.probesResolution.value=Ct.resolution}Kr.upload(B,wr(Fe),ti,$e)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(Kr.upload(B,wr(Fe),ti,$e),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&ut.setValue(B,"center",K.center),ut.setValue(B,"modelViewMatrix",K.modelViewMatrix),ut.setValue(B,"normalMatrix",K.normalMatrix),ut.setValue(B,"modelMatrix",K.matrixWorld),q.uniformsGroups!==void 0){let Ct=q.uniformsGroups;for(let pi=0,Gi=Ct.length;pi<Gi;pi++){let ll=Ct[pi];We.update(ll,di),We.bind(ll,di)}}return di}function Ss(E,z){E.ambientLightColor.needsUpdate=z,E.lightProbe.needsUpdate=z,E.sunLights.needsUpdate=z,E.sunLightShadows.needsUpdate=z,E.directionalLights.needsUpdate=z,E.directionalLightShadows.needsUpdate=z,E.pointLights.needsUpdate=z,E.pointLightShadows.needsUpdate=z,E.spotLights.needsUpdate=z,E.spotLightShadows.needsUpdate=z,E.rectAreaLights.needsUpdate=z,E.hemisphereLights.needsUpdate=z}function Tr(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(E,z,J){let q=He.get(E);q.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),He.get(E.texture).__webglTexture=z,He.get(E.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:J,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,z){let J=He.get(E);J.__webglFramebuffer=z,J.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(E,z=0,J=0){ce=E,Y=z,V=J;let q=null,K=!1,we=!1;if(E){let Te=He.get(E);if(Te.__useDefaultFramebuffer!==void 0){be.bindFramebuffer(B.FRAMEBUFFER,Te.__webglFramebuffer),ne.copy(E.viewport),he.copy(E.scissor),ue=E.scissorTest,be.viewport(ne),be.scissor(he),be.setScissorTest(ue),$=-1;return}else if(Te.__webglFramebuffer===void 0)$e.setupRenderTarget(E);else if(Te.__hasExternalTextures)$e.rebindTextures(E,He.get(E.texture).__webglTexture,He.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let tt=E.depthTexture;if(Te.__boundDepthTexture!==tt){if(tt!==null&&He.has(tt)&&(E.width!==tt.image.width||E.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(E)}}let De=E.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(we=!0);let ze=He.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(ze[z])?q=ze[z][J]:q=ze[z],K=!0):E.samples>0&&$e.useMultisampledRTT(E)===!1?q=He.get(E).__webglMultisampledFramebuffer:Array.isArray(ze)?q=ze[J]:q=ze,ne.copy(E.viewport),he.copy(E.scissor),ue=E.scissorTest}else ne.copy(Ve).multiplyScalar(ye).floor(),he.copy(dt).multiplyScalar(ye).floor(),ue=ft;if(J!==0&&(q=k),be.bindFramebuffer(B.FRAMEBUFFER,q)&&be.drawBuffers(E,q),be.viewport(ne),be.scissor(he),be.setScissorTest(ue),K){let Te=He.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+z,Te.__webglTexture,J)}else if(we){let Te=z;for(let De=0;De<E.textures.length;De++){let ze=He.get(E.textures[De]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+De,ze.__webglTexture,J,Te)}}else if(E!==null&&J!==0){let Te=He.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Te.__webglTexture,J)}$=-1};function ys(E){let z=He.get(E);return(z.__readFormat!==E.format||z.__readType!==E.type)&&(z.__readFormat=E.format,z.__readType=E.type,z.__formatReadable=st.textureFormatReadable(E.format),z.__typeReadable=st.textureTypeReadable(E.type)),z}this.readRenderTargetPixels=function(E,z,J,q,K,we,Pe,Te=0){if(!(E&&E.isWebGLRenderTarget)){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=He.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pe!==void 0&&(De=De[Pe],Array.isArray(De)&&(De=De[0])),De){be.bindFramebuffer(B.FRAMEBUFFER,De);try{let ze=E.textures[Te],tt=ze.format,pt=ze.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let Ge=ys(ze);if(Ge.__formatReadable===!1){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ge.__typeReadable===!1){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=E.width-q&&J>=0&&J<=E.height-K&&B.readPixels(z,J,q,K,ge.convert(tt),ge.convert(pt),we)}finally{let ze=ce!==null?He.get(ce).__webglFramebuffer:null;be.bindFramebuffer(B.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(E,z,J,q,K,we,Pe,Te=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=He.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pe!==void 0&&(De=De[Pe],Array.isArray(De)&&(De=De[0])),De)if(z>=0&&z<=E.width-q&&J>=0&&J<=E.height-K){be.bindFramebuffer(B.FRAMEBUFFER,De);let ze=E.textures[Te],tt=ze.format,pt=ze.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let Ge=ys(ze);if(Ge.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ge.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.bufferData(B.PIXEL_PACK_BUFFER,we.byteLength,B.STREAM_READ),B.readPixels(z,J,q,K,ge.convert(tt),ge.convert(pt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let $t=ce!==null?He.get(ce).__webglFramebuffer:null;be.bindFramebuffer(B.FRAMEBUFFER,$t);let At=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await $p(B,At,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,we),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(mt),B.deleteSync(At),we}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,z=null,J=0){let q=Math.pow(2,-J),K=Math.floor(E.image.width*q),we=Math.floor(E.image.height*q),Pe=z!==null?z.x:0,Te=z!==null?z.y:0;$e.setTexture2D(E,0),B.copyTexSubImage2D(B.TEXTURE_2D,J,0,0,Pe,Te,K,we),be.unbindTexture()},this.copyTextureToTexture=function(E,z,J=null,q=null,K=0,we=0){let Pe,Te,De,ze,tt,pt,Ge,mt,$t,At=E.isCompressedTexture?E.mipmaps[we]:E.image;if(J!==null)Pe=J.max.x-J.min.x,Te=J.max.y-J.min.y,De=J.isBox3?J.max.z-J.min.z:1,ze=J.min.x,tt=J.min.y,pt=J.isBox3?J.min.z:0;else{let ut=Math.pow(2,-K);Pe=Math.floor(At.width*ut),Te=Math.floor(At.height*ut),E.isDataArrayTexture?De=At.depth:E.isData3DTexture?De=Math.floor(At.depth*ut):De=1,ze=0,tt=0,pt=0}q!==null?(Ge=q.x,mt=q.y,$t=q.z):(Ge=0,mt=0,$t=0);let Rt=ge.convert(z.format),Mi=ge.convert(z.type),Fe;z.isData3DTexture?($e.setTexture3D(z,0),Fe=B.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?($e.setTexture2DArray(z,0),Fe=B.TEXTURE_2D_ARRAY):($e.setTexture2D(z,0),Fe=B.TEXTURE_2D),be.activeTexture(B.TEXTURE0),be.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,z.flipY),be.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),be.pixelStorei(B.UNPACK_ALIGNMENT,z.unpackAlignment);let hi=be.getParameter(B.UNPACK_ROW_LENGTH),xt=be.getParameter(B.UNPACK_IMAGE_HEIGHT),lr=be.getParameter(B.UNPACK_SKIP_PIXELS),di=be.getParameter(B.UNPACK_SKIP_ROWS),bs=be.getParameter(B.UNPACK_SKIP_IMAGES);be.pixelStorei(B.UNPACK_ROW_LENGTH,At.width),be.pixelStorei(B.UNPACK_IMAGE_HEIGHT,At.height),be.pixelStorei(B.UNPACK_SKIP_PIXELS,ze),be.pixelStorei(B.UNPACK_SKIP_ROWS,tt),be.pixelStorei(B.UNPACK_SKIP_IMAGES,pt);let Kn=E.isDataArrayTexture||E.isData3DTexture,cr=z.isDataArrayTexture||z.isData3DTexture;if(E.isDepthTexture){let ut=He.get(E),ti=He.get(z),Ki=He.get(ut.__renderTarget),Ct=He.get(ti.__renderTarget);be.bindFramebuffer(B.READ_FRAMEBUFFER,Ki.__webglFramebuffer),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ct.__webglFramebuffer);for(let pi=0;pi<De;pi++)Kn&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(E).__webglTexture,K,pt+pi),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(z).__webglTexture,we,$t+pi)),B.blitFramebuffer(ze,tt,ze+Pe,tt+Te,Ge,mt,Ge+Pe,mt+Te,B.DEPTH_BUFFER_BIT,B.NEAREST);be.bindFramebuffer(B.READ_FRAMEBUFFER,null),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(K!==0||E.isRenderTargetTexture||He.has(E)){let ut=He.get(E),ti=He.get(z);be.bindFramebuffer(B.READ_FRAMEBUFFER,I),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,W);for(let Ki=0;Ki<De;Ki++)Kn?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ut.__webglTexture,K,pt+Ki):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ut.__webglTexture,K),cr?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ti.__webglTexture,we,$t+Ki):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ti.__webglTexture,we),K!==0?B.blitFramebuffer(ze,tt,ze+Pe,tt+Te,Ge,mt,Ge+Pe,mt+Te,B.COLOR_BUFFER_BIT,B.NEAREST):cr?B.copyTexSubImage3D(Fe,we,Ge,mt,$t+Ki,ze,tt,Pe,Te):B.copyTexSubImage2D(Fe,we,Ge,mt,ze,tt,Pe,Te);be.bindFramebuffer(B.READ_FRAMEBUFFER,null),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else cr?E.isDataTexture||E.isData3DTexture?B.texSubImage3D(Fe,we,Ge,mt,$t,Pe,Te,De,Rt,Mi,At.data):z.isCompressedArrayTexture?B.compressedTexSubImage3D(Fe,we,Ge,mt,$t,Pe,Te,De,Rt,At.data):B.texSubImage3D(Fe,we,Ge,mt,$t,Pe,Te,De,Rt,Mi,At):E.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,we,Ge,mt,Pe,Te,Rt,Mi,At.data):E.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,we,Ge,mt,At.width,At.height,Rt,At.data):B.texSubImage2D(B.TEXTURE_2D,we,Ge,mt,Pe,Te,Rt,Mi,At);be.pixelStorei(B.UNPACK_ROW_LENGTH,hi),be.pixelStorei(B.UNPACK_IMAGE_HEIGHT,xt),be.pixelStorei(B.UNPACK_SKIP_PIXELS,lr),be.pixelStorei(B.UNPACK_SKIP_ROWS,di),be.pixelStorei(B.UNPACK_SKIP_IMAGES,bs),we===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&B.generateMipmap(Fe),be.unbindTexture()},this.initRenderTarget=function(E){He.get(E).__webglFramebuffer===void 0&&$e.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?$e.setTextureCube(E,0):E.isData3DTexture?$e.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?$e.setTexture2DArray(E,0):$e.setTexture2D(E,0),be.unbindTexture()},this.resetState=function(){Y=0,V=0,ce=null,be.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Fi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=ot._getDrawingBufferColorSpace(e),t.unpackColorSpace=ot._getUnpackColorSpace()}};var gb=.07,Kc=Math.PI/2-.001,$c=class{constructor(e,t,i,r){this.camera=e,this.element=t,this.changed=i,this.up=new U(...r).normalize(),this.basis=new Wt().setFromUnitVectors(new U(0,1,0),this.up),this.now={target:new U,azimuth:.6,elevation:.4,distance:1},this.goal={target:new U,azimuth:.6,elevation:.4,distance:1},this.nearest=1e-6,this.farthest=1e6,this.chosen=!1,this.takesWheel=()=>!0,this.pointers=new Map,t.addEventListener("pointerdown",s=>this.#i(s)),t.addEventListener("pointermove",s=>this.#r(s));for(let s of["pointerup","pointercancel"])t.addEventListener(s,o=>this.#n(o));t.addEventListener("wheel",s=>this.#s(s),{passive:!1}),t.addEventListener("contextmenu",s=>s.preventDefault())}get pixel(){return 2*this.now.distance*Math.tan(this.camera.fov*Math.PI/360)/Math.max(this.element.clientHeight,1)}direction(e=this.now){let t=Math.cos(e.elevation);return new U(t*Math.sin(e.azimuth),Math.sin(e.elevation),t*Math.cos(e.azimuth)).applyQuaternion(this.basis)}look({target:e,direction:t,distance:i},r=!1){if(this.chosen=!0,e&&this.goal.target.copy(e),i&&(this.goal.distance=this.#t(i)),t){let s=t.clone().normalize().applyQuaternion(this.basis.clone().invert());if(this.goal.elevation=Math.max(-Kc,Math.min(Kc,Math.asin(Math.max(-1,Math.min(1,s.y))))),Math.hypot(s.x,s.z)>1e-6){let o=Math.atan2(s.x,s.z);this.goal.azimuth=o+2*Math.PI*Math.round((this.now.azimuth-o)/(2*Math.PI))}}r&&this.settle(),this.changed()}settle(){this.now.target.copy(this.goal.target);for(let e of["azimuth","elevation","distance"])this.now[e]=this.goal[e];this.#e()}step(e){let t=1-Math.exp(-e/gb),{now:i,goal:r}=this,s=i.target.distanceTo(r.target)/i.distance+Math.abs(i.azimuth-r.azimuth)+Math.abs(i.elevation-r.elevation)+Math.abs(Math.log(i.distance/r.distance));return s<1e-4?(s&&this.settle(),!1):(i.target.lerp(r.target,t),i.azimuth+=t*(r.azimuth-i.azimuth),i.elevation+=t*(r.elevation-i.elevation),i.distance*=(r.distance/i.distance)**t,this.#e(),!0)}#e(){let{camera:e,now:t}=this;e.position.copy(t.target).addScaledVector(this.direction(),t.distance),m_.lookAt(this.direction(),xb,this.up),e.quaternion.setFromRotationMatrix(m_),e.updateMatrixWorld(!0)}#t(e){return Math.max(this.nearest,Math.min(this.farthest,e))}#i(e){e.button>2||(this.element.setPointerCapture?.(e.pointerId),this.pointers.set(e.pointerId,{x:e.clientX,y:e.clientY,pan:e.button!==0||e.shiftKey||e.ctrlKey}))}#n(e){this.pointers.delete(e.pointerId)}get dragging(){return this.pointers.size>0}#r(e){let t=this.pointers.get(e.pointerId);if(!t)return;let i=[...this.pointers.entries()].filter(([o])=>o!==e.pointerId).map(([,o])=>o),r=e.clientX-t.x,s=e.clientY-t.y;if(i.length){let[o]=i,a=Math.hypot(t.x-o.x,t.y-o.y),c=Math.hypot(e.clientX-o.x,e.clientY-o.y);a>0&&c>0&&this.zoom(a/c,(e.clientX+o.x)/2,(e.clientY+o.y)/2),this.pan(r/2,s/2)}else t.pan?this.pan(r,s):this.turn(r,s);t.x=e.clientX,t.y=e.clientY}turn(e,t){this.chosen=!0;let i=1.1*Math.PI/Math.max(this.element.clientHeight,1);this.goal.azimuth-=i*e,this.goal.elevation=Math.max(-Kc,Math.min(Kc,this.goal.elevation+i*t)),this.changed()}pan(e,t){this.chosen=!0;let i=this.pixel;this.goal.target.addScaledVector(Zc.set(1,0,0).applyQuaternion(this.camera.quaternion),-e*i),this.goal.target.addScaledVector(Zc.set(0,1,0).applyQuaternion(this.camera.quaternion),t*i),this.changed()}zoom(e,t,i){this.chosen=!0;let r=this.goal.distance;if(this.goal.distance=this.#t(r*e),t!==void 0){let s=this.element.getBoundingClientRect(),o=this.pixel*r/this.now.distance*(1-this.goal.distance/r);this.goal.target.addScaledVector(Zc.set(1,0,0).applyQuaternion(this.camera.quaternion),(t-s.left-this.middle(t-s.left))*o),this.goal.target.addScaledVector(Zc.set(0,1,0).applyQuaternion(this.camera.quaternion),(s.height/2-(i-s.top))*o)}this.changed()}middle(e){let t=this.element.clientWidth/(this.pictures??1);return(Math.floor(e/t)+.5)*t}#s(e){if(!this.takesWheel(e))return;e.preventDefault();let t=e.deltaMode===1?33:1;this.zoom(Math.exp(Math.max(-1,Math.min(1,e.deltaY*t*.0015))),e.clientX,e.clientY)}},m_=new Ie,xb=new U,Zc=new U;var[_b,vb]=[5126,5125],[g_,Mb]=[34962,34963],Ku=class{constructor(){this.pieces=[],this.length=0,this.json={asset:{version:"2.0",generator:"pitchpoint"},scene:0,scenes:[{nodes:[]}],nodes:[],meshes:[],materials:[],accessors:[],bufferViews:[],buffers:[{byteLength:0}]}}put(e,t,i,r=!1){let s={SCALAR:1,VEC3:3,VEC4:4}[t];this.json.bufferViews.push({buffer:0,byteOffset:this.length,byteLength:e.byteLength,...i&&{target:i}});let o={bufferView:this.json.bufferViews.length-1,componentType:e instanceof Float32Array?_b:vb,count:e.length/s,type:t};return r&&(o.min=Array(s).fill(1/0),o.max=Array(s).fill(-1/0),e.forEach((a,c)=>{o.min[c%s]=Math.min(o.min[c%s],a),o.max[c%s]=Math.max(o.max[c%s],a)})),this.pieces.push(new Uint8Array(e.buffer,e.byteOffset,e.byteLength)),this.length+=e.byteLength,this.json.accessors.push(o)-1}bytes(){this.json.buffers[0].byteLength=this.length;let e=new TextEncoder().encode(JSON.stringify(this.json)),t=Math.ceil(e.length/4)*4,i=new Uint8Array(20+t+8+this.length),r=new DataView(i.buffer);[1179937895,2,i.length,t,1313821514].forEach((o,a)=>r.setUint32(4*a,o,!0)),i.fill(32,20,20+t),i.set(e,20),r.setUint32(20+t,this.length,!0),r.setUint32(24+t,5130562,!0);let s=28+t;for(let o of this.pieces)i.set(o,s),s+=o.length;return i}};function x_(n,e,t,i){let r=new Ku,{json:s}=r,o=new U,a=new Wt,c=new U,l=new Wt,h=i.length>1,f=h?r.put(Float32Array.from(i,d=>d-i[0]),"SCALAR",void 0,!0):0,u={name:"record",samplers:[],channels:[]},m=new Set(n.map(({solid:d})=>d.skin?d.skin.bodies[0]:d.body)),x=new Map;for(let d of m){let p={name:d<0?"ground":e[d].name,children:[]};if(x.set(d,p),s.scenes[0].nodes.push(s.nodes.push(p)-1),d<0)continue;let v=new Float32Array(3*i.length),A=new Float32Array(4*i.length);if(t[d].forEach((y,R)=>{y.decompose(o,a,c),R&&a.dot(l)<0&&a.set(-a.x,-a.y,-a.z,-a.w),l.copy(a),o.toArray(v,3*R),a.toArray(A,4*R)}),p.translation=[...v.slice(0,3)],p.rotation=[...A.slice(0,4)],!!h)for(let[y,R,T,g]of[["translation",v,"VEC3",3],["rotation",A,"VEC4",4]]){if(R.every((O,L)=>O===R[L%g]))continue;let w=u.samplers.push({input:f,output:r.put(R,T),interpolation:"LINEAR"})-1;u.channels.push({sampler:w,target:{node:s.nodes.indexOf(p),path:y}})}}let M=new Map;for(let{solid:d,geometry:p,colour:v}of n){let A=v+!!d.see_through;if(!M.has(A)){let{r:L,g:D,b:G}=new Xe(v),k={baseColorFactor:[L,D,G,d.see_through?.22:1],metallicFactor:.1,roughnessFactor:.7};M.set(A,s.materials.push({pbrMetallicRoughness:k,...d.see_through&&{alphaMode:"BLEND"}})-1)}let{position:y,normal:R}=p.attributes,T={POSITION:r.put(y.array,"VEC3",g_,!0),NORMAL:r.put(R.array,"VEC3",g_)},g=r.put(Uint32Array.from(p.index.array),"SCALAR",Mb),w=s.meshes.push({name:d.name,primitives:[{attributes:T,indices:g,material:M.get(A)}]})-1,O=s.nodes.push({name:d.name,mesh:w})-1;x.get(d.skin?d.skin.bodies[0]:d.body).children.push(O)}for(let d of x.values())d.children.length||delete d.children;return u.channels.length&&(s.animations=[u]),r.bytes()}function il(n,e){let t=URL.createObjectURL(n),i=ae("a",{href:t,download:e});document.body.append(i),i.click(),i.remove(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}function nl(n,e){return`${n.scenes[0].title.toLowerCase().replace(/[^a-z0-9]+/g,"-").replace(/^-|-$/g,"")||"scene"}.${e}`}function Jc(n,e=1){let{stage:t}=n,{renderer:i,canvas:r}=t;i.setPixelRatio(t.ratio*e),i.setSize(t.size.width,t.size.height),n.draw();let s=ae("canvas",{width:r.width,height:r.height}),o=s.getContext("2d");o.drawImage(r,0,0),t.resize(),n.draw();let a=t.ratio*e;o.scale(a,a);let c=getComputedStyle(n.root),l=c.getPropertyValue("--v-ink").trim()||"#222",h=c.getPropertyValue("--v-soft").trim()||"#666",{width:f,height:u}=t.size;o.textBaseline="top",o.font=`600 14px ${c.fontFamily}`,o.fillStyle=l;let m=f/n.scenes.length;n.scenes.forEach((A,y)=>o.fillText(A.title,12+y*m,10)),o.font=`12px ${c.fontFamily}`,o.fillStyle=h;let x=n.modes?.active?n.modes.words:`t = ${$o(n.player.time,n.transport.stepLength/10)}`;n.scenes.forEach((A,y)=>o.fillText([A.subtitle,x].filter(Boolean).join(", "),12+y*m,28)),n.legends.forEach((A,y)=>{A.element.hidden||Sb(o,n,y,(y+1)*m,l,c)});let[M,d]=n.scale.children;o.fillStyle=o.strokeStyle=h,o.fillText(M.textContent,12,u-30);let p=parseFloat(d.style.width);o.beginPath(),o.moveTo(12,u-15),o.lineTo(12,u-10),o.lineTo(12+p,u-10),o.lineTo(12+p,u-15),o.stroke();let v=atob(s.toDataURL("image/png").split(",")[1]);return new Blob([Uint8Array.from(v,A=>A.charCodeAt(0))],{type:"image/png"})}function Sb(n,e,t,i,r,s){let{arrows:o}=e.stage.pictures[t],a=e.legends[t],{columns:c}=a,l=a.lines(o.now,o.shown).slice(0,20),h=92*c.length+24+Math.max(0,...l.map(({name:f})=>n.measureText(f).width));n.globalAlpha=.85,n.fillStyle=s.getPropertyValue("--v-paper").trim()||"#fff",n.fillRect(i-h,0,h,34+16*l.length),n.globalAlpha=1,n.textAlign="right",c.forEach((f,u)=>{n.fillStyle=Zo(e.root,f),n.fillText(f,i-12-92*(c.length-1-u),10)}),l.forEach(({name:f,values:u},m)=>{let x=27+16*m;n.fillStyle=r,n.font=`12px ${s.fontFamily}`,n.fillText(f,i-12-92*c.length,x);for(let{part:M,text:d}of u)n.fillText(d,i-12-92*(c.length-1-c.indexOf(M)),x)}),n.textAlign="left"}function Qc(n){let e=n.stage.pictures[0].solids.exported(!1),t=e.reduce((h,f)=>h+f.geometry.index.count/3,0),i=new ArrayBuffer(84+50*t),r=new DataView(i);r.setUint32(80,t,!0);let s=84,o=[new U,new U,new U],a=new U,c=new U,l=h=>{for(let f of[h.x,h.y,h.z])r.setFloat32(s,f,!0),s+=4};for(let{solid:h,geometry:f}of e){let u=n.stage.pictures[0].poses.ofSolid(h),m=f.attributes.position.array,x=f.index.array;for(let M=0;M<x.length;M+=3)o.forEach((d,p)=>d.fromArray(m,3*x[M+p]).applyMatrix4(u)),a.subVectors(o[1],o[0]).cross(c.subVectors(o[2],o[0])).normalize(),l(a),o.forEach(l),s+=2}return new Blob([i],{type:"model/stl"})}var __=1e3;function jc(n){let{solids:e,poses:t,data:i}=n.stage.pictures[0],r=t.times.length,s=Math.max(1,Math.ceil((r-1)/(__-1))),o=[];for(let h=0;h<r;h+=s)o.push(h);let a=yb(o.map(h=>t.times[h]),t),c=e.exported(!0),l=t.world.map(()=>[]);for(let h of a)t.at(h),t.world.forEach((f,u)=>l[u].push(new Ie().copy(f)));return t.at(n.player.time),n.changed(),new Blob([x_(c,i.bodies,l,a)],{type:"model/gltf-binary"})}function yb(n,e){let t=s=>(e.at(s),e.bodies.map((o,a)=>e.angle(a))),i=[n[0]],r=t(n[0]);for(let s=1;s<n.length&&i.length<8*__;s++){let o=t(n[s]),a=Math.max(0,...o.map((l,h)=>Math.abs(l-r[h]))),c=Math.min(64,Math.max(1,Math.ceil(a/(Math.PI/2))));for(let l=1;l<=c;l++)i.push(n[s-1]+(n[s]-n[s-1])*l/c);r=o}return i}function v_(n){if(typeof MediaRecorder>"u"||!n.captureStream)return null;let t=["video/mp4;codecs=avc1.42E01E","video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm"].find(i=>MediaRecorder.isTypeSupported(i));return t?{ending:t.slice(6,t.includes(";")?t.indexOf(";"):void 0),start(){let i=new MediaRecorder(n.captureStream(30),{mimeType:t,videoBitsPerSecond:6e6}),r=[];return i.ondataavailable=({data:s})=>s.size&&r.push(s),i.start(500),()=>new Promise(s=>{i.onstop=()=>s(new Blob(r,{type:t.split(";")[0]})),i.stop()})}}:null}var ef=class{constructor(){this.bar=ae("div",{className:"ppv-tools",role:"toolbar","aria-label":"Scene"}),this.panel=ae("div",{className:"ppv-panel",hidden:!0}),this.open=null,this.panel.addEventListener("keydown",e=>{e.key==="Escape"&&this.close()})}action(e,t,i){let r=Ht(e,t,i);return this.bar.append(r),r}add(e,t,i){let r=Ht(e,t,()=>this.open===e?this.close():this.show(e,i,r),{"aria-expanded":"false"});return this.bar.append(r),r}show(e,t,i){this.close(),this.open=e,this.opener=i,i.setAttribute("aria-expanded","true"),this.panel.replaceChildren(ae("div",{className:"ppv-panel-head"},ae("b",{},e),Ht("\xD7","Close",()=>this.close())),...t),this.panel.hidden=!1}close(){if(!this.open)return;let e=this.panel.contains(document.activeElement);this.open=null,this.panel.hidden=!0,this.opener.setAttribute("aria-expanded","false"),e&&this.opener.focus()}};function M_(n){let{stage:e}=n,t=e.pictures[0].data,i=[["axis","Along the axis"],["front","From the side"],["top","From above"],["iso","Oblique"]];n.followed=ur("follow",[["-1","nothing"],...t.bodies.map((l,h)=>[String(h),l.name])],l=>n.follow(Number(l)),"Body that the camera follows (1 to 9, 0)");let r=jr("turn with it",!1,l=>{n.views.turning=l,n.views.follow(n.views.body,l)}),s=t.solids.some(l=>l.see_through)?ur("housing",[["see-through","see-through"],["solid","solid"],["hidden","hidden"]],l=>{for(let h of e.pictures)h.solids.cover(l);n.changed()}).row:null,o=t.solids.some(l=>l.schematic)?jr("what only stands for parts",!0,l=>{for(let h of e.pictures)h.solids.schematics(l);n.changed()}).row:null,c=t.arrows.filter(l=>l.kind==="mesh").map(l=>Ht(l.name.replaceAll("_"," "),`Look into the mesh ${l.name}, along its axis`,()=>n.intoMesh(l)));return[ae("div",{className:"ppv-buttons"},...i.map(([l,h])=>Ht(l,h,()=>n.views.named(l)))),n.followed.row,r.row,s,o,c.length?ae("div",{},ae("span",{className:"ppv-soft"},"look into a mesh"),ae("div",{className:"ppv-buttons"},...c)):null].filter(Boolean)}function S_(n){let e=n.stage.pictures.map(r=>r.arrows),t=[...new Set(e.flatMap(r=>[...r.kinds]))],i=Qr({label:"length",title:"Length of the arrows",least:.05,most:20,value:1,show:r=>`\xD7 ${zi(r,2)}`,changed:r=>{for(let s of e)s.scale=r;n.changed()}});return[...t.map(r=>jr({mesh:"mesh forces",bearing:"bearing forces",load:"loads"}[r]??r,!0,s=>{for(let o of e)s?o.shown.add(r):o.shown.delete(r);n.changed()}).row),i.row]}function y_(n){let{stage:e}=n,t=o=>il(Jc(n,o),nl(n,"png")),i=v_(e.canvas),r=null,s=i?Ht("film",`Film what is played, ${i.ending}`,async()=>{if(s.setAttribute("aria-pressed",String(!r)),!r){n.filming=!0,e.coarsen(!1),r=i.start(),s.textContent="stop the film",n.toggle(!0);return}let o=r;r=null,n.filming=!1,s.textContent="film",il(await o(),nl(n,i.ending))}):null;return[ae("div",{className:"ppv-buttons"},Ht("picture","PNG of the scene with title, time and forces",()=>t(1)),Ht("picture \xD7 2","The same with twice as many pixels each way",()=>t(2)),s),ae("div",{className:"ppv-buttons"},Ht("GLB, moving","Solids and their motion, binary glTF",()=>il(jc(n),nl(n,"glb"))),Ht("STL","Solids where they are now, metres",()=>il(Qc(n),nl(n,"stl"))))]}function b_(n){return n.magnification=Qr({label:"\xD7 ",title:"How much vibrations are magnified; turning is not (m)",least:1,most:1e4,value:1,show:e=>zi(e<10?Number(e.toPrecision(2)):Math.round(e),e<10?2:5),changed:e=>n.magnify(e)}),[n.magnification.row,ae("p",{className:"ppv-soft"},"Displacements, tilts and torsion about their means; the turning itself is not magnified.")]}var MU=new U(1,0,0),rf=new U(0,0,1);function E_(n,e,t,i){let r=Math.hypot(e,t,i);if(r<1e-300)return n.identity();let s=Math.sin(r/2)/r;return n.set(s*e,s*t,s*i,Math.cos(r/2))}var No=class{constructor(e){this.bodies=e.bodies,this.times=e.times?.data??new Float64Array([0]),this.where={low:0,share:0},this.magnification=1,this.world=this.bodies.map(()=>new Ie),this.still=this.bodies.map(()=>new Ie),this.rest=this.bodies.map(()=>new Ie),this.means=this.bodies.map(t=>({position:t.position&&Hs(t.position),turn:t.turn&&Hs(t.turn),spin:t.spin&&Hs(t.spin)})),this.bodies.forEach((t,i)=>{let[r,s,o]=t.place??[0,0,0],a=new Wt(...t.axes??[0,0,0,1]).normalize();t.frame=new Ie().compose(new U(r,s,o),a,new U(1,1,1)),this.rest[i].multiplyMatrices(this.#e(this.rest,i),t.frame)}),this.at(this.times[0])}#e(e,t){let i=this.bodies[t].parent??-1;return i<0?tf:e[i]}ofSolid(e){if(e.between)return this.#t(e);let t=e.skin?e.skin.bodies[0]:e.body,i=t<0?tf:this.world[t];return!e.place&&!e.axes?i:(e.seat??=new Ie().compose(new U(...e.place??[0,0,0]),new Wt(...e.axes??[0,0,0,1]).normalize(),w_),e.placed??=new Ie,e.placed.multiplyMatrices(i,e.seat))}#t(e){let{bodies:t,ends:i}=e.between,[r,s]=t.map((m,x)=>new U(...i[x]).applyMatrix4(m<0?tf:this.world[m])),o=s.clone().sub(r),a=o.length()||1e-12,c=o.clone().divideScalar(a),l=t[0]<0?tf:this.world[t[0]],h=[0,1,2].map(m=>new U().setFromMatrixColumn(l,m)).reduce((m,x)=>Math.abs(x.dot(c))<Math.abs(m.dot(c))-.2?x:m),f=h.addScaledVector(c,-h.dot(c)).normalize(),u=new U().crossVectors(c,f);return e.placed??=new Ie,e.placed.makeBasis(f,u,o.lengthSq()?o:c.multiplyScalar(a)).setPosition(r)}#i({gross:e,ratio:t=1},i){return e?t*ki(e,i):0}angle(e,t=this.where){let{spin:i}=this.bodies[e];return this.#i(this.bodies[e],t)+(i?ki(i,t):0)}at(e){this.mode=null,this.where=er(this.times,e);let{where:t,magnification:i}=this,r=(s,o,a)=>{let c=ki(s,t,a);return i===1?c:o[a]+i*(c-o[a])};return this.bodies.forEach((s,o)=>{this.still[o].multiplyMatrices(this.#e(this.world,o),s.frame),vs.set(0,0,0);let a=this.means[o];s.position&&vs.set(r(s.position,a.position,0),r(s.position,a.position,1),r(s.position,a.position,2)),s.travel&&vs.set(vs.x+ki(s.travel,t,0),vs.y+ki(s.travel,t,1),vs.z+ki(s.travel,t,2)),s.quaternion?(Er.set(...[0,1,2,3].map(l=>s.quaternion.data[l+(s.quaternion.count>1?4*t.low:0)])),s.quaternion.count>1&&t.share&&(Zu.set(...[4,5,6,7].map(l=>s.quaternion.data[l+4*t.low])),Er.slerp(Zu,t.share)),Er.normalize()):(Er.identity(),s.turn&&E_(Er,r(s.turn,a.turn,0),r(s.turn,a.turn,1),r(s.turn,a.turn,2)));let c=this.#i(s,t)+(s.spin?r(s.spin,a.spin,0):0);c&&Er.multiply(Zu.setFromAxisAngle(rf,c)),nf.compose(vs,Er,w_),this.world[o].multiplyMatrices(this.still[o],nf)}),this}ofMode(e,t,i){let r=i*Math.cos(t),s=-i*Math.sin(t);this.mode={shape:e,cosine:r,sine:s};let o=(a,c,l)=>a?r*a.data[6*c+l]+s*a.data[6*c+3+l]:0;return this.bodies.forEach((a,c)=>{E_(Er,o(e.turn,c,0),o(e.turn,c,1),o(e.turn,c,2));let l=this.rest[c];nf.makeRotationFromQuaternion(Er),this.world[c].multiplyMatrices(nf,l);let h=this.world[c].elements;for(let f=0;f<3;f++)h[12+f]=l.elements[12+f]+o(e.position,c,f);this.still[c].copy(this.world[c])}),this}axis(){let e=new U;return this.bodies.forEach((t,i)=>{if(!t.gross&&!t.spin)return;let r=new U().setFromMatrixColumn(this.rest[i],2);e.addScaledVector(r,e.dot(r)<0?-1:1)}),e.length()>1e-9?e.normalize():rf.clone()}},tf=new Ie,nf=new Ie,vs=new U,w_=new U(1,1,1),Er=new Wt,Zu=new Wt;var rl={x:new U(1,0,0),y:new U(0,1,0),z:new U(0,0,1)},sf=class{constructor(e,t){this.stage=e,this.changed=t,this.on=!1,this.normal=new U(0,0,1),this.flipped=!1,this.at=0,this.plane=new Xi;let[i]=Object.entries(rl).reduce((r,s)=>Math.abs(s[1].dot(e.pictures[0].poses.axis()))>Math.abs(r[1].dot(e.pictures[0].poses.axis()))?s:r);this.enable=jr("cut the solids (s)",!1,r=>this.turn(r)),this.axis=ur("square to",[...Object.keys(rl).map(r=>[r,r]),["mesh","axis of the mesh"]],r=>this.along(r)),this.axis.select.lastChild.hidden=!0,this.place=ae("input",{type:"range",min:"0",max:"1000",title:"Place of the cut","aria-label":"Place of the cut"}),this.place.addEventListener("input",()=>this.#t()),this.said=ae("output",{}),this.flip=jr("other half",!1,r=>{this.flipped=r,this.update(),t()}),this.rows=[this.enable.row,this.axis.row,ae("label",{className:"ppv-slider"},ae("span",{},"place"),this.place,this.said),this.flip.row],this.along(i)}along(e){e in rl&&this.normal.copy(rl[e]),this.axis.select.value=e;let[t,i]=this.#e();this.#i((t+i)/2)}through(e,t){let i=Object.entries(rl).find(([,r])=>Math.abs(r.dot(t))>.999999999);this.normal.copy(t).normalize(),i&&this.normal.copy(i[1]),this.axis.select.lastChild.hidden=!!i,this.axis.select.value=i?i[0]:"mesh",this.flipped=this.normal.dot(t)<0,this.flip.input.checked=this.flipped,this.#i(this.normal.dot(e)),this.turn(!0)}#e(){let{low:e,high:t}=this.stage.pictures[0].bounds,i=1/0,r=-1/0;for(let s=0;s<8;s++){let o=new U(s&1?t.x:e.x,s&2?t.y:e.y,s&4?t.z:e.z).dot(this.normal);i=Math.min(i,o),r=Math.max(r,o)}return[i,r]}#t(){let[e,t]=this.#e();this.at=e+Number(this.place.value)/1e3*(t-e),this.said.textContent=`${zi(this.at*1e3,4)} mm`,this.update(),this.changed()}#i(e){let[t,i]=this.#e();this.at=e,this.place.value=String(1e3*(e-t)/(i-t||1)),this.said.textContent=`${zi(e*1e3,4)} mm`,this.update(),this.changed()}turn(e){this.on=e,this.enable.input.checked=e;for(let t of this.stage.pictures)t.solids.cut(e?[this.plane]:[]);this.update(),this.changed()}update(){let e=this.flipped?1:-1;this.plane.normal.copy(this.normal).multiplyScalar(e),this.plane.constant=-e*this.at,this.plane.applyMatrix4(this.stage.seen)}};function bb(){let n=new wo(.19,.19,.72,12,1,!1).translate(0,.36,0),e=new Cc(.5,.3,16,1,!1).translate(0,.85,0),t=[n.toNonIndexed(),e.toNonIndexed()],i=s=>t.flatMap(o=>[...o.attributes[s].array]),r=new Qt;return r.setAttribute("position",new Ft(i("position"),3)),r.setAttribute("normal",new Ft(i("normal"),3)),r.rotateX(Math.PI/2)}var of=class{constructor(e,t,i,r,s){this.arrows=e.arrows,this.poses=i,this.radius=s,this.scale=1,this.kinds=new Set(this.arrows.map(f=>f.kind)),this.shown=new Set(this.kinds),this.hidden=!1;let o=bb(),a=new Pc(.5,14,10),c=f=>new xs({color:f,emissive:f,emissiveIntensity:.35}),l=Object.fromEntries(pr.map(f=>[f,c(Zo(r,f))]));this.states=Object.fromEntries(Object.entries(ks).map(([f,{colour:u}])=>[f,c(u)]));let h=(f,u)=>{let m=new Ot(f,u);return m.matrixAutoUpdate=!1,t.add(m),m};this.drawn=this.arrows.map(f=>({parts:Object.fromEntries(pr.filter(u=>f.components?.[u]).map(u=>[u,h(o,l[u])])),ball:f.state?h(a,this.states[0]):null})),this.largest=this.arrows.map(f=>Object.fromEntries(pr.filter(u=>f.components?.[u]).map(u=>[u,Tb(f.components[u].data)]))),this.size=Math.max(0,...this.arrows.map(f=>f.size??0))}get longest(){return .55*this.radius*this.scale}forces(){let{where:e}=this.poses;return this.arrows.map(t=>{let i=t.body<0?null:this.poses.still[t.body],r=new U(ki(t.at,e,0),ki(t.at,e,1),ki(t.at,e,2));i&&r.applyMatrix4(i);let s={},o={},a=new U;for(let f of pr){let u=t.components?.[f];if(!u)continue;let m=new U(ki(u,e,0),ki(u,e,1),ki(u,e,2));o[f]=m.length(),a.add(m),i&&(T_.extractRotation(i),m.applyMatrix4(T_)),s[f]=m}let c=t.state?e.share===1?e.low+1:e.low:0,l=t.state?t.state.data[t.state.count>1?c:0]:null,h=l===255?-1:l;return{name:t.name,kind:t.kind,unit:t.unit??"N",state:h,vectors:s,values:o,at:r,total:a.length()}})}ends(){return this.hidden||!(this.size>0)?[]:this.forces().flatMap((e,t)=>this.shown.has(e.kind)?Object.entries(e.vectors).map(([i,r])=>{let s=this.longest*this.largest[t][i]/this.size;return r.clone().setLength(r.length()?s:0).add(e.at)}):[])}update(e){this.now=this.forces(),this.now.forEach((t,i)=>{let r=!this.hidden&&this.shown.has(t.kind),{parts:s,ball:o}=this.drawn[i],a=Math.min(.055*this.radius*Math.sqrt(this.scale),22*e||1/0);for(let[c,l]of Object.entries(s)){let h=t.vectors[c],f=this.size>0?this.longest*h.length()/this.size:0;if(l.visible=r&&f>2*e&&f>0,!l.visible)continue;let u=Math.min(a,.5*f);A_.copy(h).normalize(),l.matrix.compose(t.at,Eb.setFromUnitVectors(rf,A_),wb.set(u,u,f))}o&&(o.visible=r,o.material=this.states[t.state]??this.states[0],o.matrix.makeScale(.6*a,.6*a,.6*a).setPosition(t.at))})}},T_=new Ie,Eb=new Wt,A_=new U,wb=new U;function Tb(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}var sl=1024,lf=class extends Ot{constructor(e,t){let i=d=>e.reduce((p,v)=>p+d(v.geometry),0),r=i(d=>d.attributes.position.count),s=new Float32Array(3*r),o=new Float32Array(3*r),a=new Uint8Array(3*r),c=new Float32Array(r),l=new Uint32Array(i(d=>d.index.count)),h=new Xe,f=0,u=0;e.forEach(({geometry:d,colour:p},v)=>{let{array:A}=d.attributes.position;s.set(A,3*f),o.set(d.attributes.normal.array,3*f),h.set(p);let y=[h.r,h.g,h.b].map(R=>Math.round(255*R));for(let R=f;R<f+A.length/3;R++)c[R]=v,a.set(y,3*R);for(let R of d.index.array)l[u++]=f+R;f+=A.length/3});let m=new Qt;m.setAttribute("position",new Zt(s,3)),m.setAttribute("normal",new Zt(o,3)),m.setAttribute("color",new Zt(a,3,!0)),m.setAttribute("member",new Zt(c,1)),m.setIndex(new Zt(l,1)),super(m,t),this.parts=e;let x=Math.ceil(4*e.length/sl);this.places=new yr(new Float32Array(4*sl*x),sl,x,Di,li),this.frustumCulled=!1,this.matrixAutoUpdate=!1,t.vertexColors=!0;let M=t.onBeforeCompile;t.onBeforeCompile=d=>{M(d),d.uniforms.places={value:this.places},d.vertexShader=`attribute float member;
        uniform highp sampler2D places;
        mat4 placeOf() {
          int at = 4 * int(member + 0.5);
          ivec2 t = ivec2(at % ${sl}, at / ${sl});
          return mat4(texelFetch(places, t, 0), texelFetch(places, t + ivec2(1, 0), 0),
            texelFetch(places, t + ivec2(2, 0), 0), texelFetch(places, t + ivec2(3, 0), 0));
        }
        ${d.vertexShader}`.replace("#include <beginnormal_vertex>",`#include <beginnormal_vertex>
mat4 place = placeOf();
objectNormal = mat3(place) * objectNormal;`).replace("#include <begin_vertex>","vec3 transformed = (place * vec4(position, 1.0)).xyz;")},t.customProgramCacheKey=()=>"crowd"}place(e,t){this.places.image.data.set(t.elements,16*e),this.places.needsUpdate=!0}raycast(e,t){this.parts.forEach((i,r)=>{af.geometry=i.geometry,af.material=this.material,af.matrixWorld.fromArray(this.places.image.data,16*r).premultiply(this.matrixWorld);let s=[];af.raycast(e,s);for(let o of s)t.push({...o,object:this,member:r})})}},af=new Ot;function cf(n,e,t=40){let i=n.length/3,r=e.length/3,s=new Float64Array(3*r),o=new Float64Array(r);for(let M=0;M<r;M++){let[d,p,v]=[3*e[3*M],3*e[3*M+1],3*e[3*M+2]],A=n[p]-n[d],y=n[p+1]-n[d+1],R=n[p+2]-n[d+2],T=n[v]-n[d],g=n[v+1]-n[d+1],w=n[v+2]-n[d+2],O=y*w-R*g,L=R*T-A*w,D=A*g-y*T,G=Math.hypot(O,L,D);o[M]=G,G&&s.set([O/G,L/G,D/G],3*M)}let a=new Uint32Array(i+1);for(let M=0;M<e.length;M++)a[e[M]+1]++;for(let M=0;M<i;M++)a[M+1]+=a[M];let c=a.slice(0,i),l=new Uint32Array(e.length);for(let M=0;M<e.length;M++)l[c[e[M]]++]=M;let h=Math.cos(t*Math.PI/180),f=[],u=[],m=[],x=new Uint32Array(e.length);for(let M=0;M<i;M++){let d=[];for(let p=a[M];p<a[M+1];p++){let v=3*(l[p]/3|0),A=0,y=0,R=0;for(let w=a[M];w<a[M+1];w++){let O=l[w]/3|0;s[v]*s[3*O]+s[v+1]*s[3*O+1]+s[v+2]*s[3*O+2]<h||(A+=o[O]*s[3*O],y+=o[O]*s[3*O+1],R+=o[O]*s[3*O+2])}let T=Math.hypot(A,y,R)||1;A/=T,y/=T,R/=T;let g=d.find(w=>Math.abs(u[3*w]-A)+Math.abs(u[3*w+1]-y)+Math.abs(u[3*w+2]-R)<1e-6);g===void 0&&(g=m.length,d.push(g),m.push(M),f.push(n[3*M],n[3*M+1],n[3*M+2]),u.push(A,y,R)),x[l[p]]=g}}return{points:Float32Array.from(f),normals:Float32Array.from(u),index:x,source:Uint32Array.from(m)}}var Ab=.35;function hf({points:n,normals:e,index:t}){let i=new Qt;return i.setAttribute("position",new Zt(n,3)),i.setAttribute("normal",new Zt(e,3)),i.setIndex(n.length/3<65536?new Zt(Uint16Array.from(t),1):new Zt(Uint32Array.from(t),1)),i.computeBoundingSphere(),i}function Qu(n,e){let t=Math.cos(e),i=Math.sin(e),r=new Float32Array(n.length);for(let s=0;s<n.length;s+=3)r[s]=t*n[s]-i*n[s+1],r[s+1]=i*n[s]+t*n[s+1],r[s+2]=n[s+2];return r}function Rb(n,e,t){let i=n.points.data,r=n.triangles.data,s=i.length/3,o=0;for(let d of i)o=Math.max(o,Math.abs(d));let a=new Map,c=[],l=(d,p,v)=>{let A=[d,p,v].map(y=>Math.round(y/o*2e5)).join();return a.has(A)||(a.set(A,c.length/3),c.push(d,p,v)),a.get(A)},h=[];for(let d of[0,-1,1]){let p=d?Qu(i,d*e):i,v=Array.from({length:s},(A,y)=>l(p[3*y],p[3*y+1],p[3*y+2]));for(let A of r)h.push(v[A])}let f=cf(Float32Array.from(c),Uint32Array.from(h),t),u=f.index.subarray(0,r.length),m=new Map,x=Uint32Array.from(u,d=>(m.has(d)||m.set(d,m.size),m.get(d))),M=d=>{let p=new Float32Array(3*m.size);for(let[v,A]of m)p.set(d.subarray(3*v,3*v+3),3*A);return p};return hf({points:M(f.points),normals:M(f.normals),index:x})}var R_=new Ie,$u=new Ie,ff=new Ie,Ju=new on,C_=new an,Cb=new U,uf=class extends Sn{constructor(e,t){super();let{solid:i}=e;this.matrixAutoUpdate=!1;let r=2*Math.PI/Math.max(i.teeth||0,2);this.pieces=i.pieces.map(s=>{let o=Array.from(s.turns.data),a=s.levels.map(f=>{let u=Rb(f,r,i.creases??40),m=new Ya(u,t(s.fault),o.length);return m.instanceMatrix=new Wr(new Float32Array(16*o.length),16),m.frustumCulled=!1,m.matrixAutoUpdate=!1,m.count=0,m.visible=!1,Object.assign(m.userData,{part:e,fault:s.fault}),this.add(m),{error:f.error,geometry:u,mesh:m,shown:[]}}),{center:c,radius:l}=a[a.length-1].geometry.boundingSphere,h=o.map(f=>c.clone().applyMatrix4(R_.makeRotationZ(f)));return{turns:o,levels:a,centres:h,radius:l}})}get meshes(){return this.pieces.flatMap(({levels:e})=>e.map(({mesh:t})=>t))}get drawn(){return this.meshes.reduce((e,t)=>e+(t.visible?t.count*t.geometry.index.count/3:0),0)}get finest(){return this.pieces.reduce((e,{turns:t,levels:i})=>e+t.length*i[i.length-1].geometry.index.count/3,0)}choose(e,t,i){$u.multiplyMatrices(e,this.matrix),ff.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),C_.setFromProjectionMatrix(ff),ff.multiplyMatrices(t.matrixWorldInverse,$u);for(let r of this.pieces){let s=r.levels.map(()=>[]);r.centres.forEach((o,a)=>{if(Ju.center.copy(o).applyMatrix4($u),Ju.radius=r.radius,!C_.intersectsSphere(Ju))return;let c=Math.max(-Cb.copy(o).applyMatrix4(ff).z-r.radius,t.near),l=Ab*i*c,h=r.levels.findIndex(({error:f})=>f<=l);h<0&&(h=r.levels.length-1),s[h].push(a)}),r.levels.forEach((o,a)=>this.#e(r,o,s[a]))}}#e(e,t,i){let{mesh:r}=t;i.length===t.shown.length&&i.every((s,o)=>s===t.shown[o])||(t.shown=i,i.forEach((s,o)=>R_.makeRotationZ(e.turns[s]).toArray(r.instanceMatrix.array,16*o)),r.instanceMatrix.needsUpdate=!0,r.count=i.length,r.visible=i.length>0,r.boundingSphere=null)}whole(e){let t=this.pieces.flatMap(({turns:l,levels:h})=>{let{geometry:f}=h[e==="fine"?Math.min(1,h.length-1):0];return l.map(u=>({geometry:f,turn:u}))}),i=l=>t.reduce((h,{geometry:f})=>h+l(f),0),r=new Float32Array(i(({attributes:l})=>l.position.array.length)),s=new Float32Array(r.length),o=new Uint32Array(i(l=>l.index.count)),[a,c]=[0,0];for(let{geometry:l,turn:h}of t){r.set(Qu(l.attributes.position.array,h),a),s.set(Qu(l.attributes.normal.array,h),a);for(let f of l.index.array)o[c++]=a/3+f;a+=l.attributes.position.array.length}return hf({points:r,normals:s,index:o})}};var Pb=new Ie,df=(n,e)=>e<0?Pb:n[e],pf=class{constructor(e,t,i,r){this.skin=e,this.geometry=t,this.source=i,this.poses=r,this.points=t.attributes.position.array.slice(),this.normals=t.attributes.normal.array.slice();let s=df(r.rest,e.bodies[0]);this.toBody=e.bodies.map(o=>df(r.rest,o).clone().invert().multiply(s)),this.moved=e.bodies.map(()=>new Ie),this.drawn=e.bodies.map(()=>new Ie)}update(e,t){let{skin:i,poses:r,moved:s,drawn:o}=this,a=df(r.world,i.bodies[0]).clone().invert(),c=0;if(s.forEach((x,M)=>{x.multiplyMatrices(a,df(r.world,i.bodies[M])).multiply(this.toBody[M]);for(let d=0;d<16;d++)c=Math.max(c,Math.abs(x.elements[d]-o[M].elements[d])*(d<12?t:1))}),c<=e)return;s.forEach((x,M)=>o[M].copy(x));let{position:l,normal:h}=this.geometry.attributes,{first:f,second:u,weight:m}=i;for(let x=0;x<this.source.length;x++){let M=this.source[x],d=u.data[M],p=m.data[M],v=o[f?f.data[M]:0].elements,A=o[d].elements,y=this.points[3*x],R=this.points[3*x+1],T=this.points[3*x+2],g=this.normals[3*x],w=this.normals[3*x+1],O=this.normals[3*x+2];for(let L=0;L<3;L++){let D=v[L]+p*(A[L]-v[L]),G=v[4+L]+p*(A[4+L]-v[4+L]),k=v[8+L]+p*(A[8+L]-v[8+L]);l.array[3*x+L]=D*y+G*R+k*T+v[12+L]+p*(A[12+L]-v[12+L]),h.array[3*x+L]=D*g+G*w+k*O}}l.needsUpdate=h.needsUpdate=!0,this.geometry.computeBoundingSphere()}};var mf=class{constructor(e,t,i,r){this.name=e.name,this.geometry=t,this.poses=r;let{shapes:s,node:o,coordinates:a}=e.sway;this.shapes=s.data,this.count=s.shape[0],this.nodes=s.shape[1],this.node=Uint32Array.from(i,c=>o.data[c]),this.points=t.attributes.position.array.slice(),this.coordinates=a,this.mean=a&&Hs(a),this.drawn=new Float64Array(this.count),this.moved=new Float64Array(3*this.nodes)}#e(){let{mode:e,magnification:t,where:i}=this.poses;return this.drawn.map((r,s)=>{if(e){let a=e.shape.sway?.[this.name];return a?e.cosine*a.data[2*s]+e.sine*a.data[2*s+1]:0}if(!this.coordinates)return 0;let o=ki(this.coordinates,i,s);return t===1?o:this.mean[s]+t*(o-this.mean[s])})}largest(e){let t=e.sway?.[this.name],i=0;for(let r=0;t&&r<this.nodes;r++){let s=0;for(let o=0;o<6;o++){let a=0;for(let c=0;c<this.count;c++)a+=t.data[2*c+o%2]*this.shapes[3*(this.nodes*c+r)+(o>>1)];s+=a*a}i=Math.max(i,Math.sqrt(s))}return i}update(){let e=this.#e();if(e.every((i,r)=>i===this.drawn[r]))return;this.drawn=e,this.moved.fill(0);for(let i=0;i<this.count;i++){let r=3*this.nodes*i;for(let s=0;s<this.moved.length;s++)this.moved[s]+=e[i]*this.shapes[r+s]}let{position:t}=this.geometry.attributes;for(let i=0;i<this.node.length;i++)for(let r=0;r<3;r++)t.array[3*i+r]=this.points[3*i+r]+this.moved[3*this.node[i]+r];t.needsUpdate=!0,this.geometry.computeBoundingSphere()}};var P_=300;function Lb(n){n.onBeforeCompile=e=>{e.fragmentShader=e.fragmentShader.replace("#include <opaque_fragment>",`#ifdef DOUBLE_SIDED
        if (!gl_FrontFacing) {
          float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0);
          outgoingLight = diffuseColor.rgb * (stripe < 1.1 ? 0.66 : 0.86);
        }
      #endif
      #include <opaque_fragment>`)}}function L_(n,e){let t=new xs({color:n});return e&&Object.assign(t,{transparent:!0,opacity:.22,depthWrite:!1}),Lb(t),t}var gf=class{constructor(e,t,i){this.solids=e.solids,this.root=t,this.poses=i,this.known=new Map;let r={};this.parts=e.solids.map(s=>{let o=r[s.kind]=(r[s.kind]??-1)+1,a={solid:s,colour:tp(s.kind,o,s.schematic)};if(s.pieces)a.repeated=new uf(a,l=>this.#e(a,l,"repeated")),a.geometry=a.repeated.whole("coarse");else{let l=cf(s.points.data,s.triangles.data,s.creases??40);a.geometry=hf(l),a.skin=s.skin?new pf(s.skin,a.geometry,l.source,i):null,a.sway=s.sway?new mf(s,a.geometry,l.source,i):null}let c=a.geometry.attributes.position.array;return Object.assign(a,{radius:Nb(c),rim:Db(c)})}),this.triangles=this.parts.reduce((s,o)=>s+(o.repeated?.finest??o.geometry.index.count/3),0),this.meshes=[],this.crowds=[],this.parts.length>P_?this.#i():this.#t(),this.update(0)}#e({colour:e,solid:t},i="",r=""){let s=[e,!!t.see_through,!!i,r].join();if(!this.known.has(s)){let o=i?new Xe(e).lerp(new Xe(ep),.55):e;this.known.set(s,L_(o,t.see_through))}return this.known.get(s)}get materials(){return[...this.known.values()]}#t(){for(let e of this.parts){let t=e.repeated??new Ot(e.geometry,this.#e(e));t.matrixAutoUpdate=!1,t.renderOrder=e.solid.see_through?1:0,t.userData.part=e,e.mesh=t,this.meshes.push(...e.repeated?.meshes??[t]),this.root.add(t)}}#i(){for(let e of[!1,!0]){let t=this.parts.filter(s=>!!s.solid.see_through===e);if(!t.length)continue;let i=L_("#ffffff",e),r=new lf(t,i);t.forEach((s,o)=>Object.assign(s,{crowd:r,member:o,skin:null,sway:null,repeated:null})),r.renderOrder=e?1:0,this.known.set(`crowd ${e}`,i),this.crowds.push(r),this.root.add(r)}}update(e){for(let t of this.parts){let i=this.poses.ofSolid(t.solid);t.crowd?t.crowd.place(t.member,i):t.mesh.matrix.copy(i),t.skin?.update(e,t.radius),t.sway?.update()}}choose(e,t,i){for(let{repeated:r}of this.parts)r?.choose(e,t,i)}exported(e){return this.parts.map(t=>{let i=t.repeated?t.repeated.whole("fine"):t.geometry,{solid:r}=t;if(!e||!(r.place||r.axes||r.between))return{...t,geometry:i};let s=this.poses.ofSolid(r).clone(),o=r.between?r.between.bodies[0]:r.body;return o>=0&&s.premultiply(this.poses.world[o].clone().invert()),{...t,solid:{...r,body:o},geometry:i.clone().applyMatrix4(s)}})}get drawn(){return this.parts.reduce((e,{repeated:t,mesh:i,geometry:r})=>e+(t?.drawn??(i?.visible===!1?0:r.index.count/3)),0)}cut(e){for(let t of this.materials)t.clippingPlanes=e.length?e:null,t.side=e.length?ji:nn,t.needsUpdate=!0}cover(e){let t=new Set;for(let i of this.parts){if(!i.solid.see_through)continue;i.hidden=e==="hidden",i.crowd?i.crowd.visible=!i.hidden:this.#n(i);let r=i.crowd?.material??i.mesh.material;t.has(r)||(t.add(r),Object.assign(r,e==="solid"?{transparent:!1,opacity:1,depthWrite:!0}:{transparent:!0,opacity:.22,depthWrite:!1}),r.needsUpdate=!0)}}schematics(e){this.plain=!e;for(let t of this.parts)t.solid.schematic&&t.mesh&&this.#n(t)}#n(e){e.mesh.visible=!e.hidden&&!(this.plain&&e.solid.schematic)}hit(e){let i=e.intersectObjects([...this.meshes,...this.crowds].filter(r=>r.visible),!1).map(({object:r,member:s,point:o})=>({part:r.userData.part??r.parts[s],fault:r.userData.fault??"",point:o}));return i.find(({part:r,point:s})=>!r.solid.see_through&&this.#r(s))??i.find(({point:r})=>this.#r(r))??null}#r(e){return!this.materials[0]?.clippingPlanes?.some(t=>t.distanceToPoint(e)<0)}bounds(){let e=this.parts.filter(({solid:o})=>!o.see_through||o.schematic),t=new U(1/0,1/0,1/0),i=t.clone().negate(),r=new U,s=[];for(let o of e.length?e:this.parts){let a=this.poses.ofSolid(o.solid),{center:c,radius:l}=o.geometry.boundingSphere;o.geometry.computeBoundingBox();let{min:h,max:f}=o.geometry.boundingBox;if(!(l>=0))continue;let u=o.geometry.attributes.position,m=Math.max(1,Math.ceil(u.count/(this.parts.length>P_?4:80)));for(let x=0;x<u.count;x+=m)s.push(new U().fromBufferAttribute(u,x).applyMatrix4(a));for(let x=0;x<8;x++)r.set(x&1?f.x:h.x,x&2?f.y:h.y,x&4?f.z:h.z),r.sub(c).clampLength(0,l).add(c).applyMatrix4(a),t.min(r),i.max(r)}return i.x>=t.x?{centre:t.clone().add(i).multiplyScalar(.5),radius:Math.max(t.distanceTo(i)/2,1e-9),low:t,high:i,outline:s}:{centre:r.set(0,0,0),radius:1,low:r.clone().set(-1,-1,-1),high:r.clone().set(1,1,1),outline:s}}reachOf(e){return Math.max(0,...this.parts.filter(t=>t.solid.body===e).map(t=>t.radius))}};function Db(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1]));return e}function Nb(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}var Ib=/swiftshader|llvmpipe|softpipe|software|basic render/i;function D_(){try{let n=document.createElement("canvas").getContext("webgl2");if(!n)return null;let e=n.getExtension("WEBGL_debug_renderer_info"),t=String(n.getParameter(e?e.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),{software:Ib.test(t)}}catch{return null}}var ju=class{constructor(e,t){this.data=e,this.scene=new fo,this.over=new fo,this.root=new Sn,this.overRoot=new Sn,this.root.matrixAutoUpdate=this.overRoot.matrixAutoUpdate=!1,this.scene.add(this.root),this.over.add(this.overRoot),this.lights=[this.scene,this.over].map(i=>{let r=new Za("#ffffff",2.1),s=new Ka("#ffffff","#8f98a3",1.25);return i.add(r,r.target,s),{light:r,sky:s}}),this.poses=new No(e),this.solids=new gf(e,this.root,this.poses),this.bounds=this.solids.bounds(),this.arrows=new of(e,this.overRoot,this.poses,t,this.bounds.radius)}},xf=class{constructor(e,t,i){this.host=e,this.software=i,this.renderer=new tl({antialias:!i,powerPreference:"high-performance"}),this.renderer.autoClear=!1,this.renderer.localClippingEnabled=!0,this.canvas=this.renderer.domElement,this.canvas.className="ppv-canvas",e.append(this.canvas),this.camera=new Ii(28,1,.01,100),this.pictures=t.map(o=>new ju(o,e));let r=Math.max(...this.pictures.map(o=>o.arrows.size)),s=Math.max(...this.pictures.map(o=>o.bounds.radius));for(let{arrows:o}of this.pictures)Object.assign(o,{size:r,radius:s});this.background=new Xe("#ffffff"),this.size={width:1,height:1},this.drawn=0,this.coarse=!1,this.seen=new Ie}coarsen(e){return e===this.coarse?!1:(this.coarse=e,this.resize(),!0)}get ratio(){return this.coarse?.6:this.software?1:Math.min(window.devicePixelRatio||1,2)}resize(){let{clientWidth:e,clientHeight:t}=this.host;!e||!t||(this.size={width:e,height:t},this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(e,t),this.camera.aspect=e/this.pictures.length/t,this.camera.updateProjectionMatrix())}bounds(){let e=Math.max(...this.pictures.map(t=>t.bounds.radius));return{centre:this.pictures[0].bounds.centre.clone().applyMatrix4(this.seen),radius:e,low:this.pictures[0].bounds.low,high:this.pictures[0].bounds.high}}render(e){let{renderer:t,camera:i}=this,{centre:r,radius:s}=this.bounds(),{distance:o,target:a}=e.now,c=a.distanceTo(r);i.near=Math.max(.01*o,o-c-1.3*s),i.far=o+c+2.5*s,i.updateProjectionMatrix(),this.setLights(),t.setScissorTest(!0);let l=this.size.width/this.pictures.length;i.updateMatrixWorld();let h=(this.software?2.5:1)*2*Math.tan(i.fov*Math.PI/360)/this.size.height;this.pictures.forEach((f,u)=>{t.setViewport(u*l,0,l,this.size.height),t.setScissor(u*l,0,l,this.size.height),t.setClearColor(this.background,1),t.clear(),f.root.matrix.copy(this.seen),f.overRoot.matrix.copy(this.seen),f.solids.choose(this.seen,i,h),t.render(f.scene,i),!(f.arrows.hidden||!f.arrows.shown.size)&&(t.clearDepth(),t.render(f.over,i))}),this.drawn++}setLights(){let e=new U(-.45,.7,.9).applyQuaternion(this.camera.quaternion),t=new U(0,1,0).applyQuaternion(this.camera.quaternion);for(let i of this.pictures)for(let r of i.lights)r.light.position.copy(e),r.sky.position.copy(t)}hit(e,t){let i=this.canvas.getBoundingClientRect(),r=i.width/this.pictures.length,s=Math.floor((e-i.left)/r),o=this.pictures[s];if(!o)return null;let a=new Ze((e-i.left-s*r)/r*2-1,1-(t-i.top)/i.height*2),c=new $a;c.setFromCamera(a,this.camera);let l=o.solids.hit(c);return l&&{...l,picture:s}}onScreen(e,t=0){let i=e.clone().applyMatrix4(this.seen).project(this.camera),r=this.size.width/this.pictures.length;return{x:(t+(i.x+1)/2)*r,y:(1-i.y)/2*this.size.height,front:i.z<1}}};var eh=1e6,_f=class{constructor(e,t,i){this.player=e,this.marks=[...t].sort((r,s)=>r.time-s.time),this.kinds=[...new Set(this.marks.map(r=>r.kind))],this.does=i,this.stepLength=1/0;for(let r=1;r<e.times.length;r++)this.stepLength=Math.min(this.stepLength,e.times[r]-e.times[r-1]||1/0);Number.isFinite(this.stepLength)||(this.stepLength=1),this.play=Ht("","Play (space)",i.toggle,{className:"ppv-play"}),this.range=ae("input",{type:"range",min:"0",max:String(eh),step:"1",className:"ppv-range",title:"Time","aria-label":"Time"}),this.range.addEventListener("input",()=>i.seek(this.#e(Number(this.range.value)/eh))),this.strip=ae("canvas",{className:"ppv-marks",role:"img","aria-label":`${this.marks.length} marks`}),this.tip=ae("div",{className:"ppv-tip",hidden:!0}),this.strip.addEventListener("pointermove",r=>this.#n(r)),this.strip.addEventListener("pointerleave",()=>this.tip.hidden=!0),this.strip.addEventListener("click",r=>{let s=this.#i(r);i.seek(s?s.time:this.#e(this.#t(r)))}),this.read=ae("output",{className:"ppv-now",title:"Time of the record"}),this.speed=Qr({label:"",title:"Speed, part of real time (+ and \u2212)",least:Jo,most:1,value:e.speed,show:ap,changed:i.speed}),this.loop=ur("repeat",[["record","whole record"],["turn","one turn"],["cycle","one mesh cycle"]],r=>{let s=i.loop(r);this.loop.select.value=e.loop,this.say(s)}),this.said=ae("span",{className:"ppv-said",role:"status"}),this.jump=this.marks.length?[Ht("\u27E8","Mark before ([)",()=>this.toMark(-1)),Ht("\u27E9","Next mark (])",()=>this.toMark(1))]:[],this.element=ae("div",{className:"ppv-time"},ae("div",{className:"ppv-track"},this.strip,this.range,this.tip),ae("div",{className:"ppv-transport"},this.play,Ht("|\u25C2","To the start (Home)",()=>i.seek(e.window[0])),Ht("\u25C2","One frame back (left arrow)",()=>i.step(-1)),Ht("\u25B8","One frame on (right arrow)",()=>i.step(1)),...this.jump,this.read,this.speed.row,this.loop.row,this.said)),e.times.length<2&&this.element.classList.add("ppv-still")}#e(e){return this.player.first+e*(this.player.last-this.player.first)}#t(e){let t=this.strip.getBoundingClientRect();return Math.max(0,Math.min(1,(e.clientX-t.left)/t.width))}#i(e){let t=this.strip.getBoundingClientRect(),i=this.#e(this.#t(e)),r=6*(this.player.last-this.player.first)/Math.max(t.width,1),s=null;for(let o of this.marks)Math.abs(o.time-i)<=r&&(!s||Math.abs(o.time-i)<Math.abs(s.time-i))&&(s=o);return s}#n(e){let t=this.#i(e);if(this.tip.hidden=!t,this.strip.style.cursor="pointer",!t)return;this.tip.textContent=`${t.kind.replaceAll("_"," ")}${t.what?`, ${t.what}`:""}, ${$o(t.time,this.stepLength/10)}`;let i=this.strip.getBoundingClientRect(),r=e.clientX-i.left;this.tip.style.left=`${Math.max(0,Math.min(i.width-180,r))}px`}say(e){this.said.textContent=e}toMark(e){let t=this.player.time,i=1e-9*(this.player.last-this.player.first),r=e>0?this.marks.find(s=>s.time>t+i):this.marks.findLast(s=>s.time<t-i);r&&this.does.seek(r.time)}draw(){let{strip:e,player:t}=this,i=e.clientWidth,r=e.clientHeight;if(!i)return;let s=window.devicePixelRatio||1;e.width=i*s,e.height=r*s;let o=e.getContext("2d");o.scale(s,s);let a=t.last-t.first||1,c=h=>(h-t.first)/a*i,l=getComputedStyle(this.element);t.loop!=="record"&&(o.fillStyle=l.getPropertyValue("--v-accent"),o.globalAlpha=.35,o.fillRect(c(t.window[0]),r-4,Math.max(2,c(t.window[1])-c(t.window[0])),4),o.globalAlpha=1);for(let h of this.marks)o.fillStyle=Al(this.kinds,h.kind),o.fillRect(c(h.time)-.75,1,1.5,r-5)}update(){let{player:e}=this,t=e.last-e.first,i=t>0?(e.time-e.first)/t:0;this.range.value=String(Math.round(i*eh));let r=$o(e.time,e.playing?this.stepLength:this.stepLength/10);this.range.ariaValueText=r,this.read.textContent=r,this.read.title=`Time of the record; it lasts ${op(t)}`;let s=e.playing?"pause":"play";this.play.dataset.state!==s&&(this.play.dataset.state=s,this.play.textContent=e.playing?"\u275A\u275A":"\u25B6\uFE0E",this.play.title=e.playing?"Pause (space)":"Play (space)",this.play.setAttribute("aria-label",this.play.title))}};var vf=class{constructor(e,t){this.stage=e,this.orbit=t,this.body=-1,this.turning=!1,this.anchor=new Ie}get poses(){return this.stage.pictures[0].poses}directions(){let e=this.poses.axis().transformDirection(this.stage.seen),t=this.orbit.up,i=new U().crossVectors(t,e);i.length()<.001&&i.crossVectors(new U(1,0,0),e),i.length()<.001&&i.crossVectors(new U(0,0,1),e),i.normalize();let r=new U().crossVectors(e,i);return{axis:e,front:i,top:r,iso:e.clone().addScaledVector(i,.75).addScaledVector(r,.55)}}distanceFor(e){let{camera:t}=this.stage,i=Math.atan(Math.tan(t.fov*Math.PI/360)*Math.min(1,t.aspect));return e/Math.sin(i)}fit(e=!1){let{centre:t,radius:i}=this.stage.bounds(),{camera:r,seen:s,pictures:o}=this.stage,a=this.orbit.direction(this.orbit.goal),c=new U().crossVectors(this.orbit.up,a).normalize(),l=new U().crossVectors(a,c),h=.9*Math.tan(r.fov*Math.PI/360),f=h*r.aspect,u=t.clone(),m=this.distanceFor(i),x=o.flatMap(M=>[...M.bounds.outline,...M.arrows.ends()].map(d=>d.clone().applyMatrix4(s)));for(let M=0;x.length&&M<3;M++){let d=[1/0,-1/0,1/0,-1/0],p=0;for(let v of x){let A=v.clone().sub(u),[y,R,T]=[A.dot(c),A.dot(l),A.dot(a)],g=Math.max(m-T,.001*i);d[0]=Math.min(d[0],y/g),d[1]=Math.max(d[1],y/g),d[2]=Math.min(d[2],R/g),d[3]=Math.max(d[3],R/g),p=Math.max(p,T+Math.abs(y)/f,T+Math.abs(R)/h)}if(M===2){m=p;break}u.addScaledVector(c,m*(d[0]+d[1])/2),u.addScaledVector(l,m*(d[2]+d[3])/2)}this.orbit.look({target:u,distance:Math.max(m,.1*i)},e),this.orbit.chosen=!1}named(e,t=!1){this.orbit.look({direction:this.directions()[e]},t),this.fit(t)}follow(e,t=this.turning){if(this.body=e,this.turning=t,e<0){let i=this.orbit.goal.target.clone().applyMatrix4(this.stage.seen.clone().invert());this.stage.seen.identity(),this.anchor.identity(),this.orbit.look({target:i},!0);return}this.anchor.multiplyMatrices(this.stage.seen,this.#e()),this.orbit.changed()}#e(){let e=this.poses.world[this.body];return this.turning?e.clone():new Ie().setPosition(new U().setFromMatrixPosition(e))}update(){this.body>=0&&this.stage.seen.multiplyMatrices(this.anchor,this.#e().invert())}look(e,t,i){let r=i/(2*Math.tan(this.stage.camera.fov*Math.PI/360));this.orbit.look({target:new U(...e),direction:t&&new U(...t),distance:r},!0)}closeUp(){if(this.body<0)return;let{solids:e}=this.stage.pictures[0],t=new U().setFromMatrixPosition(this.poses.world[this.body]).applyMatrix4(this.stage.seen),i=e.reachOf(this.body);this.orbit.look({target:t,distance:i>0?this.distanceFor(1.15*i):void 0})}#t(e){let t=null;for(let i of this.stage.pictures[0].solids.parts){if(!i.solid.teeth)continue;let r=this.poses.ofSolid(i.solid),s=new U().setFromMatrixColumn(r,2),o=e.clone().sub(new U().setFromMatrixPosition(r)),a=o.addScaledVector(s,-o.dot(s)).length(),c=Math.abs(i.rim-a)/i.rim;(!t||c<t.off)&&(t={off:c,axis:s,pitch:2*Math.PI*a/i.solid.teeth})}return t}intoMesh(e){let{poses:t,arrows:i}=this.stage.pictures[0],r=i.forces()[this.stage.pictures[0].data.arrows.indexOf(e)],s=this.#t(r.at),o=s?s.axis:t.axis(),a=s?s.pitch:.1*this.stage.bounds().radius;return this.orbit.look({target:r.at.clone().applyMatrix4(this.stage.seen),direction:o.clone().transformDirection(this.stage.seen),distance:1.6*a/(2*Math.tan(this.stage.camera.fov*Math.PI/360))}),{point:r.at,axis:o}}};var Ub="This browser or machine offers no WebGL 2, so the solids cannot be drawn; curves and time work.",Mf=class{constructor(e,t){this.root=e,this.scenes=t,this.last=0,this.waiting=0,this.stage=null;let i=Ob(t);this.poses=new No(t[0]),this.player=new Dl(i,this.poses);let r=Fb(t),s=[this.player.first,this.player.last];this.curves=new Pl(t,s,r,l=>this.seek(l)),this.transport=new _f(this.player,r,{seek:l=>this.seek(l),toggle:()=>this.toggle(),step:l=>this.step(l),speed:l=>this.player.speed=l,loop:l=>this.loop(l)}),this.panels=new ef,this.host=ae("div",{className:"ppv-view"}),this.area=ae("div",{className:"ppv-scene"},this.host,this.panels.panel);let o=[...new Set(t.map(l=>l.title))].join(" and "),a=t.length>1?"":t[0].subtitle,c=ae("div",{className:"ppv-head"},ae("div",{className:"ppv-title",title:`${o} ${a}`},ae("b",{},o),ae("span",{},a)),this.panels.bar);e.replaceChildren(c,this.area,this.transport.element,this.curves.element),this.#t(),this.#i(),hp(this),this.watch=new ResizeObserver(()=>this.resize()),this.watch.observe(e),this.watch.observe(this.curves.body),window.addEventListener("beforeprint",()=>this.draw()),this.dark=window.matchMedia("(prefers-color-scheme: dark)"),this.dark.addEventListener("change",()=>this.colours()),this.resize(),this.curves.build(),this.colours()}#e(e){this.area.append(ae("div",{className:"ppv-message",role:"alert"},ae("p",{},e)))}#t(){if(!this.scenes.some(o=>o.solids.length)){this.#e("This scene holds no solids: the model gives no shapes, or the result none that moves.");return}let e=D_();if(!e){this.#e(Ub);return}this.stage=new xf(this.host,this.scenes,e.software);let{stage:t}=this;t.canvas.tabIndex=0,t.canvas.setAttribute("aria-label","3-D scene: drag to turn, right button to shift, wheel to zoom"),t.canvas.addEventListener("webglcontextlost",()=>this.#e("The graphics card gave the scene up. Load the page again.")),this.orbit=new $c(t.camera,t.canvas,()=>this.changed(),this.scenes[0].up),this.orbit.takesWheel=o=>{let a=this.fills||o.ctrlKey||document.activeElement===t.canvas;return a||this.#o("click the scene first, then the wheel zooms"),a},this.orbit.pictures=t.pictures.length;let{radius:i}=t.bounds();this.orbit.nearest=2e-5*i,this.orbit.farthest=40*i,this.views=new vf(t,this.orbit),this.hover=new Ll(t,this.orbit,o=>this.follow(o)),this.legends=this.scenes.map(o=>new Nl(o.arrows)),this.scale=ae("div",{className:"ppv-scale","aria-hidden":"true"},ae("span"),ae("i")),this.status=ae("div",{className:"ppv-status",role:"status"});let r=N_(this.scenes),s=this.legends.map((o,a)=>ae("div",{className:"ppv-half"},o.element,r[a]&&ae("span",{className:"ppv-name"},r[a])));this.host.append(ae("div",{className:"ppv-halves"},...s),this.hover.label,this.scale,this.status)}#i(){let{panels:e,stage:t}=this;if(t){e.action("Fit","Show all of it (f)",()=>this.views.fit()),e.add("View","Views, following a body, housing, meshes",M_(this)),this.scenes.some(o=>o.arrows.length)&&e.add("Forces","Arrows of forces",S_(this)),this.player.times.length>1&&e.add("Vibration","Magnify vibrations",b_(this)),this.section=new sf(t,()=>this.changed()),e.add("Section","Cut the solids by a plane",this.section.rows);let{modes:s}=this.scenes[0];s.length&&!this.scenes[1]&&(this.modes=new Il(s,t,()=>this.changed()),e.add("Modes","Mode shapes",this.modes.rows)),e.add("Save","Picture, solids, film",y_(this))}let i=[...new Set(this.scenes.flatMap(s=>s.notes))],r=[ae("dl",{},...up.flatMap(([s,o])=>[ae("dt",{},s),ae("dd",{},o)]))];i.length&&r.unshift(ae("ul",{className:"ppv-notes"},...i.map(s=>ae("li",{},s)))),e.add(i.length?`Notes (${i.length})`:"?","Notes and keys",r)}colours(){this.stage?.background.set(getComputedStyle(this.area).backgroundColor),this.curves.build(),this.transport.draw(),this.changed()}resize(){if(!(!this.root.clientWidth||!this.root.clientHeight)){if(this.stage){let e=this.stage.size.width===1;this.stage.resize(),e&&this.views.named("iso",!0),this.orbit.chosen||this.views.fit(!0),this.draw()}this.curves.resize(),this.transport.draw(),this.update()}}changed(){this.waiting||(this.waiting=requestAnimationFrame(e=>this.#n(e)))}#n(e){this.waiting=0;let t=this.player.playing||this.easing||this.modes?.active,i=t&&this.last?Math.min(.25,Math.max(0,(e-this.last)/1e3)):1/60;this.last=e,this.player.advance(i),this.modes?.advance(i),this.easing=this.orbit?.step(i)??!1,this.#r(i,t),this.update(),this.draw(),this.frames=(this.frames??0)+1,this.player.playing||this.easing||this.modes?.active?this.changed():this.last=0}#r(e,t){let i=this.player.playing||this.easing||this.modes?.active;t&&i&&(this.pace=.7*(this.pace??e)+.3*e),!this.filming&&this.stage?.coarsen(!!i&&this.pace>(this.stage.coarse?.03:.085))}update(){this.transport.update(),this.curves.plots.cursor(this.player.time)}draw(){let{stage:e,orbit:t}=this;if(!(!e||e.size.width===1)){for(let i of e.pictures)this.modes?.active?this.modes.pose(i):i.poses.at(this.player.time);this.modes?.active||this.views.update(),this.section?.update();for(let i of e.pictures)i.solids.update(.25*t.pixel),i.arrows.hidden=!!this.modes?.active,i.arrows.update(t.pixel);e.render(t),e.pictures.forEach(({arrows:i},r)=>this.legends[r].update(i.now,i.shown,i.hidden)),this.#s()}}#s(){let e=Qo(90*this.orbit.pixel),[t,i]=this.scale.children;t.textContent=sp(e),i.style.width=`${e/this.orbit.pixel}px`;let r=this.views.body,s=r>=0?`following ${this.scenes[0].bodies[r].name}`:"",o=this.stage.pictures[0].poses.magnification>1?`vibrations \xD7 ${this.magnification.row.lastChild.textContent}`:"";this.status.textContent=[s,o,this.modes?.words].filter(Boolean).join(" \xB7 ")}get fills(){return this.root.clientHeight>.8*window.innerHeight}#o(e){this.status.textContent=e,clearTimeout(this.hinted),this.hinted=setTimeout(()=>this.changed(),2500)}advance(e){this.player.advance(e),this.modes?.advance(e),this.update(),this.draw()}seek(e){this.player.seek(e),this.update(),this.changed()}toggle(e=!this.player.playing){this.player.playing=e&&this.player.last>this.player.first,this.transport.update(),this.changed()}step(e){this.player.step(e),this.update(),this.changed()}loop(e){let t=this.player.repeat(e,this.views?.body??-1,this.scenes[0].solids);return this.transport.loop.select.value=this.player.loop,this.transport.draw(),this.changed(),t}follow(e){e>=this.scenes[0].bodies.length||!this.stage||(this.views.follow(e),e>=0&&this.views.closeUp(),this.followed.select.value=String(e),this.changed())}magnify(e){for(let t of this.stage.pictures)t.poses.magnification=e;this.changed()}intoMesh(e){let{point:t,axis:i}=this.views.intoMesh(e);this.section.through(t,i)}};function N_(n){if(n.length<2)return[""];let[e,t]=n;return e.title!==t.title?[e.title,t.title]:e.subtitle===t.subtitle?["first","second"]:[e.subtitle,t.subtitle]}function Fb(n){let e=N_(n);return n.flatMap((t,i)=>t.marks.map(r=>({...r,what:[r.what,e[i]].filter(Boolean).join(", ")})))}function Ob(n){let e=n.map(t=>t.times?.data??[]);return e.length===1?e[0]:Float64Array.from(new Set(e.flatMap(t=>[...t]))).sort()}var I_="pitchpoint-scene-1",Bb={f8:Float64Array,f4:Float32Array,i4:Int32Array,u4:Uint32Array,i2:Int16Array,u2:Uint16Array,u1:Uint8Array},ln=class extends Error{};function Gb(n){let e;try{e=atob(n.trim())}catch{throw new ln("The numbers of this scene cannot be read: they are not base64. The file may be damaged.")}let t=new Uint8Array(e.length);for(let i=0;i<t.length;i++)t[i]=e.charCodeAt(i);return t}async function zb(n){if(typeof DecompressionStream>"u")throw new ln("This browser cannot unpack the numbers of the scene (no DecompressionStream); a newer one can.");try{let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip"));return await new Response(e).arrayBuffer()}catch{throw new ln("The numbers of this scene cannot be unpacked: the file is truncated or damaged.")}}function kb(n,e,t){let i=Bb[e?.type],r=e?.shape;if(!i||!Array.isArray(r)||!r.length||r.some(M=>!Number.isInteger(M)||M<0))throw new ln(`This scene cannot be read: ${t} has no type or shape that this viewer knows.`);let s=r.reduce((M,d)=>M*d,1),o=e.at;if(!Number.isInteger(o)||o<0||o%8||o+s*i.BYTES_PER_ELEMENT>n.byteLength)throw new ln(`This scene is truncated: ${t} lies beyond the end of the numbers.`);let a=new i(n,o,s),c=r[r.length-1],l=r.length>1?s/Math.max(r[0],1):1,h=r[0];if(!e.scale&&!e.offset)return{data:a,shape:r,width:l,count:h};let f=r.length>1?c:1,u=e.scale??Array(f).fill(1),m=e.offset??Array(f).fill(0),x=new Float64Array(s);for(let M=0;M<s;M++)x[M]=m[M%f]+u[M%f]*a[M];return{data:x,shape:r,width:l,count:h}}function th(n,e,t,i=new Map){if(Array.isArray(n))return n.map((s,o)=>th(s,e,s?.name?`${t} ${s.name}`:`${t} ${o+1}`,i));if(n===null||typeof n!="object")return n;if("at"in n&&"type"in n&&"shape"in n){let s=JSON.stringify(n);return i.has(s)||i.set(s,kb(e,n,t)),i.get(s)}let r={};for(let[s,o]of Object.entries(n))r[s]=th(o,e,`${s} of ${t}`,i);return r}function En(n,e){if(!n)throw new ln(`This scene cannot be read: ${e}.`)}function Hb(n){let e=n.times?.count??0,t=(i,r)=>En(!i||i.count===e||i.count===1,`${r} has ${i?.count} rows for ${e} times`);n.bodies.forEach((i,r)=>{En(Number.isInteger(i.parent??-1)&&(i.parent??-1)<r,`body ${i.name} comes before its parent`);for(let s of["position","travel","turn","spin","gross","quaternion"])t(i[s],`${s} of body ${i.name}`)});for(let i of n.solids){En(i.body>=-1&&i.body<n.bodies.length,`solid ${i.name} belongs to no body`);let r=i.pieces?i.pieces.flatMap(s=>s.levels??[]):[i];En(r.length,`solid ${i.name} has no surface`);for(let{points:s,triangles:o}of r){En(s?.width===3&&o?.width===3,`solid ${i.name} has no surface`);for(let a of o.data)En(a<s.count,`solid ${i.name} has a triangle without a point`)}for(let s of i.pieces??[])En(s.turns?.count,`solid ${i.name} stands nowhere`);if(i.sway){let{shapes:s,node:o,coordinates:a}=i.sway;En(s?.shape.length===3&&o?.count===i.points?.count,`solid ${i.name} does not say how it bends`);for(let c of o.data)En(c<s.shape[1],`solid ${i.name} has a point without a node`);t(a,`the modal coordinates of ${i.name}`)}for(let s of i.between?.bodies??[])En(s>=-1&&s<n.bodies.length,`solid ${i.name} ends on a body that is not there`);for(let s of i.skin?.bodies??[])En(s>=-1&&s<n.bodies.length,`the skin of ${i.name} names a body that is not there`)}for(let i of n.arrows){En(i.body>=-1&&i.body<n.bodies.length,`arrow ${i.name} belongs to no body`);for(let r of["circumferential","radial","axial"])t(i.components?.[r],`the ${r} force ${i.name}`);t(i.at,`the place of arrow ${i.name}`),t(i.state,`the state of arrow ${i.name}`)}for(let i of n.channels){let r=i.least?.count;En(i.times&&r&&i.times.count===r&&(i.most?.count??r)===r,`channel ${i.name} has times and values of different length`)}}async function ih(n=""){let e=document.getElementById(`pp-scene${n}`),t=document.getElementById(`pp-scene-numbers${n}`);if(!e||!t)throw new ln("This page holds no scene.");let i;try{i=JSON.parse(e.textContent??"")}catch{throw new ln("The header of this scene cannot be read: the file is truncated or damaged.")}if(i?.format!==I_)throw new ln(`This scene is of the format "${i?.format}"; this viewer reads "${I_}".`);let r=await zb(Gb(t.textContent??"")),o={title:"",subtitle:"",up:[0,1,0],...{bodies:[],solids:[],arrows:[],channels:[],spectra:[],marks:[],modes:[],notes:[]},...th(i,r,"this scene")};return Hb(o),o}function U_(n){let{player:e,stage:t,curves:i}=n,r=s=>[s.x,s.y,s.z];return{time:e.time,playing:e.playing,frame:e.frame,speed:e.speed,loop:e.loop,window:[...e.window],channels:[...i.plots.names],cursor:i.plots.drawn.map(({plot:s,line:o})=>({at:o.hidden?null:s.posToVal(new DOMMatrix(getComputedStyle(o).transform).m41,"x"),readings:[...o.closest(".ppv-plot").querySelectorAll("output")].map(a=>a.textContent)})),marks:n.transport.marks.length,message:n.area.querySelector(".ppv-message")?.textContent??null,drawn:t?.drawn??0,section:n.section?{on:n.section.on,normal:r(n.section.normal),at:n.section.at}:null,mode:n.modes?.number??-1,following:n.views?.body??-1,camera:n.orbit?{position:r(t.camera.position),target:r(n.orbit.now.target),distance:n.orbit.now.distance,near:t.camera.near,far:t.camera.far}:null,pictures:(t?.pictures??[]).map(s=>({bodies:s.poses.world.map(o=>[...o.elements]),seen:[...t.seen.elements],magnification:s.poses.magnification,triangles:s.solids.triangles,drawnTriangles:s.solids.drawn,crowds:s.solids.crowds.length,arrows:(s.arrows.now??[]).map((o,a)=>({name:o.name,kind:o.kind,state:o.state,at:r(o.at),vectors:Object.fromEntries(Object.entries(o.vectors).map(([c,l])=>[c,r(l)])),lengths:Object.fromEntries(Object.entries(s.arrows.drawn[a].parts).map(([c,l])=>[c,l.visible?new U().setFromMatrixColumn(l.matrix,2).length():0]))}))}))}}var ol=null;async function Vb(n,{compare:e=!1}={}){document.getElementById("ppv-style")||document.head.append(ae("style",{id:"ppv-style"},yh+bh));let t=ae("div",{className:"ppv"}),i=ae("p",{},"Reading the scene \u2026");t.append(ae("div",{className:"ppv-message",role:"status"},i)),n.replaceChildren(t);try{let r=[await ih()];return e&&r.push(await ih("-2")),ol=new Mf(t,r),t.dataset.ready="scene",!0}catch(r){return i.textContent=r instanceof ln?r.message:`The viewer failed: ${r instanceof Error?r.message:r}.`,t.replaceChildren(ae("div",{className:"ppv-message",role:"alert"},i)),t.dataset.ready="failed",r instanceof ln||console.error(r),!1}}var Bi=()=>{if(!ol)throw new Error("no scene is shown");return ol};window.pitchpointViewer={mount:Vb,state:()=>ol?U_(ol):null,seek:n=>Bi().seek(n),play:()=>Bi().toggle(!0),pause:()=>Bi().toggle(!1),step:n=>Bi().step(n),repeat:n=>Bi().loop(n),advance:n=>Bi().advance(n),follow:n=>Bi().follow(n),look:(n,e,t)=>Bi().views?.look(n,e,t),view:n=>Bi().views?.named(n,!0),show:(n,e=!0)=>Bi().curves.plots.show(n,e),magnify:n=>Bi().magnify(n),mode:n=>Bi().modes.choose(n),file:(n,e=1)=>n==="png"?Jc(Bi(),e):n==="glb"?jc(Bi()):Qc(Bi()),draw:()=>{Bi().orbit?.settle(),Bi().draw()}};})();
