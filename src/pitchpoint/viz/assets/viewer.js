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
(()=>{var ph='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var mh=`.ppv { --v-paper: var(--pp-paper, #fff); --v-ink: var(--pp-ink, #1f2933); --v-soft: var(--pp-soft, #5b6672); --v-grid: var(--pp-grid, #e3e7ec);
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
`;function ae(n,e={},...t){let i=document.createElement(n);for(let[r,s]of Object.entries(e))s==null||s===!1||(r.startsWith("on")?i.addEventListener(r.slice(2),s):r in i&&r!=="list"&&typeof s!="string"?i[r]=s:i.setAttribute(r==="className"?"class":r,s===!0?"":String(s)));return i.append(...t.filter(r=>r!=null)),i}function kt(n,e,t,i={}){return ae("button",{type:"button",title:e,"aria-label":e,onclick:t,...i},n)}function ts({label:n,title:e,least:t,most:i,value:r,show:s,changed:o}){let a=Math.log(i/t),l=ae("output",{},s(r)),c=ae("input",{type:"range",min:"0",max:"1",step:"0.001",title:e,"aria-label":e}),h=()=>t*Math.exp(a*Number(c.value)),u=f=>{c.value=String(Math.log(f/t)/a),l.textContent=c.ariaValueText=s(f)};return c.addEventListener("input",()=>{let f=h();l.textContent=c.ariaValueText=s(f),o(f)}),u(r),{row:ae("label",{className:"ppv-slider"},ae("span",{},n),c,l),set:u,input:c}}function dr(n,e,t,i=n){let r=ae("select",{title:i,"aria-label":i,onchange:()=>t(r.value)},...e.map(([s,o])=>ae("option",{value:s},o)));return{row:ae("label",{className:"ppv-choice"},ae("span",{},n),r),select:r}}function Is(n,e,t,i=null){let r=ae("input",{type:"checkbox",checked:e,onchange:()=>t(r.checked)});return{row:ae("label",{className:"ppv-tick"},r,i,ae("span",{},n)),input:r}}var z_="uplot",k_="u-hz",V_="u-vt",H_="u-title",W_="u-wrap",X_="u-under",q_="u-over",Y_="u-axis",rs="u-off",K_="u-select",Z_="u-cursor-x",$_="u-cursor-y",J_="u-cursor-pt",Q_="u-legend",j_="u-live",ev="u-inline",tv="u-series",iv="u-marker",gh="u-label",nv="u-value",Ho="width",Wo="height";var xh="bottom",Ns="left",Su="right",Ou="#000",_h=Ou+"0",Mu="mousemove",vh="mousedown",yu="mouseup",Sh="mouseenter",Mh="mouseleave",yh="dblclick",rv="resize",sv="scroll",bh="change",hl="dppxchange",Bu="--",ks=typeof window<"u",Au=ks?document:null,Fs=ks?window:null,ov=ks?navigator:null,wt,ll;function Ru(){let n=devicePixelRatio;wt!=n&&(wt=n,ll&&Pu(bh,ll,Ru),ll=matchMedia(`(min-resolution: ${wt-.001}dppx) and (max-resolution: ${wt+.001}dppx)`),ss(bh,ll,Ru),Fs.dispatchEvent(new CustomEvent(hl)))}function dn(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Cu(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Vt(n,e,t){n.style[e]=t+"px"}function On(n,e,t,i){let r=Au.createElement(n);return e!=null&&dn(r,e),t?.insertBefore(r,i),r}function An(n,e){return On("div",n,e)}var Eh=new WeakMap;function er(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=Eh.get(n);s!=o&&(n.style.transform=s,Eh.set(n,s),e<0||t<0||e>i||t>r?dn(n,rs):Cu(n,rs))}var wh=new WeakMap;function Th(n,e,t){let i=e+t,r=wh.get(n);i!=r&&(wh.set(n,i),n.style.background=e,n.style.borderColor=t)}var Ah=new WeakMap;function Rh(n,e,t,i){let r=e+""+t,s=Ah.get(n);r!=s&&(Ah.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Gu={passive:!0},av={...Gu,capture:!0};function ss(n,e,t,i){e.addEventListener(n,t,i?av:Gu)}function Pu(n,e,t,i){e.removeEventListener(n,t,Gu)}ks&&Ru();function Bn(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:pn((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function id(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var nd=n=>n!=null,rd=n=>n!=null&&n>0,ml=id(nd),lv=id(rd);function cv(n,e,t,i=0,r=!1){let s=r?lv:ml,o=r?rd:nd;[e,t]=s(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??It,l??-It]}function gl(n,e,t,i){let r=Lh(n),s=Lh(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?pr:sd,a=r==1?pn:Rn,l=s==1?Rn:pn,c=a(o(yi(n))),h=l(o(yi(e))),u=Os(t,c),f=Os(t,h);return t==10&&(c<0&&(u=Nt(u,-c)),h<0&&(f=Nt(f,-h))),i||t==2?(n=u*r,e=f*s):(n=cd(n,u),e=xl(e,f)),[n,e]}function zu(n,e,t,i){let r=gl(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var ku=.1,Ch={mode:3,pad:ku},qo={pad:0,soft:null,mode:0},uv={min:qo,max:qo};function dl(n,e,t,i){return _l(t)?Ph(n,e,t):(qo.pad=t,qo.soft=i?0:null,qo.mode=i?3:0,Ph(n,e,uv))}function yt(n,e){return n??e}function fv(n,e,t){for(e=yt(e,0),t=yt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Ph(n,e,t){let i=t.min,r=t.max,s=yt(i.pad,0),o=yt(r.pad,0),a=yt(i.hard,-It),l=yt(r.hard,It),c=yt(i.soft,It),h=yt(r.soft,-It),u=yt(i.mode,0),f=yt(r.mode,0),m=e-n,x=pr(m),S=Qi(yi(n),yi(e)),d=pr(S),p=yi(d-x);(m<1e-24||p>10)&&(m=0,(n==0||e==0)&&(m=1e-24,u==2&&c!=It&&(s=0),f==2&&h!=-It&&(o=0)));let v=m||S||1e3,A=pr(v),M=Os(10,pn(A)),R=v*(m==0?n==0?.1:1:s),T=Nt(cd(n-R,M/10),24),g=n>=c&&(u==1||u==3&&T<=c||u==2&&T>=c)?c:It,E=Qi(a,T<g&&n>=g?g:Gn(g,T)),U=v*(m==0?e==0?.1:1:o),P=Nt(xl(e+U,M/10),24),D=e<=h&&(f==1||f==3&&P>=h||f==2&&P<=h)?h:-It,G=Gn(l,P>D&&e<=D?D:Qi(D,P));return E==G&&E==0&&(G=100),[E,G]}var hv=new Intl.NumberFormat(ks?ov.language:"en-US"),Vu=n=>hv.format(n),mn=Math,fl=mn.PI,yi=mn.abs,pn=mn.floor,Mi=mn.round,Rn=mn.ceil,Gn=mn.min,Qi=mn.max,Os=mn.pow,Lh=mn.sign,pr=mn.log10,sd=mn.log2,dv=(n,e=1)=>mn.sinh(n)*e,bu=(n,e=1)=>mn.asinh(n/e),It=1/0;function Dh(n){return(pr((n^n>>31)-(n>>31))|0)+1}function Lu(n,e,t){return Gn(Qi(n,e),t)}function od(n){return typeof n=="function"}function _t(n){return od(n)?n:()=>n}var pv=()=>{},ad=n=>n,ld=(n,e)=>e,mv=n=>null,Ih=n=>!0,Nh=(n,e)=>n==e,gv=/\.\d*?(?=9{6,}|0{6,})/gm,os=n=>{if(fd(n)||Ir.has(n))return n;let e=`${n}`,t=e.match(gv);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${os(r)}e${s}`}return Nt(n,i)};function is(n,e){return os(Nt(os(n/e))*e)}function xl(n,e){return os(Rn(os(n/e))*e)}function cd(n,e){return os(pn(os(n/e))*e)}function Nt(n,e=0){if(fd(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mi(i)/t}var Ir=new Map;function ud(n){return((""+n).split(".")[1]||"").length}function Ko(n,e,t,i){let r=[],s=i.map(ud);for(let o=e;o<t;o++){let a=yi(o),l=Nt(Os(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,u=(o>=0?0:a)+(o>=s[c]?0:s[c]),f=n==10?h:Nt(h,u);r.push(f),Ir.set(f,u)}}return r}var Yo={},Hu=[],Bs=[null,null],Dr=Array.isArray,fd=Number.isInteger,xv=n=>n===void 0;function Uh(n){return typeof n=="string"}function _l(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function _v(n){return n!=null&&typeof n=="object"}var vv=Object.getPrototypeOf(Uint8Array),hd="__proto__";function Gs(n,e=_l){let t;if(Dr(n)){let i=n.find(r=>r!=null);if(Dr(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=Gs(n[r],e)}else t=n.slice()}else if(n instanceof vv)t=n.slice();else if(e(n)){t={};for(let i in n)i!=hd&&(t[i]=Gs(n[i],e))}else t=n;return t}function pi(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=hd&&(_l(n[r])?pi(n[r],Gs(i[r])):n[r]=Gs(i[r]))}return n}var Sv=0,Mv=1,yv=2;function bv(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function Ev(n,e){if(Av(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Rv(o[0])||(o=Tv(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(r).fill(void 0),f=e?e[o][c]:Mv,m=[];for(let x=0;x<h.length;x++){let S=h[x],d=s.get(l[x]);S===null?f!=Sv&&(u[d]=S,f==yv&&m.push(d)):u[d]=S}bv(u,m,r),i.push(u)}}return i}var wv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Tv(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];r.push(a)}return r}function Av(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function Rv(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=Qi(1,pn((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var dd=["January","February","March","April","May","June","July","August","September","October","November","December"],pd=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function md(n){return n.slice(0,3)}var Cv=pd.map(md),Pv=dd.map(md),Lv={MMMM:dd,MMM:Pv,WWWW:pd,WWW:Cv};function Vo(n){return(n<10?"0":"")+n}function Dv(n){return(n<10?"00":n<100?"0":"")+n}var Iv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Vo(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Vo(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Vo(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Vo(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Vo(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Dv(n.getMilliseconds())};function Wu(n,e){e=e||Lv;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?Iv[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var Nv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Uv(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Nv?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var gd=n=>n%1==0,pl=[1,2,2.5,5],Fv=Ko(10,-32,0,pl),xd=Ko(10,0,32,pl),Ov=xd.filter(gd),ns=Fv.concat(xd),Xu=`
`,_d="{YYYY}",Fh=Xu+_d,vd="{M}/{D}",Xo=Xu+vd,cl=Xo+"/{YY}",Sd="{aa}",Bv="{h}:{mm}",Us=Bv+Sd,Oh=Xu+Us,Bh=":{ss}",Tt=null;function Md(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,l=(n==1?Ko(10,0,3,pl).filter(gd):Ko(10,-3,0,pl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,_d,Tt,Tt,Tt,Tt,Tt,Tt,1],[r*28,"{MMM}",Fh,Tt,Tt,Tt,Tt,Tt,1],[r,vd,Fh,Tt,Tt,Tt,Tt,Tt,1],[i,"{h}"+Sd,cl,Tt,Xo,Tt,Tt,Tt,1],[t,Us,cl,Tt,Xo,Tt,Tt,Tt,1],[e,Bh,cl+" "+Us,Tt,Xo+" "+Us,Tt,Oh,Tt,1],[n,Bh+".{fff}",cl+" "+Us,Tt,Xo+" "+Us,Tt,Oh,Tt,1]];function h(u){return(f,m,x,S,d,p)=>{let v=[],A=d>=o,M=d>=s&&d<o,R=u(x),T=Nt(R*n,3),g=Eu(R.getFullYear(),A?0:R.getMonth(),M||A?1:R.getDate()),E=Nt(g*n,3);if(M||A){let U=M?d/s:0,P=A?d/o:0,D=T==E?T:Nt(Eu(g.getFullYear()+P,g.getMonth()+U,1)*n,3),G=new Date(Mi(D/n)),k=G.getFullYear(),N=G.getMonth();for(let W=0;D<=S;W++){let Y=Eu(k+P*W,N+U*W,1),H=Y-u(Nt(Y*n,3));D=Nt((+Y+H)*n,3),D<=S&&v.push(D)}}else{let U=d>=r?r:d,P=pn(x)-pn(T),D=E+P+xl(T-E,U);v.push(D);let G=u(D),k=G.getHours()+G.getMinutes()/t+G.getSeconds()/i,N=d/i,W=f.axes[m]._space,Y=p/W;for(;D=Nt(D+d,n==1?0:3),!(D>S);)if(N>1){let H=pn(Nt(k+N,6))%24,Q=u(D).getHours()-H;Q>1&&(Q=-1),D-=Q*i,k=(k+N)%24;let ne=v[v.length-1];Nt((D-ne)/d,3)*Y>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,h]}var[Gv,zv,kv]=Md(1),[Vv,Hv,Wv]=Md(.001);Ko(2,-53,53,[1]);function Gh(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function zh(n,e){return(t,i,r,s,o)=>{let a=e.find(x=>o>=x[0])||e[e.length-1],l,c,h,u,f,m;return i.map(x=>{let S=n(x),d=S.getFullYear(),p=S.getMonth(),v=S.getDate(),A=S.getHours(),M=S.getMinutes(),R=S.getSeconds(),T=d!=l&&a[2]||p!=c&&a[3]||v!=h&&a[4]||A!=u&&a[5]||M!=f&&a[6]||R!=m&&a[7]||a[1];return l=d,c=p,h=v,u=A,f=M,m=R,T(S)})}}function Xv(n,e){let t=Wu(e);return(i,r,s,o,a)=>r.map(l=>t(n(l)))}function Eu(n,e,t){return new Date(n,e,t)}function kh(n,e){return e(n)}var qv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Vh(n,e){return(t,i,r,s)=>s==null?Bu:e(n(i))}function Yv(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function Kv(n,e){return n.series[e].fill(n,e)}var Zv={show:!0,live:!0,isolate:!1,mount:pv,markers:{show:!0,width:2,stroke:Yv,fill:Kv,dash:"solid"},idx:null,idxs:null,values:[]};function $v(n,e){let t=n.cursor.points,i=An(),r=t.size(n,e);Vt(i,Ho,r),Vt(i,Wo,r);let s=r/-2;Vt(i,"marginLeft",s),Vt(i,"marginTop",s);let o=t.width(n,e,r);return o&&Vt(i,"borderWidth",o),i}function Jv(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Qv(n,e){let t=n.series[e].points;return t._stroke||t._fill}function jv(n,e){return n.series[e].points.size}var wu=[0,0];function eS(n,e,t){return wu[0]=e,wu[1]=t,wu}function ul(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function Tu(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var tS={show:!0,x:!0,y:!0,lock:!1,move:eS,points:{one:!1,show:$v,size:jv,width:0,stroke:Qv,fill:Jv},bind:{mousedown:ul,mouseup:ul,click:ul,dblclick:ul,mousemove:Tu,mouseleave:Tu,mouseenter:Tu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},yd={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},qu=pi({},yd,{filter:ld}),bd=pi({},qu,{size:10}),Ed=pi({},yd,{show:!1}),Yu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',wd="bold "+Yu,Td=1.5,Hh={show:!0,scale:"x",stroke:Ou,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wd,side:2,grid:qu,ticks:bd,border:Ed,font:Yu,lineGap:Td,rotate:0},iS="Value",nS="Time",Wh={show:!0,scale:"x",auto:!1,sorted:1,min:It,max:-It,idxs:[]};function rS(n,e,t,i,r){return e.map(s=>s==null?"":Vu(s))}function sS(n,e,t,i,r,s,o){let a=[],l=Ir.get(r)||0;t=o?t:Nt(xl(t,r),l);for(let c=t;c<=i;c=Nt(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function Du(n,e,t,i,r,s,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?pr:sd,h=pn(c(t));r=Os(l,h),l==10&&(r=ns[Bn(r,ns)]);let u=t,f=r*l;l==10&&(f=ns[Bn(f,ns)]);do a.push(u),u=u+r,l==10&&!Ir.has(u)&&(u=Nt(u,Ir.get(r))),u>=f&&(r=u,f=r*l,l==10&&(f=ns[Bn(f,ns)]));while(u<=i);return a}function oS(n,e,t,i,r,s,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Du(n,e,Qi(l,t),i,r):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?Du(n,e,Qi(l,-i),-t,r):[l]).reverse().map(f=>-f).concat(h,c)}var Ad=/./,aS=/[12357]/,lS=/[125]/,Xh=/1/,Iu=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function cS(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],l=n.valToPos,c=s._space,h=l(10,o),u=l(9,o)-h>=c?Ad:l(7,o)-h>=c?aS:l(5,o)-h>=c?lS:Xh;if(u==Xh){let f=yi(l(1,o)-h);if(f<c)return Iu(e.slice().reverse(),a.distr,u,Rn(c/f)).reverse()}return Iu(e,a.distr,u,1)}function uS(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,l=n.valToPos,c=yi(l(1,o)-l(2,o));return c<a?Iu(e.slice().reverse(),3,Ad,Rn(a/c)).reverse():e}function fS(n,e,t,i){return i==null?Bu:e==null?"":Vu(e)}var qh={show:!0,scale:"y",stroke:Ou,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wd,side:3,grid:qu,ticks:bd,border:Ed,font:Yu,lineGap:Td,rotate:0};function hS(n,e){let t=3+(n||1)*2;return Nt(t*e,3)}function dS(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=yi(o-s),l=n.series[e],c=a/(l.points.space*wt);return i[1]-i[0]<=c}var Yh={scale:null,auto:!0,sorted:0,min:It,max:-It},Rd=(n,e,t,i,r)=>r,Kh={show:!0,auto:!0,sorted:0,gaps:Rd,alpha:1,facets:[pi({},Yh,{scale:"x"}),pi({},Yh,{scale:"y"})]},Zh={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Rd,alpha:1,points:{show:dS,filter:null},values:null,min:It,max:-It,idxs:[],path:null,clip:null};function pS(n,e,t,i,r){return t/10}var Cd={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},mS=pi({},Cd,{time:!1,ori:1}),$h={};function Pd(n,e){let t=$h[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=r&&t.plots[h].pub(i,r,s,o,a,l,c)}},n!=null&&($h[n]=t)),t}var zs=1,Nu=2;function as(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=s[0],c=i==2?s[1]:s[e],h=i==2?o[r.facets[0].scale]:o[n.series[0].scale],u=i==2?o[r.facets[1].scale]:o[r.scale],f=a.left,m=a.top,x=a.width,S=a.height,d=n.valToPosH,p=n.valToPosV;return h.ori==0?t(r,l,c,h,u,d,p,f,m,x,S,Sl,Vs,yl,Dd,Nd):t(r,l,c,h,u,p,d,m,f,S,x,Ml,Hs,$u,Id,Ud)}function Ku(n,e){let t=0,i=0,r=yt(n.bands,Hu);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function gS(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,l=n.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function mr(n,e,t,i,r,s){return as(n,e,(o,a,l,c,h,u,f,m,x,S,d)=>{let p=o.pxRound,v=c.dir*(c.ori==0?1:-1),A=c.ori==0?Vs:Hs,M,R;v==1?(M=t,R=i):(M=i,R=t);let T=p(u(a[M],c,S,m)),g=p(f(l[M],h,d,x)),E=p(u(a[R],c,S,m)),U=p(f(s==1?h.max:h.min,h,d,x)),P=new Path2D(r);return A(P,E,U),A(P,T,U),A(P,T,g),P})}function vl(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?yl:$u,l=t;for(let u=0;u<n.length;u++){let f=n[u];if(f[1]>f[0]){let m=f[0]-l;m>0&&a(o,l,i,m,i+s),l=f[1]}}let c=t+r-l,h=10;c>0&&a(o,l,i-h/2,c,i+s+h)}return o}function xS(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Zu(n,e,t,i,r,s,o){let a=[],l=n.length;for(let c=r==1?t:i;c>=t&&c<=i;c+=r)if(e[c]===null){let u=c,f=c;if(r==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let m=s(n[u]),x=f==u?m:s(n[f]),S=u-r;m=o<=0&&S>=0&&S<l?s(n[S]):m;let p=f+r;x=o>=0&&p>=0&&p<l?s(n[p]):x,x>=m&&a.push([m,x])}return a}function Jh(n){return n==0?ad:n==1?Mi:e=>is(e,n)}function Ld(n){let e=n==0?Sl:Ml,t=n==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},i=n==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,h=0)=>{c==0&&h==0?i(r,s,o,a,l):(c=Gn(c,a/2,l/2),h=Gn(h,a/2,l/2),e(r,s+c,o),t(r,s+a,o,s+a,o+l,c),t(r,s+a,o+l,s,o+l,h),t(r,s,o+l,s,o,h),t(r,s,o,s+a,o,c),r.closePath())}}var Sl=(n,e,t)=>{n.moveTo(e,t)},Ml=(n,e,t)=>{n.moveTo(t,e)},Vs=(n,e,t)=>{n.lineTo(e,t)},Hs=(n,e,t)=>{n.lineTo(t,e)},yl=Ld(0),$u=Ld(1),Dd=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},Id=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},Nd=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},Ud=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function Fd(n){return(e,t,i,r,s)=>as(e,t,(o,a,l,c,h,u,f,m,x,S,d)=>{let{pxRound:p,points:v}=o,A,M;c.ori==0?(A=Sl,M=Dd):(A=Ml,M=Id);let R=Nt(v.width*wt,3),T=(v.size-v.width)/2*wt,g=Nt(T*2,3),E=new Path2D,U=new Path2D,{left:P,top:D,width:G,height:k}=e.bbox;yl(U,P-g,D-g,G+g*2,k+g*2);let N=W=>{if(l[W]!=null){let Y=p(u(a[W],c,S,m)),H=p(f(l[W],h,d,x));A(E,Y+T,H),M(E,Y,H,T,0,fl*2)}};if(s)s.forEach(N);else for(let W=i;W<=r;W++)N(W);return{stroke:R>0?E:null,fill:E,clip:U,flags:zs|Nu}})}function Od(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var _S=Od(Vs),vS=Od(Hs);function Bd(n){let e=yt(n?.alignGaps,0);return(t,i,r,s)=>as(t,i,(o,a,l,c,h,u,f,m,x,S,d)=>{[r,s]=ml(l,r,s);let p=o.pxRound,v=k=>p(u(k,c,S,m)),A=k=>p(f(k,h,d,x)),M,R;c.ori==0?(M=Vs,R=_S):(M=Hs,R=vS);let T=c.dir*(c.ori==0?1:-1),g={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zs},E=g.stroke,U=!1;if(s-r>=S*4){let k=fe=>t.posToVal(fe,c.key,!0),N=null,W=null,Y,H,ce,$=v(a[T==1?r:s]),Q=v(a[r]),ne=v(a[s]),he=k(T==1?Q+1:ne-1);for(let fe=T==1?r:s;fe>=r&&fe<=s;fe+=T){let j=a[fe],_e=(T==1?j<he:j>he)?$:v(j),Ae=l[fe];_e==$?Ae!=null?(H=Ae,N==null?(M(E,_e,A(H)),Y=N=W=H):H<N?N=H:H>W&&(W=H)):Ae===null&&(U=!0):(N!=null&&R(E,$,A(N),A(W),A(Y),A(H)),Ae!=null?(H=Ae,M(E,_e,A(H)),N=W=Y=H):(N=W=null,Ae===null&&(U=!0)),$=_e,he=k($+T))}N!=null&&N!=W&&ce!=$&&R(E,$,A(N),A(W),A(Y),A(H))}else for(let k=T==1?r:s;k>=r&&k<=s;k+=T){let N=l[k];N===null?U=!0:N!=null&&M(E,v(a[k]),A(N))}let[D,G]=Ku(t,i);if(o.fill!=null||D!=0){let k=g.fill=new Path2D(E),N=o.fillTo(t,i,o.min,o.max,D),W=A(N),Y=v(a[r]),H=v(a[s]);T==-1&&([H,Y]=[Y,H]),M(k,H,W),M(k,Y,W)}if(!o.spanGaps){let k=[];U&&k.push(...Zu(a,l,r,s,T,v,e)),g.gaps=k=o.gaps(t,i,r,s,k),g.clip=vl(k,c.ori,m,x,S,d)}return G!=0&&(g.band=G==2?[mr(t,i,r,s,E,-1),mr(t,i,r,s,E,1)]:mr(t,i,r,s,E,G)),g})}function SS(n){let e=yt(n.align,1),t=yt(n.ascDesc,!1),i=yt(n.alignGaps,0),r=yt(n.extend,!1);return(s,o,a,l)=>as(s,o,(c,h,u,f,m,x,S,d,p,v,A)=>{[a,l]=ml(u,a,l);let M=c.pxRound,{left:R,width:T}=s.bbox,g=Q=>M(x(Q,f,v,d)),E=Q=>M(S(Q,m,A,p)),U=f.ori==0?Vs:Hs,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zs},D=P.stroke,G=f.dir*(f.ori==0?1:-1),k=E(u[G==1?a:l]),N=g(h[G==1?a:l]),W=N,Y=N;r&&e==-1&&(Y=R,U(D,Y,k)),U(D,N,k);for(let Q=G==1?a:l;Q>=a&&Q<=l;Q+=G){let ne=u[Q];if(ne==null)continue;let he=g(h[Q]),fe=E(ne);e==1?U(D,he,k):U(D,W,fe),U(D,he,fe),k=fe,W=he}let H=W;r&&e==1&&(H=R+T,U(D,H,k));let[ce,$]=Ku(s,o);if(c.fill!=null||ce!=0){let Q=P.fill=new Path2D(D),ne=c.fillTo(s,o,c.min,c.max,ce),he=E(ne);U(Q,H,he),U(Q,Y,he)}if(!c.spanGaps){let Q=[];Q.push(...Zu(h,u,a,l,G,g,i));let ne=c.width*wt/2,he=t||e==1?ne:-ne,fe=t||e==-1?-ne:ne;Q.forEach(j=>{j[0]+=he,j[1]+=fe}),P.gaps=Q=c.gaps(s,o,a,l,Q),P.clip=vl(Q,f.ori,d,p,v,A)}return $!=0&&(P.band=$==2?[mr(s,o,a,l,D,-1),mr(s,o,a,l,D,1)]:mr(s,o,a,l,D,$)),P})}function Qh(n,e,t,i,r,s,o=It){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let h=yi(n[l]-n[a]);h<c&&(c=h,o=yi(t(n[l],i,r,s)-t(n[a],i,r,s)))}a=l}}return o}function MS(n){n=n||Yo;let e=yt(n.size,[.6,It,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=_t(r),o=1-e[0],a=yt(e[1],It),l=yt(e[2],1),c=yt(n.disp,Yo),h=yt(n.each,m=>{}),{fill:u,stroke:f}=c;return(m,x,S,d)=>as(m,x,(p,v,A,M,R,T,g,E,U,P,D)=>{let G=p.pxRound,k=t,N=i*wt,W=a*wt,Y=l*wt,H,ce;M.ori==0?[H,ce]=s(m,x):[ce,H]=s(m,x);let $=M.dir*(M.ori==0?1:-1),Q=M.ori==0?yl:$u,ne=M.ori==0?h:(Ce,Je,ot,be,Dt,ke,$e)=>{h(Ce,Je,ot,Dt,be,$e,ke)},he=yt(m.bands,Hu).find(Ce=>Ce.series[0]==x),fe=he!=null?he.dir:0,j=p.fillTo(m,x,p.min,p.max,fe),me=G(g(j,R,D,U)),_e,Ae,ye,qe=P,st=G(p.width*wt),He=!1,dt=null,ut=null,nt=null,Ht=null;u!=null&&(st==0||f!=null)&&(He=!0,dt=u.values(m,x,S,d),ut=new Map,new Set(dt).forEach(Ce=>{Ce!=null&&ut.set(Ce,new Path2D)}),st>0&&(nt=f.values(m,x,S,d),Ht=new Map,new Set(nt).forEach(Ce=>{Ce!=null&&Ht.set(Ce,new Path2D)})));let{x0:Ut,size:li}=c;if(Ut!=null&&li!=null){k=1,v=Ut.values(m,x,S,d),Ut.unit==2&&(v=v.map(ot=>m.posToVal(E+ot*P,M.key,!0)));let Ce=li.values(m,x,S,d);li.unit==2?Ae=Ce[0]*P:Ae=T(Ce[0],M,P,E)-T(0,M,P,E),qe=Qh(v,A,T,M,P,E,qe),ye=qe-Ae+N}else qe=Qh(v,A,T,M,P,E,qe),ye=qe*o+N,Ae=qe-ye;ye<1&&(ye=0),st>=Ae/2&&(st=0),ye<5&&(G=ad);let Pt=ye>0,Ai=qe-ye-(Pt?st:0);Ae=G(Lu(Ai,Y,W)),_e=(k==0?Ae/2:k==$?0:Ae)-k*$*((k==0?N/2:0)+(Pt?st/2:0));let St={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},vi=He?null:new Path2D,Qt=null;if(he!=null)Qt=m.data[he.series[1]];else{let{y0:Ce,y1:Je}=c;Ce!=null&&Je!=null&&(A=Je.values(m,x,S,d),Qt=Ce.values(m,x,S,d))}let ci=H*Ae,B=ce*Ae;for(let Ce=$==1?S:d;Ce>=S&&Ce<=d;Ce+=$){let Je=A[Ce];if(Je==null)continue;if(Qt!=null){let X=Qt[Ce]??0;if(Je-X==0)continue;me=g(X,R,D,U)}let ot=M.distr!=2||c!=null?v[Ce]:Ce,be=T(ot,M,P,E),Dt=g(yt(Je,j),R,D,U),ke=G(be-_e),$e=G(Qi(Dt,me)),C=G(Gn(Dt,me)),y=$e-C;if(Je!=null){let X=Je<0?B:ci,ue=Je<0?ci:B;He?(st>0&&nt[Ce]!=null&&Q(Ht.get(nt[Ce]),ke,C+pn(st/2),Ae,Qi(0,y-st),X,ue),dt[Ce]!=null&&Q(ut.get(dt[Ce]),ke,C+pn(st/2),Ae,Qi(0,y-st),X,ue)):Q(vi,ke,C+pn(st/2),Ae,Qi(0,y-st),X,ue),ne(m,x,Ce,ke-st/2,C,Ae+st,y)}}return st>0?St.stroke=He?Ht:vi:He||(St._fill=p.width==0?p._fill:p._stroke??p._fill,St.width=0),St.fill=He?ut:vi,St})}function yS(n,e){let t=yt(e?.alignGaps,0);return(i,r,s,o)=>as(i,r,(a,l,c,h,u,f,m,x,S,d,p)=>{[s,o]=ml(c,s,o);let v=a.pxRound,A=H=>v(f(H,h,d,x)),M=H=>v(m(H,u,p,S)),R,T,g;h.ori==0?(R=Sl,g=Vs,T=Nd):(R=Ml,g=Hs,T=Ud);let E=h.dir*(h.ori==0?1:-1),U=A(l[E==1?s:o]),P=U,D=[],G=[];for(let H=E==1?s:o;H>=s&&H<=o;H+=E)if(c[H]!=null){let $=l[H],Q=A($);D.push(P=Q),G.push(M(c[H]))}let k={stroke:n(D,G,R,g,T,v),fill:null,clip:null,band:null,gaps:null,flags:zs},N=k.stroke,[W,Y]=Ku(i,r);if(a.fill!=null||W!=0){let H=k.fill=new Path2D(N),ce=a.fillTo(i,r,a.min,a.max,W),$=M(ce);g(H,P,$),g(H,U,$)}if(!a.spanGaps){let H=[];H.push(...Zu(l,c,s,o,E,A,t)),k.gaps=H=a.gaps(i,r,s,o,H),k.clip=vl(H,h.ori,x,S,d,p)}return Y!=0&&(k.band=Y==2?[mr(i,r,s,o,N,-1),mr(i,r,s,o,N,1)]:mr(i,r,s,o,N,Y)),k})}function bS(n){return yS(ES,n)}function ES(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=e[f+1]-e[f],u[f]=n[f+1]-n[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)r(a,n[f]+u[f]/3,e[f]+l[f]*u[f]/3,n[f+1]-u[f]/3,e[f+1]-l[f+1]*u[f]/3,n[f+1],e[f+1])}return a}var Uu=new Set;function jh(){for(let n of Uu)n.syncRect(!0)}ks&&(ss(rv,Fs,jh),ss(sv,Fs,jh,!0),ss(hl,Fs,()=>{si.pxRatio=wt}));var wS=Bd(),TS=Fd();function ed(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>Fu(s,o,e,t))}function AS(n,e){return n.map((t,i)=>i==0?{}:pi({},e,t))}function Fu(n,e,t,i){return pi({},e==0?t:i,n)}function Gd(n,e,t){return e==null?Bs:[e,t]}var RS=Gd;function CS(n,e,t){return e==null?Bs:dl(e,t,ku,!0)}function zd(n,e,t,i){return e==null?Bs:gl(e,t,n.scales[i].log,!1)}var PS=zd;function kd(n,e,t,i){return e==null?Bs:zu(e,t,n.scales[i].log,!1)}var LS=kd;function DS(n,e,t,i,r){let s=Qi(Dh(n),Dh(e)),o=e-n,a=Bn(r/i*o,t);do{let l=t[a],c=i*l/o;if(c>=r&&s+(l<5?Ir.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function td(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Mi((t=+r)*wt))+"px"),[n,e,t]}function IS(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Nt(e[2]*wt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function si(n,e,t){let i={mode:yt(n.mode,1)},r=i.mode;function s(_,b,L,I){let V=b.valToPct(_);return I+L*(b.dir==-1?1-V:V)}function o(_,b,L,I){let V=b.valToPct(_);return I+L*(b.dir==-1?V:1-V)}function a(_,b,L,I){return b.ori==0?s(_,b,L,I):o(_,b,L,I)}i.valToPosH=s,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=An(z_);if(n.id!=null&&(c.id=n.id),dn(c,n.class),n.title){let _=An(H_,c);_.textContent=n.title}let h=On("canvas"),u=i.ctx=h.getContext("2d"),f=An(W_,c);ss("click",f,_=>{_.target===x&&(Bt!=Rs||Wt!=Cs)&&Ui.click(i,_)},!0);let m=i.under=An(X_,f);f.appendChild(h);let x=i.over=An(q_,f);n=Gs(n);let S=+yt(n.pxAlign,1),d=Jh(S);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let p=n.ms||.001,v=i.series=r==1?ed(n.series||[],Wh,Zh,!1):AS(n.series||[null],Kh),A=i.axes=ed(n.axes||[],Hh,qh,!0),M=i.scales={},R=i.bands=n.bands||[];R.forEach(_=>{_.fill=_t(_.fill||null),_.dir=yt(_.dir,-1)});let T=r==2?v[1].facets[0].scale:v[0].scale,g={axes:fr,series:mt},E=(n.drawOrder||["axes","series"]).map(_=>g[_]);function U(_){let b=_.distr==3?L=>pr(L>0?L:_.clamp(i,L,_.min,_.max,_.key)):_.distr==4?L=>bu(L,_.asinh):_.distr==100?L=>_.fwd(L):L=>L;return L=>{let I=b(L),{_min:V,_max:Z}=_,oe=Z-V;return(I-V)/oe}}function P(_){let b=M[_];if(b==null){let L=(n.scales||Yo)[_]||Yo;if(L.from!=null){P(L.from);let I=pi({},M[L.from],L,{key:_});I.valToPct=U(I),M[_]=I}else{b=M[_]=pi({},_==T?Cd:mS,L),b.key=_;let I=b.time,V=b.range,Z=Dr(V);if((_!=T||r==2&&!I)&&(Z&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?Ch:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?Ch:{mode:1,hard:V[1],soft:V[1]}},Z=!1),!Z&&_l(V))){let oe=V;V=(de,Se,Ie)=>Se==null?Bs:dl(Se,Ie,oe)}b.range=_t(V||(I?RS:_==T?b.distr==3?PS:b.distr==4?LS:Gd:b.distr==3?zd:b.distr==4?kd:CS)),b.auto=_t(Z?!1:b.auto),b.clamp=_t(b.clamp||pS),b._min=b._max=null,b.valToPct=U(b)}}}P("x"),P("y"),r==1&&v.forEach(_=>{P(_.scale)}),A.forEach(_=>{P(_.scale)});for(let _ in n.scales)P(_);let D=M[T],G=D.distr,k,N;D.ori==0?(dn(c,k_),k=s,N=o):(dn(c,V_),k=o,N=s);let W={};for(let _ in M){let b=M[_];(b.min!=null||b.max!=null)&&(W[_]={min:b.min,max:b.max},b.min=b.max=null)}let Y=n.tzDate||(_=>new Date(Mi(_/p))),H=n.fmtDate||Wu,ce=p==1?kv(Y):Wv(Y),$=zh(Y,Gh(p==1?zv:Hv,H)),Q=Vh(Y,kh(qv,H)),ne=[],he=i.legend=pi({},Zv,n.legend),fe=i.cursor=pi({},tS,{drag:{y:r==2}},n.cursor),j=he.show,me=fe.show,_e=he.markers;he.idxs=ne,_e.width=_t(_e.width),_e.dash=_t(_e.dash),_e.stroke=_t(_e.stroke),_e.fill=_t(_e.fill);let Ae,ye,qe,st=[],He=[],dt,ut=!1,nt={};if(he.live){let _=v[1]?v[1].values:null;ut=_!=null,dt=ut?_(i,1,0):{_:0};for(let b in dt)nt[b]=Bu}if(j)if(Ae=On("table",Q_,c),qe=On("tbody",null,Ae),he.mount(i,Ae),ut){ye=On("thead",null,Ae,qe);let _=On("tr",null,ye);On("th",null,_);for(var Ht in dt)On("th",gh,_).textContent=Ht}else dn(Ae,ev),he.live&&dn(Ae,j_);let Ut={show:!0},li={show:!1};function Pt(_,b){if(b==0&&(ut||!he.live||r==2))return Bs;let L=[],I=On("tr",tv,qe,qe.childNodes[b]);dn(I,_.class),_.show||dn(I,rs);let V=On("th",null,I);if(_e.show){let de=An(iv,V);if(b>0){let Se=_e.width(i,b);Se&&(de.style.border=Se+"px "+_e.dash(i,b)+" "+_e.stroke(i,b)),de.style.background=_e.fill(i,b)}}let Z=An(gh,V);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,b>0&&(_e.show||(Z.style.color=_.width>0?_e.stroke(i,b):_e.fill(i,b)),St("click",V,de=>{if(fe._lock)return;je(de);let Se=v.indexOf(_);if((de.ctrlKey||de.metaKey)!=he.isolate){let Ie=v.some((Ne,Fe)=>Fe>0&&Fe!=Se&&Ne.show);v.forEach((Ne,Fe)=>{Fe>0&&$n(Fe,Ie?Fe==Se?Ut:li:Ut,!0,di.setSeries)})}else $n(Se,{show:!_.show},!0,di.setSeries)},!1),et&&St(Sh,V,de=>{fe._lock||(je(de),$n(v.indexOf(_),Ls,!0,di.setSeries))},!1));for(var oe in dt){let de=On("td",nv,I);de.textContent="--",L.push(de)}return[I,L]}let Ai=new Map;function St(_,b,L,I=!0){let V=Ai.get(b)||{},Z=fe.bind[_](i,b,L,I);Z&&(ss(_,b,V[_]=Z),Ai.set(b,V))}function vi(_,b,L){let I=Ai.get(b)||{};for(let V in I)(_==null||V==_)&&(Pu(V,b,I[V]),delete I[V]);_==null&&Ai.delete(b)}let Qt=0,ci=0,B=0,Ce=0,Je=0,ot=0,be=Je,Dt=ot,ke=B,$e=Ce,C=0,y=0,X=0,ue=0;i.bbox={};let se=!1,xe=!1,ve=!1,ee=!1,ie=!1,pe=!1;function O(_,b,L){(L||_!=i.width||b!=i.height)&&re(_,b),ft(!1),ve=!0,xe=!0,Gi()}function re(_,b){i.width=Qt=B=_,i.height=ci=Ce=b,Je=ot=0,Me(),We();let L=i.bbox;C=L.left=is(Je*wt,.5),y=L.top=is(ot*wt,.5),X=L.width=is(B*wt,.5),ue=L.height=is(Ce*wt,.5)}let te=3;function Ee(){let _=!1,b=0;for(;!_;){b++;let L=ws(b),I=Zn(b);_=b==te||L&&I,_||(re(i.width,i.height),xe=!0)}}function ge({width:_,height:b}){O(_,b)}i.setSize=ge;function Me(){let _=!1,b=!1,L=!1,I=!1;A.forEach((V,Z)=>{if(V.show&&V._show){let{side:oe,_size:de}=V,Se=oe%2,Ie=V.label!=null?V.labelSize:0,Ne=de+Ie;Ne>0&&(Se?(B-=Ne,oe==3?(Je+=Ne,I=!0):L=!0):(Ce-=Ne,oe==0?(ot+=Ne,_=!0):b=!0))}}),Yn[0]=_,Yn[1]=L,Yn[2]=b,Yn[3]=I,B-=Nn[1]+Nn[3],Je+=Nn[3],Ce-=Nn[2]+Nn[0],ot+=Nn[0]}function We(){let _=Je+B,b=ot+Ce,L=Je,I=ot;function V(Z,oe){switch(Z){case 1:return _+=oe,_-oe;case 2:return b+=oe,b-oe;case 3:return L-=oe,L+oe;case 0:return I-=oe,I+oe}}A.forEach((Z,oe)=>{if(Z.show&&Z._show){let de=Z.side;Z._pos=V(de,Z._size),Z.label!=null&&(Z._lpos=V(de,Z.labelSize))}})}if(fe.dataIdx==null){let _=fe.hover,b=_.skip=new Set(_.skip??[]);b.add(void 0);let L=_.prox=_t(_.prox),I=_.bias??=0;fe.dataIdx=(V,Z,oe,de)=>{if(Z==0)return oe;let Se=oe,Ie=L(V,Z,oe,de)??It,Ne=Ie>=0&&Ie<It,Fe=D.ori==0?B:Ce,rt=fe.left,Et=e[0],Mt=e[Z];if(b.has(Mt[oe])){Se=null;let gt=null,Qe=null,Ye;if(I==0||I==-1)for(Ye=oe;gt==null&&Ye-- >0;)b.has(Mt[Ye])||(gt=Ye);if(I==0||I==1)for(Ye=oe;Qe==null&&Ye++<Mt.length;)b.has(Mt[Ye])||(Qe=Ye);if(gt!=null||Qe!=null)if(Ne){let zt=gt==null?-1/0:k(Et[gt],D,Fe,0),ti=Qe==null?1/0:k(Et[Qe],D,Fe,0),Li=rt-zt,Lt=ti-rt;Li<=Lt?Li<=Ie&&(Se=gt):Lt<=Ie&&(Se=Qe)}else Se=Qe==null?gt:gt==null?Qe:oe-gt<=Qe-oe?gt:Qe}else Ne&&yi(rt-k(Et[oe],D,Fe,0))>Ie&&(Se=null);return Se}}let je=_=>{fe.event=_};fe.idxs=ne,fe._lock=!1;let le=fe.points;le.show=_t(le.show),le.size=_t(le.size),le.stroke=_t(le.stroke),le.width=_t(le.width),le.fill=_t(le.fill);let Oe=i.focus=pi({},n.focus||{alpha:.3},fe.focus),et=Oe.prox>=0,Re=et&&le.one,lt=[],Ot=[],Yi=[];function No(_,b){let L=le.show(i,b);if(L instanceof HTMLElement)return dn(L,J_),dn(L,_.class),er(L,-10,-10,B,Ce),x.insertBefore(L,lt[b]),L}function ys(_,b){if(r==1||b>0){let L=r==1&&M[_.scale].time,I=_.value;_.value=L?Uh(I)?Vh(Y,kh(I,H)):I||Q:I||fS,_.label=_.label||(L?nS:iS)}if(Re||b>0){_.width=_.width==null?1:_.width,_.paths=_.paths||wS||mv,_.fillTo=_t(_.fillTo||gS),_.pxAlign=+yt(_.pxAlign,S),_.pxRound=Jh(_.pxAlign),_.stroke=_t(_.stroke||null),_.fill=_t(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let L=hS(Qi(1,_.width),1),I=_.points=pi({},{size:L,width:Qi(1,L*.2),stroke:_.stroke,space:L*2,paths:TS,_stroke:null,_fill:null},_.points);I.show=_t(I.show),I.filter=_t(I.filter),I.fill=_t(I.fill),I.stroke=_t(I.stroke),I.paths=_t(I.paths),I.pxAlign=_.pxAlign}if(j){let L=Pt(_,b);st.splice(b,0,L[0]),He.splice(b,0,L[1]),he.values.push(null)}if(me){ne.splice(b,0,null);let L=null;Re?b==0&&(L=No(_,b)):b>0&&(L=No(_,b)),lt.splice(b,0,L),Ot.splice(b,0,0),Yi.splice(b,0,0)}Pi("addSeries",b)}function uu(_,b){b=b??v.length,_=r==1?Fu(_,b,Wh,Zh):Fu(_,b,{},Kh),v.splice(b,0,_),ys(v[b],b)}i.addSeries=uu;function rl(_){if(v.splice(_,1),j){he.values.splice(_,1),He.splice(_,1);let b=st.splice(_,1)[0];vi(null,b.firstChild),b.remove()}me&&(ne.splice(_,1),lt.splice(_,1)[0].remove(),Ot.splice(_,1),Yi.splice(_,1)),Pi("delSeries",_)}i.delSeries=rl;let Yn=[!1,!1,!1,!1];function lr(_,b){if(_._show=_.show,_.show){let L=_.side%2,I=M[_.scale];I==null&&(_.scale=L?v[1].scale:T,I=M[_.scale]);let V=I.time;_.size=_t(_.size),_.space=_t(_.space),_.rotate=_t(_.rotate),Dr(_.incrs)&&_.incrs.forEach(oe=>{!Ir.has(oe)&&Ir.set(oe,ud(oe))}),_.incrs=_t(_.incrs||(I.distr==2?Ov:V?p==1?Gv:Vv:ns)),_.splits=_t(_.splits||(V&&I.distr==1?ce:I.distr==3?Du:I.distr==4?oS:sS)),_.stroke=_t(_.stroke),_.grid.stroke=_t(_.grid.stroke),_.ticks.stroke=_t(_.ticks.stroke),_.border.stroke=_t(_.border.stroke);let Z=_.values;_.values=Dr(Z)&&!Dr(Z[0])?_t(Z):V?Dr(Z)?zh(Y,Gh(Z,H)):Uh(Z)?Xv(Y,Z):Z||$:Z||rS,_.filter=_t(_.filter||(I.distr>=3&&I.log==10?cS:I.distr==3&&I.log==2?uS:ld)),_.font=td(_.font),_.labelFont=td(_.labelFont),_._size=_.size(i,null,b,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Yn[b]=!0,_._el=An(Y_,f))}}function cr(_,b,L,I){let[V,Z,oe,de]=L,Se=b%2,Ie=0;return Se==0&&(de||Z)&&(Ie=b==0&&!V||b==2&&!oe?Mi(Hh.size/3):0),Se==1&&(V||oe)&&(Ie=b==1&&!Z||b==3&&!de?Mi(qh.size/2):0),Ie}let Uo=i.padding=(n.padding||[cr,cr,cr,cr]).map(_=>_t(yt(_,cr))),Nn=i._padding=Uo.map((_,b)=>_(i,b,Yn,0)),jt,ni=null,ri=null,Kn=r==1?v[0].idxs:null,cn=null,Tr=!1;function Fo(_,b){if(e=_??[],i.data=i._data=e,r==2){jt=0;for(let L=1;L<v.length;L++)jt+=e[L][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),cn=e[0],jt=cn.length;let L=e;if(G==2){L=e.slice();let I=L[0]=Array(jt);for(let V=0;V<jt;V++)I[V]=V}i._data=e=L}if(ft(!0),Pi("setData"),G==2&&(ve=!0),b!==!1){let L=D;L.auto(i,Tr)?Oo():Cr(T,L.min,L.max),ee=ee||fe.left>=0,pe=!0,Gi()}}i.setData=Fo;function Oo(){Tr=!0;let _,b;r==1&&(jt>0?(ni=Kn[0]=0,ri=Kn[1]=jt-1,_=e[0][ni],b=e[0][ri],G==2?(_=ni,b=ri):_==b&&(G==3?[_,b]=gl(_,_,D.log,!1):G==4?[_,b]=zu(_,_,D.log,!1):D.time?b=_+Mi(86400/p):[_,b]=dl(_,b,ku,!0))):(ni=Kn[0]=_=null,ri=Kn[1]=b=null)),Cr(T,_,b)}let bs,Ar,Es,w,z,J,q,K,we,Pe;function Te(_,b,L,I,V,Z){_??=_h,L??=Hu,I??="butt",V??=_h,Z??="round",_!=bs&&(u.strokeStyle=bs=_),V!=Ar&&(u.fillStyle=Ar=V),b!=Es&&(u.lineWidth=Es=b),Z!=z&&(u.lineJoin=z=Z),I!=J&&(u.lineCap=J=I),L!=w&&u.setLineDash(w=L)}function De(_,b,L,I){b!=Ar&&(u.fillStyle=Ar=b),_!=q&&(u.font=q=_),L!=K&&(u.textAlign=K=L),I!=we&&(u.textBaseline=we=I)}function Ge(_,b,L,I,V=0){if(I.length>0&&_.auto(i,Tr)&&(b==null||b.min==null)){let Z=yt(ni,0),oe=yt(ri,I.length-1),de=L.min==null?cv(I,Z,oe,V,_.distr==3):[L.min,L.max];_.min=Gn(_.min,L.min=de[0]),_.max=Qi(_.max,L.max=de[1])}}let tt={min:null,max:null};function pt(){for(let I in M){let V=M[I];W[I]==null&&(V.min==null||W[T]!=null&&V.auto(i,Tr))&&(W[I]=tt)}for(let I in M){let V=M[I];W[I]==null&&V.from!=null&&W[V.from]!=null&&(W[I]=tt)}W[T]!=null&&ft(!0);let _={};for(let I in W){let V=W[I];if(V!=null){let Z=_[I]=Gs(M[I],_v);if(V.min!=null)pi(Z,V);else if(I!=T||r==2)if(jt==0&&Z.from==null){let oe=Z.range(i,null,null,I);Z.min=oe[0],Z.max=oe[1]}else Z.min=It,Z.max=-It}}if(jt>0){v.forEach((I,V)=>{if(r==1){let Z=I.scale,oe=W[Z];if(oe==null)return;let de=_[Z];if(V==0){let Se=de.range(i,de.min,de.max,Z);de.min=Se[0],de.max=Se[1],ni=Bn(de.min,e[0]),ri=Bn(de.max,e[0]),ri-ni>1&&(e[0][ni]<de.min&&ni++,e[0][ri]>de.max&&ri--),I.min=cn[ni],I.max=cn[ri]}else I.show&&I.auto&&Ge(de,oe,I,e[V],I.sorted);I.idxs[0]=ni,I.idxs[1]=ri}else if(V>0&&I.show&&I.auto){let[Z,oe]=I.facets,de=Z.scale,Se=oe.scale,[Ie,Ne]=e[V],Fe=_[de],rt=_[Se];Fe!=null&&Ge(Fe,W[de],Z,Ie,Z.sorted),rt!=null&&Ge(rt,W[Se],oe,Ne,oe.sorted),I.min=oe.min,I.max=oe.max}});for(let I in _){let V=_[I],Z=W[I];if(V.from==null&&(Z==null||Z.min==null)){let oe=V.range(i,V.min==It?null:V.min,V.max==-It?null:V.max,I);V.min=oe[0],V.max=oe[1]}}}for(let I in _){let V=_[I];if(V.from!=null){let Z=_[V.from];if(Z.min==null)V.min=V.max=null;else{let oe=V.range(i,Z.min,Z.max,I);V.min=oe[0],V.max=oe[1]}}}let b={},L=!1;for(let I in _){let V=_[I],Z=M[I];if(Z.min!=V.min||Z.max!=V.max){Z.min=V.min,Z.max=V.max;let oe=Z.distr;Z._min=oe==3?pr(Z.min):oe==4?bu(Z.min,Z.asinh):oe==100?Z.fwd(Z.min):Z.min,Z._max=oe==3?pr(Z.max):oe==4?bu(Z.max,Z.asinh):oe==100?Z.fwd(Z.max):Z.max,b[I]=L=!0}}if(L){v.forEach((I,V)=>{r==2?V>0&&b.y&&(I._paths=null):b[I.scale]&&(I._paths=null)});for(let I in b)ve=!0,Pi("setScale",I);me&&fe.left>=0&&(ee=pe=!0)}for(let I in W)W[I]=null}function Be(_){let b=Lu(ni-1,0,jt-1),L=Lu(ri+1,0,jt-1);for(;_[b]==null&&b>0;)b--;for(;_[L]==null&&L<jt-1;)L++;return[b,L]}function mt(){if(jt>0){let _=v.some(b=>b._focus)&&Pe!=Oe.alpha;_&&(u.globalAlpha=Pe=Oe.alpha),v.forEach((b,L)=>{if(L>0&&b.show&&(Zt(L,!1),Zt(L,!0),b._paths==null)){let I=Pe;Pe!=b.alpha&&(u.globalAlpha=Pe=b.alpha);let V=r==2?[0,e[L][0].length-1]:Be(e[L]);b._paths=b.paths(i,L,V[0],V[1]),Pe!=I&&(u.globalAlpha=Pe=I)}}),v.forEach((b,L)=>{if(L>0&&b.show){let I=Pe;Pe!=b.alpha&&(u.globalAlpha=Pe=b.alpha),b._paths!=null&&At(L,!1);{let V=b._paths!=null?b._paths.gaps:null,Z=b.points.show(i,L,ni,ri,V),oe=b.points.filter(i,L,Z,V);(Z||oe)&&(b.points._paths=b.points.paths(i,L,ni,ri,oe),At(L,!0))}Pe!=I&&(u.globalAlpha=Pe=I),Pi("drawSeries",L)}}),_&&(u.globalAlpha=Pe=1)}}function Zt(_,b){let L=b?v[_].points:v[_];L._stroke=L.stroke(i,_),L._fill=L.fill(i,_)}function At(_,b){let L=b?v[_].points:v[_],{stroke:I,fill:V,clip:Z,flags:oe,_stroke:de=L._stroke,_fill:Se=L._fill,_width:Ie=L.width}=L._paths;Ie=Nt(Ie*wt,3);let Ne=null,Fe=Ie%2/2;b&&Se==null&&(Se=Ie>0?"#fff":de);let rt=L.pxAlign==1&&Fe>0;if(rt&&u.translate(Fe,Fe),!b){let Et=C-Ie/2,Mt=y-Ie/2,gt=X+Ie,Qe=ue+Ie;Ne=new Path2D,Ne.rect(Et,Mt,gt,Qe)}b?Ue(de,Ie,L.dash,L.cap,Se,I,V,oe,Z):Rt(_,de,Ie,L.dash,L.cap,Se,I,V,oe,Ne,Z),rt&&u.translate(-Fe,-Fe)}function Rt(_,b,L,I,V,Z,oe,de,Se,Ie,Ne){let Fe=!1;Se!=0&&R.forEach((rt,Et)=>{if(rt.series[0]==_){let Mt=v[rt.series[1]],gt=e[rt.series[1]],Qe=(Mt._paths||Yo).band;Dr(Qe)&&(Qe=rt.dir==1?Qe[0]:Qe[1]);let Ye,zt=null;Mt.show&&Qe&&fv(gt,ni,ri)?(zt=rt.fill(i,Et)||Z,Ye=Mt._paths.clip):Qe=null,Ue(b,L,I,V,zt,oe,de,Se,Ie,Ne,Ye,Qe),Fe=!0}}),Fe||Ue(b,L,I,V,Z,oe,de,Se,Ie,Ne)}let Si=zs|Nu;function Ue(_,b,L,I,V,Z,oe,de,Se,Ie,Ne,Fe){Te(_,b,L,I,V),(Se||Ie||Fe)&&(u.save(),Se&&u.clip(Se),Ie&&u.clip(Ie)),Fe?(de&Si)==Si?(u.clip(Fe),Ne&&u.clip(Ne),xt(V,oe),ui(_,Z,b)):de&Nu?(xt(V,oe),u.clip(Fe),ui(_,Z,b)):de&zs&&(u.save(),u.clip(Fe),Ne&&u.clip(Ne),xt(V,oe),u.restore(),ui(_,Z,b)):(xt(V,oe),ui(_,Z,b)),(Se||Ie||Fe)&&u.restore()}function ui(_,b,L){L>0&&(b instanceof Map?b.forEach((I,V)=>{u.strokeStyle=bs=V,u.stroke(I)}):b!=null&&_&&u.stroke(b))}function xt(_,b){b instanceof Map?b.forEach((L,I)=>{u.fillStyle=Ar=I,u.fill(L)}):b!=null&&_&&u.fill(b)}function ur(_,b,L,I){let V=A[_],Z;if(I<=0)Z=[0,0];else{let oe=V._space=V.space(i,_,b,L,I),de=V._incrs=V.incrs(i,_,b,L,I,oe);Z=DS(b,L,de,I,oe)}return V._found=Z}function fi(_,b,L,I,V,Z,oe,de,Se,Ie){let Ne=oe%2/2;S==1&&u.translate(Ne,Ne),Te(de,oe,Se,Ie,de),u.beginPath();let Fe,rt,Et,Mt,gt=V+(I==0||I==3?-Z:Z);L==0?(rt=V,Mt=gt):(Fe=V,Et=gt);for(let Qe=0;Qe<_.length;Qe++)b[Qe]!=null&&(L==0?Fe=Et=_[Qe]:rt=Mt=_[Qe],u.moveTo(Fe,rt),u.lineTo(Et,Mt));u.stroke(),S==1&&u.translate(-Ne,-Ne)}function ws(_){let b=!0;return A.forEach((L,I)=>{if(!L.show)return;let V=M[L.scale];if(V.min==null){L._show&&(b=!1,L._show=!1,ft(!1));return}else L._show||(b=!1,L._show=!0,ft(!1));let Z=L.side,oe=Z%2,{min:de,max:Se}=V,[Ie,Ne]=ur(I,de,Se,oe==0?B:Ce);if(Ne==0)return;let Fe=V.distr==2,rt=L._splits=L.splits(i,I,de,Se,Ie,Ne,Fe),Et=V.distr==2?rt.map(Ye=>cn[Ye]):rt,Mt=V.distr==2?cn[rt[1]]-cn[rt[0]]:Ie,gt=L._values=L.values(i,L.filter(i,Et,I,Ne,Mt),I,Ne,Mt);L._rotate=Z==2?L.rotate(i,gt,I,Ne):0;let Qe=L._size;L._size=Rn(L.size(i,gt,I,_)),Qe!=null&&L._size!=Qe&&(b=!1)}),b}function Zn(_){let b=!0;return Uo.forEach((L,I)=>{let V=L(i,I,Yn,_);V!=Nn[I]&&(b=!1),Nn[I]=V}),b}function fr(){for(let _=0;_<A.length;_++){let b=A[_];if(!b.show||!b._show)continue;let L=b.side,I=L%2,V,Z,oe=b.stroke(i,_),de=L==0||L==3?-1:1,[Se,Ie]=b._found;if(b.label!=null){let $i=b.labelGap*de,hn=Mi((b._lpos+$i)*wt);De(b.labelFont[0],oe,"center",L==2?"top":xh),u.save(),I==1?(V=Z=0,u.translate(hn,Mi(y+ue/2)),u.rotate((L==3?-fl:fl)/2)):(V=Mi(C+X/2),Z=hn);let es=od(b.label)?b.label(i,_,Se,Ie):b.label;u.fillText(es,V,Z),u.restore()}if(Ie==0)continue;let Ne=M[b.scale],Fe=I==0?X:ue,rt=I==0?C:y,Et=b._splits,Mt=Ne.distr==2?Et.map($i=>cn[$i]):Et,gt=Ne.distr==2?cn[Et[1]]-cn[Et[0]]:Se,Qe=b.ticks,Ye=b.border,zt=Qe.show?Qe.size:0,ti=Mi(zt*wt),Li=Mi((b.alignTo==2?b._size-zt-b.gap:b.gap)*wt),Lt=b._rotate*-fl/180,ii=d(b._pos*wt),un=(ti+Li)*de,Zi=ii+un;Z=I==0?Zi:0,V=I==1?Zi:0;let wn=b.font[0],Un=b.align==1?Ns:b.align==2?Su:Lt>0?Ns:Lt<0?Su:I==0?"center":L==3?Su:Ns,Qn=Lt||I==1?"middle":L==2?"top":xh;De(wn,oe,Un,Qn);let fn=b.font[1]*b.lineGap,Tn=Et.map($i=>d(a($i,Ne,Fe,rt))),Fn=b._values;for(let $i=0;$i<Fn.length;$i++){let hn=Fn[$i];if(hn!=null){I==0?V=Tn[$i]:Z=Tn[$i],hn=""+hn;let es=hn.indexOf(`
`)==-1?[hn]:hn.split(/\n/gm);for(let Ji=0;Ji<es.length;Ji++){let dh=es[Ji];Lt?(u.save(),u.translate(V,Z+Ji*fn),u.rotate(Lt),u.fillText(dh,0,0),u.restore()):u.fillText(dh,V,Z+Ji*fn)}}}Qe.show&&fi(Tn,Qe.filter(i,Mt,_,Ie,gt),I,L,ii,ti,Nt(Qe.width*wt,3),Qe.stroke(i,_),Qe.dash,Qe.cap);let jn=b.grid;jn.show&&fi(Tn,jn.filter(i,Mt,_,Ie,gt),I,I==0?2:1,I==0?y:C,I==0?ue:X,Nt(jn.width*wt,3),jn.stroke(i,_),jn.dash,jn.cap),Ye.show&&fi([ii],[1],I==0?1:0,I==0?1:2,I==1?y:C,I==1?ue:X,Nt(Ye.width*wt,3),Ye.stroke(i,_),Ye.dash,Ye.cap)}Pi("drawAxes")}function ft(_){v.forEach((b,L)=>{L>0&&(b._paths=null,_&&(r==1?(b.min=null,b.max=null):b.facets.forEach(I=>{I.min=null,I.max=null})))})}let ei=!1,Ki=!1,Ct=[];function hi(){Ki=!1;for(let _=0;_<Ct.length;_++)Pi(...Ct[_]);Ct.length=0}function Gi(){ei||(wv(Zf),ei=!0)}function sl(_,b=!1){ei=!0,Ki=b,_(i),Zf(),b&&Ct.length>0&&queueMicrotask(hi)}i.batch=sl;function Zf(){if(se&&(pt(),se=!1),ve&&(Ee(),ve=!1),xe){if(Vt(m,Ns,Je),Vt(m,"top",ot),Vt(m,Ho,B),Vt(m,Wo,Ce),Vt(x,Ns,Je),Vt(x,"top",ot),Vt(x,Ho,B),Vt(x,Wo,Ce),Vt(f,Ho,Qt),Vt(f,Wo,ci),h.width=Mi(Qt*wt),h.height=Mi(ci*wt),A.forEach(({_el:_,_show:b,_size:L,_pos:I,side:V})=>{if(_!=null)if(b){let Z=V===3||V===0?L:0,oe=V%2==1;Vt(_,oe?"left":"top",I-Z),Vt(_,oe?"width":"height",L),Vt(_,oe?"top":"left",oe?ot:Je),Vt(_,oe?"height":"width",oe?Ce:B),Cu(_,rs)}else dn(_,rs)}),bs=Ar=Es=z=J=q=K=we=w=null,Pe=1,zo(!0),Je!=be||ot!=Dt||B!=ke||Ce!=$e){ft(!1);let _=B/ke,b=Ce/$e;if(me&&!ee&&fe.left>=0){fe.left*=_,fe.top*=b,Ts&&er(Ts,Mi(fe.left),0,B,Ce),As&&er(As,0,Mi(fe.top),B,Ce);for(let L=0;L<lt.length;L++){let I=lt[L];I!=null&&(Ot[L]*=_,Yi[L]*=b,er(I,Rn(Ot[L]),Rn(Yi[L]),B,Ce))}}if(Gt.show&&!ie&&Gt.left>=0&&Gt.width>0){Gt.left*=_,Gt.width*=_,Gt.top*=b,Gt.height*=b;for(let L in gu)Vt(Ps,L,Gt[L])}be=Je,Dt=ot,ke=B,$e=Ce}Pi("setSize"),xe=!1}Qt>0&&ci>0&&(u.clearRect(0,0,h.width,h.height),Pi("drawClear"),E.forEach(_=>_()),Pi("draw")),Gt.show&&ie&&(ol(Gt),ie=!1),me&&ee&&(jr(null,!0,!1),ee=!1),he.show&&he.live&&pe&&(pu(),pe=!1),l||(l=!0,i.status=1,Pi("ready")),Tr=!1,ei=!1}i.redraw=(_,b)=>{ve=b||!1,_!==!1?Cr(T,D.min,D.max):Gi()};function fu(_,b){let L=M[_];if(L.from==null){if(jt==0){let I=L.range(i,b.min,b.max,_);b.min=I[0],b.max=I[1]}if(b.min>b.max){let I=b.min;b.min=b.max,b.max=I}if(jt>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;_==T&&L.distr==2&&jt>0&&(b.min=Bn(b.min,e[0]),b.max=Bn(b.max,e[0]),b.min==b.max&&b.max++),W[_]=b,se=!0,Gi()}}i.setScale=fu;let hu,du,Ts,As,$f,Jf,Rs,Cs,Qf,jf,Bt,Wt,Rr=!1,Ui=fe.drag,Ri=Ui.x,Ci=Ui.y;me&&(fe.x&&(hu=An(Z_,x)),fe.y&&(du=An($_,x)),D.ori==0?(Ts=hu,As=du):(Ts=du,As=hu),Bt=fe.left,Wt=fe.top);let Gt=i.select=pi({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Ps=Gt.show?An(K_,Gt.over?x:m):null;function ol(_,b){if(Gt.show){for(let L in _)Gt[L]=_[L],L in gu&&Vt(Ps,L,_[L]);b!==!1&&Pi("setSelect")}}i.setSelect=ol;function T_(_){if(v[_].show)j&&Cu(st[_],rs);else if(j&&dn(st[_],rs),me){let L=Re?lt[0]:lt[_];L!=null&&er(L,-10,-10,B,Ce)}}function Cr(_,b,L){fu(_,{min:b,max:L})}function $n(_,b,L,I){b.focus!=null&&L_(_),b.show!=null&&v.forEach((V,Z)=>{Z>0&&(_==Z||_==null)&&(V.show=b.show,T_(Z),r==2?(Cr(V.facets[0].scale,null,null),Cr(V.facets[1].scale,null,null)):Cr(V.scale,null,null),Gi())}),L!==!1&&Pi("setSeries",_,b),I&&ko("setSeries",i,_,b)}i.setSeries=$n;function A_(_,b){pi(R[_],b)}function R_(_,b){_.fill=_t(_.fill||null),_.dir=yt(_.dir,-1),b=b??R.length,R.splice(b,0,_)}function C_(_){_==null?R.length=0:R.splice(_,1)}i.addBand=R_,i.setBand=A_,i.delBand=C_;function P_(_,b){v[_].alpha=b,me&&lt[_]!=null&&(lt[_].style.opacity=b),j&&st[_]&&(st[_].style.opacity=b)}let hr,Pr,Qr,Ls={focus:!0};function L_(_){if(_!=Qr){let b=_==null,L=Oe.alpha!=1;v.forEach((I,V)=>{if(r==1||V>0){let Z=b||V==0||V==_;I._focus=b?null:Z,L&&P_(V,Z?1:Oe.alpha)}}),Qr=_,L&&Gi()}}j&&et&&St(Mh,Ae,_=>{fe._lock||(je(_),Qr!=null&&$n(null,Ls,!0,di.setSeries))});function Jn(_,b,L){let I=M[b];L&&(_=_/wt-(I.ori==1?ot:Je));let V=B;I.ori==1&&(V=Ce,_=V-_),I.dir==-1&&(_=V-_);let Z=I._min,oe=I._max,de=_/V,Se=Z+(oe-Z)*de,Ie=I.distr;return Ie==3?Os(10,Se):Ie==4?dv(Se,I.asinh):Ie==100?I.bwd(Se):Se}function D_(_,b){let L=Jn(_,T,b);return Bn(L,e[0],ni,ri)}i.valToIdx=_=>Bn(_,e[0]),i.posToIdx=D_,i.posToVal=Jn,i.valToPos=(_,b,L)=>M[b].ori==0?s(_,M[b],L?X:B,L?C:0):o(_,M[b],L?ue:Ce,L?y:0),i.setCursor=(_,b,L)=>{Bt=_.left,Wt=_.top,jr(null,b,L)};function eh(_,b){Vt(Ps,Ns,Gt.left=_),Vt(Ps,Ho,Gt.width=b)}function th(_,b){Vt(Ps,"top",Gt.top=_),Vt(Ps,Wo,Gt.height=b)}let Bo=D.ori==0?eh:th,Go=D.ori==1?eh:th;function I_(){if(j&&he.live)for(let _=r==2?1:0;_<v.length;_++){if(_==0&&ut)continue;let b=he.values[_],L=0;for(let I in b)He[_][L++].firstChild.nodeValue=b[I]}}function pu(_,b){if(_!=null&&(_.idxs?_.idxs.forEach((L,I)=>{ne[I]=L}):xv(_.idx)||ne.fill(_.idx),he.idx=ne[0]),j&&he.live){for(let L=0;L<v.length;L++)(L>0||r==1&&!ut)&&N_(L,ne[L]);I_()}pe=!1,b!==!1&&Pi("setLegend")}i.setLegend=pu;function N_(_,b){let L=v[_],I=_==0&&G==2?cn:e[_],V;ut?V=L.values(i,_,b)??nt:(V=L.value(i,b==null?null:I[b],_,b),V=V==null?nt:{_:V}),he.values[_]=V}function jr(_,b,L){Qf=Bt,jf=Wt,[Bt,Wt]=fe.move(i,Bt,Wt),fe.left=Bt,fe.top=Wt,me&&(Ts&&er(Ts,Mi(Bt),0,B,Ce),As&&er(As,0,Mi(Wt),B,Ce));let I,V=ni>ri;hr=It,Pr=null;let Z=D.ori==0?B:Ce,oe=D.ori==1?B:Ce;if(Bt<0||jt==0||V){I=fe.idx=null;for(let de=0;de<v.length;de++){let Se=lt[de];Se!=null&&er(Se,-10,-10,B,Ce)}et&&$n(null,Ls,!0,_==null&&di.setSeries),he.live&&(ne.fill(I),pe=!0)}else{let de,Se,Ie;r==1&&(de=D.ori==0?Bt:Wt,Se=Jn(de,T),I=fe.idx=Bn(Se,e[0],ni,ri),Ie=k(e[0][I],D,Z,0));let Ne=-10,Fe=-10,rt=0,Et=0,Mt=!0,gt="",Qe="";for(let Ye=r==2?1:0;Ye<v.length;Ye++){let zt=v[Ye],ti=ne[Ye],Li=ti==null?null:r==1?e[Ye][ti]:e[Ye][1][ti],Lt=fe.dataIdx(i,Ye,I,Se),ii=Lt==null?null:r==1?e[Ye][Lt]:e[Ye][1][Lt];if(pe=pe||ii!=Li||Lt!=ti,ne[Ye]=Lt,Ye>0&&zt.show){let un=Lt==null?-10:Lt==I?Ie:k(r==1?e[0][Lt]:e[Ye][0][Lt],D,Z,0),Zi=ii==null?-10:N(ii,r==1?M[zt.scale]:M[zt.facets[1].scale],oe,0);if(et&&ii!=null){let wn=D.ori==1?Bt:Wt,Un=yi(Oe.dist(i,Ye,Lt,Zi,wn));if(Un<hr){let Qn=Oe.bias;if(Qn!=0){let fn=Jn(wn,zt.scale),Tn=ii>=0?1:-1,Fn=fn>=0?1:-1;Fn==Tn&&(Fn==1?Qn==1?ii>=fn:ii<=fn:Qn==1?ii<=fn:ii>=fn)&&(hr=Un,Pr=Ye)}else hr=Un,Pr=Ye}}if(pe||Re){let wn,Un;D.ori==0?(wn=un,Un=Zi):(wn=Zi,Un=un);let Qn,fn,Tn,Fn,jn,$i,hn=!0,es=le.bbox;if(es!=null){hn=!1;let Ji=es(i,Ye);Tn=Ji.left,Fn=Ji.top,Qn=Ji.width,fn=Ji.height}else Tn=wn,Fn=Un,Qn=fn=le.size(i,Ye);if($i=le.fill(i,Ye),jn=le.stroke(i,Ye),Re)Ye==Pr&&hr<=Oe.prox&&(Ne=Tn,Fe=Fn,rt=Qn,Et=fn,Mt=hn,gt=$i,Qe=jn);else{let Ji=lt[Ye];Ji!=null&&(Ot[Ye]=Tn,Yi[Ye]=Fn,Rh(Ji,Qn,fn,hn),Th(Ji,$i,jn),er(Ji,Rn(Tn),Rn(Fn),B,Ce))}}}}if(Re){let Ye=Oe.prox,zt=Qr==null?hr<=Ye:hr>Ye||Pr!=Qr;if(pe||zt){let ti=lt[0];ti!=null&&(Ot[0]=Ne,Yi[0]=Fe,Rh(ti,rt,Et,Mt),Th(ti,gt,Qe),er(ti,Rn(Ne),Rn(Fe),B,Ce))}}}if(Gt.show&&Rr)if(_!=null){let[de,Se]=di.scales,[Ie,Ne]=di.match,[Fe,rt]=_.cursor.sync.scales,Et=_.cursor.drag;if(Ri=Et._x,Ci=Et._y,Ri||Ci){let{left:Mt,top:gt,width:Qe,height:Ye}=_.select,zt=_.scales[Fe].ori,ti=_.posToVal,Li,Lt,ii,un,Zi,wn=de!=null&&Ie(de,Fe),Un=Se!=null&&Ne(Se,rt);wn&&Ri?(zt==0?(Li=Mt,Lt=Qe):(Li=gt,Lt=Ye),ii=M[de],un=k(ti(Li,Fe),ii,Z,0),Zi=k(ti(Li+Lt,Fe),ii,Z,0),Bo(Gn(un,Zi),yi(Zi-un))):Bo(0,Z),Un&&Ci?(zt==1?(Li=Mt,Lt=Qe):(Li=gt,Lt=Ye),ii=M[Se],un=N(ti(Li,rt),ii,oe,0),Zi=N(ti(Li+Lt,rt),ii,oe,0),Go(Gn(un,Zi),yi(Zi-un))):Go(0,oe)}else xu()}else{let de=yi(Qf-$f),Se=yi(jf-Jf);if(D.ori==1){let rt=de;de=Se,Se=rt}Ri=Ui.x&&de>=Ui.dist,Ci=Ui.y&&Se>=Ui.dist;let Ie=Ui.uni;Ie!=null?Ri&&Ci&&(Ri=de>=Ie,Ci=Se>=Ie,!Ri&&!Ci&&(Se>de?Ci=!0:Ri=!0)):Ui.x&&Ui.y&&(Ri||Ci)&&(Ri=Ci=!0);let Ne,Fe;Ri&&(D.ori==0?(Ne=Rs,Fe=Bt):(Ne=Cs,Fe=Wt),Bo(Gn(Ne,Fe),yi(Fe-Ne)),Ci||Go(0,oe)),Ci&&(D.ori==1?(Ne=Rs,Fe=Bt):(Ne=Cs,Fe=Wt),Go(Gn(Ne,Fe),yi(Fe-Ne)),Ri||Bo(0,Z)),!Ri&&!Ci&&(Bo(0,0),Go(0,0))}if(Ui._x=Ri,Ui._y=Ci,_==null){if(L){if(hh!=null){let[de,Se]=di.scales;di.values[0]=de!=null?Jn(D.ori==0?Bt:Wt,de):null,di.values[1]=Se!=null?Jn(D.ori==1?Bt:Wt,Se):null}ko(Mu,i,Bt,Wt,B,Ce,I)}if(et){let de=L&&di.setSeries,Se=Oe.prox;Qr==null?hr<=Se&&$n(Pr,Ls,!0,de):hr>Se?$n(null,Ls,!0,de):Pr!=Qr&&$n(Pr,Ls,!0,de)}}pe&&(he.idx=I,pu()),b!==!1&&Pi("setCursor")}let Lr=null;Object.defineProperty(i,"rect",{get(){return Lr==null&&zo(!1),Lr}});function zo(_=!1){_?Lr=null:(Lr=x.getBoundingClientRect(),Pi("syncRect",Lr))}function ih(_,b,L,I,V,Z,oe){fe._lock||Rr&&_!=null&&_.movementX==0&&_.movementY==0||(mu(_,b,L,I,V,Z,oe,!1,_!=null),_!=null?jr(null,!0,!0):jr(b,!0,!1))}function mu(_,b,L,I,V,Z,oe,de,Se){if(Lr==null&&zo(!1),je(_),_!=null)L=_.clientX-Lr.left,I=_.clientY-Lr.top;else{if(L<0||I<0){Bt=-10,Wt=-10;return}let[Ie,Ne]=di.scales,Fe=b.cursor.sync,[rt,Et]=Fe.values,[Mt,gt]=Fe.scales,[Qe,Ye]=di.match,zt=b.axes[0].side%2==1,ti=D.ori==0?B:Ce,Li=D.ori==1?B:Ce,Lt=zt?Z:V,ii=zt?V:Z,un=zt?I:L,Zi=zt?L:I;if(Mt!=null?L=Qe(Ie,Mt)?a(rt,M[Ie],ti,0):-10:L=ti*(un/Lt),gt!=null?I=Ye(Ne,gt)?a(Et,M[Ne],Li,0):-10:I=Li*(Zi/ii),D.ori==1){let wn=L;L=I,I=wn}}Se&&(b==null||b.cursor.event.type==Mu)&&((L<=1||L>=B-1)&&(L=is(L,B)),(I<=1||I>=Ce-1)&&(I=is(I,Ce))),de?($f=L,Jf=I,[Rs,Cs]=fe.move(i,L,I)):(Bt=L,Wt=I)}let gu={width:0,height:0,left:0,top:0};function xu(){ol(gu,!1)}let nh,rh,sh,oh;function ah(_,b,L,I,V,Z,oe){Rr=!0,Ri=Ci=Ui._x=Ui._y=!1,mu(_,b,L,I,V,Z,oe,!0,!1),_!=null&&(St(yu,Au,lh,!1),ko(vh,i,Rs,Cs,B,Ce,null));let{left:de,top:Se,width:Ie,height:Ne}=Gt;nh=de,rh=Se,sh=Ie,oh=Ne}function lh(_,b,L,I,V,Z,oe){Rr=Ui._x=Ui._y=!1,mu(_,b,L,I,V,Z,oe,!1,!0);let{left:de,top:Se,width:Ie,height:Ne}=Gt,Fe=Ie>0||Ne>0,rt=nh!=de||rh!=Se||sh!=Ie||oh!=Ne;if(Fe&&rt&&ol(Gt),Ui.setScale&&Fe&&rt){let Et=de,Mt=Ie,gt=Se,Qe=Ne;if(D.ori==1&&(Et=Se,Mt=Ne,gt=de,Qe=Ie),Ri&&Cr(T,Jn(Et,T),Jn(Et+Mt,T)),Ci)for(let Ye in M){let zt=M[Ye];Ye!=T&&zt.from==null&&zt.min!=It&&Cr(Ye,Jn(gt+Qe,Ye),Jn(gt,Ye))}xu()}else fe.lock&&(fe._lock=!fe._lock,jr(b,!0,_!=null));_!=null&&(vi(yu,Au),ko(yu,i,Bt,Wt,B,Ce,null))}function U_(_,b,L,I,V,Z,oe){if(fe._lock)return;je(_);let de=Rr;if(Rr){let Se=!0,Ie=!0,Ne=10,Fe,rt;D.ori==0?(Fe=Ri,rt=Ci):(Fe=Ci,rt=Ri),Fe&&rt&&(Se=Bt<=Ne||Bt>=B-Ne,Ie=Wt<=Ne||Wt>=Ce-Ne),Fe&&Se&&(Bt=Bt<Rs?0:B),rt&&Ie&&(Wt=Wt<Cs?0:Ce),jr(null,!0,!0),Rr=!1}Bt=-10,Wt=-10,ne.fill(null),jr(null,!0,!0),de&&(Rr=de)}function ch(_,b,L,I,V,Z,oe){fe._lock||(je(_),Oo(),xu(),_!=null&&ko(yh,i,Bt,Wt,B,Ce,null))}function uh(){A.forEach(IS),O(i.width,i.height,!0)}ss(hl,Fs,uh);let Ds={};Ds.mousedown=ah,Ds.mousemove=ih,Ds.mouseup=lh,Ds.dblclick=ch,Ds.setSeries=(_,b,L,I)=>{let V=di.match[2];L=V(i,b,L),L!=-1&&$n(L,I,!0,!1)},me&&(St(vh,x,ah),St(Mu,x,ih),St(Sh,x,_=>{je(_),zo(!1)}),St(Mh,x,U_),St(yh,x,ch),Uu.add(i),i.syncRect=zo);let al=i.hooks=n.hooks||{};function Pi(_,b,L){Ki?Ct.push([_,b,L]):_ in al&&al[_].forEach(I=>{I.call(null,i,b,L)})}(n.plugins||[]).forEach(_=>{for(let b in _.hooks)al[b]=(al[b]||[]).concat(_.hooks[b])});let fh=(_,b,L)=>L,di=pi({key:null,setSeries:!1,filters:{pub:Ih,sub:Ih},scales:[T,v[1]?v[1].scale:null],match:[Nh,Nh,fh],values:[null,null]},fe.sync);di.match.length==2&&di.match.push(fh),fe.sync=di;let hh=di.key,_u=Pd(hh);function ko(_,b,L,I,V,Z,oe){di.filters.pub(_,b,L,I,V,Z,oe)&&_u.pub(_,b,L,I,V,Z,oe)}_u.sub(i);function F_(_,b,L,I,V,Z,oe){di.filters.sub(_,b,L,I,V,Z,oe)&&Ds[_](null,b,L,I,V,Z,oe)}i.pub=F_;function O_(){_u.unsub(i),Uu.delete(i),Ai.clear(),Pu(hl,Fs,uh),c.remove(),Ae?.remove(),Pi("destroy")}i.destroy=O_;function vu(){Pi("init",n,e),Fo(e||n.data,!1),W[T]?fu(T,W[T]):Oo(),ie=Gt.show&&(Gt.width>0||Gt.height>0),ee=pe=!0,O(n.width,n.height)}return v.forEach(ys),A.forEach(lr),t?t instanceof HTMLElement?(t.appendChild(c),vu()):t(i,vu):vu(),i}si.assign=pi;si.fmtNum=Vu;si.rangeNum=dl;si.rangeLog=gl;si.rangeAsinh=zu;si.orient=as;si.pxRatio=wt;si.join=Ev;si.fmtDate=Wu,si.tzDate=Uv;si.sync=Pd;{si.addGap=xS,si.clipGaps=vl;let n=si.paths={points:Fd};n.linear=Bd,n.stepped=SS,n.bars=MS,n.spline=bS}var gr=["circumferential","radial","axial"],NS={circumferential:"#d55e00",radial:"#0072b2",axial:"#009e73"},Ws={1:{word:"front flank",colour:"#e8b400"},"-1":{word:"back flank",colour:"#b0489a"},2:{word:"both flanks",colour:"#7a5a2a"},0:{word:"no contact",colour:"#8a8f98"}},Vd=["#93a9c1","#c1ab8b","#93b5a0","#ad9fc2","#c4a0a0","#8cb0bb"],Hd={shaft:"#b3b9bf",bearing:"#6b7885",housing:"#9fb3c6",carrier:"#b9b39c",body:"#a9b6c0"};function qd(n,e){return n==="gear"?Vd[e%Vd.length]:Hd[n]??Hd.body}function Zo(n,e){return getComputedStyle(n).getPropertyValue(`--pp-force-${e}`).trim()||NS[e]}var Wd=["#3a8fd4","#8a68c4","#a88a1e","#2296a0","#d2484f","#6b8e23","#8a8f98"],Yd=n=>gr.some(e=>n.startsWith(`${e}_force`));function bl(n,e,t){let i=gr.find(r=>e.startsWith(`${r}_force`));return i?Zo(n,i):Wd[t%Wd.length]}var Xd=["#d2484f","#a88a1e","#8a68c4","#2296a0","#2f9e62"];function El(n,e){return Xd[Math.max(n.indexOf(e),0)%Xd.length]}function zi(n,e=4){if(!Number.isFinite(n))return"\u2013";if(n===0)return"0";let t=Math.abs(n),i=t>=1e6||t<1e-4?t.toExponential(e-1).replace("e+","e"):US(t.toPrecision(e));return(n<0?"\u2212":"")+i}function US(n){let e=String(Number(n));return n.includes(".")&&!n.includes("e")?n:e}function Kd(n){let e=n>0?3-Math.floor(Math.log10(n)):0;return e>9||e<-6?t=>zi(t,4):t=>t.toFixed(Math.max(0,e)).replace(/^-(0(\.0*)?)$/,"$1").replace("-","\u2212")}function Ju(n,e,t=n){let i=Math.abs(t),[r,s]=i>=1e6?[1e-6,"M"]:i>=1e3?[.001,"k"]:[1,""],o=n*r,a=Math.abs(t*r)>=100?1:Math.abs(t*r)>=10?2:3;return`${o<0?"\u2212":""}${Math.abs(o).toFixed(a)}\u2009${s}${e}`}var FS=[[1,"m"],[.001,"mm"],[1e-6,"\xB5m"],[1e-9,"nm"]],OS=[[1,"s"],[.001,"ms"],[1e-6,"\xB5s"]];function Zd(n,e,t){let[i,r]=e.find(([s])=>Math.abs(n)>=s*.999)??e[e.length-1];return`${zi(n/i,t)}\u2009${r}`}var $d=n=>Zd(n,FS,1).replace(/\.0+(?=\D)/,""),Jd=n=>n===0?"0\u2009s":Zd(n,OS,3);function $o(n,e){let t=Math.abs(e)<5e-4,i=Math.max(0,Math.min(6,Math.ceil(-Math.log10(Math.max(e,1e-12)*(t?1e3:1)))));return`${(n*(t?1e3:1)).toFixed(i).replace("-","\u2212")}\u2009${t?"ms":"s"}`}function Qd(n){if(n>=.999)return"real time";let e=1/n;return`1/${e<10?String(Number(e.toPrecision(2))):String(Math.round(e)).replace(/\B(?=(\d{3})+$)/g,"\u2009")} of real time`}var jd=84;function BS(n){let{data:e}=n.times;if(!n.most||e.length<2)return Float64Array.from(e);let t=e.length;return Float64Array.from(e,(i,r)=>i+(r<t-1?e[r+1]-i:i-e[r-1])/2)}function ep(n,e){let t=n.scale??1;return Float64Array.from(e.data,i=>i*t)}function GS(n,e){let{times:t,least:i,most:r}=n,s=0,o=t.count;for(;o-s>1;){let l=s+o>>1;t.data[l]<=e?s=l:o=l}let a=n.scale??1;return{least:i.data[s]*a,most:(r??i).data[s]*a}}var wl=class{constructor(e,t,i,r){this.channels=e,this.marks=t,this.kinds=[...new Set(t.map(s=>s.kind))],this.full=i,this.x=i,this.seek=r,this.time=i[0],this.drawn=[],this.element=ae("div",{className:"ppv-plots"}),this.names=new Set(e.flat().filter(s=>s.first).map(s=>s.name)),this.order=[...new Set(e.flat().map(s=>s.name))],this.onRemove=()=>{}}show(e,t){t?this.names.add(e):this.names.delete(e),this.build()}#e(){let e=new Map;for(let t of this.order){if(!this.names.has(t))continue;let i=this.channels.map(s=>s.find(o=>o.name===t)),r=(i.find(Boolean).shown_unit??i.find(Boolean).unit)||"1";e.has(r)||e.set(r,[]),e.get(r).push({name:t,found:i})}return e}build(){for(let{plot:t}of this.drawn)t.destroy();this.drawn=[],this.element.replaceChildren();let e=this.#e();this.ratio=window.devicePixelRatio||1,this.turns=[...e.values()].flat().map(({name:t})=>t).filter(t=>!Yd(t));for(let[t,i]of e){let r=ae("div",{className:"ppv-plot"}),s=ae("div",{className:"ppv-caption"}),o=ae("div",{className:"ppv-box"});r.append(s,o),this.element.append(r);let a=this.#t(t,i,o,s);this.drawn.push({...a,box:o})}e.size||this.element.append(ae("p",{className:"ppv-none"},this.order.length?"Choose a curve.":"This scene has no curves.")),this.resize(),this.cursor(this.time)}#t(e,t,i,r){let s=[],o=[{}],a=[],l=[],c=getComputedStyle(this.element);t.forEach(({name:p,found:v})=>{let A=bl(this.element,p,this.turns.indexOf(p)),M=ae("output",{}),R=v.find(Boolean);r.append(ae("span",{className:"ppv-curve"},ae("i",{style:`background:${A}`}),ae("span",{},R.label??p),M,ae("small",{},e==="1"?"":e),kt("\xD7",`Remove ${R.label??p}`,()=>{this.show(p,!1),this.onRemove()})));let T=Math.max(...v.filter(Boolean).map(g=>(g.scale??1)*Math.max(...[g.least,g.most??g.least].map(({data:E})=>E.reduce((U,P)=>Math.max(U,Math.abs(P)),0)))));l.push({values:M,found:v,digits:Kd(T)}),v.forEach((g,E)=>{if(!g)return;let P={stroke:A,width:1.4,dash:E?[6,4]:void 0,points:{show:!1},spanGaps:!0},D=[BS(g),ep(g,g.least)];g.most&&(D.push(ep(g,g.most)),a.push({series:[o.length+1,o.length],fill:`color-mix(in srgb, ${A} 30%, transparent)`}),o.push({...P,width:1})),o.push({...P,width:g.most?1:1.4}),s.push(D)})});let u=s.every(([p])=>p.length===s[0][0].length&&p.every((v,A)=>v===s[0][0][A]))?[s[0][0],...s.flatMap(([,...p])=>p)]:si.join(s.map(p=>p.map(v=>Array.from(v)))),f=c.getPropertyValue("--v-soft").trim()||"#666",m=c.getPropertyValue("--v-grid").trim()||"#ddd",x={stroke:f,grid:{stroke:m,width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},S=new si({width:300,height:jd,padding:[6,30,0,0],series:o,bands:a,legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,range:()=>this.x},y:{range:(p,v,A)=>zS(v,A)}},axes:[{...x,size:22,gap:3,values:(p,v)=>tp(v,"s")},{...x,size:62,gap:4,space:24,values:(p,v)=>tp(v)}],hooks:{draw:[p=>this.#i(p)]}},u,i),d=ae("div",{className:"ppv-cursor"});return S.over.append(d),this.#n(S),{plot:S,line:d,shows:l}}#i(e){let{left:t,top:i,width:r}=e.bbox,s=-9;for(let o of this.marks){let a=e.valToPos(o.time,"x",!0);a<t||a>t+r||a-s<1||(s=a,e.ctx.fillStyle=El(this.kinds,o.kind),e.ctx.fillRect(a-this.ratio/2,i,1.2*this.ratio,6*this.ratio))}}#n(e){let{over:t}=e,i=s=>e.posToVal(s.clientX-t.getBoundingClientRect().left,"x"),r=!1;t.addEventListener("pointerdown",s=>{s.button||(r=!0,t.setPointerCapture?.(s.pointerId),this.seek(i(s)))}),t.addEventListener("pointermove",s=>r&&this.seek(i(s)));for(let s of["pointerup","pointercancel"])t.addEventListener(s,()=>r=!1);t.addEventListener("dblclick",()=>this.zoom(this.full)),t.addEventListener("wheel",s=>{if(!s.ctrlKey&&!s.shiftKey&&s.deltaY>0&&this.x===this.full)return;s.preventDefault();let o=i(s),a=Math.exp(Math.max(-1,Math.min(1,(s.deltaY||s.deltaX)*.002)));this.zoom([o+(this.x[0]-o)*a,o+(this.x[1]-o)*a])},{passive:!1})}zoom([e,t]){let[i,r]=this.full,s=t-e>=r-i;this.x=s?this.full:[Math.max(i,e),Math.min(r,t)];for(let{plot:o}of this.drawn)o.setData(o.data);this.cursor(this.time)}resize(){let e=this.element.clientHeight,i=Math.max(jd,Math.min(260,Math.floor(e/Math.max(1,this.drawn.length))-20-4));for(let{plot:r,box:s}of this.drawn)r.setSize({width:Math.max(120,s.clientWidth),height:i});this.cursor(this.time)}cursor(e){this.time=e;for(let{plot:t,line:i,shows:r}of this.drawn){let s=t.valToPos(e,"x");i.hidden=!(s>=-.5&&s<=t.over.clientWidth+.5),i.style.transform=`translateX(${s}px)`;for(let{values:o,found:a,digits:l}of r){let c=a.filter(Boolean).map(h=>{let{least:u,most:f}=GS(h,e);return u===f?l(u):`${l(u)} \u2026 ${l(f)}`}).join(" | ");o.textContent!==c&&(o.textContent=c)}}}};function zS(n,e){if(!(e>=n))return[0,1];let t=.06*(e-n||Math.abs(e)||1);return[n-t,e+t]}function tp(n,e=""){let t=Math.max(...n.map(Math.abs)),i=n.length>1?Math.abs(n[1]-n[0]):t,r=Math.max(0,Math.min(12,-Math.floor(Math.log10(i||1)+1e-9)));return r<12&&Math.abs(i*10**r-Math.round(i*10**r))>1e-6&&r++,n.map((s,o)=>{let a=t>=1e6||t>0&&t<1e-4?s.toExponential(2):s.toFixed(r);return(o===n.length-1&&e?`${a} ${e}`:a).replace(/^-(0(\.0+)?)$/,"$1").replace("-","\u2212")})}var Tl=class{constructor(e,t){this.spectra=e,this.names=[...new Set(e.flat().map(r=>r.channel))];let i=r=>t.flat().find(s=>s.name===r)?.label??r;this.name=this.names[0],this.box=ae("div",{className:"ppv-box"}),this.read=ae("output",{}),this.choice=dr("spectrum of",this.names.map(r=>[r,i(r)]),r=>{this.name=r,this.build()}),this.log=!0,this.element=ae("div",{className:"ppv-spectra"},ae("div",{className:"ppv-caption"},this.choice.row,this.read),this.box),this.element.hidden=!0}build(){this.plot?.destroy();let e=this.spectra.map(u=>u.find(f=>f.channel===this.name)),t=e.filter(Boolean).map(({frequency:u,amplitude:f})=>[Array.from(u.data),Array.from(f.data,m=>m>0?m:null)]),i=getComputedStyle(this.element),r=i.getPropertyValue("--v-soft").trim()||"#666",s=i.getPropertyValue("--v-grid").trim()||"#ddd",o={stroke:r,grid:{stroke:s,width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},a=bl(this.element,this.name,0),l=e.find(Boolean)?.unit??"",c=e.flatMap((u,f)=>u?[{stroke:a,width:1.2,dash:f?[6,4]:void 0,points:{show:!1},spanGaps:!0}]:[]),h=Math.max(...t.flatMap(([,u])=>u.map(f=>f??0)),1e-300);this.plot=new si({width:300,height:160,padding:[6,44,0,0],legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},series:[{},...c],scales:{x:{time:!1},y:{distr:3,range:(u,f)=>[Math.max(f,h*1e-8),h*1.6]}},axes:[{...o,size:22,gap:3,values:(u,f)=>f.map((m,x)=>x===f.length-1?`${m} Hz`:String(m))},{...o,size:62,gap:4,space:28,values:(u,f)=>f.map(m=>m===null?"":zi(m,2))}],hooks:{setCursor:[u=>{let f=u.cursor.idx,m=f==null?[]:u.data.slice(1).map(x=>zi(x[f]??NaN,3));this.read.textContent=m.length?`${zi(u.data[0][f],5)} Hz: ${m.join(" | ")} ${l}`:""}]}},t.length>1?si.join(t):t[0],this.box),this.resize()}resize(){this.element.hidden||!this.plot||this.plot.setSize({width:Math.max(120,this.box.clientWidth),height:Math.max(110,this.element.parentElement.clientHeight-28)})}};var Al=class{constructor(e,t,i,r){let s=e.map(o=>o.channels);this.plots=new wl(s,i,t,r),this.spectra=new Tl(e.map(o=>o.spectra),s),this.labels=new Map(s.flat().map(o=>[o.name,o.label??o.name])),this.search=ae("input",{type:"search",placeholder:`add a curve (${this.labels.size})`,"aria-label":"Search channels",title:"Channels, by any words of their names"}),this.list=ae("div",{className:"ppv-list",role:"listbox","aria-label":"Channels",hidden:!0}),this.search.addEventListener("focus",()=>this.fill()),this.search.addEventListener("input",()=>this.fill()),this.search.addEventListener("keydown",o=>{if(o.key==="Escape"&&this.close(),o.key==="Enter"||o.key==="ArrowDown"){let a=this.list.querySelector("button");o.key==="Enter"?a?.click():a?.focus(),o.preventDefault()}o.stopPropagation()}),this.list.addEventListener("keydown",o=>{let a={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[o.key];a&&(document.activeElement?.[a]??this.search).focus(),o.key==="Escape"&&this.close(),(a||o.key==="Escape")&&o.preventDefault(),o.stopPropagation()}),this.picker=ae("div",{className:"ppv-picker"},this.search,this.list),this.picker.addEventListener("focusout",o=>{this.picker.contains(o.relatedTarget)||this.close()}),this.tab=kt("Spectrum","Curves over time or spectrum",()=>this.turn()),this.tab.hidden=!this.spectra.names.length,this.plots.onRemove=()=>this.list.hidden||this.fill(),this.body=ae("div",{className:"ppv-curves-body"},this.plots.element,this.spectra.element),this.element=ae("div",{className:"ppv-curves"},ae("div",{className:"ppv-bar"},this.picker,this.tab),this.body),this.element.hidden=!this.labels.size&&!this.spectra.names.length}matches(){let e=this.search.value.toLowerCase().split(/\s+/).filter(Boolean);return[...this.labels].filter(([t,i])=>{let r=`${t} ${i}`.toLowerCase();return e.every(s=>r.includes(s))})}fill(){let e=this.matches();this.list.replaceChildren(...e.slice(0,200).map(([t,i])=>{let r=this.plots.names.has(t);return ae("button",{type:"button",role:"option","aria-selected":String(r),title:t,onclick:s=>{this.plots.show(t,!this.plots.names.has(t)),s.currentTarget.setAttribute("aria-selected",String(this.plots.names.has(t)))}},i)})),e.length||this.list.append(ae("p",{},"No channel has these words.")),e.length>200&&this.list.append(ae("p",{},`${e.length-200} more: search for words of their names.`)),this.list.hidden=!1}close(){this.list.hidden=!0}turn(){if(!this.spectra.names.length)return;let e=this.spectra.element.hidden;this.spectra.element.hidden=!e,this.plots.element.hidden=e,this.tab.textContent=e?"Curves":"Spectrum",this.picker.style.visibility=e?"hidden":"",e?this.spectra.build():this.resize()}build(){this.element.hidden||(this.plots.build(),this.spectra.element.hidden||this.spectra.build())}resize(){this.element.hidden||(this.plots.element.hidden||this.plots.resize(),this.spectra.resize())}};var Rl=class{constructor(e,t,i){this.stage=e,this.label=ae("div",{className:"ppv-label",hidden:!0}),this.at=null,this.waiting=!1;let{canvas:r}=e;r.addEventListener("pointermove",s=>{this.at=t.dragging||s.pointerType==="touch"?null:{x:s.clientX,y:s.clientY},this.waiting||setTimeout(()=>this.#e(),60),this.waiting=!0}),r.addEventListener("pointerleave",()=>{this.at=null,this.label.hidden=!0}),r.addEventListener("dblclick",s=>{let o=e.hit(s.clientX,s.clientY);o&&i(o.part.solid.body)})}#e(){this.waiting=!1;let e=this.at&&this.stage.hit(this.at.x,this.at.y);if(this.label.hidden=!e,!e)return;let{solid:t}=e.part;this.label.textContent=kS(t);let i=this.stage.canvas.getBoundingClientRect(),r=Math.min(this.at.x-i.left+14,i.width-this.label.offsetWidth-4);this.label.style.transform=`translate(${r}px, ${Math.max(0,this.at.y-i.top-26)}px)`}};function kS(n){let e=n.name.replaceAll("_"," ");return n.teeth?`${e}, ${n.kind} of ${n.teeth} teeth`:e===n.kind?e:`${e}, ${n.kind}`}function tr(n,e){let t=n.length;if(t<2||e<=n[0])return{low:0,share:0};if(e>=n[t-1])return{low:t-2,share:1};let i=0,r=t-1;for(;r-i>1;){let o=i+r>>1;n[o]<=e?i=o:r=o}let s=n[i+1]-n[i];return{low:i,share:s>0?(e-n[i])/s:0}}function zn(n,e,t=0){let{data:i,width:r,count:s}=n;if(s===1)return i[t];let o=e.low*r+t;return e.share?i[o]+e.share*(i[o+r]-i[o]):i[o]}function Cl(n){let e=new Float64Array(n.width);for(let t=0;t<n.data.length;t++)e[t%n.width]+=n.data[t];return e.map(t=>t/Math.max(n.count,1))}var Jo=1e-4;function Qo(n){let e=10**Math.floor(Math.log10(n)),t=n/e;return e*(t<1.5?1:t<3.5?2:t<7.5?5:10)}var Pl=class{constructor(e,t){this.times=e,this.poses=t,this.first=e.length?e[0]:0,this.last=e.length?e[e.length-1]:0,this.time=this.first,this.playing=!1,this.loop="record",this.window=[this.first,this.last],this.body=-1,this.speed=this.#e()}#e(){let e=this.last-this.first,t=0,i=[tr(this.times,this.first),tr(this.times,this.last)];this.poses?.bodies.forEach((s,o)=>{t=Math.max(t,Math.abs(this.poses.angle(o,i[1])-this.poses.angle(o,i[0])))});let r=e>0?t>1?2*Math.PI*e/t/3:e/10:1;return Qo(Math.max(Jo,Math.min(1,r)))}seek(e){this.time=Math.max(this.first,Math.min(this.last,e))}advance(e){if(!this.playing)return;let[t,i]=this.window,r=this.time+e*this.speed;r<t&&(r=t),r>i&&(r=i>t?t+(r-t)%(i-t):t),this.time=r}step(e){this.playing=!1;let{low:t,share:i}=tr(this.times,this.time),r=t+i,s=e>0?Math.floor(r+1e-9)+e:Math.ceil(r-1e-9)+e;this.time=this.times[Math.max(0,Math.min(this.times.length-1,s))]??0}get frame(){let{low:e,share:t}=tr(this.times,this.time);return e+t}reference(e,t){let i=s=>this.poses&&Math.abs(this.poses.angle(s,tr(this.times,this.last))-this.poses.angle(s,tr(this.times,this.first)))>0;if(e>=0&&i(e))return e;let r=t.find(s=>s.teeth&&i(s.body));return r?r.body:this.poses?.bodies.findIndex((s,o)=>i(o))??-1}repeat(e,t,i){if(this.loop="record",this.window=[this.first,this.last],e==="record")return"";let r=this.reference(t,i);if(r<0)return"No body of this scene turns.";let s=i.find(u=>u.body===r&&u.teeth)?.teeth;if(e==="cycle"&&!s)return"The followed body is not a gear.";let o=2*Math.PI/(e==="cycle"?s:1),a=u=>this.poses.angle(r,tr(this.times,u));if(Math.abs(a(this.last)-a(this.first))<o)return"The record is shorter than that.";let c=this.time;Math.abs(a(this.last)-a(c))<o&&(c=this.#t(u=>Math.abs(a(this.last)-a(u))<=o,this.first,this.last));let h=this.#t(u=>Math.abs(a(u)-a(c))>=o,c,this.last);return this.loop=e,this.body=r,this.window=[c,h],this.seek(c),""}#t(e,t,i){for(let r=0;r<60;r++){let s=(t+i)/2;e(s)?i=s:t=s}return i}};var ip=[["space","play, pause"],["\u2190 \u2192","one frame back, on"],["Home, End","start, end"],["+ \u2212","faster, slower"],["[ ]","mark before, next mark"],["f","show all"],["1 \u2026 9, 0","follow a body, none"],["s","section"],["m","vibrations \xD71, \xD710, \xD7100, \xD71000"],["drag","turn; right button or shift: move"],["wheel","zoom to the pointer"],["double click","follow the body of a part"]];function np(n){let e={" ":()=>n.toggle(),ArrowLeft:()=>n.step(-1),ArrowRight:()=>n.step(1),Home:()=>n.seek(n.player.window[0]),End:()=>n.seek(n.player.window[1]),"+":()=>Qu(n,2.1),"=":()=>Qu(n,2.1),"-":()=>Qu(n,.47619047619047616),"[":()=>n.transport.toMark(-1),"]":()=>n.transport.toMark(1),f:()=>n.views?.fit(),s:()=>n.section?.turn(!n.section.on),m:()=>VS(n),Escape:()=>n.panels.close()};n.root.tabIndex=-1,document.addEventListener("keydown",t=>{if(t.ctrlKey||t.metaKey||t.altKey||t.defaultPrevented)return;let{target:i}=t,r=n.root.contains(i),s=i===document.body&&n.fills;if(!(!r&&!s||i.matches?.("select, input[type=search], input[type=text]")||i.matches?.("input[type=range]")&&i!==n.transport.range&&/^(Arrow|Home|End)/.test(t.key))&&!(t.key===" "&&i.matches?.("button, input[type=checkbox]"))){if(/^[0-9]$/.test(t.key))n.follow(Number(t.key)-1);else if(e[t.key])e[t.key]();else return;t.preventDefault()}})}function Qu(n,e){let{player:t,transport:i}=n;t.speed=Math.max(Jo,Math.min(1,Qo(t.speed*e))),i.speed.set(t.speed)}function VS(n){if(!n.magnification)return;let e=n.stage.pictures[0].poses.magnification,t=e>=1e3?1:e>=100?1e3:e>=10?100:10;n.magnification.set(t),n.magnify(t)}var Ll=class{constructor(e){this.arrows=e,this.columns=gr.filter(i=>e.some(r=>r.components?.[i])),this.rows=e.map(i=>{let r=i.state?ae("span",{className:"ppv-state"}):null,s=this.columns.map(a=>ae("td",{className:`ppv-${a}`})),o=i.name.replaceAll("_"," ");return{state:r,cells:s,said:null,row:ae("tr",{},ae("th",{scope:"row",title:`${i.kind} ${o}`},r,o),...s)}});let t=ae("tr",{},ae("td"),...this.columns.map(i=>ae("th",{scope:"col",className:`ppv-${i}`},ae("i"),i)));if(this.states=ae("div",{className:"ppv-states"}),e.some(i=>i.state)){let i=new Set(e.flatMap(r=>[...r.state?.data??[]]).map(r=>r===255?-1:r));for(let{word:r,colour:s}of[1,-1,2,0].filter(o=>i.has(o)).map(o=>Ws[o]))this.states.append(ae("span",{},ae("i",{style:`background:${s}`}),r))}this.element=ae("div",{className:"ppv-legend",tabindex:"0",role:"region","aria-label":"Forces now"},ae("table",{},ae("thead",{},t),ae("tbody",{},...this.rows.map(({row:i})=>i))),this.states),this.element.hidden=!e.length}update(e,t,i){this.element.hidden=i||!e.some(r=>t.has(r.kind)),!this.element.hidden&&e.forEach((r,s)=>{let{row:o,cells:a,state:l}=this.rows[s];if(o.hidden=!t.has(r.kind),!o.hidden&&(this.columns.forEach((c,h)=>{let u=c in r.values?Ju(r.values[c],r.unit,this.arrows[s].size||r.values[c]):"";a[h].textContent!==u&&(a[h].textContent=u)}),l&&this.rows[s].said!==r.state)){let{word:c,colour:h}=Ws[r.state]??Ws[0];this.rows[s].said=r.state,l.style.background=h,l.title=c,l.setAttribute("aria-label",c)}})}lines(e,t){return e.map((i,r)=>({each:i,size:this.arrows[r].size})).filter(({each:i})=>t.has(i.kind)).map(({each:i,size:r})=>({name:i.name.replaceAll("_"," "),values:this.columns.filter(s=>s in i.values).map(s=>({part:s,text:Ju(i.values[s],i.unit,r||i.values[s])}))}))}};var HS=1.6,WS=.06,Dl=class{constructor(e,t,i){this.modes=e,this.changed=i,this.stage=t,this.number=-1,this.phase=0,this.amplitude=1,this.unit=e.map(s=>this.#t(s)),this.buttons=e.map((s,o)=>kt("",`Swing in ${s.name}`,()=>this.choose(this.number===o?-1:o),{"aria-pressed":"false"})),this.buttons.forEach((s,o)=>s.append(ae("span",{},e[o].name),ae("span",{},this.#e(e[o])))),this.stop=kt("back to the record","End the mode shape",()=>this.choose(-1)),this.stop.hidden=!0;let r=ts({label:"amplitude",title:"Amplitude of the mode shape",least:.05,most:20,value:1,show:s=>`\xD7 ${zi(s,2)}`,changed:s=>{this.amplitude=s,this.changed()}});this.rows=[ae("div",{className:"ppv-modes"},...this.buttons),r.row,this.stop]}#e({frequency:e,damping:t}){return`${zi(e,4)} Hz${t==null?"":`, ${zi(100*t,2)} %`}`}#t(e){let{solids:t,bounds:i}=this.stage.pictures[0],r=0,s=(o,a)=>{let l=0;for(let c=0;c<6;c++)l+=o?o.data[6*a+c]**2:0;return Math.sqrt(l)};return this.stage.pictures[0].data.bodies.forEach((o,a)=>{let l=t.reachOf(a);r=Math.max(r,s(e.position,a)+s(e.turn,a)*(l||.1*i.radius))}),r>0?WS*i.radius/r:0}get active(){return this.number>=0}get words(){return this.active?`${this.modes[this.number].name}, ${this.#e(this.modes[this.number])}`:""}choose(e){this.number=e,this.phase=0,this.buttons.forEach((t,i)=>t.setAttribute("aria-pressed",String(i===e))),this.stop.hidden=e<0,this.changed()}advance(e){this.active&&(this.phase=(this.phase+2*Math.PI*e/HS)%(2*Math.PI))}pose({poses:e}){e.ofMode(this.modes[this.number],this.phase,this.amplitude*this.unit[this.number])}};var rp=0,ju=1,sp=2;var Xs=1,op=2,ls=3,nn=0,$t=1,ji=2,ir=0,Nr=1,ef=2,tf=3,nf=4,ap=5;var Ur=100,lp=101,cp=102,up=103,fp=104,hp=200,dp=201,pp=202,mp=203,Il=204,Nl=205,gp=206,xp=207,_p=208,vp=209,Sp=210,Mp=211,yp=212,bp=213,Ep=214,jo=0,ea=1,ta=2,Fr=3,ia=4,na=5,ra=6,sa=7,qs=0,wp=1,Tp=2,gn=0,Ul=1,Fl=2,Ol=3,Bl=4,Gl=5,zl=6,kl=7;var rf=300,nr=301,Or=302,Vl=303,Hl=304,oa=1e3,rn=1001,aa=1002,Xt=1003,Ap=1004;var la=1005;var mi=1006,Wl=1007;var xn=1008;var oi=1009,Xl=1010,ql=1011,xr=1012,Ys=1013,gi=1014,xi=1015,Di=1016,Ks=1017,Zs=1018,kn=1020,Yl=35902,Kl=35899,Zl=1021,$l=1022,bi=1023,sn=1026,_n=1027,Jl=1028,Br=1029,vn=1030,$s=1031;var Js=1033,Qs=33776,js=33777,eo=33778,to=33779,ca=35840,ua=35841,fa=35842,ha=35843,da=36196,pa=37492,ma=37496,ga=37488,xa=37489,cs=37490,_a=37491,va=37808,Sa=37809,Ma=37810,ya=37811,ba=37812,Ea=37813,wa=37814,Ta=37815,Aa=37816,Ra=37817,Ca=37818,Pa=37819,La=37820,Da=37821,Ia=36492,Na=36494,Ua=36495,Fa=36283,Oa=36284,us=36285,Ba=36286;var Rp=3200;var Ga=0,Cp=1,Cn="",en="srgb",fs="srgb-linear",hs="linear",vt="srgb";var Ql=7680;var Pp=519,Lp=512,Dp=513,Ip=514,jl=515,Np=516,Up=517,ec=518,tc=519,Fp=35044;var sf="300 es",Fi=2e3,_r=2001;function Bp(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function no(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Gp(){let n=no("canvas");return n.style.display="block",n}var Op={},io=null;function of(...n){let e="THREE."+n.shift();io?io("log",e,...n):console.log(e,...n)}function zp(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ze(...n){n=zp(n);let e="THREE."+n.shift();if(io)io("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function ht(...n){n=zp(n);let e="THREE."+n.shift();if(io)io("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ds(...n){let e=n.join(" ");e in Op||(Op[e]=!0,ze(...n))}function kp(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var Vp={[jo]:jo,[ta]:ra,[ia]:ia,[Fr]:na,[ea]:ea,[ra]:ta,[sa]:sa,[na]:Fr};var ki=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}};var Vi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var ic=Math.PI/180,za=180/Math.PI;function rr(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Vi[n&255]+Vi[n>>8&255]+Vi[n>>16&255]+Vi[n>>24&255]+"-"+Vi[e&255]+Vi[e>>8&255]+"-"+Vi[e>>16&15|64]+Vi[e>>24&255]+"-"+Vi[t&63|128]+Vi[t>>8&255]+"-"+Vi[t>>16&255]+Vi[t>>24&255]+Vi[i&255]+Vi[i>>8&255]+Vi[i>>16&255]+Vi[i>>24&255]).toLowerCase()}function ct(n,e,t){return Math.max(e,Math.min(t,n))}function Hp(n,e){return(n%e+e)%e}function nc(n,e,t){return(1-t)*n+t*e}function Wp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function rc(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Xp(n,e){if(e.constructor===Float32Array)return n;let t=rc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function qp(n,e){if(e.constructor===Float32Array)return n;let t=rc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Ze=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};var qt=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let l=i[r+0],c=i[r+1],h=i[r+2],u=i[r+3],f=s[o+0],m=s[o+1],x=s[o+2],S=s[o+3];if(u!==S||l!==f||c!==m||h!==x){let d=l*f+c*m+h*x+u*S;d<0&&(f=-f,m=-m,x=-x,S=-S,d=-d);let p=1-a;if(d<.9995){let v=Math.acos(d),A=Math.sin(v);p=Math.sin(p*v)/A,a=Math.sin(a*v)/A,l=l*p+f*a,c=c*p+m*a,h=h*p+x*a,u=u*p+S*a}else{l=l*p+f*a,c=c*p+m*a,h=h*p+x*a,u=u*p+S*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],l=i[r+1],c=i[r+2],h=i[r+3],u=s[o],f=s[o+1],m=s[o+2],x=s[o+3];return e[t]=a*x+h*u+l*m-c*f,e[t+1]=l*x+h*f+c*u-a*m,e[t+2]=c*x+h*m+a*f-l*u,e[t+3]=h*x-a*u-l*f-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(r/2),u=a(s/2),f=l(i/2),m=l(r/2),x=l(s/2);switch(o){case"XYZ":this._x=f*h*u+c*m*x,this._y=c*m*u-f*h*x,this._z=c*h*x+f*m*u,this._w=c*h*u-f*m*x;break;case"YXZ":this._x=f*h*u+c*m*x,this._y=c*m*u-f*h*x,this._z=c*h*x-f*m*u,this._w=c*h*u+f*m*x;break;case"ZXY":this._x=f*h*u-c*m*x,this._y=c*m*u+f*h*x,this._z=c*h*x+f*m*u,this._w=c*h*u-f*m*x;break;case"ZYX":this._x=f*h*u-c*m*x,this._y=c*m*u+f*h*x,this._z=c*h*x-f*m*u,this._w=c*h*u+f*m*x;break;case"YZX":this._x=f*h*u+c*m*x,this._y=c*m*u+f*h*x,this._z=c*h*x-f*m*u,this._w=c*h*u-f*m*x;break;case"XZY":this._x=f*h*u-c*m*x,this._y=c*m*u-f*h*x,this._z=c*h*x+f*m*u,this._w=c*h*u+f*m*x;break;default:ze("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],f=i+a+u;if(f>0){let m=.5/Math.sqrt(f+1);this._w=.25/m,this._x=(h-l)*m,this._y=(s-c)*m,this._z=(o-r)*m}else if(i>a&&i>u){let m=2*Math.sqrt(1+i-a-u);this._w=(h-l)/m,this._x=.25*m,this._y=(r+o)/m,this._z=(s+c)/m}else if(a>u){let m=2*Math.sqrt(1+a-i-u);this._w=(s-c)/m,this._x=(r+o)/m,this._y=.25*m,this._z=(l+h)/m}else{let m=2*Math.sqrt(1+u-i-a);this._w=(o-r)/m,this._x=(s+c)/m,this._y=(l+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+o*a+r*c-s*l,this._y=r*h+o*l+s*a-i*c,this._z=s*h+o*c+i*l-r*a,this._w=o*h-i*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}};var F=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Yp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Yp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*i),h=2*(a*t-s*r),u=2*(s*i-o*t);return this.x=t+l*c+o*u-a*h,this.y=i+l*h+a*c-s*u,this.z=r+l*u+s*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-i*l,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return af.copy(this).projectOnVector(e),this.sub(af)}reflect(e){return this.sub(af.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},af=new F,Yp=new qt;var Ke=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c)}set(e,t,i,r,s,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=r,h[2]=a,h[3]=t,h[4]=s,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],f=i[2],m=i[5],x=i[8],S=r[0],d=r[3],p=r[6],v=r[1],A=r[4],M=r[7],R=r[2],T=r[5],g=r[8];return s[0]=o*S+a*v+l*R,s[3]=o*d+a*A+l*T,s[6]=o*p+a*M+l*g,s[1]=c*S+h*v+u*R,s[4]=c*d+h*A+u*T,s[7]=c*p+h*M+u*g,s[2]=f*S+m*v+x*R,s[5]=f*d+m*A+x*T,s[8]=f*p+m*M+x*g,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-i*s*h+i*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,f=a*l-h*s,m=c*s-o*l,x=t*u+i*f+r*m;if(x===0)return this.set(0,0,0,0,0,0,0,0,0);let S=1/x;return e[0]=u*S,e[1]=(r*c-h*i)*S,e[2]=(a*i-r*o)*S,e[3]=f*S,e[4]=(h*t-r*l)*S,e[5]=(r*s-a*t)*S,e[6]=m*S,e[7]=(i*l-c*t)*S,e[8]=(o*t-i*s)*S,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return ds("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(lf.makeScale(e,t)),this}rotate(e){return ds("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(lf.makeRotation(-e)),this}translate(e,t){return ds("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(lf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},lf=new Ke;var Kp=new Ke().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Zp=new Ke().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function XS(){let n={enabled:!0,workingColorSpace:fs,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===vt&&(r.r=Vn(r.r),r.g=Vn(r.g),r.b=Vn(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===vt&&(r.r=ps(r.r),r.g=ps(r.g),r.b=ps(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Cn?hs:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[fs]:{primaries:e,whitePoint:i,transfer:hs,toXYZ:Kp,fromXYZ:Zp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:en},outputColorSpaceConfig:{drawingBufferColorSpace:en}},[en]:{primaries:e,whitePoint:i,transfer:vt,toXYZ:Kp,fromXYZ:Zp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:en}}}),n}var it=XS();function Vn(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ps(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ro,sc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{ro===void 0&&(ro=no("canvas")),ro.width=e.width,ro.height=e.height;let r=ro.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=ro}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=no("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Vn(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Vn(t[i]/255)*255):t[i]=Vn(t[i]);return{data:t,width:e.width,height:e.height}}else return ze("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}};var qS=0,Gr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:qS++}),this.uuid=rr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(cf(r[o].image)):s.push(cf(r[o]))}else s=cf(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function cf(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?sc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ze("Texture: Unable to serialize Texture."),{})}var YS=0,uf=new F,ai=class n extends ki{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=rn,r=rn,s=mi,o=xn,a=bi,l=oi,c=n.DEFAULT_ANISOTROPY,h=Cn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:YS++}),this.uuid=rr(),this.name="",this.source=new Gr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ze(0,0),this.repeat=new Ze(1,1),this.center=new Ze(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ke,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(uf).x}get height(){return this.source.getSize(uf).y}get depth(){return this.source.getSize(uf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){ze(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){ze(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==rf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case oa:e.x=e.x-Math.floor(e.x);break;case rn:e.x=e.x<0?0:1;break;case aa:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case oa:e.y=e.y-Math.floor(e.y);break;case rn:e.y=e.y<0?0:1;break;case aa:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ai.DEFAULT_IMAGE=null;ai.DEFAULT_MAPPING=rf;ai.DEFAULT_ANISOTROPY=1;var bt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,l=e.elements,c=l[0],h=l[4],u=l[8],f=l[1],m=l[5],x=l[9],S=l[2],d=l[6],p=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-S)<.01&&Math.abs(x-d)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+S)<.1&&Math.abs(x+d)<.1&&Math.abs(c+m+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,M=(m+1)/2,R=(p+1)/2,T=(h+f)/4,g=(u+S)/4,E=(x+d)/4;return A>M&&A>R?A<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(A),r=T/i,s=g/i):M>R?M<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(M),i=T/r,s=E/r):R<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(R),i=g/s,r=E/s),this.set(i,r,s,t),this}let v=Math.sqrt((d-x)*(d-x)+(u-S)*(u-S)+(f-h)*(f-h));return Math.abs(v)<.001&&(v=1),this.x=(d-x)/v,this.y=(u-S)/v,this.z=(f-h)/v,this.w=Math.acos((c+m+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};var oc=class extends ki{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:mi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new bt(0,0,e,t),this.scissorTest=!1,this.viewport=new bt(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new ai({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:mi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Gr(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Oi=class extends oc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}};var so=class extends ai{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Xt,this.minFilter=Xt,this.wrapR=rn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ac=class extends ai{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Xt,this.minFilter=Xt,this.wrapR=rn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Ve=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,l,c,h,u,f,m,x,S,d){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c,h,u,f,m,x,S,d)}set(e,t,i,r,s,o,a,l,c,h,u,f,m,x,S,d){let p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=r,p[1]=s,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=u,p[14]=f,p[3]=m,p[7]=x,p[11]=S,p[15]=d,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/oo.setFromMatrixColumn(e,0).length(),s=1/oo.setFromMatrixColumn(e,1).length(),o=1/oo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(r),c=Math.sin(r),h=Math.cos(s),u=Math.sin(s);if(e.order==="XYZ"){let f=o*h,m=o*u,x=a*h,S=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=m+x*c,t[5]=f-S*c,t[9]=-a*l,t[2]=S-f*c,t[6]=x+m*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*h,m=l*u,x=c*h,S=c*u;t[0]=f+S*a,t[4]=x*a-m,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=m*a-x,t[6]=S+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*h,m=l*u,x=c*h,S=c*u;t[0]=f-S*a,t[4]=-o*u,t[8]=x+m*a,t[1]=m+x*a,t[5]=o*h,t[9]=S-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*h,m=o*u,x=a*h,S=a*u;t[0]=l*h,t[4]=x*c-m,t[8]=f*c+S,t[1]=l*u,t[5]=S*c+f,t[9]=m*c-x,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,m=o*c,x=a*l,S=a*c;t[0]=l*h,t[4]=S-f*u,t[8]=x*u+m,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=m*u+x,t[10]=f-S*u}else if(e.order==="XZY"){let f=o*l,m=o*c,x=a*l,S=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=f*u+S,t[5]=o*h,t[9]=m*u-x,t[2]=x*u-m,t[6]=a*h,t[10]=S*u+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(KS,e,ZS)}lookAt(e,t,i){let r=this.elements;return Sn.subVectors(e,t),Sn.lengthSq()===0&&(Sn.z=1),Sn.normalize(),zr.crossVectors(i,Sn),zr.lengthSq()===0&&(Math.abs(i.z)===1?Sn.x+=1e-4:Sn.z+=1e-4,Sn.normalize(),zr.crossVectors(i,Sn)),zr.normalize(),lc.crossVectors(Sn,zr),r[0]=zr.x,r[4]=lc.x,r[8]=Sn.x,r[1]=zr.y,r[5]=lc.y,r[9]=Sn.y,r[2]=zr.z,r[6]=lc.z,r[10]=Sn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],f=i[9],m=i[13],x=i[2],S=i[6],d=i[10],p=i[14],v=i[3],A=i[7],M=i[11],R=i[15],T=r[0],g=r[4],E=r[8],U=r[12],P=r[1],D=r[5],G=r[9],k=r[13],N=r[2],W=r[6],Y=r[10],H=r[14],ce=r[3],$=r[7],Q=r[11],ne=r[15];return s[0]=o*T+a*P+l*N+c*ce,s[4]=o*g+a*D+l*W+c*$,s[8]=o*E+a*G+l*Y+c*Q,s[12]=o*U+a*k+l*H+c*ne,s[1]=h*T+u*P+f*N+m*ce,s[5]=h*g+u*D+f*W+m*$,s[9]=h*E+u*G+f*Y+m*Q,s[13]=h*U+u*k+f*H+m*ne,s[2]=x*T+S*P+d*N+p*ce,s[6]=x*g+S*D+d*W+p*$,s[10]=x*E+S*G+d*Y+p*Q,s[14]=x*U+S*k+d*H+p*ne,s[3]=v*T+A*P+M*N+R*ce,s[7]=v*g+A*D+M*W+R*$,s[11]=v*E+A*G+M*Y+R*Q,s[15]=v*U+A*k+M*H+R*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],f=e[10],m=e[14],x=e[3],S=e[7],d=e[11],p=e[15],v=l*m-c*f,A=a*m-c*u,M=a*f-l*u,R=o*m-c*h,T=o*f-l*h,g=o*u-a*h;return t*(S*v-d*A+p*M)-i*(x*v-d*R+p*T)+r*(x*A-S*R+p*g)-s*(x*M-S*T+d*g)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-i*(s*h-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],f=e[10],m=e[11],x=e[12],S=e[13],d=e[14],p=e[15],v=t*a-i*o,A=t*l-r*o,M=t*c-s*o,R=i*l-r*a,T=i*c-s*a,g=r*c-s*l,E=h*S-u*x,U=h*d-f*x,P=h*p-m*x,D=u*d-f*S,G=u*p-m*S,k=f*p-m*d,N=v*k-A*G+M*D+R*P-T*U+g*E;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*k-l*G+c*D)*W,e[1]=(r*G-i*k-s*D)*W,e[2]=(S*g-d*T+p*R)*W,e[3]=(f*T-u*g-m*R)*W,e[4]=(l*P-o*k-c*U)*W,e[5]=(t*k-r*P+s*U)*W,e[6]=(d*M-x*g-p*A)*W,e[7]=(h*g-f*M+m*A)*W,e[8]=(o*G-a*P+c*E)*W,e[9]=(i*P-t*G-s*E)*W,e[10]=(x*T-S*M+p*v)*W,e[11]=(u*M-h*T-m*v)*W,e[12]=(a*U-o*D-l*E)*W,e[13]=(t*D-i*U+r*E)*W,e[14]=(S*A-x*R-d*v)*W,e[15]=(h*R-u*A+f*v)*W,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,l=e.z,c=s*o,h=s*a;return this.set(c*o+i,c*a-r*l,c*l+r*a,0,c*a+r*l,h*a+i,h*l-r*o,0,c*l-r*a,h*l+r*o,s*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,h=o+o,u=a+a,f=s*c,m=s*h,x=s*u,S=o*h,d=o*u,p=a*u,v=l*c,A=l*h,M=l*u,R=i.x,T=i.y,g=i.z;return r[0]=(1-(S+p))*R,r[1]=(m+M)*R,r[2]=(x-A)*R,r[3]=0,r[4]=(m-M)*T,r[5]=(1-(f+p))*T,r[6]=(d+v)*T,r[7]=0,r[8]=(x+A)*g,r[9]=(d-v)*g,r[10]=(1-(f+S))*g,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=oo.set(r[0],r[1],r[2]).length(),a=oo.set(r[4],r[5],r[6]).length(),l=oo.set(r[8],r[9],r[10]).length();s<0&&(o=-o),Hn.copy(this);let c=1/o,h=1/a,u=1/l;return Hn.elements[0]*=c,Hn.elements[1]*=c,Hn.elements[2]*=c,Hn.elements[4]*=h,Hn.elements[5]*=h,Hn.elements[6]*=h,Hn.elements[8]*=u,Hn.elements[9]*=u,Hn.elements[10]*=u,t.setFromRotationMatrix(Hn),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,r,s,o,a=Fi,l=!1){let c=this.elements,h=2*s/(t-e),u=2*s/(i-r),f=(t+e)/(t-e),m=(i+r)/(i-r),x,S;if(l)x=s/(o-s),S=o*s/(o-s);else if(a===Fi)x=-(o+s)/(o-s),S=-2*o*s/(o-s);else if(a===_r)x=-o/(o-s),S=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=x,c[14]=S,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=Fi,l=!1){let c=this.elements,h=2/(t-e),u=2/(i-r),f=-(t+e)/(t-e),m=-(i+r)/(i-r),x,S;if(l)x=1/(o-s),S=o/(o-s);else if(a===Fi)x=-2/(o-s),S=-(o+s)/(o-s);else if(a===_r)x=-1/(o-s),S=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=x,c[14]=S,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},oo=new F,Hn=new Ve,KS=new F(0,0,0),ZS=new F(1,1,1),zr=new F,lc=new F,Sn=new F;var $p=new Ve,Jp=new qt,Pn=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],h=r[9],u=r[2],f=r[6],m=r[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,s),this._z=0);break;case"ZXY":this._x=Math.asin(ct(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-ct(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,m),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,s)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-h,m),this._y=0);break;default:ze("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return $p.makeRotationFromQuaternion(e),this.setFromRotationMatrix($p,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Jp.setFromEuler(this),this.setFromQuaternion(Jp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Pn.DEFAULT_ORDER="XYZ";var kr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}};var $S=0,Qp=new F,ao=new qt,vr=new Ve,cc=new F,ka=new F,JS=new F,QS=new qt,jp=new F(1,0,0),em=new F(0,1,0),tm=new F(0,0,1),im={type:"added"},jS={type:"removed"},lo={type:"childadded",child:null},ff={type:"childremoved",child:null},Yt=class n extends ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:$S++}),this.uuid=rr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new F,t=new Pn,i=new qt,r=new F(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new Ve},normalMatrix:{value:new Ke}}),this.matrix=new Ve,this.matrixWorld=new Ve,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new kr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ao.setFromAxisAngle(e,t),this.quaternion.multiply(ao),this}rotateOnWorldAxis(e,t){return ao.setFromAxisAngle(e,t),this.quaternion.premultiply(ao),this}rotateX(e){return this.rotateOnAxis(jp,e)}rotateY(e){return this.rotateOnAxis(em,e)}rotateZ(e){return this.rotateOnAxis(tm,e)}translateOnAxis(e,t){return Qp.copy(e).applyQuaternion(this.quaternion),this.position.add(Qp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(jp,e)}translateY(e){return this.translateOnAxis(em,e)}translateZ(e){return this.translateOnAxis(tm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(vr.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?cc.copy(e):cc.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),ka.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?vr.lookAt(ka,cc,this.up):vr.lookAt(cc,ka,this.up),this.quaternion.setFromRotationMatrix(vr),r&&(vr.extractRotation(r.matrixWorld),ao.setFromRotationMatrix(vr),this.quaternion.premultiply(ao.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ht("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(im),lo.child=e,this.dispatchEvent(lo),lo.child=null):ht("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(jS),ff.child=e,this.dispatchEvent(ff),ff.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),vr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),vr.multiply(e.parent.matrixWorld)),e.applyMatrix4(vr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(im),lo.child=e,this.dispatchEvent(lo),lo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ka,e,JS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ka,QS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];s(e.shapes,u)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),f=o(e.skeletons),m=o(e.animations),x=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),f.length>0&&(i.skeletons=f),m.length>0&&(i.animations=m),x.length>0&&(i.nodes=x)}return i.object=r,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Yt.DEFAULT_UP=new F(0,1,0);Yt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Yt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Wn=class extends Yt{constructor(){super(),this.isGroup=!0,this.type="Group"}};var eM={type:"move"},co=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Wn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Wn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Wn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let S of e.hand.values()){let d=t.getJointPose(S,i),p=this._getHandJoint(c,S);d!==null&&(p.matrix.fromArray(d.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=d.radius),p.visible=d!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),m=.02,x=.005;c.inputState.pinching&&f>m+x?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=m-x&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(eM)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Wn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}};var nm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Vr={h:0,s:0,l:0},uc={h:0,s:0,l:0};function hf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Xe=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=en){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,it.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=it.workingColorSpace){return this.r=e,this.g=t,this.b=i,it.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=it.workingColorSpace){if(e=Hp(e,1),t=ct(t,0,1),i=ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=hf(o,s,e+1/3),this.g=hf(o,s,e),this.b=hf(o,s,e-1/3)}return it.colorSpaceToWorking(this,r),this}setStyle(e,t=en){function i(s){s!==void 0&&parseFloat(s)<1&&ze("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:ze("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);ze("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=en){let i=nm[e.toLowerCase()];return i!==void 0?this.setHex(i,t):ze("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Vn(e.r),this.g=Vn(e.g),this.b=Vn(e.b),this}copyLinearToSRGB(e){return this.r=ps(e.r),this.g=ps(e.g),this.b=ps(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=en){return it.workingToColorSpace(Hi.copy(this),e),Math.round(ct(Hi.r*255,0,255))*65536+Math.round(ct(Hi.g*255,0,255))*256+Math.round(ct(Hi.b*255,0,255))}getHexString(e=en){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=it.workingColorSpace){it.workingToColorSpace(Hi.copy(this),t);let i=Hi.r,r=Hi.g,s=Hi.b,o=Math.max(i,r,s),a=Math.min(i,r,s),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(r-s)/u+(r<s?6:0);break;case r:l=(s-i)/u+2;break;case s:l=(i-r)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=it.workingColorSpace){return it.workingToColorSpace(Hi.copy(this),t),e.r=Hi.r,e.g=Hi.g,e.b=Hi.b,e}getStyle(e=en){it.workingToColorSpace(Hi.copy(this),e);let t=Hi.r,i=Hi.g,r=Hi.b;return e!==en?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(Vr),this.setHSL(Vr.h+e,Vr.s+t,Vr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Vr),e.getHSL(uc);let i=nc(Vr.h,uc.h,t),r=nc(Vr.s,uc.s,t),s=nc(Vr.l,uc.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Hi=new Xe;Xe.NAMES=nm;var uo=class extends Yt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Pn,this.environmentIntensity=1,this.environmentRotation=new Pn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}};var Xn=new F,Sr=new F,df=new F,Mr=new F,fo=new F,ho=new F,rm=new F,pf=new F,mf=new F,gf=new F,xf=new bt,_f=new bt,vf=new bt,Hr=class n{constructor(e=new F,t=new F,i=new F){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),Xn.subVectors(e,t),r.cross(Xn);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){Xn.subVectors(r,t),Sr.subVectors(i,t),df.subVectors(e,t);let o=Xn.dot(Xn),a=Xn.dot(Sr),l=Xn.dot(df),c=Sr.dot(Sr),h=Sr.dot(df),u=o*c-a*a;if(u===0)return s.set(0,0,0),null;let f=1/u,m=(c*l-a*h)*f,x=(o*h-a*l)*f;return s.set(1-m-x,x,m)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,Mr)===null?!1:Mr.x>=0&&Mr.y>=0&&Mr.x+Mr.y<=1}static getInterpolation(e,t,i,r,s,o,a,l){return this.getBarycoord(e,t,i,r,Mr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Mr.x),l.addScaledVector(o,Mr.y),l.addScaledVector(a,Mr.z),l)}static getInterpolatedAttribute(e,t,i,r,s,o){return xf.setScalar(0),_f.setScalar(0),vf.setScalar(0),xf.fromBufferAttribute(e,t),_f.fromBufferAttribute(e,i),vf.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(xf,s.x),o.addScaledVector(_f,s.y),o.addScaledVector(vf,s.z),o}static isFrontFacing(e,t,i,r){return Xn.subVectors(i,t),Sr.subVectors(e,t),Xn.cross(Sr).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Xn.subVectors(this.c,this.b),Sr.subVectors(this.a,this.b),Xn.cross(Sr).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;fo.subVectors(r,i),ho.subVectors(s,i),pf.subVectors(e,i);let l=fo.dot(pf),c=ho.dot(pf);if(l<=0&&c<=0)return t.copy(i);mf.subVectors(e,r);let h=fo.dot(mf),u=ho.dot(mf);if(h>=0&&u<=h)return t.copy(r);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(i).addScaledVector(fo,o);gf.subVectors(e,s);let m=fo.dot(gf),x=ho.dot(gf);if(x>=0&&m<=x)return t.copy(s);let S=m*c-l*x;if(S<=0&&c>=0&&x<=0)return a=c/(c-x),t.copy(i).addScaledVector(ho,a);let d=h*x-m*u;if(d<=0&&u-h>=0&&m-x>=0)return rm.subVectors(s,r),a=(u-h)/(u-h+(m-x)),t.copy(r).addScaledVector(rm,a);let p=1/(d+S+f);return o=S*p,a=f*p,t.copy(i).addScaledVector(fo,o).addScaledVector(ho,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}};var on=class{constructor(e=new F(1/0,1/0,1/0),t=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(qn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(qn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=qn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,qn):qn.fromBufferAttribute(s,o),qn.applyMatrix4(e.matrixWorld),this.expandByPoint(qn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),fc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),fc.copy(i.boundingBox)),fc.applyMatrix4(e.matrixWorld),this.union(fc)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,qn),qn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Va),hc.subVectors(this.max,Va),po.subVectors(e.a,Va),mo.subVectors(e.b,Va),go.subVectors(e.c,Va),Wr.subVectors(mo,po),Xr.subVectors(go,mo),ms.subVectors(po,go);let t=[0,-Wr.z,Wr.y,0,-Xr.z,Xr.y,0,-ms.z,ms.y,Wr.z,0,-Wr.x,Xr.z,0,-Xr.x,ms.z,0,-ms.x,-Wr.y,Wr.x,0,-Xr.y,Xr.x,0,-ms.y,ms.x,0];return!Sf(t,po,mo,go,hc)||(t=[1,0,0,0,1,0,0,0,1],!Sf(t,po,mo,go,hc))?!1:(dc.crossVectors(Wr,Xr),t=[dc.x,dc.y,dc.z],Sf(t,po,mo,go,hc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,qn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(qn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(yr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),yr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),yr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),yr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),yr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),yr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),yr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),yr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(yr),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},yr=[new F,new F,new F,new F,new F,new F,new F,new F],qn=new F,fc=new on,po=new F,mo=new F,go=new F,Wr=new F,Xr=new F,ms=new F,Va=new F,hc=new F,dc=new F,gs=new F;function Sf(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){gs.fromArray(n,s);let a=r.x*Math.abs(gs.x)+r.y*Math.abs(gs.y)+r.z*Math.abs(gs.z),l=e.dot(gs),c=t.dot(gs),h=i.dot(gs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var _i=new F,pc=new Ze,tM=0,Ei=class extends ki{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:tM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Fp,this.updateRanges=[],this.gpuType=xi,this.version=0,this._normalizationScale=e!==void 0?rc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)pc.fromBufferAttribute(this,t),pc.applyMatrix3(e),this.setXY(t,pc.x,pc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyMatrix3(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyMatrix4(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyNormalMatrix(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.transformDirection(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Xp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):qp(e,this.array)}};var xo=class extends Ei{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var _o=class extends Ei{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Ft=class extends Ei{constructor(e,t,i){super(new Float32Array(e),t,i)}};var iM=new on,Ha=new F,Mf=new F,Mn=class{constructor(e=new F,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):iM.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ha.subVectors(e,this.center);let t=Ha.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(Ha,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Mf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ha.copy(e.center).add(Mf)),this.expandByPoint(Ha.copy(e.center).sub(Mf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}};var nM=0,Ln=new Ve,yf=new Yt,vo=new F,yn=new on,Wa=new on,Ii=new F,Kt=class n extends ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:nM++}),this.uuid=rr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Bp(e)?_o:xo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new Ke().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ln.makeRotationFromQuaternion(e),this.applyMatrix4(Ln),this}rotateX(e){return Ln.makeRotationX(e),this.applyMatrix4(Ln),this}rotateY(e){return Ln.makeRotationY(e),this.applyMatrix4(Ln),this}rotateZ(e){return Ln.makeRotationZ(e),this.applyMatrix4(Ln),this}translate(e,t,i){return Ln.makeTranslation(e,t,i),this.applyMatrix4(Ln),this}scale(e,t,i){return Ln.makeScale(e,t,i),this.applyMatrix4(Ln),this}lookAt(e){return yf.lookAt(e),yf.updateMatrix(),this.applyMatrix4(yf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(vo).negate(),this.translate(vo.x,vo.y,vo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ft(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&ze("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new on);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ht("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];yn.setFromBufferAttribute(s),this.morphTargetsRelative?(Ii.addVectors(this.boundingBox.min,yn.min),this.boundingBox.expandByPoint(Ii),Ii.addVectors(this.boundingBox.max,yn.max),this.boundingBox.expandByPoint(Ii)):(this.boundingBox.expandByPoint(yn.min),this.boundingBox.expandByPoint(yn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ht('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Mn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ht("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(e){let i=this.boundingSphere.center;if(yn.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];Wa.setFromBufferAttribute(a),this.morphTargetsRelative?(Ii.addVectors(yn.min,Wa.min),yn.expandByPoint(Ii),Ii.addVectors(yn.max,Wa.max),yn.expandByPoint(Ii)):(yn.expandByPoint(Wa.min),yn.expandByPoint(Wa.max))}yn.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)Ii.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(Ii));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Ii.fromBufferAttribute(a,c),l&&(vo.fromBufferAttribute(e,c),Ii.add(vo)),r=Math.max(r,i.distanceToSquared(Ii))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&ht('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ht("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Ei(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new F,l[U]=new F;let h=new F,u=new F,f=new F,m=new Ze,x=new Ze,S=new Ze,d=new F,p=new F;function v(U,P,D){c[U]=c[P]=c[D]=1,h.fromBufferAttribute(i,U),u.fromBufferAttribute(i,P),f.fromBufferAttribute(i,D),m.fromBufferAttribute(s,U),x.fromBufferAttribute(s,P),S.fromBufferAttribute(s,D),u.sub(h),f.sub(h),x.sub(m),S.sub(m);let G=1/(x.x*S.y-S.x*x.y);isFinite(G)&&(d.copy(u).multiplyScalar(S.y).addScaledVector(f,-x.y).multiplyScalar(G),p.copy(f).multiplyScalar(x.x).addScaledVector(u,-S.x).multiplyScalar(G),a[U].add(d),a[P].add(d),a[D].add(d),l[U].add(p),l[P].add(p),l[D].add(p))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let U=0,P=A.length;U<P;++U){let D=A[U],G=D.start,k=D.count;for(let N=G,W=G+k;N<W;N+=3)v(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let M=new F,R=new F,T=new F,g=new F;function E(U){T.fromBufferAttribute(r,U),g.copy(T);let P=a[U];M.copy(P),M.sub(T.multiplyScalar(T.dot(P))).normalize(),R.crossVectors(g,P);let G=R.dot(l[U])<0?-1:1;o.setXYZW(U,M.x,M.y,M.z,G)}for(let U=0,P=i.count;U<P;++U)c[U]&&E(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Ei(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,m=i.count;f<m;f++)i.setXYZ(f,0,0,0);let r=new F,s=new F,o=new F,a=new F,l=new F,c=new F,h=new F,u=new F;if(e)for(let f=0,m=e.count;f<m;f+=3){let x=e.getX(f+0),S=e.getX(f+1),d=e.getX(f+2);r.fromBufferAttribute(t,x),s.fromBufferAttribute(t,S),o.fromBufferAttribute(t,d),h.subVectors(o,s),u.subVectors(r,s),h.cross(u),a.fromBufferAttribute(i,x),l.fromBufferAttribute(i,S),c.fromBufferAttribute(i,d),a.add(h),l.add(h),c.add(h),i.setXYZ(x,a.x,a.y,a.z),i.setXYZ(S,l.x,l.y,l.z),i.setXYZ(d,c.x,c.y,c.z)}else for(let f=0,m=t.count;f<m;f+=3)r.fromBufferAttribute(t,f+0),s.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),h.subVectors(o,s),u.subVectors(r,s),h.cross(u),i.setXYZ(f+0,h.x,h.y,h.z),i.setXYZ(f+1,h.x,h.y,h.z),i.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Ii.fromBufferAttribute(e,t),Ii.normalize(),e.setXYZ(t,Ii.x,Ii.y,Ii.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),m=0,x=0;for(let S=0,d=l.length;S<d;S++){a.isInterleavedBufferAttribute?m=l[S]*a.data.stride+a.offset:m=l[S]*h;for(let p=0;p<h;p++)f[x++]=c[m++]}return new Ei(f,h,u)}if(this.index===null)return ze("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,i);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],m=e(f,i);l.push(m)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let m=c[u];h.push(m.toJSON(e.data))}h.length>0&&(r[l]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let c in r){let h=r[c];this.setAttribute(c,h.clone(t))}let s=e.morphAttributes;for(let c in s){let h=[],u=s[c];for(let f=0,m=u.length;f<m;f++)h.push(u[f].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var bf=new F,rM=new F,sM=new Ke,Wi=class{constructor(e=new F(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=bf.subVectors(i,t).cross(rM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(bf),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||sM.getNormalMatrix(e),r=this.coplanarPoint(bf).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}};var oM=0,Dn=class extends ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:oM++}),this.uuid=rr(),this.name="",this.type="Material",this.blending=Nr,this.side=nn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Il,this.blendDst=Nl,this.blendEquation=Ur,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Xe(0,0,0),this.blendAlpha=0,this.depthFunc=Fr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Pp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ql,this.stencilZFail=Ql,this.stencilZPass=Ql,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){ze(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){ze(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Xe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Wi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ze().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ze().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var br=new F,Ef=new F,mc=new F,gc=new F,So=class{constructor(e=new F,t=new F(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,br)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=br.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(br.copy(this.origin).addScaledVector(this.direction,t),br.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){Ef.copy(e).add(t).multiplyScalar(.5),mc.copy(t).sub(e).normalize(),gc.copy(this.origin).sub(Ef);let s=e.distanceTo(t)*.5,o=-this.direction.dot(mc),a=gc.dot(this.direction),l=-gc.dot(mc),c=gc.lengthSq(),h=Math.abs(1-o*o),u,f,m,x;if(h>0)if(u=o*l-a,f=o*a-l,x=s*h,u>=0)if(f>=-x)if(f<=x){let S=1/h;u*=S,f*=S,m=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=s,u=Math.max(0,-(o*f+a)),m=-u*u+f*(f+2*l)+c;else f=-s,u=Math.max(0,-(o*f+a)),m=-u*u+f*(f+2*l)+c;else f<=-x?(u=Math.max(0,-(-o*s+a)),f=u>0?-s:Math.min(Math.max(-s,-l),s),m=-u*u+f*(f+2*l)+c):f<=x?(u=0,f=Math.min(Math.max(-s,-l),s),m=f*(f+2*l)+c):(u=Math.max(0,-(o*s+a)),f=u>0?s:Math.min(Math.max(-s,-l),s),m=-u*u+f*(f+2*l)+c);else f=o>0?-s:s,u=Math.max(0,-(o*f+a)),m=-u*u+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),r&&r.copy(Ef).addScaledVector(mc,f),m}intersectSphere(e,t){if(e.radius<0)return null;br.subVectors(e.center,this.origin);let i=br.dot(this.direction),r=br.dot(br)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,r=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,r=(e.min.x-f.x)*c),h>=0?(s=(e.min.y-f.y)*h,o=(e.max.y-f.y)*h):(s=(e.max.y-f.y)*h,o=(e.min.y-f.y)*h),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),u>=0?(a=(e.min.z-f.z)*u,l=(e.max.z-f.z)*u):(a=(e.max.z-f.z)*u,l=(e.min.z-f.z)*u),i>l||a>r)||((a>i||i!==i)&&(i=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,br)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,f=e.y-o.y,m=e.z-o.z,x=t.x-o.x,S=t.y-o.y,d=t.z-o.z,p=i.x-o.x,v=i.y-o.y,A=i.z-o.z,M=Math.abs(l),R=Math.abs(c),T=Math.abs(h),g,E,U,P,D,G,k,N,W,Y,H,ce;if(M>=R&&M>=T?(U=l,G=u,W=x,ce=p,l>=0?(g=c,E=h,P=f,D=m,k=S,N=d,Y=v,H=A):(g=h,E=c,P=m,D=f,k=d,N=S,Y=A,H=v)):R>=T?(U=c,G=f,W=S,ce=v,c>=0?(g=h,E=l,P=m,D=u,k=d,N=x,Y=A,H=p):(g=l,E=h,P=u,D=m,k=x,N=d,Y=p,H=A)):(U=h,G=m,W=d,ce=A,h>=0?(g=l,E=c,P=u,D=f,k=x,N=S,Y=p,H=v):(g=c,E=l,P=f,D=u,k=S,N=x,Y=v,H=p)),U===0)return null;let $=g/U,Q=E/U,ne=1/U,he=P-$*G,fe=D-Q*G,j=k-$*W,me=N-Q*W,_e=Y-$*ce,Ae=H-Q*ce,ye=_e*me-Ae*j,qe=he*Ae-fe*_e,st=j*fe-me*he;if(r){if(ye<0||qe<0||st<0)return null}else if((ye<0||qe<0||st<0)&&(ye>0||qe>0||st>0))return null;let He=ye+qe+st;if(He===0)return null;let dt=ne*(ye*G+qe*W+st*ce);return(He>0?dt<0:dt>0)?null:this.at(dt/He,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}};var xc=class extends Dn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=qs,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var sm=new Ve,xs=new So,_c=new Mn,om=new F,vc=new F,Sc=new F,Mc=new F,wf=new F,yc=new F,am=new F,bc=new F,Jt=class extends Yt{constructor(e=new Kt,t=new xc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){yc.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let h=a[l],u=s[l];h!==0&&(wf.fromBufferAttribute(u,e),o?yc.addScaledVector(wf,h):yc.addScaledVector(wf.sub(t),h))}t.add(yc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),_c.copy(i.boundingSphere),_c.applyMatrix4(s),xs.copy(e.ray).recast(e.near),!(_c.containsPoint(xs.origin)===!1&&(xs.intersectSphere(_c,om)===null||xs.origin.distanceToSquared(om)>(e.far-e.near)**2))&&(sm.copy(s).invert(),xs.copy(e.ray).applyMatrix4(sm),!(i.boundingBox!==null&&xs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,xs)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,h=s.attributes.uv1,u=s.attributes.normal,f=s.groups,m=s.drawRange;if(a!==null)if(Array.isArray(o))for(let x=0,S=f.length;x<S;x++){let d=f[x],p=o[d.materialIndex],v=Math.max(d.start,m.start),A=Math.min(a.count,Math.min(d.start+d.count,m.start+m.count));for(let M=v,R=A;M<R;M+=3){let T=a.getX(M),g=a.getX(M+1),E=a.getX(M+2);r=Ec(this,p,e,i,c,h,u,T,g,E),r&&(r.faceIndex=Math.floor(M/3),r.face.materialIndex=d.materialIndex,t.push(r))}}else{let x=Math.max(0,m.start),S=Math.min(a.count,m.start+m.count);for(let d=x,p=S;d<p;d+=3){let v=a.getX(d),A=a.getX(d+1),M=a.getX(d+2);r=Ec(this,o,e,i,c,h,u,v,A,M),r&&(r.faceIndex=Math.floor(d/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let x=0,S=f.length;x<S;x++){let d=f[x],p=o[d.materialIndex],v=Math.max(d.start,m.start),A=Math.min(l.count,Math.min(d.start+d.count,m.start+m.count));for(let M=v,R=A;M<R;M+=3){let T=M,g=M+1,E=M+2;r=Ec(this,p,e,i,c,h,u,T,g,E),r&&(r.faceIndex=Math.floor(M/3),r.face.materialIndex=d.materialIndex,t.push(r))}}else{let x=Math.max(0,m.start),S=Math.min(l.count,m.start+m.count);for(let d=x,p=S;d<p;d+=3){let v=d,A=d+1,M=d+2;r=Ec(this,o,e,i,c,h,u,v,A,M),r&&(r.faceIndex=Math.floor(d/3),t.push(r))}}}};function aM(n,e,t,i,r,s,o,a){let l;if(e.side===$t?l=i.intersectTriangle(o,s,r,!0,a):l=i.intersectTriangle(r,s,o,e.side===nn,a),l===null)return null;bc.copy(a),bc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(bc);return c<t.near||c>t.far?null:{distance:c,point:bc.clone(),object:n}}function Ec(n,e,t,i,r,s,o,a,l,c){n.getVertexPosition(a,vc),n.getVertexPosition(l,Sc),n.getVertexPosition(c,Mc);let h=aM(n,e,t,i,vc,Sc,Mc,am);if(h){let u=new F;Hr.getBarycoord(am,vc,Sc,Mc,u),r&&(h.uv=Hr.getInterpolatedAttribute(r,a,l,c,u,new Ze)),s&&(h.uv1=Hr.getInterpolatedAttribute(s,a,l,c,u,new Ze)),o&&(h.normal=Hr.getInterpolatedAttribute(o,a,l,c,u,new F),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new F,materialIndex:0};Hr.getNormal(vc,Sc,Mc,f.normal),h.face=f,h.barycoord=u}return h}var qr=class extends ai{constructor(e=null,t=1,i=1,r,s,o,a,l,c=Xt,h=Xt,u,f){super(null,o,a,l,c,h,r,s,u,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var _s=new Mn,lM=new Ze(.5,.5),wc=new F,bn=class{constructor(e=new Wi,t=new Wi,i=new Wi,r=new Wi,s=new Wi,o=new Wi){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Fi,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],h=s[4],u=s[5],f=s[6],m=s[7],x=s[8],S=s[9],d=s[10],p=s[11],v=s[12],A=s[13],M=s[14],R=s[15];if(r[0].setComponents(c-o,m-h,p-x,R-v).normalize(),r[1].setComponents(c+o,m+h,p+x,R+v).normalize(),r[2].setComponents(c+a,m+u,p+S,R+A).normalize(),r[3].setComponents(c-a,m-u,p-S,R-A).normalize(),i)r[4].setComponents(l,f,d,M).normalize(),r[5].setComponents(c-l,m-f,p-d,R-M).normalize();else if(r[4].setComponents(c-l,m-f,p-d,R-M).normalize(),t===Fi)r[5].setComponents(c+l,m+f,p+d,R+M).normalize();else if(t===_r)r[5].setComponents(l,f,d,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),_s.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),_s.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(_s)}intersectsSprite(e){_s.center.set(0,0,0);let t=lM.distanceTo(e.center);return _s.radius=.7071067811865476+t,_s.applyMatrix4(e.matrixWorld),this.intersectsSphere(_s)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(wc.x=r.normal.x>0?e.max.x:e.min.x,wc.y=r.normal.y>0?e.max.y:e.min.y,wc.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(wc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var lm=new Ve,Mo=class n{constructor(){this.coordinateSystem=Fi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];lm.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new bn),i[r].setFromProjectionMatrix(lm,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new bn),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};function Tf(n,e){return n-e}function cM(n,e){return n.z-e.z}function uM(n,e){return e.z-n.z}var Cf=class{constructor(){this.index=0,this.pool=[],this.list=[]}push(e,t,i,r){let s=this.pool,o=this.list;this.index>=s.length&&s.push({start:-1,count:-1,z:-1,index:-1});let a=s[this.index];o.push(a),this.index++,a.start=e,a.count=t,a.z=i,a.index=r}reset(){this.list.length=0,this.index=0}},an=new Ve,fM=new Xe(1,1,1),hM=new bn,dM=new Mo,Tc=new on,vs=new Mn,Af=new F,cm=new F,um=new F,pM=new F,Rf=new Cf,Xi=new Jt,Ac=[];function mM(n,e,t=0){let i=e.itemSize;if(n.isInterleavedBufferAttribute||n.array.constructor!==e.array.constructor){let r=n.count;for(let s=0;s<r;s++)for(let o=0;o<i;o++)e.setComponent(s+t,o,n.getComponent(s,o))}else e.array.set(n.array,t*i);e.needsUpdate=!0}function sr(n,e){if(n.constructor!==e.constructor){let t=Math.min(n.length,e.length);for(let i=0;i<t;i++)e[i]=n[i]}else{let t=Math.min(n.length,e.length);e.set(new n.constructor(n.buffer,0,t))}}var Xa=class extends Jt{constructor(e,t,i=t*2,r){super(new Kt,r),this.isBatchedMesh=!0,this.perObjectFrustumCulled=!0,this.sortObjects=!0,this.boundingBox=null,this.boundingSphere=null,this.customSort=null,this._instanceInfo=[],this._geometryInfo=[],this._availableInstanceIds=[],this._availableGeometryIds=[],this._nextIndexStart=0,this._nextVertexStart=0,this._geometryCount=0,this._visibilityChanged=!0,this._geometryInitialized=!1,this._maxInstanceCount=e,this._maxVertexCount=t,this._maxIndexCount=i,this._multiDrawCounts=new Int32Array(e),this._multiDrawStarts=new Int32Array(e),this._multiDrawCount=0,this._multiDrawBytesPerElement=1,this._mergedDrawCounts=new Int32Array(e),this._mergedDrawStarts=new Int32Array(e),this._mergedDrawInstanceCounts=new Int32Array(e),this._mergedDrawCount=0,this._matricesTexture=null,this._indirectTexture=null,this._colorsTexture=null,this._previousMatricesTexture=null,this._initMatricesTexture(),this._initIndirectTexture()}get maxInstanceCount(){return this._maxInstanceCount}get instanceCount(){return this._instanceInfo.length-this._availableInstanceIds.length}get unusedVertexCount(){return this._maxVertexCount-this._nextVertexStart}get unusedIndexCount(){return this._maxIndexCount-this._nextIndexStart}_initMatricesTexture(){let e=Math.sqrt(this._maxInstanceCount*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4),i=new qr(t,e,e,bi,xi);this._matricesTexture=i}_initIndirectTexture(){let e=Math.sqrt(this._maxInstanceCount);e=Math.ceil(e);let t=new Uint32Array(e*e),i=new qr(t,e,e,Br,gi);this._indirectTexture=i}_initColorsTexture(){let e=Math.sqrt(this._maxInstanceCount);e=Math.ceil(e);let t=new Float32Array(e*e*4).fill(1),i=new qr(t,e,e,bi,xi);i.colorSpace=it.workingColorSpace,this._colorsTexture=i}_initializeGeometry(e){let t=this.geometry,i=this._maxVertexCount,r=this._maxIndexCount;if(this._geometryInitialized===!1){for(let s in e.attributes){let o=e.getAttribute(s),{array:a,itemSize:l,normalized:c}=o,h=new a.constructor(i*l),u=new Ei(h,l,c);t.setAttribute(s,u)}if(e.getIndex()!==null){let s=i>65535?new Uint32Array(r):new Uint16Array(r);t.setIndex(new Ei(s,1))}this._geometryInitialized=!0}}_validateGeometry(e){let t=this.geometry;if(!!e.getIndex()!=!!t.getIndex())throw new Error('THREE.BatchedMesh: All geometries must consistently have "index".');for(let i in t.attributes){if(!e.hasAttribute(i))throw new Error(`THREE.BatchedMesh: Added geometry missing "${i}". All geometries must have consistent attributes.`);let r=e.getAttribute(i),s=t.getAttribute(i);if(r.itemSize!==s.itemSize||r.normalized!==s.normalized)throw new Error(`THREE.BatchedMesh: Added geometry attribute "${i}" has an inconsistent itemSize or normalized value.`)}}validateInstanceId(e){let t=this._instanceInfo;if(e<0||e>=t.length||t[e].active===!1)throw new Error(`THREE.BatchedMesh: Invalid instanceId ${e}. Instance is either out of range or has been deleted.`)}validateGeometryId(e){let t=this._geometryInfo;if(e<0||e>=t.length||t[e].active===!1)throw new Error(`THREE.BatchedMesh: Invalid geometryId ${e}. Geometry is either out of range or has been deleted.`)}setCustomSort(e){return this.customSort=e,this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new on);let e=this.boundingBox,t=this._instanceInfo;e.makeEmpty();for(let i=0,r=t.length;i<r;i++){if(t[i].active===!1)continue;let s=t[i].geometryIndex;this.getMatrixAt(i,an),this.getBoundingBoxAt(s,Tc).applyMatrix4(an),e.union(Tc)}}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Mn);let e=this.boundingSphere,t=this._instanceInfo;e.makeEmpty();for(let i=0,r=t.length;i<r;i++){if(t[i].active===!1)continue;let s=t[i].geometryIndex;this.getMatrixAt(i,an),this.getBoundingSphereAt(s,vs).applyMatrix4(an),e.union(vs)}}addInstance(e){if(this._instanceInfo.length>=this.maxInstanceCount&&this._availableInstanceIds.length===0)throw new Error("THREE.BatchedMesh: Maximum item count reached.");let i={visible:!0,active:!0,geometryIndex:e},r=null;this._availableInstanceIds.length>0?(this._availableInstanceIds.sort(Tf),r=this._availableInstanceIds.shift(),this._instanceInfo[r]=i):(r=this._instanceInfo.length,this._instanceInfo.push(i));let s=this._matricesTexture;an.identity().toArray(s.image.data,r*16),s.needsUpdate=!0;let o=this._colorsTexture;return o&&(fM.toArray(o.image.data,r*4),o.needsUpdate=!0),this._visibilityChanged=!0,r}addGeometry(e,t=-1,i=-1){this._initializeGeometry(e),this._validateGeometry(e);let r={vertexStart:-1,vertexCount:-1,reservedVertexCount:-1,indexStart:-1,indexCount:-1,reservedIndexCount:-1,start:-1,count:-1,boundingBox:null,boundingSphere:null,active:!0},s=this._geometryInfo;r.vertexStart=this._nextVertexStart,r.reservedVertexCount=t===-1?e.getAttribute("position").count:t;let o=e.getIndex();if(o!==null&&(r.indexStart=this._nextIndexStart,r.reservedIndexCount=i===-1?o.count:i),r.indexStart!==-1&&r.indexStart+r.reservedIndexCount>this._maxIndexCount||r.vertexStart+r.reservedVertexCount>this._maxVertexCount)throw new Error("THREE.BatchedMesh: Reserved space request exceeds the maximum buffer size.");let l;return this._availableGeometryIds.length>0?(this._availableGeometryIds.sort(Tf),l=this._availableGeometryIds.shift(),s[l]=r):(l=this._geometryCount,this._geometryCount++,s.push(r)),this.setGeometryAt(l,e),this._nextIndexStart=r.indexStart+r.reservedIndexCount,this._nextVertexStart=r.vertexStart+r.reservedVertexCount,l}setGeometryAt(e,t){if(e>=this._geometryCount)throw new Error("THREE.BatchedMesh: Maximum geometry count reached.");this._validateGeometry(t);let i=this.geometry,r=i.getIndex()!==null,s=i.getIndex(),o=t.getIndex(),a=this._geometryInfo[e];if(r&&o.count>a.reservedIndexCount||t.attributes.position.count>a.reservedVertexCount)throw new Error("THREE.BatchedMesh: Reserved space not large enough for provided geometry.");let l=a.vertexStart,c=a.reservedVertexCount;a.vertexCount=t.getAttribute("position").count;for(let h in i.attributes){let u=t.getAttribute(h),f=i.getAttribute(h);mM(u,f,l);let m=u.itemSize;for(let x=u.count,S=c;x<S;x++){let d=l+x;for(let p=0;p<m;p++)f.setComponent(d,p,0)}f.needsUpdate=!0,f.addUpdateRange(l*m,c*m)}if(r){let h=a.indexStart,u=a.reservedIndexCount;a.indexCount=t.getIndex().count;for(let f=0;f<o.count;f++)s.setX(h+f,l+o.getX(f));for(let f=o.count,m=u;f<m;f++)s.setX(h+f,l);s.needsUpdate=!0,s.addUpdateRange(h,a.reservedIndexCount)}return a.start=r?a.indexStart:a.vertexStart,a.count=r?a.indexCount:a.vertexCount,a.boundingBox=null,t.boundingBox!==null&&(a.boundingBox=t.boundingBox.clone()),a.boundingSphere=null,t.boundingSphere!==null&&(a.boundingSphere=t.boundingSphere.clone()),this._visibilityChanged=!0,e}deleteGeometry(e){let t=this._geometryInfo;if(e>=t.length||t[e].active===!1)return this;let i=this._instanceInfo;for(let r=0,s=i.length;r<s;r++)i[r].active&&i[r].geometryIndex===e&&this.deleteInstance(r);return t[e].active=!1,this._availableGeometryIds.push(e),this._visibilityChanged=!0,this}deleteInstance(e){return this.validateInstanceId(e),this._instanceInfo[e].active=!1,this._availableInstanceIds.push(e),this._visibilityChanged=!0,this}optimize(){let e=0,t=0,i=this._geometryInfo,r=i.map((o,a)=>a).sort((o,a)=>i[o].vertexStart-i[a].vertexStart),s=this.geometry;for(let o=0,a=i.length;o<a;o++){let l=r[o],c=i[l];if(c.active!==!1){if(s.index!==null){if(c.indexStart!==t){let{indexStart:h,vertexStart:u,reservedIndexCount:f}=c,m=s.index,x=m.array,S=e-u;for(let d=h;d<h+f;d++)x[d]=x[d]+S;m.array.copyWithin(t,h,h+f),m.addUpdateRange(t,f),m.needsUpdate=!0,c.indexStart=t}t+=c.reservedIndexCount}if(c.vertexStart!==e){let{vertexStart:h,reservedVertexCount:u}=c,f=s.attributes;for(let m in f){let x=f[m],{array:S,itemSize:d}=x;S.copyWithin(e*d,h*d,(h+u)*d),x.addUpdateRange(e*d,u*d),x.needsUpdate=!0}c.vertexStart=e}e+=c.reservedVertexCount,c.start=s.index?c.indexStart:c.vertexStart}}return this._nextIndexStart=t,this._nextVertexStart=e,this._visibilityChanged=!0,this}getBoundingBoxAt(e,t){if(e>=this._geometryCount)return null;let i=this.geometry,r=this._geometryInfo[e];if(r.boundingBox===null){let s=new on,o=i.index,a=i.attributes.position;for(let l=r.start,c=r.start+r.count;l<c;l++){let h=l;o&&(h=o.getX(h)),s.expandByPoint(Af.fromBufferAttribute(a,h))}r.boundingBox=s}return t.copy(r.boundingBox),t}getBoundingSphereAt(e,t){if(e>=this._geometryCount)return null;let i=this.geometry,r=this._geometryInfo[e];if(r.boundingSphere===null){let s=new Mn;this.getBoundingBoxAt(e,Tc),Tc.getCenter(s.center);let o=i.index,a=i.attributes.position,l=0;for(let c=r.start,h=r.start+r.count;c<h;c++){let u=c;o&&(u=o.getX(u)),Af.fromBufferAttribute(a,u),l=Math.max(l,s.center.distanceToSquared(Af))}s.radius=Math.sqrt(l),r.boundingSphere=s}return t.copy(r.boundingSphere),t}setMatrixAt(e,t){this.validateInstanceId(e);let i=this._matricesTexture,r=this._matricesTexture.image.data;return t.toArray(r,e*16),i.needsUpdate=!0,this}getMatrixAt(e,t){return this.validateInstanceId(e),t.fromArray(this._matricesTexture.image.data,e*16)}setColorAt(e,t){return this.validateInstanceId(e),this._colorsTexture===null&&this._initColorsTexture(),t.toArray(this._colorsTexture.image.data,e*4),this._colorsTexture.needsUpdate=!0,this}getColorAt(e,t){return this.validateInstanceId(e),this._colorsTexture===null?t.isVector4?t.set(1,1,1,1):t.setRGB(1,1,1):t.fromArray(this._colorsTexture.image.data,e*4)}setVisibleAt(e,t){return this.validateInstanceId(e),this._instanceInfo[e].visible===t?this:(this._instanceInfo[e].visible=t,this._visibilityChanged=!0,this)}getVisibleAt(e){return this.validateInstanceId(e),this._instanceInfo[e].visible}setGeometryIdAt(e,t){return this.validateInstanceId(e),this.validateGeometryId(t),this._instanceInfo[e].geometryIndex=t,this._visibilityChanged=!0,this}getGeometryIdAt(e){return this.validateInstanceId(e),this._instanceInfo[e].geometryIndex}getGeometryRangeAt(e,t={}){this.validateGeometryId(e);let i=this._geometryInfo[e];return t.vertexStart=i.vertexStart,t.vertexCount=i.vertexCount,t.reservedVertexCount=i.reservedVertexCount,t.indexStart=i.indexStart,t.indexCount=i.indexCount,t.reservedIndexCount=i.reservedIndexCount,t.start=i.start,t.count=i.count,t}setInstanceCount(e){let t=this._availableInstanceIds,i=this._instanceInfo;for(t.sort(Tf);t[t.length-1]===i.length-1;)i.pop(),t.pop();if(e<i.length)throw new Error(`THREE.BatchedMesh: Instance ids outside the range ${e} are being used. Cannot shrink instance count.`);let r=new Int32Array(e),s=new Int32Array(e);sr(this._multiDrawCounts,r),sr(this._multiDrawStarts,s),this._multiDrawCounts=r,this._multiDrawStarts=s;let o=new Int32Array(e),a=new Int32Array(e),l=new Int32Array(e);sr(this._mergedDrawCounts,o),sr(this._mergedDrawStarts,a),sr(this._mergedDrawInstanceCounts,l),this._mergedDrawCounts=o,this._mergedDrawStarts=a,this._mergedDrawInstanceCounts=l,this._maxInstanceCount=e;let c=this._indirectTexture,h=this._matricesTexture,u=this._colorsTexture;c.dispose(),this._initIndirectTexture(),sr(c.image.data,this._indirectTexture.image.data),h.dispose(),this._initMatricesTexture(),sr(h.image.data,this._matricesTexture.image.data),u&&(u.dispose(),this._initColorsTexture(),sr(u.image.data,this._colorsTexture.image.data)),this._previousMatricesTexture!==null&&(this._previousMatricesTexture.dispose(),this._previousMatricesTexture=null)}setGeometrySize(e,t){let i=[...this._geometryInfo].filter(a=>a.active);if(Math.max(...i.map(a=>a.vertexStart+a.reservedVertexCount))>e)throw new Error(`THREE.BatchedMesh: Geometry vertex values are being used outside the range ${e}. Cannot shrink further.`);if(this.geometry.index&&Math.max(...i.map(l=>l.indexStart+l.reservedIndexCount))>t)throw new Error(`THREE.BatchedMesh: Geometry index values are being used outside the range ${t}. Cannot shrink further.`);let s=this.geometry;s.dispose(),this._maxVertexCount=e,this._maxIndexCount=t,this._geometryInitialized&&(this._geometryInitialized=!1,this.geometry=new Kt,this._initializeGeometry(s));let o=this.geometry;s.index&&sr(s.index.array,o.index.array);for(let a in s.attributes)sr(s.attributes[a].array,o.attributes[a].array);this._visibilityChanged=!0}raycast(e,t){let i=this._instanceInfo,r=this._geometryInfo,s=this.matrixWorld,o=this.geometry;Xi.material=this.material,Xi.geometry.index=o.index,Xi.geometry.attributes=o.attributes,Xi.geometry.boundingBox===null&&(Xi.geometry.boundingBox=new on),Xi.geometry.boundingSphere===null&&(Xi.geometry.boundingSphere=new Mn);for(let a=0,l=i.length;a<l;a++){if(!i[a].visible||!i[a].active)continue;let c=i[a].geometryIndex,h=r[c];Xi.geometry.setDrawRange(h.start,h.count),this.getMatrixAt(a,Xi.matrixWorld).premultiply(s),this.getBoundingBoxAt(c,Xi.geometry.boundingBox),this.getBoundingSphereAt(c,Xi.geometry.boundingSphere),Xi.raycast(e,Ac);for(let u=0,f=Ac.length;u<f;u++){let m=Ac[u];m.object=this,m.batchId=a,t.push(m)}Ac.length=0}Xi.material=null,Xi.geometry.index=null,Xi.geometry.attributes={},Xi.geometry.setDrawRange(0,1/0)}copy(e){return super.copy(e),this.geometry=e.geometry.clone(),this.perObjectFrustumCulled=e.perObjectFrustumCulled,this.sortObjects=e.sortObjects,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this._geometryInfo=e._geometryInfo.map(t=>({...t,boundingBox:t.boundingBox!==null?t.boundingBox.clone():null,boundingSphere:t.boundingSphere!==null?t.boundingSphere.clone():null})),this._instanceInfo=e._instanceInfo.map(t=>({...t})),this._availableInstanceIds=e._availableInstanceIds.slice(),this._availableGeometryIds=e._availableGeometryIds.slice(),this._nextIndexStart=e._nextIndexStart,this._nextVertexStart=e._nextVertexStart,this._geometryCount=e._geometryCount,this._maxInstanceCount=e._maxInstanceCount,this._maxVertexCount=e._maxVertexCount,this._maxIndexCount=e._maxIndexCount,this._geometryInitialized=e._geometryInitialized,this._multiDrawCounts=e._multiDrawCounts.slice(),this._multiDrawStarts=e._multiDrawStarts.slice(),this._multiDrawBytesPerElement=e._multiDrawBytesPerElement,this._mergedDrawCounts=e._mergedDrawCounts.slice(),this._mergedDrawStarts=e._mergedDrawStarts.slice(),this._mergedDrawInstanceCounts=e._mergedDrawInstanceCounts.slice(),this._indirectTexture=e._indirectTexture.clone(),this._indirectTexture.image.data=this._indirectTexture.image.data.slice(),this._matricesTexture=e._matricesTexture.clone(),this._matricesTexture.image.data=this._matricesTexture.image.data.slice(),e._colorsTexture!==null?(this._colorsTexture=e._colorsTexture.clone(),this._colorsTexture.image.data=this._colorsTexture.image.data.slice()):this._colorsTexture=null,this}dispose(){super.dispose(),this.geometry.dispose(),this._matricesTexture.dispose(),this._matricesTexture=null,this._indirectTexture.dispose(),this._indirectTexture=null,this._colorsTexture!==null&&(this._colorsTexture.dispose(),this._colorsTexture=null),this._previousMatricesTexture!==null&&(this._previousMatricesTexture.dispose(),this._previousMatricesTexture=null)}_updateDrawParameters(e,t,i,r="multiDraw"){if(!this._visibilityChanged&&!this.perObjectFrustumCulled&&!this.sortObjects)return;let s=t.getIndex(),o=s===null?1:s.array.BYTES_PER_ELEMENT,a=1;i.wireframe&&(a=2,o=t.attributes.position.count>65535?4:2);let l=this._instanceInfo,c=this._multiDrawStarts,h=this._multiDrawCounts,u=this._mergedDrawStarts,f=this._mergedDrawCounts,m=this._mergedDrawInstanceCounts,x=this._geometryInfo,S=this.perObjectFrustumCulled,d=this._indirectTexture,p=d.image.data,v=e.isArrayCamera?dM:hM;S&&(e.isArrayCamera?v.setFromArrayCamera(e):(an.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse).multiply(this.matrixWorld),v.setFromProjectionMatrix(an,e.coordinateSystem,e.reversedDepth)));let A=0,M=0;if(this.sortObjects){an.copy(this.matrixWorld).invert(),cm.setFromMatrixPosition(e.matrixWorld).applyMatrix4(an),um.set(0,0,-1).transformDirection(e.matrixWorld).transformDirection(an);for(let g=0,E=l.length;g<E;g++)if(l[g].visible&&l[g].active){let U=l[g].geometryIndex;this.getMatrixAt(g,an),this.getBoundingSphereAt(U,vs).applyMatrix4(an);let P=!1;if(S&&(P=!v.intersectsSphere(vs)),!P){let D=x[U],G=pM.subVectors(vs.center,cm).dot(um);Rf.push(D.start,D.count,G,g)}}let R=Rf.list,T=this.customSort;T===null?R.sort(i.transparent?uM:cM):T.call(this,R,e);for(let g=0,E=R.length;g<E;g++){let U=R[g],P=U.start*o*a,D=U.count*a;r==="merged"?M>0&&u[M-1]===P&&f[M-1]===D?m[M-1]++:(u[M]=P,f[M]=D,m[M]=1,M++):(c[A]=P,h[A]=D),p[A]=U.index,A++}Rf.reset()}else for(let R=0,T=l.length;R<T;R++)if(l[R].visible&&l[R].active){let g=l[R].geometryIndex,E=!1;if(S&&(this.getMatrixAt(R,an),this.getBoundingSphereAt(g,vs).applyMatrix4(an),E=!v.intersectsSphere(vs)),!E){let U=x[g],P=U.start*o*a,D=U.count*a;r==="merged"?M>0&&u[M-1]===P&&f[M-1]===D?m[M-1]++:(u[M]=P,f[M]=D,m[M]=1,M++):(c[A]=P,h[A]=D),p[A]=R,A++}}d.needsUpdate=!0,this._multiDrawCount=A,this._mergedDrawCount=M,this._multiDrawBytesPerElement=o,this._visibilityChanged=!1}onBeforeRender(e,t,i,r,s){e.isWebGPURenderer===!0?(this._visibilityChanged||this.perObjectFrustumCulled||this.sortObjects)&&(this._indirectTexture.needsUpdate=!0):this._updateDrawParameters(i,r,s)}onBeforeShadow(e,t,i,r,s,o){e.isWebGPURenderer!==!0&&this._updateDrawParameters(r,s,o)}};var yo=class extends ai{constructor(e=[],t=nr,i,r,s,o,a,l,c,h){super(e,t,i,r,s,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var En=class extends ai{constructor(e,t,i=gi,r,s,o,a=Xt,l=Xt,c,h=sn,u=1){if(h!==sn&&h!==_n)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:u};super(f,r,s,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Gr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}};var bo=class extends En{constructor(e,t=gi,i=nr,r,s,o=Xt,a=Xt,l,c=sn){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,i,r,s,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}};var Eo=class extends ai{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var Yr=class n extends Kt{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,m=0;x("z","y","x",-1,-1,i,t,e,o,s,0),x("z","y","x",1,-1,i,t,-e,o,s,1),x("x","z","y",1,1,e,i,t,r,o,2),x("x","z","y",1,-1,e,i,-t,r,o,3),x("x","y","z",1,-1,e,t,i,r,s,4),x("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(l),this.setAttribute("position",new Ft(c,3)),this.setAttribute("normal",new Ft(h,3)),this.setAttribute("uv",new Ft(u,2));function x(S,d,p,v,A,M,R,T,g,E,U){let P=M/g,D=R/E,G=M/2,k=R/2,N=T/2,W=g+1,Y=E+1,H=0,ce=0,$=new F;for(let Q=0;Q<Y;Q++){let ne=Q*D-k;for(let he=0;he<W;he++){let fe=he*P-G;$[S]=fe*v,$[d]=ne*A,$[p]=N,c.push($.x,$.y,$.z),$[S]=0,$[d]=0,$[p]=T>0?1:-1,h.push($.x,$.y,$.z),u.push(he/g),u.push(1-Q/E),H+=1}}for(let Q=0;Q<E;Q++)for(let ne=0;ne<g;ne++){let he=f+ne+W*Q,fe=f+ne+W*(Q+1),j=f+(ne+1)+W*(Q+1),me=f+(ne+1)+W*Q;l.push(he,fe,me),l.push(fe,j,me),ce+=6}a.addGroup(m,ce,U),m+=ce,f+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var wo=class n extends Kt{constructor(e=1,t=1,i=1,r=32,s=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:l};let c=this;r=Math.floor(r),s=Math.floor(s);let h=[],u=[],f=[],m=[],x=0,S=[],d=i/2,p=0;v(),o===!1&&(e>0&&A(!0),t>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new Ft(u,3)),this.setAttribute("normal",new Ft(f,3)),this.setAttribute("uv",new Ft(m,2));function v(){let M=new F,R=new F,T=0,g=(t-e)/i;for(let E=0;E<=s;E++){let U=[],P=E/s,D=P*(t-e)+e;for(let G=0;G<=r;G++){let k=G/r,N=k*l+a,W=Math.sin(N),Y=Math.cos(N);R.x=D*W,R.y=-P*i+d,R.z=D*Y,u.push(R.x,R.y,R.z),M.set(W,g,Y).normalize(),f.push(M.x,M.y,M.z),m.push(k,1-P),U.push(x++)}S.push(U)}for(let E=0;E<r;E++)for(let U=0;U<s;U++){let P=S[U][E],D=S[U+1][E],G=S[U+1][E+1],k=S[U][E+1];(e>0||U!==0)&&(h.push(P,D,k),T+=3),(t>0||U!==s-1)&&(h.push(D,G,k),T+=3)}c.addGroup(p,T,0),p+=T}function A(M){let R=x,T=new Ze,g=new F,E=0,U=M===!0?e:t,P=M===!0?1:-1;for(let G=1;G<=r;G++)u.push(0,d*P,0),f.push(0,P,0),m.push(.5,.5),x++;let D=x;for(let G=0;G<=r;G++){let N=G/r*l+a,W=Math.cos(N),Y=Math.sin(N);g.x=U*Y,g.y=d*P,g.z=U*W,u.push(g.x,g.y,g.z),f.push(0,P,0),T.x=W*.5+.5,T.y=Y*.5*P+.5,m.push(T.x,T.y),x++}for(let G=0;G<r;G++){let k=R+G,N=D+G;M===!0?h.push(N,N+1,k):h.push(N+1,N,k),E+=3}c.addGroup(p,E,M===!0?1:2),p+=E}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Rc=class n extends wo{constructor(e=1,t=1,i=32,r=1,s=!1,o=0,a=Math.PI*2){super(0,e,t,i,r,s,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:r,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var To=class n extends Kt{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),l=Math.floor(r),c=a+1,h=l+1,u=e/a,f=t/l,m=[],x=[],S=[],d=[];for(let p=0;p<h;p++){let v=p*f-o;for(let A=0;A<c;A++){let M=A*u-s;x.push(M,-v,0),S.push(0,0,1),d.push(A/a),d.push(1-p/l)}}for(let p=0;p<l;p++)for(let v=0;v<a;v++){let A=v+c*p,M=v+c*(p+1),R=v+1+c*(p+1),T=v+1+c*p;m.push(A,M,T),m.push(M,R,T)}this.setIndex(m),this.setAttribute("position",new Ft(x,3)),this.setAttribute("normal",new Ft(S,3)),this.setAttribute("uv",new Ft(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Cc=class n extends Kt{constructor(e=1,t=32,i=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new F,f=new F,m=[],x=[],S=[],d=[];for(let p=0;p<=i;p++){let v=[],A=p/i,M=o+A*a,R=e*Math.cos(M),T=Math.sqrt(e*e-R*R),g=0;p===0&&o===0?g=.5/t:p===i&&l===Math.PI&&(g=-.5/t);for(let E=0;E<=t;E++){let U=E/t,P=r+U*s;u.x=-T*Math.cos(P),u.y=R,u.z=T*Math.sin(P),x.push(u.x,u.y,u.z),f.copy(u).normalize(),S.push(f.x,f.y,f.z),d.push(U+g,1-A),v.push(c++)}h.push(v)}for(let p=0;p<i;p++)for(let v=0;v<t;v++){let A=h[p][v+1],M=h[p][v],R=h[p+1][v],T=h[p+1][v+1];(p!==0||o>0)&&m.push(A,M,T),(p!==i-1||l<Math.PI)&&m.push(M,R,T)}this.setIndex(m),this.setAttribute("position",new Ft(x,3)),this.setAttribute("normal",new Ft(S,3)),this.setAttribute("uv",new Ft(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Er(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(fm(r))r.isRenderTargetTexture?(ze("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(fm(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function qi(n){let e={};for(let t=0;t<n.length;t++){let i=Er(n[t]);for(let r in i)e[r]=i[r]}return e}function fm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function hm(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Pc(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:it.workingColorSpace}var dm={clone:Er,merge:qi};var pm=`
void main() {
gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}
`;var mm=`
void main() {
gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}
`;var tn=class extends Dn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=pm,this.fragmentShader=mm,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Er(e.uniforms),this.uniformsGroups=hm(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new Xe().setHex(r.value);break;case"v2":this.uniforms[i].value=new Ze().fromArray(r.value);break;case"v3":this.uniforms[i].value=new F().fromArray(r.value);break;case"v4":this.uniforms[i].value=new bt().fromArray(r.value);break;case"m3":this.uniforms[i].value=new Ke().fromArray(r.value);break;case"m4":this.uniforms[i].value=new Ve().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}};var Lc=class extends tn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ss=class extends Dn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Xe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ga,this.normalScale=new Ze(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=qs,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Dc=class extends Dn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Rp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}};var Ic=class extends Dn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var Ao=class extends Yt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Xe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var qa=class extends Ao{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Yt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Xe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}};var Pf=new Ve,gm=new F,xm=new F,Nc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ze(512,512),this.mapType=oi,this.map=null,this.mapPass=null,this.matrix=new Ve,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new bn,this._frameExtents=new Ze(1,1),this._viewportCount=1,this._viewports=[new bt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;gm.setFromMatrixPosition(e.matrixWorld),t.position.copy(gm),xm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(xm),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,r){Pf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Pf,e.coordinateSystem,e.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,l=r?r.x/s.x:0,c=r?r.y/s.y:0;e.coordinateSystem===_r||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Pf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var Uc=new F,Fc=new qt,or=new F,Ro=class extends Yt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ve,this.projectionMatrix=new Ve,this.projectionMatrixInverse=new Ve,this.coordinateSystem=Fi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Uc,Fc,or),or.x===1&&or.y===1&&or.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Uc,Fc,or.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Uc,Fc,or),or.x===1&&or.y===1&&or.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Uc,Fc,or.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}};var Kr=new F,_m=new Ze,vm=new Ze,Ni=class extends Ro{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=za*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ic*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return za*2*Math.atan(Math.tan(ic*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Kr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Kr.x,Kr.y).multiplyScalar(-e/Kr.z),Kr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Kr.x,Kr.y).multiplyScalar(-e/Kr.z)}getViewSize(e,t){return this.getViewBounds(e,_m,vm),t.subVectors(vm,_m)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ic*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*i/c,r*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Co=class extends Ro{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Oc=class extends Nc{constructor(){super(new Co(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}};var Ya=class extends Ao{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Yt.DEFAULT_UP),this.updateMatrix(),this.target=new Yt,this.shadow=new Oc}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Po=-90,Lo=1,Ms=class extends Yt{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Ni(Po,Lo,e,t);r.layers=this.layers,this.add(r);let s=new Ni(Po,Lo,e,t);s.layers=this.layers,this.add(s);let o=new Ni(Po,Lo,e,t);o.layers=this.layers,this.add(o);let a=new Ni(Po,Lo,e,t);a.layers=this.layers,this.add(a);let l=new Ni(Po,Lo,e,t);l.layers=this.layers,this.add(l);let c=new Ni(Po,Lo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===Fi)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===_r)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,h]=this.children,u=e.getRenderTarget(),f=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),x=e.xr.enabled;e.xr.enabled=!1;let S=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let d=!1;e.isWebGLRenderer===!0?d=e.state.buffers.depth.getReversed():d=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=S,e.setRenderTarget(i,5,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,f,m),e.xr.enabled=x,i.texture.needsPMREMUpdate=!0}};var Bc=class extends Ni{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Sm=new Ve,Ka=class{constructor(e,t,i=0,r=1/0){this.ray=new So(e,t),this.near=i,this.far=r,this.camera=null,this.layers=new kr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):ht("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Sm.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Sm),this}intersectObject(e,t=!0,i=[]){return Lf(e,this,i,t),i.sort(Mm),i}intersectObjects(e,t=!0,i=[]){for(let r=0,s=e.length;r<s;r++)Lf(e[r],this,i,t);return i.sort(Mm),i}};function Mm(n,e){return n.distance-e.distance}function Lf(n,e,t,i){let r=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(r=!1),r===!0&&i===!0){let s=n.children;for(let o=0,a=s.length;o<a;o++)Lf(s[o],e,t,!0)}}function Df(n,e,t,i){let r=gM(i);switch(t){case Zl:return n*e;case Jl:return n*e/r.components*r.byteLength;case Br:return n*e/r.components*r.byteLength;case vn:return n*e*2/r.components*r.byteLength;case $s:return n*e*2/r.components*r.byteLength;case $l:return n*e*3/r.components*r.byteLength;case bi:return n*e*4/r.components*r.byteLength;case Js:return n*e*4/r.components*r.byteLength;case Qs:case js:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case eo:case to:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ua:case ha:return Math.max(n,16)*Math.max(e,8)/4;case ca:case fa:return Math.max(n,8)*Math.max(e,8)/2;case da:case pa:case ga:case xa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case ma:case cs:case _a:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case va:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Sa:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Ma:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case ya:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case ba:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Ea:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case wa:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Ta:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Aa:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Ra:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Ca:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Pa:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case La:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Da:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Ia:case Na:case Ua:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Fa:case Oa:return Math.ceil(n/4)*Math.ceil(e/4)*8;case us:case Ba:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function gM(n){switch(n){case oi:case Xl:return{byteLength:1,components:1};case xr:case ql:case Di:return{byteLength:2,components:1};case Ks:case Zs:return{byteLength:2,components:4};case gi:case Ys:case xi:return{byteLength:4,components:1};case Yl:case Kl:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ze("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Gc(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function ym(n){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,h),a.onUploadCallback();let m;if(c instanceof Float32Array)m=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=n.HALF_FLOAT:m=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=n.SHORT;else if(c instanceof Uint32Array)m=n.UNSIGNED_INT;else if(c instanceof Int32Array)m=n.INT;else if(c instanceof Int8Array)m=n.BYTE;else if(c instanceof Uint8Array)m=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((m,x)=>m.start-x.start);let f=0;for(let m=1;m<u.length;m++){let x=u[f],S=u[m];S.start<=x.start+x.count+1?x.count=Math.max(x.count,S.start+S.count-x.start):(++f,u[f]=S)}u.length=f+1;for(let m=0,x=u.length;m<x;m++){let S=u[m];n.bufferSubData(c,S.start*h.BYTES_PER_ELEMENT,h,S.start,S.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var bm=`
#ifdef USE_ALPHAHASH
if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif
`;var Em=`
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
`;var wm=`
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif
`;var Tm=`
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif
`;var Am=`
#ifdef USE_ALPHATEST
#ifdef ALPHA_TO_COVERAGE
diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
if ( diffuseColor.a == 0.0 ) discard;
#else
if ( diffuseColor.a < alphaTest ) discard;
#endif
#endif
`;var Rm=`
#ifdef USE_ALPHATEST
uniform float alphaTest;
#endif
`;var Cm=`
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
`;var Pm=`
#ifdef USE_AOMAP
uniform sampler2D aoMap;
uniform float aoMapIntensity;
#endif
`;var Lm=`
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
`;var Dm=`
#ifdef USE_BATCHING
mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif
`;var Im=`
vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
vPosition = vec3( position );
#endif
`;var Nm=`
vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
vec3 objectTangent = vec3( tangent.xyz );
#endif
`;var Um=`
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
`;var Fm=`
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
`;var Om=`
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
`;var Bm=`
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
`;var Gm=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif
`;var zm=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
#endif
`;var km=`
#if NUM_CLIPPING_PLANES > 0
vClipPosition = - mvPosition.xyz;
#endif
`;var Vm=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
diffuseColor *= vColor;
#endif
`;var Hm=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
varying vec4 vColor;
#endif
`;var Wm=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
varying vec4 vColor;
#endif
`;var Xm=`
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
`;var qm=`
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
`;var Ym=`
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
`;var Km=`
#ifdef USE_DISPLACEMENTMAP
uniform sampler2D displacementMap;
uniform float displacementScale;
uniform float displacementBias;
#endif
`;var Zm=`
#ifdef USE_DISPLACEMENTMAP
transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif
`;var $m=`
#ifdef USE_EMISSIVEMAP
vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
emissiveColor = sRGBTransferEOTF( emissiveColor );
#endif
totalEmissiveRadiance *= emissiveColor.rgb;
#endif
`;var Jm=`
#ifdef USE_EMISSIVEMAP
uniform sampler2D emissiveMap;
#endif
`;var Qm=`
gl_FragColor = linearToOutputTexel( gl_FragColor );
`;var jm=`
vec4 LinearTransferOETF( in vec4 value ) {
return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}
`;var eg=`
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
`;var tg=`
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
`;var ig=`
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
`;var ng=`
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
`;var rg=`
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
`;var sg=`
#ifdef USE_FOG
vFogDepth = - mvPosition.z;
#endif
`;var og=`
#ifdef USE_FOG
varying float vFogDepth;
#endif
`;var ag=`
#ifdef USE_FOG
#ifdef FOG_EXP2
float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
#else
float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
#endif
gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif
`;var lg=`
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
`;var cg=`
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
`;var ug=`
#ifdef USE_LIGHTMAP
uniform sampler2D lightMap;
uniform float lightMapIntensity;
#endif
`;var fg=`
LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;
`;var hg=`
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
`;var dg=`
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
`;var pg=`
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
`;var mg=`
ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;
`;var gg=`
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
`;var xg=`
BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;
`;var _g=`
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
`;var vg=`
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
`;var Sg=`
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
`;var Mg=`
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
`;var yg=`
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
`;var bg=`
#if defined( RE_IndirectDiffuse )
#if defined( LAMBERT ) || defined( PHONG )
irradiance += iblIrradiance;
#endif
RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
`;var Eg=`
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
`;var wg=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif
`;var Tg=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
uniform float logDepthBufFC;
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var Ag=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var Rg=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
vFragDepth = 1.0 + gl_Position.w;
vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif
`;var Cg=`
#ifdef USE_MAP
vec4 sampledDiffuseColor = texture2D( map, vMapUv );
#ifdef DECODE_VIDEO_TEXTURE
sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
#endif
diffuseColor *= sampledDiffuseColor;
#endif
`;var Pg=`
#ifdef USE_MAP
uniform sampler2D map;
#endif
`;var Lg=`
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
`;var Dg=`
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
`;var Ig=`
float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
metalnessFactor *= texelMetalness.b;
#endif
`;var Ng=`
#ifdef USE_METALNESSMAP
uniform sampler2D metalnessMap;
#endif
`;var Ug=`
#ifdef USE_INSTANCING_MORPH
float morphTargetInfluences[ MORPHTARGETS_COUNT ];
float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
}
#endif
`;var Fg=`
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
`;var Og=`
#ifdef USE_MORPHNORMALS
objectNormal *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var Bg=`
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
`;var Gg=`
#ifdef USE_MORPHTARGETS
transformed *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var zg=`
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
`;var kg=`
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
`;var Vg=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var Hg=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var Wg=`
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
`;var Xg=`
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
`;var qg=`
#ifdef USE_CLEARCOAT
vec3 clearcoatNormal = nonPerturbedNormal;
#endif
`;var Yg=`
#ifdef USE_CLEARCOAT_NORMALMAP
vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
clearcoatMapN.xy *= clearcoatNormalScale;
clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif
`;var Kg=`
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
`;var Zg=`
#ifdef USE_IRIDESCENCEMAP
uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform sampler2D iridescenceThicknessMap;
#endif
`;var $g=`
#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );
`;var Jg=`
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
`;var Qg=`
#ifdef PREMULTIPLIED_ALPHA
gl_FragColor.rgb *= gl_FragColor.a;
#endif
`;var jg=`
vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;
`;var ex=`
#ifdef DITHERING
gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif
`;var tx=`
#ifdef DITHERING
vec3 dithering( vec3 color ) {
float grid_position = rand( gl_FragCoord.xy );
vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
return color + dither_shift_RGB;
}
#endif
`;var ix=`
float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
roughnessFactor *= texelRoughness.g;
#endif
`;var nx=`
#ifdef USE_ROUGHNESSMAP
uniform sampler2D roughnessMap;
#endif
`;var rx=`
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
`;var sx=`
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
`;var ox=`
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
`;var ax=`
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
`;var lx=`
#ifdef USE_SKINNING
mat4 boneMatX = getBoneMatrix( skinIndex.x );
mat4 boneMatY = getBoneMatrix( skinIndex.y );
mat4 boneMatZ = getBoneMatrix( skinIndex.z );
mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif
`;var cx=`
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
`;var ux=`
#ifdef USE_SKINNING
vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
vec4 skinned = vec4( 0.0 );
skinned += boneMatX * skinVertex * skinWeight.x;
skinned += boneMatY * skinVertex * skinWeight.y;
skinned += boneMatZ * skinVertex * skinWeight.z;
skinned += boneMatW * skinVertex * skinWeight.w;
transformed = ( bindMatrixInverse * skinned ).xyz;
#endif
`;var fx=`
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
`;var hx=`
float specularStrength;
#ifdef USE_SPECULARMAP
vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
specularStrength = texelSpecular.r;
#else
specularStrength = 1.0;
#endif
`;var dx=`
#ifdef USE_SPECULARMAP
uniform sampler2D specularMap;
#endif
`;var px=`
#if defined( TONE_MAPPING )
gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif
`;var mx=`
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
`;var gx=`
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
`;var xx=`
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
`;var _x=`
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
`;var vx=`
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
`;var Sx=`
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
`;var Mx=`
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
`;var yx=`
varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
gl_Position = vec4( position.xy, 1.0, 1.0 );
}
`,bx=`
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
`;var Ex=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,wx=`
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
`;var Tx=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,Ax=`
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
`;var Rx=`
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
`,Cx=`
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
`;var Px=`
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
`,Lx=`
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
`;var Dx=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
}
`,Ix=`
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
`;var Nx=`
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
`,Ux=`
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
`;var Fx=`
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
`,Ox=`
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
`;var Bx=`
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
`,Gx=`
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
`;var zx=`
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
`,kx=`
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
`;var Vx=`
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
`,Hx=`
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
`;var Wx=`
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
`,Xx=`
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
`;var qx=`
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
`,Yx=`
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
`;var Kx=`
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
`,Zx=`
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
`;var $x=`
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
`,Jx=`
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
`;var Qx=`
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
`,jx=`
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
`;var e0=`
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
`,t0=`
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
`;var at={alphahash_fragment:bm,alphahash_pars_fragment:Em,alphamap_fragment:wm,alphamap_pars_fragment:Tm,alphatest_fragment:Am,alphatest_pars_fragment:Rm,aomap_fragment:Cm,aomap_pars_fragment:Pm,batching_pars_vertex:Lm,batching_vertex:Dm,begin_vertex:Im,beginnormal_vertex:Nm,bsdfs:Um,iridescence_fragment:Fm,bumpmap_pars_fragment:Om,clipping_planes_fragment:Bm,clipping_planes_pars_fragment:Gm,clipping_planes_pars_vertex:zm,clipping_planes_vertex:km,color_fragment:Vm,color_pars_fragment:Hm,color_pars_vertex:Wm,color_vertex:Xm,common:qm,defaultnormal_vertex:Ym,displacementmap_pars_vertex:Km,displacementmap_vertex:Zm,emissivemap_fragment:$m,emissivemap_pars_fragment:Jm,colorspace_fragment:Qm,colorspace_pars_fragment:jm,envmap_fragment:eg,envmap_common_pars_fragment:tg,envmap_pars_fragment:ig,envmap_pars_vertex:ng,envmap_physical_pars_fragment:pg,envmap_vertex:rg,fog_vertex:sg,fog_pars_vertex:og,fog_fragment:ag,fog_pars_fragment:lg,gradientmap_pars_fragment:cg,lightmap_pars_fragment:ug,lights_lambert_fragment:fg,lights_lambert_pars_fragment:hg,lights_pars_begin:dg,lights_toon_fragment:mg,lights_toon_pars_fragment:gg,lights_phong_fragment:xg,lights_phong_pars_fragment:_g,lights_physical_fragment:vg,lights_physical_pars_fragment:Sg,lights_fragment_begin:Mg,lights_fragment_maps:yg,lights_fragment_end:bg,lightprobes_pars_fragment:Eg,logdepthbuf_fragment:wg,logdepthbuf_pars_fragment:Tg,logdepthbuf_pars_vertex:Ag,logdepthbuf_vertex:Rg,map_fragment:Cg,map_pars_fragment:Pg,map_particle_fragment:Lg,map_particle_pars_fragment:Dg,metalnessmap_fragment:Ig,metalnessmap_pars_fragment:Ng,morphinstance_vertex:Ug,morphcolor_vertex:Fg,morphnormal_vertex:Og,morphtarget_pars_vertex:Bg,morphtarget_vertex:Gg,normal_fragment_begin:zg,normal_fragment_maps:kg,normal_pars_fragment:Vg,normal_pars_vertex:Hg,normal_vertex:Wg,normalmap_pars_fragment:Xg,clearcoat_normal_fragment_begin:qg,clearcoat_normal_fragment_maps:Yg,clearcoat_pars_fragment:Kg,iridescence_pars_fragment:Zg,opaque_fragment:$g,packing:Jg,premultiplied_alpha_fragment:Qg,project_vertex:jg,dithering_fragment:ex,dithering_pars_fragment:tx,roughnessmap_fragment:ix,roughnessmap_pars_fragment:nx,shadowmap_pars_fragment:rx,shadowmap_pars_vertex:sx,shadowmap_vertex:ox,shadowmask_pars_fragment:ax,skinbase_vertex:lx,skinning_pars_vertex:cx,skinning_vertex:ux,skinnormal_vertex:fx,specularmap_fragment:hx,specularmap_pars_fragment:dx,tonemapping_fragment:px,tonemapping_pars_fragment:mx,transmission_fragment:gx,transmission_pars_fragment:xx,uv_pars_fragment:_x,uv_pars_vertex:vx,uv_vertex:Sx,worldpos_vertex:Mx,background_vert:yx,background_frag:bx,backgroundCube_vert:Ex,backgroundCube_frag:wx,cube_vert:Tx,cube_frag:Ax,depth_vert:Rx,depth_frag:Cx,distance_vert:Px,distance_frag:Lx,equirect_vert:Dx,equirect_frag:Ix,linedashed_vert:Nx,linedashed_frag:Ux,meshbasic_vert:Fx,meshbasic_frag:Ox,meshlambert_vert:Bx,meshlambert_frag:Gx,meshmatcap_vert:zx,meshmatcap_frag:kx,meshnormal_vert:Vx,meshnormal_frag:Hx,meshphong_vert:Wx,meshphong_frag:Xx,meshphysical_vert:qx,meshphysical_frag:Yx,meshtoon_vert:Kx,meshtoon_frag:Zx,points_vert:$x,points_frag:Jx,shadow_vert:Qx,shadow_frag:jx,sprite_vert:e0,sprite_frag:t0};var Le={common:{diffuse:{value:new Xe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ke},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ke}},envmap:{envMap:{value:null},envMapRotation:{value:new Ke},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ke}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ke}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ke},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ke},normalScale:{value:new Ze(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ke},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ke}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ke}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ke}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Xe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Xe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0},uvTransform:{value:new Ke}},sprite:{diffuse:{value:new Xe(16777215)},opacity:{value:1},center:{value:new Ze(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ke},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0}}};var In={basic:{uniforms:qi([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:at.meshbasic_vert,fragmentShader:at.meshbasic_frag},lambert:{uniforms:qi([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)},envMapIntensity:{value:1}}]),vertexShader:at.meshlambert_vert,fragmentShader:at.meshlambert_frag},phong:{uniforms:qi([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)},specular:{value:new Xe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:at.meshphong_vert,fragmentShader:at.meshphong_frag},standard:{uniforms:qi([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag},toon:{uniforms:qi([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new Xe(0)}}]),vertexShader:at.meshtoon_vert,fragmentShader:at.meshtoon_frag},matcap:{uniforms:qi([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:at.meshmatcap_vert,fragmentShader:at.meshmatcap_frag},points:{uniforms:qi([Le.points,Le.fog]),vertexShader:at.points_vert,fragmentShader:at.points_frag},dashed:{uniforms:qi([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:at.linedashed_vert,fragmentShader:at.linedashed_frag},depth:{uniforms:qi([Le.common,Le.displacementmap]),vertexShader:at.depth_vert,fragmentShader:at.depth_frag},normal:{uniforms:qi([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:at.meshnormal_vert,fragmentShader:at.meshnormal_frag},sprite:{uniforms:qi([Le.sprite,Le.fog]),vertexShader:at.sprite_vert,fragmentShader:at.sprite_frag},background:{uniforms:{uvTransform:{value:new Ke},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:at.background_vert,fragmentShader:at.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ke}},vertexShader:at.backgroundCube_vert,fragmentShader:at.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:at.cube_vert,fragmentShader:at.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:at.equirect_vert,fragmentShader:at.equirect_frag},distance:{uniforms:qi([Le.common,Le.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:at.distance_vert,fragmentShader:at.distance_frag},shadow:{uniforms:qi([Le.lights,Le.fog,{color:{value:new Xe(0)},opacity:{value:1}}]),vertexShader:at.shadow_vert,fragmentShader:at.shadow_frag}};In.physical={uniforms:qi([In.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ke},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ke},clearcoatNormalScale:{value:new Ze(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ke},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ke},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ke},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ke},sheen:{value:0},sheenColor:{value:new Xe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ke},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ke},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ke},transmissionSamplerSize:{value:new Ze},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ke},attenuationDistance:{value:0},attenuationColor:{value:new Xe(0)},specularColor:{value:new Xe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ke},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ke},anisotropyVector:{value:new Ze},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ke}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag};var zc={r:0,b:0,g:0},NM=new Ve,i0=new Ke;i0.set(-1,0,0,0,1,0,0,0,1);function n0(n,e,t,i,r,s){let o=new Xe(0),a=r===!0?0:1,l,c,h=null,u=0,f=null;function m(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let M=v.backgroundBlurriness>0;A=e.get(A,M)}return A}function x(v){let A=!1,M=m(v);M===null?d(o,a):M&&M.isColor&&(d(M,1),A=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,s):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function S(v,A){let M=m(A);M&&M.isCubeTexture?(c===void 0&&(c=new Jt(new Yr(1,1,1),new tn({name:"BackgroundCubeMaterial",uniforms:Er(In.backgroundCube.uniforms),vertexShader:In.backgroundCube.vertexShader,fragmentShader:In.backgroundCube.fragmentShader,side:$t,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,T,g){this.matrixWorld.copyPosition(g.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(NM.makeRotationFromEuler(A.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(i0),c.material.toneMapped=it.getTransfer(M.colorSpace)!==vt,(h!==M||u!==M.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,h=M,u=M.version,f=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Jt(new To(2,2),new tn({name:"BackgroundMaterial",uniforms:Er(In.background.uniforms),vertexShader:In.background.vertexShader,fragmentShader:In.background.fragmentShader,side:nn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=it.getTransfer(M.colorSpace)!==vt,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||u!==M.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,h=M,u=M.version,f=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function d(v,A){v.getRGB(zc,Pc(n)),t.buffers.color.setClear(zc.r,zc.g,zc.b,A,s)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,d(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,d(o,a)},render:x,addToRenderList:S,dispose:p}}function r0(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=f(null),s=r,o=!1;function a(D,G,k,N,W){let Y=!1,H=u(D,N,k,G);s!==H&&(s=H,c(s.object)),Y=m(D,N,k,W),Y&&x(D,N,k,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,M(D,G,k,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function h(D){return n.deleteVertexArray(D)}function u(D,G,k,N){let W=N.wireframe===!0,Y=i[G.id];Y===void 0&&(Y={},i[G.id]=Y);let H=D.isInstancedMesh===!0?D.id:0,ce=Y[H];ce===void 0&&(ce={},Y[H]=ce);let $=ce[k.id];$===void 0&&($={},ce[k.id]=$);let Q=$[W];return Q===void 0&&(Q=f(l()),$[W]=Q),Q}function f(D){let G=[],k=[],N=[];for(let W=0;W<t;W++)G[W]=0,k[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:k,attributeDivisors:N,object:D,attributes:{},index:null}}function m(D,G,k,N){let W=s.attributes,Y=G.attributes,H=0,ce=k.getAttributes();for(let $ in ce)if(ce[$].location>=0){let ne=W[$],he=Y[$];if(he===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(he=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(he=D.instanceColor)),ne===void 0||ne.attribute!==he||he&&ne.data!==he.data)return!0;H++}return s.attributesNum!==H||s.index!==N}function x(D,G,k,N){let W={},Y=G.attributes,H=0,ce=k.getAttributes();for(let $ in ce)if(ce[$].location>=0){let ne=Y[$];ne===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(ne=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(ne=D.instanceColor));let he={};he.attribute=ne,ne&&ne.data&&(he.data=ne.data),W[$]=he,H++}s.attributes=W,s.attributesNum=H,s.index=N}function S(){let D=s.newAttributes;for(let G=0,k=D.length;G<k;G++)D[G]=0}function d(D){p(D,0)}function p(D,G){let k=s.newAttributes,N=s.enabledAttributes,W=s.attributeDivisors;k[D]=1,N[D]===0&&(n.enableVertexAttribArray(D),N[D]=1),W[D]!==G&&(n.vertexAttribDivisor(D,G),W[D]=G)}function v(){let D=s.newAttributes,G=s.enabledAttributes;for(let k=0,N=G.length;k<N;k++)G[k]!==D[k]&&(n.disableVertexAttribArray(k),G[k]=0)}function A(D,G,k,N,W,Y,H){H===!0?n.vertexAttribIPointer(D,G,k,W,Y):n.vertexAttribPointer(D,G,k,N,W,Y)}function M(D,G,k,N){S();let W=N.attributes,Y=k.getAttributes(),H=G.defaultAttributeValues;for(let ce in Y){let $=Y[ce];if($.location>=0){let Q=W[ce];if(Q===void 0&&(ce==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),ce==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let ne=Q.normalized,he=Q.itemSize,fe=e.get(Q);if(fe===void 0)continue;let j=fe.buffer,me=fe.type,_e=fe.bytesPerElement,Ae=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===Ys;if(Q.isInterleavedBufferAttribute){let ye=Q.data,qe=ye.isInterleavedBuffer===!0?ye.stride:ye.itemSize,st=Q.offset;if(ye.isInstancedInterleavedBuffer||ye.isInstancedBufferAttribute){for(let He=0;He<$.locationSize;He++)p($.location+He,ye.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ye.meshPerAttribute*ye.count)}else for(let He=0;He<$.locationSize;He++)d($.location+He);n.bindBuffer(n.ARRAY_BUFFER,j);for(let He=0;He<$.locationSize;He++)A($.location+He,he/$.locationSize,me,ne,qe*_e,(st+he/$.locationSize*He)*_e,Ae)}else{if(Q.isInstancedBufferAttribute){for(let ye=0;ye<$.locationSize;ye++)p($.location+ye,Q.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ye=0;ye<$.locationSize;ye++)d($.location+ye);n.bindBuffer(n.ARRAY_BUFFER,j);for(let ye=0;ye<$.locationSize;ye++)A($.location+ye,he/$.locationSize,me,ne,he*_e,he/$.locationSize*ye*_e,Ae)}}else if(H!==void 0){let ne=H[ce];if(ne!==void 0)switch(ne.length){case 2:n.vertexAttrib2fv($.location,ne);break;case 3:n.vertexAttrib3fv($.location,ne);break;case 4:n.vertexAttrib4fv($.location,ne);break;default:n.vertexAttrib1fv($.location,ne)}}}}v()}function R(){U();for(let D in i){let G=i[D];for(let k in G){let N=G[k];for(let W in N){let Y=N[W];for(let H in Y)h(Y[H].object),delete Y[H];delete N[W]}}delete i[D]}}function T(D){if(i[D.id]===void 0)return;let G=i[D.id];for(let k in G){let N=G[k];for(let W in N){let Y=N[W];for(let H in Y)h(Y[H].object),delete Y[H];delete N[W]}}delete i[D.id]}function g(D){for(let G in i){let k=i[G];for(let N in k){let W=k[N];if(W[D.id]===void 0)continue;let Y=W[D.id];for(let H in Y)h(Y[H].object),delete Y[H];delete W[D.id]}}}function E(D){for(let G in i){let k=i[G],N=D.isInstancedMesh===!0?D.id:0,W=k[N];if(W!==void 0){for(let Y in W){let H=W[Y];for(let ce in H)h(H[ce].object),delete H[ce];delete W[Y]}delete k[N],Object.keys(k).length===0&&delete i[G]}}}function U(){P(),o=!0,s!==r&&(s=r,c(s.object))}function P(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:U,resetDefaultState:P,dispose:R,releaseStatesOfGeometry:T,releaseStatesOfObject:E,releaseStatesOfProgram:g,initAttributes:S,enableAttribute:d,disableUnusedAttributes:v}}function s0(n,e,t){let i;function r(l){i=l}function s(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),t.update(c,i,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let f=0;for(let m=0;m<h;m++)f+=c[m];t.update(f,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function o0(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let g=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(g.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(g){return!(g!==bi&&i.convert(g)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(g){let E=g===Di&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(g!==oi&&g!==xi&&!E&&i.convert(g)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(g){if(g==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";g="mediump"}return g==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(ze("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&ze("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&ze("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),S=n.getParameter(n.MAX_TEXTURE_SIZE),d=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:m,maxVertexTextures:x,maxTextureSize:S,maxCubemapSize:d,maxAttributes:p,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:M,maxSamples:R,samples:T}}function a0(n){let e=this,t=null,i=0,r=!1,s=!1,o=new Wi,a=new Ke,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let m=u.length!==0||f||i!==0||r;return r=f,i=u.length,m},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(u,f){t=h(u,f,0)},this.setState=function(u,f,m){let x=u.clippingPlanes,S=u.clipIntersection,d=u.clipShadows,p=n.get(u);if(!r||x===null||x.length===0||s&&!d)s?h(null):c();else{let v=s?0:i,A=v*4,M=p.clippingState||null;l.value=M,M=h(x,f,A,m);for(let R=0;R!==A;++R)M[R]=t[R];p.clippingState=M,this.numIntersection=S?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(u,f,m,x){let S=u!==null?u.length:0,d=null;if(S!==0){if(d=l.value,x!==!0||d===null){let p=m+S*4,v=f.matrixWorldInverse;a.getNormalMatrix(v),(d===null||d.length<p)&&(d=new Float32Array(p));for(let A=0,M=m;A!==S;++A,M+=4)o.copy(u[A]).applyMatrix4(v,a),o.normal.toArray(d,M),d[M+3]=o.constant}l.value=d,l.needsUpdate=!0}return e.numPlanes=S,e.numIntersection=0,d}}var Zr=class extends Oi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new yo(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new Yr(5,5,5),s=new tn({name:"CubemapFromEquirect",uniforms:Er(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:$t,blending:ir});s.uniforms.tEquirect.value=t;let o=new Jt(r,s),a=t.minFilter;return t.minFilter===xn&&(t.minFilter=mi),new Ms(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}};var l0=256,UM=3,FM=20,h0=256,d0=16,OM=3,BM=new F,GM=new Xe,Za=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ms(1,10,null),this._boxMesh=new Jt(new Yr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=BM}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,m=l.autoClearDepth,x=l.autoClearStencil,S=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,S===null&&(e.background=l.getClearColor(GM));let d=new Ms(i,r,h);return d.position.copy(a),d.update(l,e),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=m,l.autoClearStencil=x,e.background=S,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=f0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=u0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(l0,Wp(e))}_fromTexture(e,t){e.mapping===nr||e.mapping===Or?this._setSize(e.image.length===0?l0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=c0(e,!1,!1),i=Math.log2(e)-UM;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=c0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===nr||e.mapping===Or?(this._cubemapMaterial===null&&(this._cubemapMaterial=f0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=u0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=zM(),this._integrationMaterial=kM());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/d0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-OM)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(h0*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=VM());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function c0(n,e,t){return new Zr(n,{minFilter:xn,generateMipmaps:e,type:Di,colorSpace:fs,depthBuffer:t})}function $a(n,e,t){return new tn({name:n,uniforms:e,vertexShader:at.cube_vert,fragmentShader:t,side:$t,blending:ir,depthTest:!1,depthWrite:!1})}function zM(){return $a("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${h0}u

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
	`)}function kM(){return $a("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:d0}},`

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
	`)}function VM(){return $a("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${FM}
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
	`)}function u0(){return $a("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function f0(){return $a("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function p0(n){let e=new WeakMap,t=new WeakMap,i=null;function r(f,m=!1){return f==null?null:m?o(f):s(f)}function s(f){if(f&&f.isTexture){let m=f.mapping;if(m===Vl||m===Hl)if(e.has(f)){let x=e.get(f).texture;return a(x,f.mapping)}else{let x=f.image;if(x&&x.height>0){let S=new Zr(x.height);return S.fromEquirectangularTexture(n,f),e.set(f,S),f.addEventListener("dispose",c),a(S.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let m=f.mapping,x=m===Vl||m===Hl,S=m===nr||m===Or;if(x||S){let d=t.get(f),p=d!==void 0?d.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==p)return i===null&&(i=new Za(n)),d=x?i.fromEquirectangular(f,d):i.fromCubemap(f,d),d.texture.pmremVersion=f.pmremVersion,t.set(f,d),d.texture;if(d!==void 0)return d.texture;{let v=f.image;return x&&v&&v.height>0||S&&v&&l(v)?(i===null&&(i=new Za(n)),d=x?i.fromEquirectangular(f):i.fromCubemap(f),d.texture.pmremVersion=f.pmremVersion,t.set(f,d),f.addEventListener("dispose",h),d.texture):null}}}return f}function a(f,m){return m===Vl?f.mapping=nr:m===Hl&&(f.mapping=Or),f}function l(f){let m=0,x=6;for(let S=0;S<x;S++)f[S]!==void 0&&m++;return m===x}function c(f){let m=f.target;m.removeEventListener("dispose",c);let x=e.get(m);x!==void 0&&(e.delete(m),x.dispose())}function h(f){let m=f.target;m.removeEventListener("dispose",h);let x=t.get(m);x!==void 0&&(t.delete(m),x.dispose())}function u(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:u}}function m0(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&ds("WebGLRenderer: "+i+" extension not supported."),r}}}function g0(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(x=>delete r[x]);function a(x){l(x.target)}function l(x){x.index!==null&&e.remove(x.index);for(let d in x.attributes)e.remove(x.attributes[d]);x.removeEventListener("dispose",a),delete r[x.id],o.unregister(x);let S=s.get(x);S&&(e.remove(S),s.delete(x)),i.releaseStatesOfGeometry(x),x.isInstancedBufferGeometry===!0&&delete x._maxInstanceCount,t.memory.geometries--}function c(x,S){return r[S.id]!==void 0||(S.addEventListener("dispose",a),r[S.id]=new WeakRef(S),o.register(S,S.id,S),t.memory.geometries++),S}function h(x){let S=x.attributes;for(let d in S)e.update(S[d],n.ARRAY_BUFFER)}function u(x){let S=x.index,d=x.attributes.position,p=0;if(d===void 0)return;let v=S!==null?S.array.length:d.array.length/3-1,A=d.count>=65535?_o:xo,M=new A(Math.ceil(v/3)*6,1),R=M.array;if(S!==null){let g=S.array;p=S.version;for(let E=0,U=0;E<v;E+=3){let P=g[E+0],D=g[E+1],G=g[E+2];R[U++]=P,R[U++]=D,R[U++]=D,R[U++]=G,R[U++]=G,R[U++]=P}}else{p=d.version;for(let g=0,E=0;g<v;g+=3){let U=g+0,P=g+1,D=g+2;R[E++]=U,R[E++]=P,R[E++]=P,R[E++]=D,R[E++]=D,R[E++]=U}}M.version=p;let T=s.get(x);T&&e.remove(T),s.set(x,M)}function f(x){let S=s.get(x);if(S){let d=x.index;d!==null&&S.version<d.version&&u(x)}else u(x);return s.get(x)}function m(){for(let x in r){let S=r[x].deref();S!==void 0&&l(S)}}return{get:c,update:h,getWireframeAttribute:f,dispose:m}}function x0(n,e,t){let i;function r(u){i=u}let s,o;function a(u){s=u.type,o=u.bytesPerElement}function l(u,f){n.drawElements(i,f,s,u*o),t.update(f,i,1)}function c(u,f,m){m!==0&&(n.drawElementsInstanced(i,f,s,u*o,m),t.update(f,i,m))}function h(u,f,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,s,u,0,m);let S=0;for(let d=0;d<m;d++)S+=f[d];t.update(S,i,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function _0(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:ht("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function v0(n,e,t){let i=new WeakMap,r=new bt;function s(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=i.get(a);if(f===void 0||f.count!==u){let U=function(){g.dispose(),i.delete(a),a.removeEventListener("dispose",U)};f!==void 0&&f.texture.dispose();let m=a.morphAttributes.position!==void 0,x=a.morphAttributes.normal!==void 0,S=a.morphAttributes.color!==void 0,d=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;m===!0&&(A=1),x===!0&&(A=2),S===!0&&(A=3);let M=a.attributes.position.count*A,R=1;M>e.maxTextureSize&&(R=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let T=new Float32Array(M*R*4*u),g=new so(T,M,R,u);g.type=xi,g.needsUpdate=!0;let E=A*4;for(let P=0;P<u;P++){let D=d[P],G=p[P],k=v[P],N=M*R*4*P;for(let W=0;W<D.count;W++){let Y=W*E;m===!0&&(r.fromBufferAttribute(D,W),T[N+Y+0]=r.x,T[N+Y+1]=r.y,T[N+Y+2]=r.z,T[N+Y+3]=0),x===!0&&(r.fromBufferAttribute(G,W),T[N+Y+4]=r.x,T[N+Y+5]=r.y,T[N+Y+6]=r.z,T[N+Y+7]=0),S===!0&&(r.fromBufferAttribute(k,W),T[N+Y+8]=r.x,T[N+Y+9]=r.y,T[N+Y+10]=r.z,T[N+Y+11]=k.itemSize===4?r.w:1)}}f={count:u,texture:g,size:new Ze(M,R)},i.set(a,f),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let m=0;for(let S=0;S<c.length;S++)m+=c[S];let x=a.morphTargetsRelative?1:1-m;l.getUniforms().setValue(n,"morphTargetBaseInfluence",x),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:s}}function S0(n,e,t,i,r){let s=new WeakMap;function o(c){let h=r.render.frame,u=c.geometry,f=e.get(c,u);if(s.get(f)!==h&&(e.update(f),s.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==h&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),s.set(c,h))),c.isSkinnedMesh){let m=c.skeleton;s.get(m)!==h&&(m.update(),s.set(m,h))}return f}function a(){s=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var HM={[Ul]:"LINEAR_TONE_MAPPING",[Fl]:"REINHARD_TONE_MAPPING",[Ol]:"CINEON_TONE_MAPPING",[Bl]:"ACES_FILMIC_TONE_MAPPING",[zl]:"AGX_TONE_MAPPING",[kl]:"NEUTRAL_TONE_MAPPING",[Gl]:"CUSTOM_TONE_MAPPING"};function M0(n,e,t,i,r,s){let o=new Oi(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Kt;h.setAttribute("position",new Ft([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ft([0,2,0,0,2,0],2));let u=new Lc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Jt(h,u),m=new Co(-1,1,1,-1,0,1),x=null,S=null,d=!1,p,v=null,A=[],M=!1;this.setSize=function(R,T){o.setSize(R,T),a!==null&&a.setSize(R,T),l!==null&&l.setSize(R,T);for(let g=0;g<A.length;g++){let E=A[g];E.setSize&&E.setSize(R,T)}},this.setEffects=function(R){A=R,M=A.length>0&&A[0].isRenderPass===!0;let T=o.width,g=o.height;A.length>0&&a===null&&(a=new Oi(T,g,{type:Di,depthBuffer:!1,stencilBuffer:!1}),l=new Oi(T,g,{type:Di,depthBuffer:!1,stencilBuffer:!1}));let E=r===!0&&A.some(U=>U.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new En(T,g),s===!0&&(c.format=_n,c.type=kn)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let U=0;U<A.length;U++){let P=A[U];P.setSize&&P.setSize(T,g),E&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(R,T){if(d||R.toneMapping===gn&&A.length===0)return!1;if(v=T,T!==null){let g=T.width,E=T.height;(o.width!==g||o.height!==E)&&this.setSize(g,E)}return M===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=gn,!0},this.hasRenderPass=function(){return M},this.end=function(R,T){R.toneMapping=p,d=!0;let g=o,E=a;for(let U=0;U<A.length;U++){let P=A[U];P.enabled!==!1&&(P.render(R,E,g,T),P.needsSwap!==!1&&(g=E,E=E===a?l:a))}if(x!==R.outputColorSpace||S!==R.toneMapping){x=R.outputColorSpace,S=R.toneMapping,u.defines={},it.getTransfer(x)===vt&&(u.defines.SRGB_TRANSFER="");let U=HM[S];U&&(u.defines[U]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=g.texture,R.setRenderTarget(v),R.render(f,m),v=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var R0=new ai,C0=new En(1,1),P0=new bo(1),L0=new so,D0=new ac,I0=new yo,y0=[],b0=[],E0=new Float32Array(16),w0=new Float32Array(9),T0=new Float32Array(4);function Do(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=y0[r];if(s===void 0&&(s=new Float32Array(r),y0[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function wi(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Ti(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function kc(n,e){let t=b0[e];t===void 0&&(t=new Int32Array(e),b0[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function WM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function XM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wi(t,e))return;n.uniform2fv(this.addr,e),Ti(t,e)}}function qM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(wi(t,e))return;n.uniform3fv(this.addr,e),Ti(t,e)}}function YM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wi(t,e))return;n.uniform4fv(this.addr,e),Ti(t,e)}}function KM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wi(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Ti(t,e)}else{if(wi(t,i))return;T0.set(i),n.uniformMatrix2fv(this.addr,!1,T0),Ti(t,i)}}function ZM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wi(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Ti(t,e)}else{if(wi(t,i))return;w0.set(i),n.uniformMatrix3fv(this.addr,!1,w0),Ti(t,i)}}function $M(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wi(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Ti(t,e)}else{if(wi(t,i))return;E0.set(i),n.uniformMatrix4fv(this.addr,!1,E0),Ti(t,i)}}function JM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function QM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wi(t,e))return;n.uniform2iv(this.addr,e),Ti(t,e)}}function jM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wi(t,e))return;n.uniform3iv(this.addr,e),Ti(t,e)}}function ey(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wi(t,e))return;n.uniform4iv(this.addr,e),Ti(t,e)}}function ty(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function iy(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wi(t,e))return;n.uniform2uiv(this.addr,e),Ti(t,e)}}function ny(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wi(t,e))return;n.uniform3uiv(this.addr,e),Ti(t,e)}}function ry(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wi(t,e))return;n.uniform4uiv(this.addr,e),Ti(t,e)}}function Vc(n){return n.version===0&&(n.compareFunction=tc,n.needsUpdate=!0),n}function sy(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=Vc(C0):s=R0,t.setTexture2D(e||s,r)}function oy(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||D0,r)}function ay(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=Vc(P0):s=I0,t.setTextureCube(e||s,r)}function ly(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||L0,r)}function cy(n){switch(n){case 5126:return WM;case 35664:return XM;case 35665:return qM;case 35666:return YM;case 35674:return KM;case 35675:return ZM;case 35676:return $M;case 5124:case 35670:return JM;case 35667:case 35671:return QM;case 35668:case 35672:return jM;case 35669:case 35673:return ey;case 5125:return ty;case 36294:return iy;case 36295:return ny;case 36296:return ry;case 35678:case 36198:case 36298:case 36306:case 35682:return sy;case 35679:case 36299:case 36307:return oy;case 35680:case 36300:case 36308:case 36293:return ay;case 36289:case 36303:case 36311:case 36292:return ly}}function uy(n,e){n.uniform1fv(this.addr,e)}function fy(n,e){let t=Do(e,this.size,2);n.uniform2fv(this.addr,t)}function hy(n,e){let t=Do(e,this.size,3);n.uniform3fv(this.addr,t)}function dy(n,e){let t=Do(e,this.size,4);n.uniform4fv(this.addr,t)}function py(n,e){let t=Do(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function my(n,e){let t=Do(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function gy(n,e){let t=Do(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function xy(n,e){n.uniform1iv(this.addr,e)}function _y(n,e){n.uniform2iv(this.addr,e)}function vy(n,e){n.uniform3iv(this.addr,e)}function Sy(n,e){n.uniform4iv(this.addr,e)}function My(n,e){n.uniform1uiv(this.addr,e)}function yy(n,e){n.uniform2uiv(this.addr,e)}function by(n,e){n.uniform3uiv(this.addr,e)}function Ey(n,e){n.uniform4uiv(this.addr,e)}function wy(n,e,t){let i=this.cache,r=e.length,s=kc(t,r);wi(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=Vc(C0):o=R0;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function Ty(n,e,t){let i=this.cache,r=e.length,s=kc(t,r);wi(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||D0,s[o])}function Ay(n,e,t){let i=this.cache,r=e.length,s=kc(t,r);wi(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Vc(P0):o=I0;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function Ry(n,e,t){let i=this.cache,r=e.length,s=kc(t,r);wi(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||L0,s[o])}function Cy(n){switch(n){case 5126:return uy;case 35664:return fy;case 35665:return hy;case 35666:return dy;case 35674:return py;case 35675:return my;case 35676:return gy;case 5124:case 35670:return xy;case 35667:case 35671:return _y;case 35668:case 35672:return vy;case 35669:case 35673:return Sy;case 5125:return My;case 36294:return yy;case 36295:return by;case 36296:return Ey;case 35678:case 36198:case 36298:case 36306:case 35682:return wy;case 35679:case 36299:case 36307:return Ty;case 35680:case 36300:case 36308:case 36293:return Ay;case 36289:case 36303:case 36311:case 36292:return Ry}}var Uf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=cy(t.type)}},Ff=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Cy(t.type)}},Of=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},Nf=/(\w+)(\])?(\[|\.)?/g;function A0(n,e){n.seq.push(e),n.map[e.id]=e}function Py(n,e,t){let i=n.name,r=i.length;for(Nf.lastIndex=0;;){let s=Nf.exec(i),o=Nf.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){A0(t,c===void 0?new Uf(a,n,e):new Ff(a,n,e));break}else{let u=t.map[a];u===void 0&&(u=new Of(a),A0(t,u)),t=u}}}var $r=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Py(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function Bf(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var Ly=37297,Dy=0;function Iy(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var N0=new Ke;function Ny(n){it._getMatrix(N0,it.workingColorSpace,n);let e=`mat3( ${N0.elements.map(t=>t.toFixed(4))} )`;switch(it.getTransfer(n)){case hs:return[e,"LinearTransferOETF"];case vt:return[e,"sRGBTransferOETF"];default:return ze("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function U0(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+Iy(n.getShaderSource(e),a)}else return s}function Uy(n,e){let t=Ny(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Fy={[Ul]:"Linear",[Fl]:"Reinhard",[Ol]:"Cineon",[Bl]:"ACESFilmic",[zl]:"AgX",[kl]:"Neutral",[Gl]:"Custom"};function Oy(n,e){let t=Fy[e];return t===void 0?(ze("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Hc=new F;function By(){it.getLuminanceCoefficients(Hc);let n=Hc.x.toFixed(4),e=Hc.y.toFixed(4),t=Hc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Gy(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ja).join(`
`)}function zy(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function ky(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Ja(n){return n!==""}function F0(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function O0(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Vy=/^[ \t]*#include +<([\w\d./]+)>/gm;function Gf(n){return n.replace(Vy,Hy)}function Hy(n,e){let t=at[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Gf(t)}var Wy=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function B0(n){return n.replace(Wy,Xy)}function Xy(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function G0(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var qy={[Xs]:"SHADOWMAP_TYPE_PCF",[ls]:"SHADOWMAP_TYPE_VSM"};function Yy(n){return qy[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Ky={[Or]:"ENVMAP_MODE_REFRACTION"};function Zy(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Ky[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var $y={[qs]:"ENVMAP_BLENDING_MULTIPLY",[wp]:"ENVMAP_BLENDING_MIX",[Tp]:"ENVMAP_BLENDING_ADD"};function Jy(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":$y[n.combine]||"ENVMAP_BLENDING_NONE"}function z0(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=Yy(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Zy(t),u=Jy(t),f=Gy(t),m=zy(s),x=r.createProgram(),S,d,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(S=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(Ja).join(`
`),S.length>0&&(S+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(Ja).join(`
`),d.length>0&&(d+=`
`)):(S=[G0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ja).join(`
`),d=[G0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==gn?"#define TONE_MAPPING":"",t.toneMapping!==gn?at.tonemapping_pars_fragment:"",t.toneMapping!==gn?Oy("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",at.colorspace_pars_fragment,Uy("linearToOutputTexel",t.outputColorSpace),By(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ja).join(`
`)),o=Gf(o),o=F0(o,t),o=O0(o,t),a=Gf(a),a=F0(a,t),a=O0(a,t),o=B0(o),a=B0(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,S=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+S,d=["#define varying in",t.glslVersion===sf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===sf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let v=p+S+o,A=p+d+a,M=Bf(r,r.VERTEX_SHADER,v),R=Bf(r,r.FRAGMENT_SHADER,A);r.attachShader(x,M),r.attachShader(x,R),t.index0AttributeName!==void 0?r.bindAttribLocation(x,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(x,0,"position"),r.linkProgram(x);function T(P){if(n.debug.checkShaderErrors){let D=r.getProgramInfoLog(x)||"",G=r.getShaderInfoLog(M)||"",k=r.getShaderInfoLog(R)||"",N=D.trim(),W=G.trim(),Y=k.trim(),H=!0,ce=!0;if(r.getProgramParameter(x,r.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,x,M,R);else{let $=U0(r,M,"vertex"),Q=U0(r,R,"fragment");ht("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(x,r.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+N+`
`+$+`
`+Q)}else N!==""?ze("WebGLProgram: Program Info Log:",N):(W===""||Y==="")&&(ce=!1);ce&&(P.diagnostics={runnable:H,programLog:N,vertexShader:{log:W,prefix:S},fragmentShader:{log:Y,prefix:d}})}r.deleteShader(M),r.deleteShader(R),g=new $r(r,x),E=ky(r,x)}let g;this.getUniforms=function(){return g===void 0&&T(this),g};let E;this.getAttributes=function(){return E===void 0&&T(this),E};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=r.getProgramParameter(x,Ly)),U},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(x),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Dy++,this.cacheKey=e,this.usedTimes=1,this.program=x,this.vertexShader=M,this.fragmentShader=R,this}var Qy=0,Wc=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new zf(e),t.set(e,i)),i}},zf=class{constructor(e){this.id=Qy++,this.code=e,this.usedTimes=0}};function jy(n){return n===vn||n===cs||n===us}function k0(n,e,t,i,r,s){let o=new kr,a=new Wc,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(g){return l.add(g),g===0?"uv":`uv${g}`}function x(g,E,U,P,D,G){let k=P.fog,N=D.geometry,W=g.isMeshStandardMaterial||g.isMeshLambertMaterial||g.isMeshPhongMaterial?P.environment:null,Y=g.isMeshStandardMaterial||g.isMeshLambertMaterial&&!g.envMap||g.isMeshPhongMaterial&&!g.envMap,H=e.get(g.envMap||W,Y),ce=f[g.type],$=i.precision;g.precision!==null&&($=i.getMaxPrecision(g.precision),$!==g.precision&&ze("WebGLProgram.getParameters:",g.precision,"not supported, using",$,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ne=Q!==void 0?Q.length:0,he=0;N.morphAttributes.position!==void 0&&(he=1),N.morphAttributes.normal!==void 0&&(he=2),N.morphAttributes.color!==void 0&&(he=3);let fe,j,me,_e;if(ce){let Re=In[ce];fe=Re.vertexShader,j=Re.fragmentShader}else{fe=g.vertexShader,j=g.fragmentShader;let Re=a.getVertexShaderStage(g),lt=a.getFragmentShaderStage(g);a.update(g,Re,lt),me=Re.id,_e=lt.id}let Ae=n.getRenderTarget(),ye=n.state.buffers.depth.getReversed(),qe=D.isInstancedMesh===!0,st=D.isBatchedMesh===!0,He=!!g.map,dt=!!g.matcap,ut=!!H,nt=ut&&H.isPMREMTexture===!0,Ht=!!g.aoMap,Ut=!!g.lightMap,li=!!g.bumpMap&&g.wireframe===!1,Pt=!!g.normalMap,Ai=!!g.displacementMap,St=!!g.emissiveMap,vi=!!g.metalnessMap,Qt=!!g.roughnessMap,ci=g.anisotropy>0,B=g.clearcoat>0,Ce=g.diffuseRoughness>0,Je=g.dispersion>0,ot=g.retroreflectivity>0,be=g.iridescence>0,Dt=g.sheen>0,ke=g.transmission>0,$e=ci&&!!g.anisotropyMap,C=B&&!!g.clearcoatMap,y=B&&!!g.clearcoatNormalMap,X=B&&!!g.clearcoatRoughnessMap,ue=Ce&&!!g.diffuseRoughnessMap,se=be&&!!g.iridescenceMap,xe=be&&!!g.iridescenceThicknessMap,ve=Dt&&!!g.sheenColorMap,ee=Dt&&!!g.sheenRoughnessMap,ie=!!g.specularMap,pe=!!g.specularColorMap,O=!!g.specularIntensityMap,re=ke&&!!g.transmissionMap,te=ke&&!!g.thicknessMap,Ee=!!g.gradientMap,ge=!!g.alphaMap,Me=g.alphaTest>0,We=!!g.alphaHash,je=!!g.extensions,le=gn;g.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(le=n.toneMapping);let Oe=nt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,et={shaderID:ce,shaderType:g.type,shaderName:g.name,vertexShader:fe,fragmentShader:j,defines:g.defines,customVertexShaderID:me,customFragmentShaderID:_e,isRawShaderMaterial:g.isRawShaderMaterial===!0,glslVersion:g.glslVersion,precision:$,batching:st,batchingColor:st&&D._colorsTexture!==null,instancing:qe,instancingColor:qe&&D.instanceColor!==null,instancingMorph:qe&&D.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:it.workingColorSpace,alphaToCoverage:!!g.alphaToCoverage,map:He,matcap:dt,envMap:ut,envMapMode:ut&&H.mapping,envMapPMREM:nt,envMapMaxLod:nt?Oe.length-1:null,envMapSize:nt?Oe[0].width:null,aoMap:Ht,lightMap:Ut,bumpMap:li,normalMap:Pt,displacementMap:Ai,emissiveMap:St,normalMapObjectSpace:Pt&&g.normalMapType===Cp,normalMapTangentSpace:Pt&&g.normalMapType===Ga,packedNormalMap:Pt&&g.normalMapType===Ga&&jy(g.normalMap.format),metalnessMap:vi,roughnessMap:Qt,anisotropy:ci,anisotropyMap:$e,clearcoat:B,clearcoatMap:C,clearcoatNormalMap:y,clearcoatRoughnessMap:X,diffuseRoughness:Ce,diffuseRoughnessMap:ue,dispersion:Je,retroreflection:ot,iridescence:be,iridescenceMap:se,iridescenceThicknessMap:xe,sheen:Dt,sheenColorMap:ve,sheenRoughnessMap:ee,specularMap:ie,specularColorMap:pe,specularIntensityMap:O,transmission:ke,transmissionMap:re,thicknessMap:te,gradientMap:Ee,opaque:g.transparent===!1&&g.blending===Nr&&g.alphaToCoverage===!1,alphaMap:ge,alphaTest:Me,alphaHash:We,combine:g.combine,mapUv:He&&m(g.map.channel),aoMapUv:Ht&&m(g.aoMap.channel),lightMapUv:Ut&&m(g.lightMap.channel),bumpMapUv:li&&m(g.bumpMap.channel),normalMapUv:Pt&&m(g.normalMap.channel),displacementMapUv:Ai&&m(g.displacementMap.channel),emissiveMapUv:St&&m(g.emissiveMap.channel),metalnessMapUv:vi&&m(g.metalnessMap.channel),roughnessMapUv:Qt&&m(g.roughnessMap.channel),anisotropyMapUv:$e&&m(g.anisotropyMap.channel),clearcoatMapUv:C&&m(g.clearcoatMap.channel),clearcoatNormalMapUv:y&&m(g.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&m(g.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&m(g.diffuseRoughnessMap.channel),iridescenceMapUv:se&&m(g.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&m(g.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&m(g.sheenColorMap.channel),sheenRoughnessMapUv:ee&&m(g.sheenRoughnessMap.channel),specularMapUv:ie&&m(g.specularMap.channel),specularColorMapUv:pe&&m(g.specularColorMap.channel),specularIntensityMapUv:O&&m(g.specularIntensityMap.channel),transmissionMapUv:re&&m(g.transmissionMap.channel),thicknessMapUv:te&&m(g.thicknessMap.channel),alphaMapUv:ge&&m(g.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Pt||ci),vertexNormals:!!N.attributes.normal,vertexColors:g.vertexColors,vertexAlphas:g.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(He||ge),fog:!!k,useFog:g.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:g.wireframe===!1&&(g.flatShading===!0||N.attributes.normal===void 0&&Pt===!1&&(g.isMeshLambertMaterial||g.isMeshPhongMaterial||g.isMeshStandardMaterial||g.isMeshPhysicalMaterial)),sizeAttenuation:g.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:ye,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:he,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:G.filter(Re=>Re.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:g.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:le,decodeVideoTexture:He&&g.map.isVideoTexture===!0&&it.getTransfer(g.map.colorSpace)===vt,decodeVideoTextureEmissive:St&&g.emissiveMap.isVideoTexture===!0&&it.getTransfer(g.emissiveMap.colorSpace)===vt,premultipliedAlpha:g.premultipliedAlpha,doubleSided:g.side===ji,flipSided:g.side===$t,useDepthPacking:g.depthPacking>=0,depthPacking:g.depthPacking||0,index0AttributeName:g.index0AttributeName,extensionClipCullDistance:je&&g.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&g.extensions.multiDraw===!0||st)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:g.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function S(g){let E=[];if(g.shaderID?E.push(g.shaderID):(E.push(g.customVertexShaderID),E.push(g.customFragmentShaderID)),g.defines!==void 0)for(let U in g.defines)E.push(U),E.push(g.defines[U]);return g.isRawShaderMaterial===!1&&(d(E,g),p(E,g),E.push(n.outputColorSpace)),E.push(g.customProgramCacheKey),E.join()}function d(g,E){g.push(E.precision),g.push(E.outputColorSpace),g.push(E.envMapMode),g.push(E.envMapPMREM),g.push(E.envMapMaxLod),g.push(E.envMapSize),g.push(E.mapUv),g.push(E.alphaMapUv),g.push(E.lightMapUv),g.push(E.aoMapUv),g.push(E.bumpMapUv),g.push(E.normalMapUv),g.push(E.displacementMapUv),g.push(E.emissiveMapUv),g.push(E.metalnessMapUv),g.push(E.roughnessMapUv),g.push(E.anisotropyMapUv),g.push(E.clearcoatMapUv),g.push(E.clearcoatNormalMapUv),g.push(E.clearcoatRoughnessMapUv),g.push(E.diffuseRoughnessMapUv),g.push(E.iridescenceMapUv),g.push(E.iridescenceThicknessMapUv),g.push(E.sheenColorMapUv),g.push(E.sheenRoughnessMapUv),g.push(E.specularMapUv),g.push(E.specularColorMapUv),g.push(E.specularIntensityMapUv),g.push(E.transmissionMapUv),g.push(E.thicknessMapUv),g.push(E.combine),g.push(E.fogExp2),g.push(E.sizeAttenuation),g.push(E.morphTargetsCount),g.push(E.numSunLights),g.push(E.numDirLights),g.push(E.numPointLights),g.push(E.numSpotLights),g.push(E.numSpotLightMaps),g.push(E.numHemiLights),g.push(E.numRectAreaLights),g.push(E.numSunLightShadows),g.push(E.numDirLightShadows),g.push(E.numPointLightShadows),g.push(E.numSpotLightShadows),g.push(E.numSpotLightShadowsWithMaps),g.push(E.numLightProbes),g.push(E.numLightProbeGrids),g.push(E.shadowMapType),g.push(E.toneMapping),g.push(E.numClippingPlanes),g.push(E.numClipIntersection),g.push(E.depthPacking)}function p(g,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),g.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),g.push(o.mask)}function v(g){let E=f[g.type],U;if(E){let P=In[E];U=dm.clone(P.uniforms)}else U=g.uniforms;return U}function A(g,E){let U=h.get(E);return U!==void 0?++U.usedTimes:(U=new z0(n,E,g,r),c.push(U),h.set(E,U)),U}function M(g){if(--g.usedTimes===0){let E=c.indexOf(g);c[E]=c[c.length-1],c.pop(),h.delete(g.cacheKey),g.destroy()}}function R(g){a.remove(g)}function T(){a.dispose()}return{getParameters:x,getProgramCacheKey:S,getUniforms:v,acquireProgram:A,releaseProgram:M,releaseShaderCache:R,programs:c,dispose:T}}function V0(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,l){n.get(o)[a]=l}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function eb(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function H0(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function W0(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(f){let m=0;return f.isInstancedMesh&&(m+=2),f.isSkinnedMesh&&(m+=1),m}function a(f,m,x,S,d,p){let v=n[e];return v===void 0?(v={id:f.id,object:f,geometry:m,material:x,materialVariant:o(f),groupOrder:S,renderOrder:f.renderOrder,z:d,group:p},n[e]=v):(v.id=f.id,v.object=f,v.geometry=m,v.material=x,v.materialVariant=o(f),v.groupOrder=S,v.renderOrder=f.renderOrder,v.z=d,v.group=p),e++,v}function l(f,m,x,S,d,p,v){v.reversedDepth===!0&&(d=-d);let A=a(f,m,x,S,d,p);x.transmission>0?i.push(A):x.transparent===!0?r.push(A):t.push(A)}function c(f,m,x,S,d,p){let v=a(f,m,x,S,d,p);x.transmission>0?i.unshift(v):x.transparent===!0?r.unshift(v):t.unshift(v)}function h(f,m){t.length>1&&t.sort(f||eb),i.length>1&&i.sort(m||H0),r.length>1&&r.sort(m||H0)}function u(){for(let f=e,m=n.length;f<m;f++){let x=n[f];if(x.id===null)break;x.id=null,x.object=null,x.geometry=null,x.material=null,x.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:l,unshift:c,finish:u,sort:h}}function X0(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new W0,n.set(i,[o])):r>=s.length?(o=new W0,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function tb(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new F,color:new Xe};break;case"SpotLight":t={position:new F,direction:new F,color:new Xe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new F,color:new Xe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new F,skyColor:new Xe,groundColor:new Xe};break;case"RectAreaLight":t={color:new Xe,position:new F,halfWidth:new F,halfHeight:new F};break}return n[e.id]=t,t}}}function ib(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var nb=0;function rb(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function q0(n){let e=new tb,t=ib(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new F);let r=new F,s=new Ve,o=new Ve;function a(c){let h=0,u=0,f=0;for(let G=0;G<9;G++)i.probe[G].set(0,0,0);let m=0,x=0,S=0,d=0,p=0,v=0,A=0,M=0,R=0,T=0,g=0,E=0,U=0,P=0;c.sort(rb);for(let G=0,k=c.length;G<k;G++){let N=c[G],W=N.color,Y=N.intensity,H=N.distance,ce=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===vn?ce=N.shadow.map.texture:ce=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=W.r*Y,u+=W.g*Y,f+=W.b*Y;else if(N.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(N.sh.coefficients[$],Y);P++}else if(N.isSunLight){let $=e.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ne=t.get(N);ne.shadowIntensity=Q.intensity,ne.shadowBias=Q.bias,ne.shadowNormalBias=Q.normalBias,ne.shadowRadius=Q.radius,ne.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[x]=ne,i.sunShadowMap[x]=ce;let he=Q.getViewportCount();for(let fe=0;fe<he;fe++)i.sunShadowMatrix[S+fe]=Q.getMatrix(fe),i.sunShadowCascade[S+fe]=Q._cascadeData[fe];S+=he,x++}i.sun[m]=$,m++}else if(N.isDirectionalLight){let $=e.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ne=t.get(N);ne.shadowIntensity=Q.intensity,ne.shadowBias=Q.bias,ne.shadowNormalBias=Q.normalBias,ne.shadowRadius=Q.radius,ne.shadowMapSize=Q.mapSize,i.directionalShadow[d]=ne,i.directionalShadowMap[d]=ce,i.directionalShadowMatrix[d]=N.shadow.matrix,R++}i.directional[d]=$,d++}else if(N.isSpotLight){let $=e.get(N);$.position.setFromMatrixPosition(N.matrixWorld),$.color.copy(W).multiplyScalar(Y),$.distance=H,$.coneCos=Math.cos(N.angle),$.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),$.decay=N.decay,i.spot[v]=$;let Q=N.shadow;if(N.map&&(i.spotLightMap[E]=N.map,E++,Q.updateMatrices(N),N.castShadow&&U++),i.spotLightMatrix[v]=Q.matrix,N.castShadow){let ne=t.get(N);ne.shadowIntensity=Q.intensity,ne.shadowBias=Q.bias,ne.shadowNormalBias=Q.normalBias,ne.shadowRadius=Q.radius,ne.shadowMapSize=Q.mapSize,i.spotShadow[v]=ne,i.spotShadowMap[v]=ce,g++}v++}else if(N.isRectAreaLight){let $=e.get(N);$.color.copy(W).multiplyScalar(Y),$.halfWidth.set(N.width*.5,0,0),$.halfHeight.set(0,N.height*.5,0),i.rectArea[A]=$,A++}else if(N.isPointLight){let $=e.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),$.distance=N.distance,$.decay=N.decay,N.castShadow){let Q=N.shadow,ne=t.get(N);ne.shadowIntensity=Q.intensity,ne.shadowBias=Q.bias,ne.shadowNormalBias=Q.normalBias,ne.shadowRadius=Q.radius,ne.shadowMapSize=Q.mapSize,ne.shadowCameraNear=Q.camera.near,ne.shadowCameraFar=Q.camera.far,i.pointShadow[p]=ne,i.pointShadowMap[p]=ce,i.pointShadowMatrix[p]=N.shadow.matrix,T++}i.point[p]=$,p++}else if(N.isHemisphereLight){let $=e.get(N);$.skyColor.copy(N.color).multiplyScalar(Y),$.groundColor.copy(N.groundColor).multiplyScalar(Y),i.hemi[M]=$,M++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=f;let D=i.hash;(D.sunLength!==m||D.directionalLength!==d||D.pointLength!==p||D.spotLength!==v||D.rectAreaLength!==A||D.hemiLength!==M||D.numSunShadows!==x||D.numDirectionalShadows!==R||D.numPointShadows!==T||D.numSpotShadows!==g||D.numSpotMaps!==E||D.numLightProbes!==P)&&(i.sun.length=m,i.directional.length=d,i.spot.length=v,i.rectArea.length=A,i.point.length=p,i.hemi.length=M,i.sunShadow.length=x,i.sunShadowMap.length=x,i.sunShadowMatrix.length=S,i.sunShadowCascade.length=S,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=g,i.spotShadowMap.length=g,i.spotLightMatrix.length=g+E-U,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=P,D.sunLength=m,D.directionalLength=d,D.pointLength=p,D.spotLength=v,D.rectAreaLength=A,D.hemiLength=M,D.numSunShadows=x,D.numDirectionalShadows=R,D.numPointShadows=T,D.numSpotShadows=g,D.numSpotMaps=E,D.numLightProbes=P,i.version=nb++)}function l(c,h){let u=0,f=0,m=0,x=0,S=0,d=0,p=h.matrixWorldInverse;for(let v=0,A=c.length;v<A;v++){let M=c[v];if(M.isSunLight){let R=i.sun[u];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(p),u++}else if(M.isDirectionalLight){let R=i.directional[f];R.direction.setFromMatrixPosition(M.matrixWorld),r.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(r),R.direction.transformDirection(p),f++}else if(M.isSpotLight){let R=i.spot[x];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(M.matrixWorld),r.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(r),R.direction.transformDirection(p),x++}else if(M.isRectAreaLight){let R=i.rectArea[S];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),o.identity(),s.copy(M.matrixWorld),s.premultiply(p),o.extractRotation(s),R.halfWidth.set(M.width*.5,0,0),R.halfHeight.set(0,M.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),S++}else if(M.isPointLight){let R=i.point[m];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),m++}else if(M.isHemisphereLight){let R=i.hemi[d];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(p),d++}}}return{setup:a,setupView:l,state:i}}function Y0(n){let e=new q0(n),t=[],i=[],r=[];function s(u){h.camera=u,t.length=0,i.length=0,r.length=0}function o(u){u.isLightProbeGrid?r.push(u):t.push(u)}function a(u){i.push(u)}function l(){e.setup(t),r.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function K0(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new Y0(n),e.set(r,[a])):s>=o.length?(a=new Y0(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var Z0=`
void main() {
gl_Position = vec4( position, 1.0 );
}
`,$0=`
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
`;var ob=[new F(1,0,0),new F(-1,0,0),new F(0,1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1)],ab=[new F(0,-1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1),new F(0,-1,0),new F(0,-1,0)],J0=new Ve,Qa=new F,kf=new F;function Q0(n,e,t){let i=new bn,r=new Ze,s=new Ze,o=new bt,a=new Dc,l=new Ic,c={},h=t.maxTextureSize,u={[nn]:$t,[$t]:nn,[ji]:ji},f=new tn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ze},radius:{value:4}},vertexShader:Z0,fragmentShader:$0}),m=f.clone();m.defines.HORIZONTAL_PASS=1;let x=new Kt;x.setAttribute("position",new Ei(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let S=new Jt(x,f),d=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xs;let p=this.type;this.render=function(T,g,E){if(d.enabled===!1||d.autoUpdate===!1&&d.needsUpdate===!1||T.length===0)return;this.type===op&&(ze("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Xs);let U=n.getRenderTarget(),P=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),G=n.state;G.setBlending(ir),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let k=p!==this.type;k&&g.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=T.length;N<W;N++){let Y=T[N],H=Y.shadow;if(H===void 0){ze("WebGLShadowMap:",Y,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;r.copy(H.mapSize);let ce=H.getFrameExtents();r.multiply(ce),s.copy(H.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/ce.x),r.x=s.x*ce.x,H.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/ce.y),r.y=s.y*ce.y,H.mapSize.y=s.y));let $=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=$,H.map===null||k===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===ls){if(Y.isPointLight){ze("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new Oi(r.x,r.y,{format:vn,type:Di,minFilter:mi,magFilter:mi,generateMipmaps:!1}),H.map.texture.name=Y.name+".shadowMap",H.map.depthTexture=new En(r.x,r.y,xi),H.map.depthTexture.name=Y.name+".shadowMapDepth",H.map.depthTexture.format=sn,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Xt,H.map.depthTexture.magFilter=Xt}else Y.isPointLight?(H.map=new Zr(r.x),H.map.depthTexture=new bo(r.x,gi)):(H.map=new Oi(r.x,r.y),H.map.depthTexture=new En(r.x,r.y,gi)),H.map.depthTexture.name=Y.name+".shadowMap",H.map.depthTexture.format=sn,this.type===Xs?(H.map.depthTexture.compareFunction=$?ec:jl,H.map.depthTexture.minFilter=mi,H.map.depthTexture.magFilter=mi):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Xt,H.map.depthTexture.magFilter=Xt);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==r.x||H.map.height!==r.y)&&H.map.setSize(r.x,r.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();Y.isPointLight!==!0&&H.updateMatrices(Y,E);let ne=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:E.layers;for(let he=0;he<Q;he++){let fe=H.getCamera(he);if(Y.isPointLight){let j=H.camera,me=H.matrix,_e=Y.distance||j.far;_e!==j.far&&(j.far=_e,j.updateProjectionMatrix()),Qa.setFromMatrixPosition(Y.matrixWorld),j.position.copy(Qa),kf.copy(j.position),kf.add(ob[he]),j.up.copy(ab[he]),j.lookAt(kf),j.updateMatrixWorld(),me.makeTranslation(-Qa.x,-Qa.y,-Qa.z),J0.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),H._frustum.setFromProjectionMatrix(J0,j.coordinateSystem,j.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,he),n.clear();else{he===0&&(n.setRenderTarget(H.map),n.clear());let j=H.getViewport(he);o.set(s.x*j.x,s.y*j.y,s.x*j.z,s.y*j.w),G.viewport(o)}i=H.getFrustum(he),M(g,E,fe,Y,ne,this.type)}H.isPointLightShadow!==!0&&this.type===ls&&v(H,E),H.needsUpdate=!1}p=this.type,d.needsUpdate=!1,n.setRenderTarget(U,P,D)};function v(T,g){let E=e.update(S);f.defines.VSM_SAMPLES!==T.blurSamples&&(f.defines.VSM_SAMPLES=T.blurSamples,m.defines.VSM_SAMPLES=T.blurSamples,f.needsUpdate=!0,m.needsUpdate=!0),T.mapPass===null?T.mapPass=new Oi(r.x,r.y,{format:vn,type:Di}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),f.uniforms.shadow_pass.value=T.map.depthTexture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(g,null,E,f,S,null),m.uniforms.shadow_pass.value=T.mapPass.texture,m.uniforms.resolution.value.set(T.map.width,T.map.height),m.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(g,null,E,m,S,null)}function A(T,g,E,U){let P=null,D=E.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(D!==void 0)P=D;else if(P=E.isPointLight===!0?l:a,n.localClippingEnabled&&g.clipShadows===!0&&Array.isArray(g.clippingPlanes)&&g.clippingPlanes.length!==0||g.displacementMap&&g.displacementScale!==0||g.alphaMap&&g.alphaTest>0||g.map&&g.alphaTest>0||g.alphaToCoverage===!0){let G=P.uuid,k=g.uuid,N=c[G];N===void 0&&(N={},c[G]=N);let W=N[k];W===void 0&&(W=P.clone(),N[k]=W,g.addEventListener("dispose",R)),P=W}if(P.visible=g.visible,P.wireframe=g.wireframe,U===ls?P.side=g.shadowSide!==null?g.shadowSide:g.side:P.side=g.shadowSide!==null?g.shadowSide:u[g.side],P.alphaMap=g.alphaMap,P.alphaTest=g.alphaToCoverage===!0?.5:g.alphaTest,P.map=g.map,P.clipShadows=g.clipShadows,P.clippingPlanes=g.clippingPlanes,P.clipIntersection=g.clipIntersection,P.displacementMap=g.displacementMap,P.displacementScale=g.displacementScale,P.displacementBias=g.displacementBias,P.wireframeLinewidth=g.wireframeLinewidth,P.linewidth=g.linewidth,E.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let G=n.properties.get(P);G.light=E}return P}function M(T,g,E,U,P,D){if(T.visible===!1)return;if(T.layers.test(P)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&D===ls)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,T.matrixWorld);let N=e.update(T),W=T.material;if(Array.isArray(W)){let Y=N.groups;for(let H=0,ce=Y.length;H<ce;H++){let $=Y[H],Q=W[$.materialIndex];if(Q&&Q.visible){let ne=A(T,Q,U,D);T.onBeforeShadow(n,T,g,E,N,ne,$),n.renderBufferDirect(E,null,N,ne,T,$),T.onAfterShadow(n,T,g,E,N,ne,$)}}}else if(W.visible){let Y=A(T,W,U,D);T.onBeforeShadow(n,T,g,E,N,Y,null),n.renderBufferDirect(E,null,N,Y,T,null),T.onAfterShadow(n,T,g,E,N,Y,null)}}let k=T.children;for(let N=0,W=k.length;N<W;N++)M(k[N],g,E,U,P,D)}function R(T){T.target.removeEventListener("dispose",R);for(let E in c){let U=c[E],P=T.target.uuid;P in U&&(U[P].dispose(),delete U[P])}}}function j0(n,e){function t(){let O=!1,re=new bt,te=null,Ee=new bt(0,0,0,0);return{setMask:function(ge){te!==ge&&!O&&(n.colorMask(ge,ge,ge,ge),te=ge)},setLocked:function(ge){O=ge},setClear:function(ge,Me,We,je,le){le===!0&&(ge*=je,Me*=je,We*=je),re.set(ge,Me,We,je),Ee.equals(re)===!1&&(n.clearColor(ge,Me,We,je),Ee.copy(re))},reset:function(){O=!1,te=null,Ee.set(-1,0,0,0)}}}function i(){let O=!1,re=!1,te=null,Ee=null,ge=null;return{setReversed:function(Me){if(re!==Me){let We=e.get("EXT_clip_control");Me?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),re=Me;let je=ge;ge=null,this.setClear(je)}},getReversed:function(){return re},setTest:function(Me){Me?ye(n.DEPTH_TEST):qe(n.DEPTH_TEST)},setMask:function(Me){te!==Me&&!O&&(n.depthMask(Me),te=Me)},setFunc:function(Me){if(re&&(Me=Vp[Me]),Ee!==Me){switch(Me){case jo:n.depthFunc(n.NEVER);break;case ea:n.depthFunc(n.ALWAYS);break;case ta:n.depthFunc(n.LESS);break;case Fr:n.depthFunc(n.LEQUAL);break;case ia:n.depthFunc(n.EQUAL);break;case na:n.depthFunc(n.GEQUAL);break;case ra:n.depthFunc(n.GREATER);break;case sa:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ee=Me}},setLocked:function(Me){O=Me},setClear:function(Me){ge!==Me&&(ge=Me,re&&(Me=1-Me),n.clearDepth(Me))},reset:function(){O=!1,te=null,Ee=null,ge=null,re=!1}}}function r(){let O=!1,re=null,te=null,Ee=null,ge=null,Me=null,We=null,je=null,le=null;return{setTest:function(Oe){O||(Oe?ye(n.STENCIL_TEST):qe(n.STENCIL_TEST))},setMask:function(Oe){re!==Oe&&!O&&(n.stencilMask(Oe),re=Oe)},setFunc:function(Oe,et,Re){(te!==Oe||Ee!==et||ge!==Re)&&(n.stencilFunc(Oe,et,Re),te=Oe,Ee=et,ge=Re)},setOp:function(Oe,et,Re){(Me!==Oe||We!==et||je!==Re)&&(n.stencilOp(Oe,et,Re),Me=Oe,We=et,je=Re)},setLocked:function(Oe){O=Oe},setClear:function(Oe){le!==Oe&&(n.clearStencil(Oe),le=Oe)},reset:function(){O=!1,re=null,te=null,Ee=null,ge=null,Me=null,We=null,je=null,le=null}}}let s=new t,o=new i,a=new r,l={},c=new WeakMap,h={},u={},f={},m=new WeakMap,x=[],S=null,d=!1,p=null,v=null,A=null,M=null,R=null,T=null,g=null,E=new Xe(0,0,0),U=0,P=!1,D=null,G=null,k=null,N=null,W=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ce=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec($)[1]),H=ce>=1):$.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),H=ce>=2);let Q=null,ne={},he=n.getParameter(n.SCISSOR_BOX),fe=n.getParameter(n.VIEWPORT),j=new bt().fromArray(he),me=new bt().fromArray(fe);function _e(O,re,te,Ee){let ge=new Uint8Array(4),Me=n.createTexture();n.bindTexture(O,Me),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<te;We++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ee,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(re+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return Me}let Ae={};Ae[n.TEXTURE_2D]=_e(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=_e(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=_e(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=_e(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ye(n.DEPTH_TEST),o.setFunc(Fr),li(!1),Pt(ju),ye(n.CULL_FACE),Ht(ir);function ye(O){h[O]!==!0&&(n.enable(O),h[O]=!0)}function qe(O){h[O]!==!1&&(n.disable(O),h[O]=!1)}function st(O,re){return f[O]!==re?(n.bindFramebuffer(O,re),f[O]=re,O===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=re),O===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=re),!0):!1}function He(O,re){let te=x,Ee=!1;if(O){te=m.get(re),te===void 0&&(te=[],m.set(re,te));let ge=O.textures;if(te.length!==ge.length||te[0]!==n.COLOR_ATTACHMENT0){for(let Me=0,We=ge.length;Me<We;Me++)te[Me]=n.COLOR_ATTACHMENT0+Me;te.length=ge.length,Ee=!0}}else te[0]!==n.BACK&&(te[0]=n.BACK,Ee=!0);Ee&&n.drawBuffers(te)}function dt(O){return S!==O?(n.useProgram(O),S=O,!0):!1}let ut={[Ur]:n.FUNC_ADD,[lp]:n.FUNC_SUBTRACT,[cp]:n.FUNC_REVERSE_SUBTRACT};ut[up]=n.MIN,ut[fp]=n.MAX;let nt={[hp]:n.ZERO,[dp]:n.ONE,[pp]:n.SRC_COLOR,[Il]:n.SRC_ALPHA,[Sp]:n.SRC_ALPHA_SATURATE,[_p]:n.DST_COLOR,[gp]:n.DST_ALPHA,[mp]:n.ONE_MINUS_SRC_COLOR,[Nl]:n.ONE_MINUS_SRC_ALPHA,[vp]:n.ONE_MINUS_DST_COLOR,[xp]:n.ONE_MINUS_DST_ALPHA,[Mp]:n.CONSTANT_COLOR,[yp]:n.ONE_MINUS_CONSTANT_COLOR,[bp]:n.CONSTANT_ALPHA,[Ep]:n.ONE_MINUS_CONSTANT_ALPHA};function Ht(O,re,te,Ee,ge,Me,We,je,le,Oe){if(O===ir){d===!0&&(qe(n.BLEND),d=!1);return}if(d===!1&&(ye(n.BLEND),d=!0),O!==ap){if(O!==p||Oe!==P){if((v!==Ur||R!==Ur)&&(n.blendEquation(n.FUNC_ADD),v=Ur,R=Ur),Oe)switch(O){case Nr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ef:n.blendFunc(n.ONE,n.ONE);break;case tf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case nf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ht("WebGLState: Invalid blending: ",O);break}else switch(O){case Nr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ef:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case tf:ht("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case nf:ht("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ht("WebGLState: Invalid blending: ",O);break}A=null,M=null,T=null,g=null,E.set(0,0,0),U=0,p=O,P=Oe}return}ge=ge||re,Me=Me||te,We=We||Ee,(re!==v||ge!==R)&&(n.blendEquationSeparate(ut[re],ut[ge]),v=re,R=ge),(te!==A||Ee!==M||Me!==T||We!==g)&&(n.blendFuncSeparate(nt[te],nt[Ee],nt[Me],nt[We]),A=te,M=Ee,T=Me,g=We),(je.equals(E)===!1||le!==U)&&(n.blendColor(je.r,je.g,je.b,le),E.copy(je),U=le),p=O,P=!1}function Ut(O,re){O.side===ji?qe(n.CULL_FACE):ye(n.CULL_FACE);let te=O.side===$t;re&&(te=!te),li(te),O.blending===Nr&&O.transparent===!1?Ht(ir):Ht(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),s.setMask(O.colorWrite);let Ee=O.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),St(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?ye(n.SAMPLE_ALPHA_TO_COVERAGE):qe(n.SAMPLE_ALPHA_TO_COVERAGE)}function li(O){D!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),D=O)}function Pt(O){O!==rp?(ye(n.CULL_FACE),O!==G&&(O===ju?n.cullFace(n.BACK):O===sp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):qe(n.CULL_FACE),G=O}function Ai(O){O!==k&&(H&&n.lineWidth(O),k=O)}function St(O,re,te){O?(ye(n.POLYGON_OFFSET_FILL),(N!==re||W!==te)&&(N=re,W=te,o.getReversed()&&(re=-re,te=-te),n.polygonOffset(re,te))):qe(n.POLYGON_OFFSET_FILL)}function vi(O){O?ye(n.SCISSOR_TEST):qe(n.SCISSOR_TEST)}function Qt(O){O===void 0&&(O=n.TEXTURE0+Y-1),Q!==O&&(n.activeTexture(O),Q=O)}function ci(O,re,te){te===void 0&&(Q===null?te=n.TEXTURE0+Y-1:te=Q);let Ee=ne[te];Ee===void 0&&(Ee={type:void 0,texture:void 0},ne[te]=Ee),(Ee.type!==O||Ee.texture!==re)&&(Q!==te&&(n.activeTexture(te),Q=te),n.bindTexture(O,re||Ae[O]),Ee.type=O,Ee.texture=re)}function B(){let O=ne[Q];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Ce(){try{n.compressedTexImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function ot(){try{n.texSubImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function be(){try{n.texSubImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function Dt(){try{n.compressedTexSubImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function ke(){try{n.compressedTexSubImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function $e(){try{n.texStorage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function C(){try{n.texStorage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function y(){try{n.texImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function X(){try{n.texImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function ue(O){return u[O]!==void 0?u[O]:n.getParameter(O)}function se(O,re){u[O]!==re&&(n.pixelStorei(O,re),u[O]=re)}function xe(O){j.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),j.copy(O))}function ve(O){me.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function ee(O,re){let te=c.get(re);te===void 0&&(te=new WeakMap,c.set(re,te));let Ee=te.get(O);Ee===void 0&&(Ee=n.getUniformBlockIndex(re,O.name),n.uniformBlockBinding(re,Ee,Ee),te.set(O,Ee))}function ie(O,re,te){let ge=c.get(re).get(O);l[ge]!==te&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,te),l[ge]=te)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,ne={},f={},l={},m=new WeakMap,x=[],S=null,d=!1,p=null,v=null,A=null,M=null,R=null,T=null,g=null,E=new Xe(0,0,0),U=0,P=!1,D=null,G=null,k=null,N=null,W=null,j.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:ye,disable:qe,bindFramebuffer:st,drawBuffers:He,useProgram:dt,setBlending:Ht,setMaterial:Ut,setFlipSided:li,setCullFace:Pt,setLineWidth:Ai,setPolygonOffset:St,setScissorTest:vi,activeTexture:Qt,bindTexture:ci,unbindTexture:B,compressedTexImage2D:Ce,compressedTexImage3D:Je,texImage2D:y,texImage3D:X,pixelStorei:se,getParameter:ue,updateUBOMapping:ee,uniformBlockBinding:ie,texStorage2D:$e,texStorage3D:C,texSubImage2D:ot,texSubImage3D:be,compressedTexSubImage2D:Dt,compressedTexSubImage3D:ke,scissor:xe,viewport:ve,reset:pe}}function e_(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ze,h=new WeakMap,u=new Set,f,m=new WeakMap,x=new Set,S=new FinalizationRegistry(C=>x.delete(C)),d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(C,y){return d?new OffscreenCanvas(C,y):no("canvas")}function v(C,y,X){let ue=1,se=$e(C);if((se.width>X||se.height>X)&&(ue=X/Math.max(se.width,se.height)),ue<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let xe=Math.floor(ue*se.width),ve=Math.floor(ue*se.height);f===void 0&&(f=p(xe,ve));let ee=y?p(xe,ve):f;return ee.width=xe,ee.height=ve,ee.getContext("2d").drawImage(C,0,0,xe,ve),ze("WebGLRenderer: Texture has been resized from ("+se.width+"x"+se.height+") to ("+xe+"x"+ve+")."),ee}else return"data"in C&&ze("WebGLRenderer: Image in DataTexture is too big ("+se.width+"x"+se.height+")."),C;return C}function A(C){return C.generateMipmaps}function M(C){n.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?n.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(C,y,X,ue,se,xe=!1){if(C!==null){if(n[C]!==void 0)return n[C];ze("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ve;ue&&(ve=e.get("EXT_texture_norm16"),ve||ze("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=y;if(y===n.RED&&(X===n.FLOAT&&(ee=n.R32F),X===n.HALF_FLOAT&&(ee=n.R16F),X===n.UNSIGNED_BYTE&&(ee=n.R8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.R16_EXT),X===n.SHORT&&ve&&(ee=ve.R16_SNORM_EXT)),y===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.R8UI),X===n.UNSIGNED_SHORT&&(ee=n.R16UI),X===n.UNSIGNED_INT&&(ee=n.R32UI),X===n.BYTE&&(ee=n.R8I),X===n.SHORT&&(ee=n.R16I),X===n.INT&&(ee=n.R32I)),y===n.RG&&(X===n.FLOAT&&(ee=n.RG32F),X===n.HALF_FLOAT&&(ee=n.RG16F),X===n.UNSIGNED_BYTE&&(ee=n.RG8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RG16_EXT),X===n.SHORT&&ve&&(ee=ve.RG16_SNORM_EXT)),y===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RG8UI),X===n.UNSIGNED_SHORT&&(ee=n.RG16UI),X===n.UNSIGNED_INT&&(ee=n.RG32UI),X===n.BYTE&&(ee=n.RG8I),X===n.SHORT&&(ee=n.RG16I),X===n.INT&&(ee=n.RG32I)),y===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGB8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGB16UI),X===n.UNSIGNED_INT&&(ee=n.RGB32UI),X===n.BYTE&&(ee=n.RGB8I),X===n.SHORT&&(ee=n.RGB16I),X===n.INT&&(ee=n.RGB32I)),y===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGBA16UI),X===n.UNSIGNED_INT&&(ee=n.RGBA32UI),X===n.BYTE&&(ee=n.RGBA8I),X===n.SHORT&&(ee=n.RGBA16I),X===n.INT&&(ee=n.RGBA32I)),y===n.RGB&&(X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGB16_EXT),X===n.SHORT&&ve&&(ee=ve.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(ee=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(ee=n.R11F_G11F_B10F)),y===n.RGBA){let ie=xe?hs:it.getTransfer(se);X===n.FLOAT&&(ee=n.RGBA32F),X===n.HALF_FLOAT&&(ee=n.RGBA16F),X===n.UNSIGNED_BYTE&&(ee=ie===vt?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGBA16_EXT),X===n.SHORT&&ve&&(ee=ve.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(ee=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(ee=n.RGB5_A1)}return(ee===n.R16F||ee===n.R32F||ee===n.RG16F||ee===n.RG32F||ee===n.RGBA16F||ee===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function g(C,y){let X;return C?y===null||y===gi||y===kn?X=n.DEPTH24_STENCIL8:y===xi?X=n.DEPTH32F_STENCIL8:y===xr&&(X=n.DEPTH24_STENCIL8,ze("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===gi||y===kn?X=n.DEPTH_COMPONENT24:y===xi?X=n.DEPTH_COMPONENT32F:y===xr&&(X=n.DEPTH_COMPONENT16),X}function E(C,y){return A(C)===!0||C.isFramebufferTexture&&C.minFilter!==Xt&&C.minFilter!==mi?Math.log2(Math.max(y.width,y.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?y.mipmaps.length:1}function U(C){let y=new WeakRef(C);i.get(C).__ref=y,x.add(y),S.register(C,y,y)}function P(C){let y=i.get(C).__ref;y!==void 0&&(x.delete(y),S.unregister(y))}function D(C){k(C.target)}function G(C){N(C.target)}function k(C){C.removeEventListener("dispose",D),P(C),Y(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&u.delete(C)}function N(C){C.removeEventListener("dispose",G),P(C),ce(C)}function W(){for(let C of x){let y=C.deref();y!==void 0&&(y.isRenderTarget===!0?N(y):k(y))}x.clear(),u.clear()}function Y(C){let y=i.get(C);if(y.__webglInit===void 0)return;let X=C.source,ue=m.get(X);if(ue){let se=ue[y.__cacheKey];se.usedTimes--,se.usedTimes===0&&H(C),Object.keys(ue).length===0&&m.delete(X)}i.remove(C)}function H(C){let y=i.get(C);n.deleteTexture(y.__webglTexture);let X=C.source,ue=m.get(X);delete ue[y.__cacheKey],o.memory.textures--}function ce(C){let y=i.get(C);y.__depthDisposeCallback&&y.__depthDisposeCallback();let X=C.depthTexture;if(X&&X.renderTarget===C&&k(X),C.isWebGLCubeRenderTarget)for(let se=0;se<6;se++){if(Array.isArray(y.__webglFramebuffer[se]))for(let xe=0;xe<y.__webglFramebuffer[se].length;xe++)n.deleteFramebuffer(y.__webglFramebuffer[se][xe]);else n.deleteFramebuffer(y.__webglFramebuffer[se]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[se])}else{if(Array.isArray(y.__webglFramebuffer))for(let se=0;se<y.__webglFramebuffer.length;se++)n.deleteFramebuffer(y.__webglFramebuffer[se]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let se=0;se<y.__webglColorRenderbuffer.length;se++)y.__webglColorRenderbuffer[se]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[se]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let ue=C.textures;for(let se=0,xe=ue.length;se<xe;se++){let ve=i.get(ue[se]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(ue[se])}i.remove(C)}let $=0;function Q(){$=0}function ne(){return $}function he(C){$=C}function fe(){let C=$;return C>=r.maxTextures&&ze("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+r.maxTextures),$+=1,C}function j(C){let y=[];return y.push(C.wrapS),y.push(C.wrapT),y.push(C.wrapR||0),y.push(C.magFilter),y.push(C.minFilter),y.push(C.anisotropy),y.push(C.internalFormat),y.push(C.format),y.push(C.type),y.push(C.generateMipmaps),y.push(C.mipmapsAutoUpdate),y.push(C.premultiplyAlpha),y.push(C.flipY),y.push(C.unpackAlignment),y.push(C.colorSpace),y.join()}function me(C,y){let X=i.get(C);if(C.isVideoTexture&&Dt(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&X.__version!==C.version){let ue=C.image;if(ue===null)ze("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)ze("WebGLRenderer: Texture marked for update but image is incomplete");else{Ut(X,C,y);return}}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+y)}function _e(C,y){let X=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){Ut(X,C,y);return}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+y)}function Ae(C,y){let X=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){Ut(X,C,y);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+y)}function ye(C,y){let X=i.get(C);if(C.version>0&&X.__version!==C.version){li(X,C,y);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+y)}let qe={[oa]:n.REPEAT,[rn]:n.CLAMP_TO_EDGE,[aa]:n.MIRRORED_REPEAT},st={[Xt]:n.NEAREST,[Ap]:n.NEAREST_MIPMAP_NEAREST,[la]:n.NEAREST_MIPMAP_LINEAR,[mi]:n.LINEAR,[Wl]:n.LINEAR_MIPMAP_NEAREST,[xn]:n.LINEAR_MIPMAP_LINEAR},He={[Lp]:n.NEVER,[tc]:n.ALWAYS,[Dp]:n.LESS,[jl]:n.LEQUAL,[Ip]:n.EQUAL,[ec]:n.GEQUAL,[Np]:n.GREATER,[Up]:n.NOTEQUAL};function dt(C,y){if(y.type===xi&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===mi||y.magFilter===Wl||y.magFilter===la||y.magFilter===xn||y.minFilter===mi||y.minFilter===Wl||y.minFilter===la||y.minFilter===xn)&&ze("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(C,n.TEXTURE_WRAP_S,qe[y.wrapS]),n.texParameteri(C,n.TEXTURE_WRAP_T,qe[y.wrapT]),(C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY)&&n.texParameteri(C,n.TEXTURE_WRAP_R,qe[y.wrapR]),n.texParameteri(C,n.TEXTURE_MAG_FILTER,st[y.magFilter]),n.texParameteri(C,n.TEXTURE_MIN_FILTER,st[y.minFilter]),y.compareFunction&&(n.texParameteri(C,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(C,n.TEXTURE_COMPARE_FUNC,He[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===Xt||y.minFilter!==la&&y.minFilter!==xn||y.type===xi&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(C,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,r.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function ut(C,y){let X=!1;C.__webglInit===void 0&&(C.__webglInit=!0,y.addEventListener("dispose",D),U(y));let ue=y.source,se=m.get(ue);se===void 0&&(se={},m.set(ue,se));let xe=j(y);if(xe!==C.__cacheKey){se[xe]===void 0&&(se[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),se[xe].usedTimes++;let ve=se[C.__cacheKey];ve!==void 0&&(se[C.__cacheKey].usedTimes--,ve.usedTimes===0&&H(y)),C.__cacheKey=xe,C.__webglTexture=se[xe].texture}return X}function nt(C,y,X){return Math.floor(Math.floor(C/X)/y)}function Ht(C,y,X,ue){let xe=C.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,y.width,y.height,X,ue,y.data);else{xe.sort((O,re)=>O.start-re.start);let ve=0;for(let O=1;O<xe.length;O++){let re=xe[ve],te=xe[O],Ee=re.start+re.count,ge=nt(te.start,y.width,4),Me=nt(re.start,y.width,4);te.start<=Ee+1&&ge===Me&&nt(te.start+te.count-1,y.width,4)===ge?re.count=Math.max(re.count,te.start+te.count-re.start):(++ve,xe[ve]=te)}xe.length=ve+1;let ee=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,y.width);for(let O=0,re=xe.length;O<re;O++){let te=xe[O],Ee=Math.floor(te.start/4),ge=Math.ceil(te.count/4),Me=Ee%y.width,We=Math.floor(Ee/y.width),je=ge,le=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,Me,We,je,le,X,ue,y.data)}C.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ee),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Ut(C,y,X){let ue=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(ue=n.TEXTURE_3D);let se=ut(C,y),xe=y.source;t.bindTexture(ue,C.__webglTexture,n.TEXTURE0+X);let ve=i.get(xe);if(xe.version!==ve.__version||se===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let le=it.getPrimaries(it.workingColorSpace),Oe=y.colorSpace===Cn?null:it.getPrimaries(y.colorSpace),et=y.colorSpace===Cn||le===Oe?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment);let ie=v(y.image,!1,r.maxTextureSize);ie=ke(y,ie);let pe=s.convert(y.format,y.colorSpace),O=s.convert(y.type),re=T(y.internalFormat,pe,O,y.normalized,y.colorSpace,y.isVideoTexture);dt(ue,y);let te,Ee=y.mipmaps,ge=y.isVideoTexture!==!0,Me=ve.__version===void 0||se===!0,We=xe.dataReady,je=E(y,ie);if(y.isDepthTexture)re=g(y.format===_n,y.type),Me&&(ge?t.texStorage2D(n.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,O,null));else if(y.isDataTexture)if(Ee.length>0){ge&&Me&&t.texStorage2D(n.TEXTURE_2D,je,re,Ee[0].width,Ee[0].height);for(let le=0,Oe=Ee.length;le<Oe;le++)te=Ee[le],ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,pe,O,te.data):t.texImage2D(n.TEXTURE_2D,le,re,te.width,te.height,0,pe,O,te.data);y.generateMipmaps=!1}else ge?(Me&&t.texStorage2D(n.TEXTURE_2D,je,re,ie.width,ie.height),We&&Ht(y,ie,pe,O)):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,O,ie.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){ge&&Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,re,Ee[0].width,Ee[0].height,ie.depth);for(let le=0,Oe=Ee.length;le<Oe;le++)if(te=Ee[le],y.format!==bi)if(pe!==null)if(ge){if(We)if(y.layerUpdates.size>0){let et=Df(te.width,te.height,y.format,y.type);for(let Re of y.layerUpdates){let lt=te.data.subarray(Re*et/te.data.BYTES_PER_ELEMENT,(Re+1)*et/te.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,Re,te.width,te.height,1,pe,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ie.depth,pe,te.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,le,re,te.width,te.height,ie.depth,0,te.data,0,0);else ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ie.depth,pe,O,te.data):t.texImage3D(n.TEXTURE_2D_ARRAY,le,re,te.width,te.height,ie.depth,0,pe,O,te.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{ge&&Me&&t.texStorage2D(n.TEXTURE_2D,je,re,Ee[0].width,Ee[0].height);for(let le=0,Oe=Ee.length;le<Oe;le++)te=Ee[le],y.format!==bi?pe!==null?ge?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,pe,te.data):t.compressedTexImage2D(n.TEXTURE_2D,le,re,te.width,te.height,0,te.data):ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,pe,O,te.data):t.texImage2D(n.TEXTURE_2D,le,re,te.width,te.height,0,pe,O,te.data)}else if(y.isDataArrayTexture)if(ge){if(Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,re,ie.width,ie.height,ie.depth),We)if(y.layerUpdates.size>0){let le=Df(ie.width,ie.height,y.format,y.type);for(let Oe of y.layerUpdates){let et=ie.data.subarray(Oe*le/ie.data.BYTES_PER_ELEMENT,(Oe+1)*le/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Oe,ie.width,ie.height,1,pe,O,et)}y.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,pe,O,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,pe,O,ie.data);else if(y.isData3DTexture)ge?(Me&&t.texStorage3D(n.TEXTURE_3D,je,re,ie.width,ie.height,ie.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,pe,O,ie.data)):t.texImage3D(n.TEXTURE_3D,0,re,ie.width,ie.height,ie.depth,0,pe,O,ie.data);else if(y.isFramebufferTexture){if(Me)if(ge)t.texStorage2D(n.TEXTURE_2D,je,re,ie.width,ie.height);else{let le=ie.width,Oe=ie.height;for(let et=0;et<je;et++)t.texImage2D(n.TEXTURE_2D,et,re,le,Oe,0,pe,O,null),le>>=1,Oe>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in n){let le=n.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),ie.parentNode!==le){le.appendChild(ie),u.add(y),le.onpaint=Oe=>{let et=Oe.changedElements;for(let Re of u)et.includes(Re.image)&&(Re.needsUpdate=!0)},le.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let et=n.RGBA,Re=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Re,lt,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(ge&&Me){let le=$e(Ee[0]);t.texStorage2D(n.TEXTURE_2D,je,re,le.width,le.height)}for(let le=0,Oe=Ee.length;le<Oe;le++)te=Ee[le],ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,pe,O,te):t.texImage2D(n.TEXTURE_2D,le,re,pe,O,te);y.generateMipmaps=!1}else if(ge){if(Me){let le=$e(ie);t.texStorage2D(n.TEXTURE_2D,je,re,le.width,le.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,O,ie)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,O,ie);A(y)&&y.mipmapsAutoUpdate===!0&&M(ue),ve.__version=xe.version,y.onUpdate&&y.onUpdate(y)}C.__version=y.version}function li(C,y,X){if(y.image.length!==6)return;let ue=ut(C,y),se=y.source;t.bindTexture(n.TEXTURE_CUBE_MAP,C.__webglTexture,n.TEXTURE0+X);let xe=i.get(se);if(se.version!==xe.__version||ue===!0){t.activeTexture(n.TEXTURE0+X);let ve=it.getPrimaries(it.workingColorSpace),ee=y.colorSpace===Cn?null:it.getPrimaries(y.colorSpace),ie=y.colorSpace===Cn||ve===ee?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let pe=y.isCompressedTexture||y.image[0].isCompressedTexture,O=y.image[0]&&y.image[0].isDataTexture,re=[];for(let Re=0;Re<6;Re++)!pe&&!O?re[Re]=v(y.image[Re],!0,r.maxCubemapSize):re[Re]=O?y.image[Re].image:y.image[Re],re[Re]=ke(y,re[Re]);let te=re[0],Ee=s.convert(y.format,y.colorSpace),ge=s.convert(y.type),Me=T(y.internalFormat,Ee,ge,y.normalized,y.colorSpace),We=y.isVideoTexture!==!0,je=xe.__version===void 0||ue===!0,le=se.dataReady,Oe=E(y,te);dt(n.TEXTURE_CUBE_MAP,y);let et;if(y.isDepthTexture){if(Me=g(y.format===_n,y.type),je)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Me,te.width,te.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Me,te.width,te.height,0,Ee,ge,null)}else if(pe){We&&je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,Me,te.width,te.height);for(let Re=0;Re<6;Re++){et=re[Re].mipmaps;for(let lt=0;lt<et.length;lt++){let Ot=et[lt];y.format!==bi?Ee!==null?We?le&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Ot.width,Ot.height,Ee,Ot.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Me,Ot.width,Ot.height,0,Ot.data):ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Ot.width,Ot.height,Ee,ge,Ot.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Me,Ot.width,Ot.height,0,Ee,ge,Ot.data)}}}else{if(et=y.mipmaps,We&&je){et.length>0&&Oe++;let Re=$e(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,Me,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(O){We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,re[Re].width,re[Re].height,Ee,ge,re[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Me,re[Re].width,re[Re].height,0,Ee,ge,re[Re].data);for(let lt=0;lt<et.length;lt++){let Yi=et[lt].image[Re].image;We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,Yi.width,Yi.height,Ee,ge,Yi.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Me,Yi.width,Yi.height,0,Ee,ge,Yi.data)}}else{We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Ee,ge,re[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Me,Ee,ge,re[Re]);for(let lt=0;lt<et.length;lt++){let Ot=et[lt];We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,Ee,ge,Ot.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Me,Ee,ge,Ot.image[Re])}}}A(y)&&y.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),xe.__version=se.version,y.onUpdate&&y.onUpdate(y)}C.__version=y.version}function Pt(C,y,X,ue,se,xe){let ve=s.convert(X.format,X.colorSpace),ee=s.convert(X.type),ie=T(X.internalFormat,ve,ee,X.normalized,X.colorSpace),pe=i.get(y),O=i.get(X);if(O.__renderTarget=y,!pe.__hasExternalTextures){let re=Math.max(1,y.width>>xe),te=Math.max(1,y.height>>xe);se===n.TEXTURE_3D||se===n.TEXTURE_2D_ARRAY?t.texImage3D(se,xe,ie,re,te,y.depth,0,ve,ee,null):t.texImage2D(se,xe,ie,re,te,0,ve,ee,null)}t.bindFramebuffer(n.FRAMEBUFFER,C),be(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,se,O.__webglTexture,0,ot(y)):(se===n.TEXTURE_2D||se>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&se<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,se,O.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Ai(C,y,X){if(n.bindRenderbuffer(n.RENDERBUFFER,C),y.depthBuffer){let ue=y.depthTexture,se=ue&&ue.isDepthTexture?ue.type:null,xe=g(y.stencilBuffer,se),ve=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;be(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(y),xe,y.width,y.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(y),xe,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,xe,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,C)}else{let ue=y.textures;for(let se=0;se<ue.length;se++){let xe=ue[se],ve=s.convert(xe.format,xe.colorSpace),ee=s.convert(xe.type),ie=T(xe.internalFormat,ve,ee,xe.normalized,xe.colorSpace);be(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(y),ie,y.width,y.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(y),ie,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,ie,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function St(C,y,X){let ue=y.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,C),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let se=i.get(y.depthTexture);se.__renderTarget=y;let xe=ue?y.depthTexture.image[0]:y.depthTexture.image;(!se.__webglTexture||xe.width!==y.width||xe.height!==y.height)&&(xe.width=y.width,xe.height=y.height,y.depthTexture.needsUpdate=!0),ue?ye(y.depthTexture,0):me(y.depthTexture,0);let ve=se.__webglTexture,ee=ot(y),ie=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,pe=y.depthTexture.format===_n?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(y.depthTexture.format===sn)be(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ve,0);else if(y.depthTexture.format===_n)be(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function vi(C){let y=i.get(C),X=C.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==C.depthTexture){let ue=C.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),ue){let se=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,ue.removeEventListener("dispose",se)};ue.addEventListener("dispose",se),y.__depthDisposeCallback=se}y.__boundDepthTexture=ue}if(C.depthTexture&&!y.__autoAllocateDepthBuffer)if(X)for(let ue=0;ue<6;ue++)St(y.__webglFramebuffer[ue],C,ue);else C.texture.mipmaps.length>0?St(y.__webglFramebuffer[0],C,0):St(y.__webglFramebuffer,C,0);else if(X){y.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[ue]),y.__webglDepthbuffer[ue]===void 0)y.__webglDepthbuffer[ue]=n.createRenderbuffer(),Ai(y.__webglDepthbuffer[ue],C,!1);else{let se=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=y.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,se,n.RENDERBUFFER,xe)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),Ai(y.__webglDepthbuffer,C,!1);else{let se=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,se,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Qt(C,y,X){let ue=i.get(C);y!==void 0&&Pt(ue.__webglFramebuffer,C,C.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&vi(C)}function ci(C){let y=C.texture,X=i.get(C),ue=i.get(y);C.addEventListener("dispose",G),U(C);let se=C.textures,xe=C.isWebGLCubeRenderTarget===!0,ve=se.length>1;if(ve||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=y.version,o.memory.textures++),xe){X.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(y.mipmaps.length>0){X.__webglFramebuffer[ee]=[];for(let ie=0;ie<y.mipmaps.length;ie++)X.__webglFramebuffer[ee][ie]=n.createFramebuffer()}else X.__webglFramebuffer[ee]=n.createFramebuffer()}else{if(y.mipmaps.length>0){X.__webglFramebuffer=[];for(let ee=0;ee<y.mipmaps.length;ee++)X.__webglFramebuffer[ee]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(ve)for(let ee=0,ie=se.length;ee<ie;ee++){let pe=i.get(se[ee]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(C.samples>0&&be(C)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let ee=0;ee<se.length;ee++){let ie=se[ee];X.__webglColorRenderbuffer[ee]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[ee]);let pe=s.convert(ie.format,ie.colorSpace),O=s.convert(ie.type),re=T(ie.internalFormat,pe,O,ie.normalized,ie.colorSpace,C.isXRRenderTarget===!0),te=ot(C);n.renderbufferStorageMultisample(n.RENDERBUFFER,te,re,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ee,n.RENDERBUFFER,X.__webglColorRenderbuffer[ee])}n.bindRenderbuffer(n.RENDERBUFFER,null),C.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),Ai(X.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),dt(n.TEXTURE_CUBE_MAP,y);for(let ee=0;ee<6;ee++)if(y.mipmaps.length>0)for(let ie=0;ie<y.mipmaps.length;ie++)Pt(X.__webglFramebuffer[ee][ie],C,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ie);else Pt(X.__webglFramebuffer[ee],C,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);A(y)?M(n.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ee=0,ie=se.length;ee<ie;ee++){let pe=se[ee],O=i.get(pe),re=n.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(re=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,O.__webglTexture),dt(re,pe),Pt(X.__webglFramebuffer,C,pe,n.COLOR_ATTACHMENT0+ee,re,0),A(pe)&&M(re)}t.unbindTexture()}else{let ee=n.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(ee=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ee,ue.__webglTexture),dt(ee,y),y.mipmaps.length>0)for(let ie=0;ie<y.mipmaps.length;ie++)Pt(X.__webglFramebuffer[ie],C,y,n.COLOR_ATTACHMENT0,ee,ie);else Pt(X.__webglFramebuffer,C,y,n.COLOR_ATTACHMENT0,ee,0);A(y)?M(ee):y.mipmaps.length>0&&n.texParameteri(ee,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&vi(C)}function B(C){let y=C.textures;for(let X=0,ue=y.length;X<ue;X++){let se=y[X];if(A(se)&&se.mipmapsAutoUpdate===!0){let xe=R(C),ve=i.get(se).__webglTexture;t.bindTexture(xe,ve),M(xe),t.unbindTexture()}}}let Ce=[];function Je(C){if(C.samples>0){if(be(C)===!1){let y=C.textures,X=C.width,ue=C.height,se=n.COLOR_BUFFER_BIT,xe=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(C),ee=y.length>1;if(ee)for(let pe=0;pe<y.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let pe=0;pe<y.length;pe++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(se|=n.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(se|=n.STENCIL_BUFFER_BIT)),ee){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=i.get(y[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,X,ue,0,0,X,ue,se,n.NEAREST),l===!0&&(Ce.length=0,Ce.push(n.COLOR_ATTACHMENT0+pe),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ce.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ee)for(let pe=0;pe<y.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=i.get(y[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let y=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function ot(C){return Math.min(r.maxSamples,C.samples)}function be(C){let y=i.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Dt(C){let y=o.render.frame;h.get(C)!==y&&(h.set(C,y),C.update())}function ke(C,y){let X=C.colorSpace,ue=C.format,se=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||X!==fs&&X!==Cn&&(it.getTransfer(X)===vt?(ue!==bi||se!==oi)&&ze("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ht("WebGLTextures: Unsupported texture color space:",X)),y}function $e(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=Q,this.getTextureUnits=ne,this.setTextureUnits=he,this.setTexture2D=me,this.setTexture2DArray=_e,this.setTexture3D=Ae,this.setTextureCube=ye,this.rebindTextures=Qt,this.setupRenderTarget=ci,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=vi,this.setupFrameBufferTexture=Pt,this.useMultisampledRTT=be,this.dispose=W}function t_(n,e){function t(i,r=Cn){let s,o=it.getTransfer(r);if(i===oi)return n.UNSIGNED_BYTE;if(i===Ks)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Zs)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Yl)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Kl)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Xl)return n.BYTE;if(i===ql)return n.SHORT;if(i===xr)return n.UNSIGNED_SHORT;if(i===Ys)return n.INT;if(i===gi)return n.UNSIGNED_INT;if(i===xi)return n.FLOAT;if(i===Di)return n.HALF_FLOAT;if(i===Zl)return n.ALPHA;if(i===$l)return n.RGB;if(i===bi)return n.RGBA;if(i===sn)return n.DEPTH_COMPONENT;if(i===_n)return n.DEPTH_STENCIL;if(i===Jl)return n.RED;if(i===Br)return n.RED_INTEGER;if(i===vn)return n.RG;if(i===$s)return n.RG_INTEGER;if(i===Js)return n.RGBA_INTEGER;if(i===Qs||i===js||i===eo||i===to)if(o===vt)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===Qs)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===js)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===eo)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===to)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===Qs)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===js)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===eo)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===to)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ca||i===ua||i===fa||i===ha)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===ca)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===ua)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===fa)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ha)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===da||i===pa||i===ma||i===ga||i===xa||i===cs||i===_a)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===da||i===pa)return o===vt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===ma)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===ga)return s.COMPRESSED_R11_EAC;if(i===xa)return s.COMPRESSED_SIGNED_R11_EAC;if(i===cs)return s.COMPRESSED_RG11_EAC;if(i===_a)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===va||i===Sa||i===Ma||i===ya||i===ba||i===Ea||i===wa||i===Ta||i===Aa||i===Ra||i===Ca||i===Pa||i===La||i===Da)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===va)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Sa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ma)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ya)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ba)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ea)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===wa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ta)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Aa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ra)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ca)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Pa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===La)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Da)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ia||i===Na||i===Ua)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===Ia)return o===vt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Na)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ua)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Fa||i===Oa||i===us||i===Ba)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===Fa)return s.COMPRESSED_RED_RGTC1_EXT;if(i===Oa)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===us)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Ba)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===kn?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var lb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,cb=`
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

}`,Xc=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Eo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new tn({vertexShader:lb,fragmentShader:cb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Jt(new To(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}};var qc=class extends ki{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,m=null,x=null,S=typeof XRWebGLBinding<"u",d=new Xc,p={},v=t.getContextAttributes(),A=null,M=null,R=[],T=[],g=new Ze,E=null,U=null,P=new Ni;P.viewport=new bt;let D=new Ni;D.viewport=new bt;let G=[P,D],k=new Bc,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let me=R[j];return me===void 0&&(me=new co,R[j]=me),me.getTargetRaySpace()},this.getControllerGrip=function(j){let me=R[j];return me===void 0&&(me=new co,R[j]=me),me.getGripSpace()},this.getHand=function(j){let me=R[j];return me===void 0&&(me=new co,R[j]=me),me.getHandSpace()};function Y(j){let me=T.indexOf(j.inputSource);if(me===-1)return;let _e=R[me];_e!==void 0&&(_e.update(j.inputSource,j.frame,c||o),_e.dispatchEvent({type:j.type,data:j.inputSource}))}function H(){r.removeEventListener("select",Y),r.removeEventListener("selectstart",Y),r.removeEventListener("selectend",Y),r.removeEventListener("squeeze",Y),r.removeEventListener("squeezestart",Y),r.removeEventListener("squeezeend",Y),r.removeEventListener("end",H),r.removeEventListener("inputsourceschange",ce);for(let j=0;j<R.length;j++){let me=T[j];me!==null&&(T[j]=null,R[j].disconnect(me))}N=null,W=null,d.reset();for(let j in p)delete p[j];if(e.setRenderTarget(A),m=null,f=null,u=null,r=null,M=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(g.width,g.height,!1),U!==null){let j=U.camera;j.fov=U.fov,j.zoom=U.zoom,j.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){s=j,i.isPresenting===!0&&ze("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,i.isPresenting===!0&&ze("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return f!==null?f:m},this.getBinding=function(){return u===null&&S&&(u=new XRWebGLBinding(r,t)),u},this.getFrame=function(){return x},this.getSession=function(){return r},this.setSession=async function(j){if(r=j,r!==null){if(A=e.getRenderTarget(),r.addEventListener("select",Y),r.addEventListener("selectstart",Y),r.addEventListener("selectend",Y),r.addEventListener("squeeze",Y),r.addEventListener("squeezestart",Y),r.addEventListener("squeezeend",Y),r.addEventListener("end",H),r.addEventListener("inputsourceschange",ce),v.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(g),S&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,Ae=null,ye=null;v.depth&&(ye=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=v.stencil?_n:sn,Ae=v.stencil?kn:gi);let qe={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:s};u=this.getBinding(),f=u.createProjectionLayer(qe),r.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),M=new Oi(f.textureWidth,f.textureHeight,{format:bi,type:oi,depthTexture:new En(f.textureWidth,f.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let _e={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:s};m=new XRWebGLLayer(r,t,_e),r.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),M=new Oi(m.framebufferWidth,m.framebufferHeight,{format:bi,type:oi,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),fe.setContext(r),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return d.getDepthTexture()};function ce(j){for(let me=0;me<j.removed.length;me++){let _e=j.removed[me],Ae=T.indexOf(_e);Ae>=0&&(T[Ae]=null,R[Ae].disconnect(_e))}for(let me=0;me<j.added.length;me++){let _e=j.added[me],Ae=T.indexOf(_e);if(Ae===-1){for(let qe=0;qe<R.length;qe++)if(qe>=T.length){T.push(_e),Ae=qe;break}else if(T[qe]===null){T[qe]=_e,Ae=qe;break}if(Ae===-1)break}let ye=R[Ae];ye&&ye.connect(_e)}}function $(j,me){me===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(me.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(r===null)return;let me=j.near,_e=j.far;d.texture!==null&&(d.depthNear>0&&(me=d.depthNear),d.depthFar>0&&(_e=d.depthFar)),k.near=D.near=P.near=me,k.far=D.far=P.far=_e,(N!==k.near||W!==k.far)&&(r.updateRenderState({depthNear:k.near,depthFar:k.far}),N=k.near,W=k.far),k.layers.mask=j.layers.mask|6,P.layers.mask=k.layers.mask&-5,D.layers.mask=k.layers.mask&-3;let Ae=j.parent,ye=k.cameras;$(k,Ae);for(let qe=0;qe<ye.length;qe++)$(ye[qe],Ae);k.projectionMatrix.copy(P.projectionMatrix),k.projectionMatrixInverse.copy(P.projectionMatrixInverse),U===null&&j.isPerspectiveCamera&&(U={camera:j,fov:j.fov,zoom:j.zoom}),Q(j,k,Ae)};function Q(j,me,_e){_e===null?j.matrix.copy(me.matrixWorld):(j.matrix.copy(_e.matrixWorld),j.matrix.invert(),j.matrix.multiply(me.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(me.projectionMatrix),j.projectionMatrixInverse.copy(me.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=za*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(f===null&&m===null))return l},this.setFoveation=function(j){l=j,f!==null&&(f.fixedFoveation=j),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=j)},this.hasDepthSensing=function(){return d.texture!==null},this.getDepthSensingMesh=function(){return d.getMesh(k)},this.getCameraTexture=function(j){return p[j]};let ne=null;function he(j,me){if(h=me.getViewerPose(c||o),x=me,h!==null){let _e=h.views;m!==null&&(e.setRenderTargetFramebuffer(M,m.framebuffer),e.setRenderTarget(M));let Ae=!1;_e.length!==k.cameras.length&&(k.cameras.length=0,Ae=!0);for(let He=0;He<_e.length;He++){let dt=_e[He],ut=null;if(m!==null)ut=m.getViewport(dt);else{let Ht=u.getViewSubImage(f,dt);ut=Ht.viewport,He===0&&(e.setRenderTargetTextures(M,Ht.colorTexture,Ht.depthStencilTexture),e.setRenderTarget(M))}let nt=G[He];nt===void 0&&(nt=new Ni,nt.layers.enable(He),nt.viewport=new bt,G[He]=nt),nt.matrix.fromArray(dt.transform.matrix),nt.matrix.decompose(nt.position,nt.quaternion,nt.scale),nt.projectionMatrix.fromArray(dt.projectionMatrix),nt.projectionMatrixInverse.copy(nt.projectionMatrix).invert(),nt.viewport.set(ut.x,ut.y,ut.width,ut.height),He===0&&(k.matrix.copy(nt.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),Ae===!0&&k.cameras.push(nt)}let ye=r.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&S){u=i.getBinding();let He=u.getDepthInformation(_e[0]);He&&He.isValid&&He.texture&&d.init(He,r.renderState)}if(ye&&ye.includes("camera-access")&&S){e.state.unbindTexture(),u=i.getBinding();for(let He=0;He<_e.length;He++){let dt=_e[He].camera;if(dt){let ut=p[dt];ut||(ut=new Eo,p[dt]=ut);let nt=u.getCameraImage(dt);ut.sourceTexture=nt}}}}for(let _e=0;_e<R.length;_e++){let Ae=T[_e],ye=R[_e];Ae!==null&&ye!==void 0&&ye.update(Ae,me,c||o)}ne&&ne(j,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),x=null}let fe=new Gc;fe.setAnimationLoop(he),this.setAnimationLoop=function(j){ne=j},this.dispose=function(){}}};var ub=new Ve,i_=new Ke;i_.set(-1,0,0,0,1,0,0,0,1);function n_(n,e){function t(d,p){d.matrixAutoUpdate===!0&&d.updateMatrix(),p.value.copy(d.matrix)}function i(d,p){p.color.getRGB(d.fogColor.value,Pc(n)),p.isFog?(d.fogNear.value=p.near,d.fogFar.value=p.far):p.isFogExp2&&(d.fogDensity.value=p.density)}function r(d,p,v,A,M){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?s(d,p):p.isMeshLambertMaterial?(s(d,p),p.envMap&&(d.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(s(d,p),u(d,p)):p.isMeshPhongMaterial?(s(d,p),h(d,p),p.envMap&&(d.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(s(d,p),f(d,p),p.isMeshPhysicalMaterial&&m(d,p,M)):p.isMeshMatcapMaterial?(s(d,p),x(d,p)):p.isMeshDepthMaterial?s(d,p):p.isMeshDistanceMaterial?(s(d,p),S(d,p)):p.isMeshNormalMaterial?s(d,p):p.isLineBasicMaterial?(o(d,p),p.isLineDashedMaterial&&a(d,p)):p.isPointsMaterial?l(d,p,v,A):p.isSpriteMaterial?c(d,p):p.isShadowMaterial?(d.color.value.copy(p.color),d.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function s(d,p){d.opacity.value=p.opacity,p.color&&d.diffuse.value.copy(p.color),p.emissive&&d.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(d.map.value=p.map,t(p.map,d.mapTransform)),p.alphaMap&&(d.alphaMap.value=p.alphaMap,t(p.alphaMap,d.alphaMapTransform)),p.bumpMap&&(d.bumpMap.value=p.bumpMap,t(p.bumpMap,d.bumpMapTransform),d.bumpScale.value=p.bumpScale,p.side===$t&&(d.bumpScale.value*=-1)),p.normalMap&&(d.normalMap.value=p.normalMap,t(p.normalMap,d.normalMapTransform),d.normalScale.value.copy(p.normalScale),p.side===$t&&d.normalScale.value.negate()),p.displacementMap&&(d.displacementMap.value=p.displacementMap,t(p.displacementMap,d.displacementMapTransform),d.displacementScale.value=p.displacementScale,d.displacementBias.value=p.displacementBias),p.emissiveMap&&(d.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,d.emissiveMapTransform)),p.specularMap&&(d.specularMap.value=p.specularMap,t(p.specularMap,d.specularMapTransform)),p.alphaTest>0&&(d.alphaTest.value=p.alphaTest);let v=e.get(p),A=v.envMap,M=v.envMapRotation;A&&(d.envMap.value=A,d.envMapRotation.value.setFromMatrix4(ub.makeRotationFromEuler(M)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&d.envMapRotation.value.premultiply(i_),d.reflectivity.value=p.reflectivity,d.ior.value=p.ior,d.refractionRatio.value=p.refractionRatio),p.lightMap&&(d.lightMap.value=p.lightMap,d.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,d.lightMapTransform)),p.aoMap&&(d.aoMap.value=p.aoMap,d.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,d.aoMapTransform))}function o(d,p){d.diffuse.value.copy(p.color),d.opacity.value=p.opacity,p.map&&(d.map.value=p.map,t(p.map,d.mapTransform))}function a(d,p){d.dashSize.value=p.dashSize,d.totalSize.value=p.dashSize+p.gapSize,d.scale.value=p.scale}function l(d,p,v,A){d.diffuse.value.copy(p.color),d.opacity.value=p.opacity,d.size.value=p.size*v,d.scale.value=A*.5,p.map&&(d.map.value=p.map,t(p.map,d.uvTransform)),p.alphaMap&&(d.alphaMap.value=p.alphaMap,t(p.alphaMap,d.alphaMapTransform)),p.alphaTest>0&&(d.alphaTest.value=p.alphaTest)}function c(d,p){d.diffuse.value.copy(p.color),d.opacity.value=p.opacity,d.rotation.value=p.rotation,p.map&&(d.map.value=p.map,t(p.map,d.mapTransform)),p.alphaMap&&(d.alphaMap.value=p.alphaMap,t(p.alphaMap,d.alphaMapTransform)),p.alphaTest>0&&(d.alphaTest.value=p.alphaTest)}function h(d,p){d.specular.value.copy(p.specular),d.shininess.value=Math.max(p.shininess,1e-4)}function u(d,p){p.gradientMap&&(d.gradientMap.value=p.gradientMap)}function f(d,p){d.metalness.value=p.metalness,p.metalnessMap&&(d.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,d.metalnessMapTransform)),d.roughness.value=p.roughness,p.roughnessMap&&(d.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,d.roughnessMapTransform)),p.envMap&&(d.envMapIntensity.value=p.envMapIntensity)}function m(d,p,v){d.ior.value=p.ior,p.diffuseRoughness>0&&(d.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(d.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,d.diffuseRoughnessMapTransform))),p.sheen>0&&(d.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),d.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(d.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,d.sheenColorMapTransform)),p.sheenRoughnessMap&&(d.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,d.sheenRoughnessMapTransform))),p.clearcoat>0&&(d.clearcoat.value=p.clearcoat,d.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(d.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,d.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(d.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,d.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(d.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,d.clearcoatNormalMapTransform),d.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===$t&&d.clearcoatNormalScale.value.negate())),p.dispersion>0&&(d.dispersion.value=p.dispersion),p.retroreflectivity>0&&(d.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(d.iridescence.value=p.iridescence,d.iridescenceIOR.value=p.iridescenceIOR,d.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,d.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(d.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,d.iridescenceMapTransform)),p.iridescenceThicknessMap&&(d.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,d.iridescenceThicknessMapTransform))),p.transmission>0&&(d.transmission.value=p.transmission,d.transmissionSamplerMap.value=v.texture,d.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(d.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,d.transmissionMapTransform)),d.thickness.value=p.thickness,p.thicknessMap&&(d.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,d.thicknessMapTransform)),d.attenuationDistance.value=p.attenuationDistance,d.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(d.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(d.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,d.anisotropyMapTransform))),d.specularIntensity.value=p.specularIntensity,d.specularColor.value.copy(p.specularColor),p.specularColorMap&&(d.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,d.specularColorMapTransform)),p.specularIntensityMap&&(d.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,d.specularIntensityMapTransform))}function x(d,p){p.matcap&&(d.matcap.value=p.matcap)}function S(d,p){let v=e.get(p).light;d.referencePosition.value.setFromMatrixPosition(v.matrixWorld),d.nearDistance.value=v.shadow.camera.near,d.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function r_(n,e,t,i){let r={},s={};function o(v,A){let M=A.program;i.uniformBlockBinding(v,M,r[v.id])}function a(v,A){let M=r[v.id];M===void 0&&(x(v),M=l(v),r[v.id]=M,v.addEventListener("dispose",d));let R=A.program;i.updateUBOMapping(v,R);let T=e.render.frame;s[v.id]!==T&&(c(v),s[v.id]=T)}function l(v){let A=n.createBuffer(),M=v.__size,R=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,M,R),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(v){let A=r[v.id],M=v.uniforms,R=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let T=0,g=M.length;T<g;T++){let E=M[T];if(Array.isArray(E))for(let U=0,P=E.length;U<P;U++)h(E[U],T,U,R);else h(E,T,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(v,A,M,R){if(f(v,A,M,R)===!0){let T=v.__offset,g=v.value;if(Array.isArray(g)){let E=0;for(let U=0;U<g.length;U++){let P=g[U],D=S(P,!0);u(P,v.__data,E),E+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(g,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,v.__data)}}function u(v,A,M){typeof v=="number"||typeof v=="boolean"?A[M]=v:v.isMatrix3?(A[M]=v.elements[0],A[M+1]=v.elements[1],A[M+2]=v.elements[2],A[M+3]=0,A[M+4]=v.elements[3],A[M+5]=v.elements[4],A[M+6]=v.elements[5],A[M+7]=0,A[M+8]=v.elements[6],A[M+9]=v.elements[7],A[M+10]=v.elements[8],A[M+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-M),M):v.toArray(A,M)}function f(v,A,M,R){let T=v.value,g=A+"_"+M;if(Array.isArray(T)){R[g]===void 0&&(R[g]=[]);let E=R[g],U=!1;for(let P=0;P<T.length;P++)m(T[P],E,P)===!0&&(U=!0);return U}return m(T,R,g)}function m(v,A,M){if(A[M]===void 0)return typeof v=="number"||typeof v=="boolean"?A[M]=v:ArrayBuffer.isView(v)?A[M]=v.slice():A[M]=v.clone(),!0;{let R=A[M];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return A[M]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function x(v){let A=v.uniforms,M=0,R=16;for(let g=0,E=A.length;g<E;g++){let U=Array.isArray(A[g])?A[g]:[A[g]];for(let P=0,D=U.length;P<D;P++){let G=U[P],k=Array.isArray(G.value)?G.value:[G.value],N=Array.isArray(A[g])||Array.isArray(G.value),W=M;for(let H=0,ce=k.length;H<ce;H++){let $=k[H],Q=S($,N),ne=M%R,he=ne%Q.boundary,fe=ne+he;M+=he,fe!==0&&R-fe<Q.storage&&(M+=R-fe),H===0&&(W=M),M+=Q.storage}let Y=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new Y((M-W)/Float32Array.BYTES_PER_ELEMENT),G.__offset=W}}let T=M%R;return T>0&&(M+=R-T),v.__size=M,v.__cache={},this}function S(v,A){let M={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(M.boundary=4,M.storage=4):v.isVector2?(M.boundary=8,M.storage=8):v.isVector3||v.isColor?(M.boundary=16,M.storage=12):v.isVector4?(M.boundary=16,M.storage=16):v.isMatrix3?(M.boundary=16,M.storage=48):v.isMatrix4?(M.boundary=16,M.storage=64):v.isTexture?ze("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(M.boundary=16,M.storage=v.byteLength):ze("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function d(v){let A=v.target;A.removeEventListener("dispose",d),n.deleteBuffer(r[A.id]),delete r[A.id],delete s[A.id]}function p(){for(let v in r)n.deleteBuffer(r[v]);r={},s={}}return{bind:o,update:a,dispose:p}}var fb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ar=null;function s_(){return ar===null&&(ar=new qr(fb,16,16,vn,Di),ar.name="DFG_LUT",ar.minFilter=mi,ar.magFilter=mi,ar.wrapS=rn,ar.wrapT=rn,ar.generateMipmaps=!1,ar.needsUpdate=!0),ar}var ja=class{constructor(e={}){let{canvas:t=Gp(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:m=oi}=e;this.isWebGLRenderer=!0;let x;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");x=i.getContextAttributes().alpha}else x=o;let S=m,d=new Set([Js,$s,Br]),p=new Set([oi,gi,xr,kn,Ks,Zs]),v=new Uint32Array(4),A=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},R=null,T=null,g=[],E=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=gn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,D=!1,G=null,k=null,N=null,W=null;this._outputColorSpace=en;let Y=0,H=0,ce=null,$=-1,Q=null,ne=new bt,he=new bt,fe=null,j=new Xe(0),me=0,_e=t.width,Ae=t.height,ye=1,qe=null,st=null,He=new bt(0,0,_e,Ae),dt=new bt(0,0,_e,Ae),ut=!1,nt=new bn,Ht=new Mo,Ut=!1,li=!1,Pt=new Ve,Ai=new F,St=new bt,vi={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qt=!1;function ci(){return ce===null?ye:1}let B=i;function Ce(w,z){return t.getContext(w,z)}let Je,ot,be,Dt,ke,$e,C,y,X,ue,se,xe,ve,ee,ie,pe,O,re,te,Ee,ge,Me,We;try{let w={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Oe,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Re,!1),B===null){let z="webgl2";if(B=Ce(z,w),B===null)throw Ce(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(w){throw t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),ht("WebGLRenderer: "+w.message),w}function je(){Je=new m0(B),Je.init(),ge=new t_(B,Je),ot=new o0(B,Je,e,ge),be=new j0(B,Je),ot.reversedDepthBuffer&&f&&be.buffers.depth.setReversed(!0),k=B.createFramebuffer(),N=B.createFramebuffer(),W=B.createFramebuffer(),Dt=new _0(B),ke=new V0,$e=new e_(B,Je,be,ke,ot,ge,Dt),C=new p0(P),y=new ym(B),Me=new r0(B,y),X=new g0(B,y,Dt,Me),ue=new S0(B,X,y,Me,Dt),re=new v0(B,ot,$e),ie=new a0(ke),se=new k0(P,C,Je,ot,Me,ie),xe=new n_(P,ke),ve=new X0,ee=new K0(Je),O=new n0(P,C,be,ue,x,l),pe=new Q0(P,ue,ot),We=new r_(B,Dt,ot,be),te=new s0(B,Je,Dt),Ee=new x0(B,Je,Dt),Dt.programs=se.programs,P.capabilities=ot,P.extensions=Je,P.properties=ke,P.renderLists=ve,P.shadowMap=pe,P.state=be,P.info=Dt}S!==oi&&(U=new M0(S,t.width,t.height,a,r,s));let le=new qc(P,B);this.xr=le,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let w=Je.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=Je.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return ye},this.setPixelRatio=function(w){w!==void 0&&(ye=w,this.setSize(_e,Ae,!1))},this.getSize=function(w){return w.set(_e,Ae)},this.setSize=function(w,z,J=!0){if(le.isPresenting){ze("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=w,Ae=z,t.width=Math.floor(w*ye),t.height=Math.floor(z*ye),J===!0&&(t.style.width=w+"px",t.style.height=z+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,w,z)},this.getDrawingBufferSize=function(w){return w.set(_e*ye,Ae*ye).floor()},this.setDrawingBufferSize=function(w,z,J){_e=w,Ae=z,ye=J,t.width=Math.floor(w*J),t.height=Math.floor(z*J),this.setViewport(0,0,w,z)},this.setEffects=function(w){if(S===oi){ht("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let z=0;z<w.length;z++)if(w[z].isOutputPass===!0){ze("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(ne)},this.getViewport=function(w){return w.copy(He)},this.setViewport=function(w,z,J,q){w.isVector4?He.set(w.x,w.y,w.z,w.w):He.set(w,z,J,q),be.viewport(ne.copy(He).multiplyScalar(ci()).round())},this.getScissor=function(w){return w.copy(dt)},this.setScissor=function(w,z,J,q){w.isVector4?dt.set(w.x,w.y,w.z,w.w):dt.set(w,z,J,q),be.scissor(he.copy(dt).multiplyScalar(ci()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(w){be.setScissorTest(ut=w)},this.setOpaqueSort=function(w){qe=w},this.setTransparentSort=function(w){st=w},this.getClearColor=function(w){return w.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(w=!0,z=!0,J=!0){let q=0;if(w){let K=!1;if(ce!==null){let we=ce.texture.format;K=d.has(we)}if(K){let we=ce.texture.type,Pe=p.has(we),Te=O.getClearColor(),De=O.getClearAlpha(),Ge=Te.r,tt=Te.g,pt=Te.b;Pe?(v[0]=Ge,v[1]=tt,v[2]=pt,v[3]=De,B.clearBufferuiv(B.COLOR,0,v)):(A[0]=Ge,A[1]=tt,A[2]=pt,A[3]=De,B.clearBufferiv(B.COLOR,0,A))}else q|=B.COLOR_BUFFER_BIT}z&&(q|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),J&&(q|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&B.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),G=w},this.dispose=function(){t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),O.dispose(),ve.dispose(),ee.dispose(),$e.dispose(),ke.dispose(),C.dispose(),ue.dispose(),X.dispose(),Me.dispose(),We.dispose(),se.dispose(),le.dispose(),le.removeEventListener("sessionstart",rl),le.removeEventListener("sessionend",Yn),lr.stop()};function Oe(w){w.preventDefault(),of("WebGLRenderer: Context Lost."),D=!0}function et(){of("WebGLRenderer: Context Restored."),D=!1;let w=Dt.autoReset,z=pe.enabled,J=pe.autoUpdate,q=pe.needsUpdate,K=pe.type;je(),Dt.autoReset=w,pe.enabled=z,pe.autoUpdate=J,pe.needsUpdate=q,pe.type=K}function Re(w){ht("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function lt(w){let z=w.target;z.removeEventListener("dispose",lt),Ot(z)}function Ot(w){Yi(w),ke.remove(w)}function Yi(w){let z=ke.get(w).programs;z!==void 0&&(z.forEach(function(J){se.releaseProgram(J)}),w.isShaderMaterial&&se.releaseShaderCache(w))}this.renderBufferDirect=function(w,z,J,q,K,we){z===null&&(z=vi);let Pe=K.isMesh&&K.matrixWorld.determinantAffine()<0,Te=Oo(w,z,J,q,K);be.setMaterial(q,Pe);let De=J.index,Ge=1;if(q.wireframe===!0){if(De=X.getWireframeAttribute(J),De===void 0)return;Ge=2}let tt=J.drawRange,pt=J.attributes.position,Be=tt.start*Ge,mt=(tt.start+tt.count)*Ge;we!==null&&(Be=Math.max(Be,we.start*Ge),mt=Math.min(mt,(we.start+we.count)*Ge)),De!==null?(Be=Math.max(Be,0),mt=Math.min(mt,De.count)):pt!=null&&(Be=Math.max(Be,0),mt=Math.min(mt,pt.count));let Zt=mt-Be;if(Zt<0||Zt===1/0)return;Me.setup(K,q,Te,J,De);let At,Rt=te;if(De!==null&&(At=y.get(De),Rt=Ee,Rt.setIndex(At)),K.isMesh)q.wireframe===!0?(be.setLineWidth(q.wireframeLinewidth*ci()),Rt.setMode(B.LINES)):Rt.setMode(B.TRIANGLES);else if(K.isLine){let Si=q.linewidth;Si===void 0&&(Si=1),be.setLineWidth(Si*ci()),K.isLineSegments?Rt.setMode(B.LINES):K.isLineLoop?Rt.setMode(B.LINE_LOOP):Rt.setMode(B.LINE_STRIP)}else K.isPoints?Rt.setMode(B.POINTS):K.isSprite&&Rt.setMode(B.TRIANGLES);if(K.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Rt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let Si=K._multiDrawStarts,Ue=K._multiDrawCounts,ui=K._multiDrawCount,xt=De?y.get(De).bytesPerElement:1,ur=ke.get(q).currentProgram.getUniforms();for(let fi=0;fi<ui;fi++)ur.setValue(B,"_gl_DrawID",fi),Rt.render(Si[fi]/xt,Ue[fi])}else if(K.isInstancedMesh)Rt.renderInstances(Be,Zt,K.count);else if(J.isInstancedBufferGeometry){let Si=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,Ue=Math.min(J.instanceCount,Si);Rt.renderInstances(Be,Zt,Ue)}else Rt.render(Be,Zt)};function No(w,z,J,q){G!==null&&w.isNodeMaterial&&G.setObject(q,w),Ut===!0&&ie.setState(w,J,!1),w.transparent===!0&&w.side===ji&&w.forceSinglePass===!1?(w.side=$t,w.needsUpdate=!0,Kn(w,z,q),w.side=nn,w.needsUpdate=!0,Kn(w,z,q),w.side=ji):Kn(w,z,q)}this.compile=function(w,z,J=null){J===null&&(J=w),G!==null&&G.renderStart(w,z,J),T=ee.get(J),T.init(z),E.push(T),J.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),w!==J&&w.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),T.setupLights(),G!==null&&G.updateLights(T.state.lightsArray),li=this.localClippingEnabled,Ut=ie.init(this.clippingPlanes,li),Ut===!0&&ie.setGlobalState(this.clippingPlanes,z),G!==null&&pe.render(T.state.shadowsArray,J,z);let q=new Set;return w.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let we=K.material;if(we)if(Array.isArray(we))for(let Pe=0;Pe<we.length;Pe++){let Te=we[Pe];No(Te,J,z,K),q.add(Te)}else No(we,J,z,K),q.add(we)}),T=E.pop(),G!==null&&G.renderEnd(),q},this.compileAsync=function(w,z,J=null){let q=this.compile(w,z,J);return new Promise(K=>{function we(){if(q.forEach(function(Pe){let De=ke.get(Pe).currentProgram;(De===void 0||De.isReady())&&q.delete(Pe)}),q.size===0){K(w);return}setTimeout(we,10)}Je.get("KHR_parallel_shader_compile")!==null?we():setTimeout(we,10)})};let ys=null;function uu(w){ys&&ys(w)}function rl(){lr.stop()}function Yn(){lr.start()}let lr=new Gc;lr.setAnimationLoop(uu),typeof self<"u"&&lr.setContext(self),this.setAnimationLoop=function(w){ys=w,le.setAnimationLoop(w),w===null?lr.stop():lr.start()},le.addEventListener("sessionstart",rl),le.addEventListener("sessionend",Yn),this.render=function(w,z){if(z!==void 0&&z.isCamera!==!0){ht("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;G!==null&&G.renderStart(w,z);let J=le.enabled===!0&&le.isPresenting===!0,q=U!==null&&(ce===null||J)&&U.begin(P,ce);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(z),z=le.getCamera()),w.isScene===!0&&w.onBeforeRender(P,w,z,ce),T=ee.get(w,E.length),T.init(z),T.state.textureUnits=$e.getTextureUnits(),E.push(T),Pt.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Ht.setFromArrayCamera(z):nt.setFromProjectionMatrix(Pt,Fi,z.reversedDepth),li=this.localClippingEnabled,Ut=ie.init(this.clippingPlanes,li),R=ve.get(w,g.length),R.init(),g.push(R),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Pe=P.xr.getDepthSensingMesh();Pe!==null&&cr(Pe,z,-1/0,P.sortObjects)}cr(w,z,0,P.sortObjects),R.finish(),G!==null&&G.updateLights(T.state.lightsArray),P.sortObjects===!0&&R.sort(qe,st),Qt=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,Qt&&O.addToRenderList(R,w),this.info.autoReset===!0&&this.info.reset(),Ut===!0&&ie.beginShadows();let K=T.state.shadowsArray;if(pe.render(K,w,z),Ut===!0&&ie.endShadows(),(q&&U.hasRenderPass())===!1){let Pe=R.opaque,Te=R.transmissive;if(T.setupLights(),z.isArrayCamera){let De=z.cameras;if(Te.length>0)for(let Ge=0,tt=De.length;Ge<tt;Ge++){let pt=De[Ge];Nn(Pe,Te,w,pt)}Qt&&O.render(w);for(let Ge=0,tt=De.length;Ge<tt;Ge++){let pt=De[Ge];Uo(R,w,pt,pt.viewport)}}else Te.length>0&&Nn(Pe,Te,w,z),Qt&&O.render(w),Uo(R,w,z)}ce!==null&&H===0&&($e.updateMultisampleRenderTarget(ce),$e.updateRenderTargetMipmap(ce)),q&&U.end(P),w.isScene===!0&&w.onAfterRender(P,w,z),Me.resetDefaultState(),$=-1,Q=null,E.pop(),E.length>0?(T=E[E.length-1],$e.setTextureUnits(T.state.textureUnits),Ut===!0&&ie.setGlobalState(P.clippingPlanes,T.state.camera)):T=null,g.pop(),g.length>0?R=g[g.length-1]:R=null,G!==null&&G.renderEnd()};function cr(w,z,J,q){if(w.visible===!1)return;if(w.layers.test(z.layers)){if(w.isGroup)J=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(z);else if(w.isLight)T.pushLight(w),w.castShadow&&T.pushShadow(w);else if(w.isSprite){let Pe=z.isArrayCamera?Ht:nt;if(!w.frustumCulled||w.intersectsFrustum(Pe)){q&&St.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Pt);let Te=ue.update(w),De=w.material;De.visible&&R.push(w,Te,De,J,St.z,null,z)}}else if(w.isMesh||w.isLine||w.isPoints){let Pe=z.isArrayCamera?Ht:nt;if(!w.frustumCulled||w.intersectsFrustum(Pe)){let Te=ue.update(w),De=w.material;if(q&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),St.copy(w.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),St.copy(Te.boundingSphere.center)),St.applyMatrix4(w.matrixWorld).applyMatrix4(Pt)),Array.isArray(De)){let Ge=Te.groups;for(let tt=0,pt=Ge.length;tt<pt;tt++){let Be=Ge[tt],mt=De[Be.materialIndex];mt&&mt.visible&&R.push(w,Te,mt,J,St.z,Be,z)}}else De.visible&&R.push(w,Te,De,J,St.z,null,z)}}}let we=w.children;for(let Pe=0,Te=we.length;Pe<Te;Pe++)cr(we[Pe],z,J,q)}function Uo(w,z,J,q){let{opaque:K,transmissive:we,transparent:Pe}=w;T.setupLightsView(J),Ut===!0&&ie.setGlobalState(P.clippingPlanes,J),q&&be.viewport(ne.copy(q)),K.length>0&&jt(K,z,J),we.length>0&&jt(we,z,J),Pe.length>0&&jt(Pe,z,J),be.buffers.depth.setTest(!0),be.buffers.depth.setMask(!0),be.buffers.color.setMask(!0),be.setPolygonOffset(!1)}function Nn(w,z,J,q){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[q.id]===void 0){let Be=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[q.id]=new Oi(1,1,{generateMipmaps:!0,type:Be?Di:oi,minFilter:xn,samples:Math.max(4,ot.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:it.workingColorSpace})}let we=T.state.transmissionRenderTarget[q.id],Pe=q.viewport||ne;we.setSize(Pe.z*P.transmissionResolutionScale,Pe.w*P.transmissionResolutionScale);let Te=P.getRenderTarget(),De=P.getActiveCubeFace(),Ge=P.getActiveMipmapLevel();P.setRenderTarget(we),P.getClearColor(j),me=P.getClearAlpha(),me<1&&P.setClearColor(16777215,.5),P.clear(),Qt&&O.render(J);let tt=P.toneMapping;P.toneMapping=gn;let pt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),T.setupLightsView(q),Ut===!0&&ie.setGlobalState(P.clippingPlanes,q),jt(w,J,q),$e.updateMultisampleRenderTarget(we),$e.updateRenderTargetMipmap(we),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let mt=0,Zt=z.length;mt<Zt;mt++){let At=z[mt],{object:Rt,geometry:Si,material:Ue,group:ui}=At;if(Ue.side===ji&&Rt.layers.test(q.layers)){let xt=Ue.side;Ue.side=$t,Ue.needsUpdate=!0,ni(Rt,J,q,Si,Ue,ui),Ue.side=xt,Ue.needsUpdate=!0,Be=!0}}Be===!0&&($e.updateMultisampleRenderTarget(we),$e.updateRenderTargetMipmap(we))}P.setRenderTarget(Te,De,Ge),P.setClearColor(j,me),pt!==void 0&&(q.viewport=pt),P.toneMapping=tt}function jt(w,z,J){let q=z.isScene===!0?z.overrideMaterial:null;for(let K=0,we=w.length;K<we;K++){let Pe=w[K],{object:Te,geometry:De,group:Ge}=Pe,tt=Pe.material;tt.allowOverride===!0&&q!==null&&(tt=q),Te.layers.test(J.layers)&&ni(Te,z,J,De,tt,Ge)}}function ni(w,z,J,q,K,we){G!==null&&K.isNodeMaterial&&G.setObject(w,K),w.onBeforeRender(P,z,J,q,K,we),w.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),K.onBeforeRender(P,z,J,q,w,we),K.transparent===!0&&K.side===ji&&K.forceSinglePass===!1?(K.side=$t,K.needsUpdate=!0,P.renderBufferDirect(J,z,q,K,w,we),K.side=nn,K.needsUpdate=!0,P.renderBufferDirect(J,z,q,K,w,we),K.side=ji):P.renderBufferDirect(J,z,q,K,w,we),w.onAfterRender(P,z,J,q,K,we)}function ri(w){let z=0;for(let J of w)J.texture!==null&&z++;return z}function Kn(w,z,J){z.isScene!==!0&&(z=vi);let q=ke.get(w),K=T.state.lights,we=T.state.shadowsArray,Pe=K.state.version,Te=se.getParameters(w,K.state,we,z,J,T.state.lightProbeGridArray),De=se.getProgramCacheKey(Te),Ge=q.programs;q.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?z.environment:null,q.fog=z.fog;let tt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;q.envMap=C.get(w.envMap||q.environment,tt),q.envMapRotation=q.environment!==null&&w.envMap===null?z.environmentRotation:w.envMapRotation,Ge===void 0&&(w.addEventListener("dispose",lt),Ge=new Map,q.programs=Ge,q.programVariants=new Map);let pt=Ge.get(De);if(pt!==void 0){if(q.currentProgram===pt&&q.lightsStateVersion===Pe)return Fo(w,Te),pt}else Te.uniforms=se.getUniforms(w),G!==null&&w.isNodeMaterial&&G.build(w,J,Te),w.onBeforeCompile(Te,P),pt=se.acquireProgram(Te,De),Ge.set(De,pt),q.uniforms=Te.uniforms;let Be=q.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Be.clippingPlanes=ie.uniform),Fo(w,Te),q.needsLights=Ar(w),q.lightsStateVersion=Pe,q.needsLights&&(Be.ambientLightColor.value=K.state.ambient,Be.lightProbe.value=K.state.probe,Be.sunLights.value=K.state.sun,Be.sunLightShadows.value=K.state.sunShadow,Be.directionalLights.value=K.state.directional,Be.directionalLightShadows.value=K.state.directionalShadow,Be.spotLights.value=K.state.spot,Be.spotLightShadows.value=K.state.spotShadow,Be.rectAreaLights.value=K.state.rectArea,Be.ltc_1.value=K.state.rectAreaLTC1,Be.ltc_2.value=K.state.rectAreaLTC2,Be.pointLights.value=K.state.point,Be.pointLightShadows.value=K.state.pointShadow,Be.hemisphereLights.value=K.state.hemi,Be.sunShadowMatrix.value=K.state.sunShadowMatrix,Be.sunShadowCascade.value=K.state.sunShadowCascade,Be.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Be.spotLightMatrix.value=K.state.spotLightMatrix,Be.spotLightMap.value=K.state.spotLightMap,Be.pointShadowMatrix.value=K.state.pointShadowMatrix),q.numLightProbeGrids=ri(T.state.lightProbeGridArray),q.currentProgram=pt,q.uniformsList=null,pt}function cn(w,z,J,q,K){let we=ke.get(w),Pe=we.currentProgram.id+","+q+","+K,Te=we.programVariants.get(Pe);return Te===void 0?(Te=Kn(w,z,J),we.programVariants.set(Pe,Te)):(we.currentProgram=Te,we.uniformsList=null,we.outputColorSpace=q,we.toneMapping=K),Te}function Tr(w){if(w.uniformsList===null){let z=w.currentProgram.getUniforms();w.uniformsList=$r.seqWithValue(z.seq,w.uniforms)}return w.uniformsList}function Fo(w,z){let J=ke.get(w);J.outputColorSpace=z.outputColorSpace,J.batching=z.batching,J.batchingColor=z.batchingColor,J.instancing=z.instancing,J.instancingColor=z.instancingColor,J.instancingMorph=z.instancingMorph,J.skinning=z.skinning,J.morphTargets=z.morphTargets,J.morphNormals=z.morphNormals,J.morphColors=z.morphColors,J.morphTargetsCount=z.morphTargetsCount,J.numClippingPlanes=z.numClippingPlanes,J.numIntersection=z.numClipIntersection,J.vertexAlphas=z.vertexAlphas,J.vertexTangents=z.vertexTangents,J.toneMapping=z.toneMapping}function Oo(w,z,J,q,K){z.isScene!==!0&&(z=vi),$e.resetTextureUnits();let we=z.fog,Pe=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?z.environment:null,Te=ce===null?P.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:it.workingColorSpace,De=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,Ge=C.get(q.envMap||Pe,De),tt=q.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,pt=!!J.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Be=!!J.morphAttributes.position,mt=!!J.morphAttributes.normal,Zt=!!J.morphAttributes.color,At=gn;q.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(At=P.toneMapping);let Rt=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,Si=Rt!==void 0?Rt.length:0,Ue=ke.get(q),ui=T.state.lights;if(Ut===!0&&(li===!0||w!==Q)){let Ct=w===Q&&q.id===$;ie.setState(q,w,Ct)}let xt=!1,ur=!1;q.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==ui.state.version||K.isBatchedMesh&&Ue.batching===!1||!K.isBatchedMesh&&Ue.batching===!0||K.isBatchedMesh&&Ue.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ue.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ue.instancing===!1||!K.isInstancedMesh&&Ue.instancing===!0||K.isSkinnedMesh&&Ue.skinning===!1||!K.isSkinnedMesh&&Ue.skinning===!0||K.isInstancedMesh&&Ue.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ue.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ue.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ue.instancingMorph===!1&&K.morphTexture!==null||Ue.envMap!==Ge||q.fog===!0&&Ue.fog!==we||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==ie.numPlanes||Ue.numIntersection!==ie.numIntersection)||Ue.vertexAlphas!==tt||Ue.vertexTangents!==pt||Ue.morphTargets!==Be||Ue.morphNormals!==mt||Ue.morphColors!==Zt||Ue.morphTargetsCount!==Si||Ue.numLightProbeGrids!==ri(T.state.lightProbeGridArray)?xt=!0:(Ue.outputColorSpace!==Te||Ue.toneMapping!==At)&&(ur=!0):(xt=!0,Ue.__version=q.version);let fi=Ue.currentProgram;(xt===!0||ur===!0)&&(fi=ur===!0?cn(q,z,K,Te,At):Kn(q,z,K),G&&q.isNodeMaterial&&G.onUpdateProgram(q,fi,Ue));let ws=!1,Zn=!1,fr=!1,ft=fi.getUniforms(),ei=Ue.uniforms;if(be.useProgram(fi.program)&&(ws=!0,Zn=!0,fr=!0),q.id!==$&&($=q.id,Zn=!0),ws||Q!==w){be.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),ft.setValue(B,"projectionMatrix",w.projectionMatrix),ft.setValue(B,"viewMatrix",w.matrixWorldInverse);let hi=ft.map.cameraPosition;hi!==void 0&&hi.setValue(B,Ai.setFromMatrixPosition(w.matrixWorld)),ot.logarithmicDepthBuffer&&ft.setValue(B,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&ft.setValue(B,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&(Q=w,Zn=!0,fr=!0)}if(Ue.needsLights&&(ui.state.sunShadowMap.length>0&&ft.setValue(B,"sunShadowMap",ui.state.sunShadowMap,$e),ui.state.directionalShadowMap.length>0&&ft.setValue(B,"directionalShadowMap",ui.state.directionalShadowMap,$e),ui.state.spotShadowMap.length>0&&ft.setValue(B,"spotShadowMap",ui.state.spotShadowMap,$e),ui.state.pointShadowMap.length>0&&ft.setValue(B,"pointShadowMap",ui.state.pointShadowMap,$e)),K.isSkinnedMesh){ft.setOptional(B,K,"bindMatrix"),ft.setOptional(B,K,"bindMatrixInverse");let Ct=K.skeleton;Ct&&(Ct.boneTexture===null&&Ct.computeBoneTexture(),ft.setValue(B,"boneTexture",Ct.boneTexture,$e))}K.isBatchedMesh&&(ft.setOptional(B,K,"batchingTexture"),ft.setValue(B,"batchingTexture",K._matricesTexture,$e),ft.setOptional(B,K,"batchingIdTexture"),ft.setValue(B,"batchingIdTexture",K._indirectTexture,$e),ft.setOptional(B,K,"batchingColorTexture"),K._colorsTexture!==null&&ft.setValue(B,"batchingColorTexture",K._colorsTexture,$e));let Ki=J.morphAttributes;if((Ki.position!==void 0||Ki.normal!==void 0||Ki.color!==void 0)&&re.update(K,J,fi),(Zn||Ue.receiveShadow!==K.receiveShadow)&&(Ue.receiveShadow=K.receiveShadow,ft.setValue(B,"receiveShadow",K.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&z.environment!==null&&(ei.envMapIntensity.value=z.environmentIntensity),ei.dfgLUT!==void 0&&(ei.dfgLUT.value=s_()),Zn){if(ft.setValue(B,"toneMappingExposure",P.toneMappingExposure),Ue.needsLights&&bs(ei,fr),we&&q.fog===!0&&xe.refreshFogUniforms(ei,we),xe.refreshMaterialUniforms(ei,q,ye,Ae,T.state.transmissionRenderTarget[w.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Ct=M,hi=0;for(let Gi of T.state.lightProbeGridArray)Gi.texture!==null&&(Ct.textures[hi]=Gi.texture,Ct.min[hi]=Gi.boundingBox.min,Ct.max[hi]=Gi.boundingBox.max,Ct.resolution[hi]=Gi.resolution,hi++);for(let Gi in Ct)Ct[Gi].length=hi;ei.probesSH.value=Ct.textures,ei.probesMin.value=Ct.min,ei.probesMax.value=Ct.max,ei.probesResolution.value=Ct.resolution}$r.upload(B,Tr(Ue),ei,$e)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&($r.upload(B,Tr(Ue),ei,$e),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&ft.setValue(B,"center",K.center),ft.setValue(B,"modelViewMatrix",K.modelViewMatrix),ft.setValue(B,"normalMatrix",K.normalMatrix),ft.setValue(B,"modelMatrix",K.matrixWorld),q.uniformsGroups!==void 0){let Ct=q.uniformsGroups;for(let hi=0,Gi=Ct.length;hi<Gi;hi++){let sl=Ct[hi];We.update(sl,fi),We.bind(sl,fi)}}return fi}function bs(w,z){w.ambientLightColor.needsUpdate=z,w.lightProbe.needsUpdate=z,w.sunLights.needsUpdate=z,w.sunLightShadows.needsUpdate=z,w.directionalLights.needsUpdate=z,w.directionalLightShadows.needsUpdate=z,w.pointLights.needsUpdate=z,w.pointLightShadows.needsUpdate=z,w.spotLights.needsUpdate=z,w.spotLightShadows.needsUpdate=z,w.rectAreaLights.needsUpdate=z,w.hemisphereLights.needsUpdate=z}function Ar(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(w,z,J){let q=ke.get(w);q.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),ke.get(w.texture).__webglTexture=z,ke.get(w.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:J,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,z){let J=ke.get(w);J.__webglFramebuffer=z,J.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(w,z=0,J=0){ce=w,Y=z,H=J;let q=null,K=!1,we=!1;if(w){let Te=ke.get(w);if(Te.__useDefaultFramebuffer!==void 0){be.bindFramebuffer(B.FRAMEBUFFER,Te.__webglFramebuffer),ne.copy(w.viewport),he.copy(w.scissor),fe=w.scissorTest,be.viewport(ne),be.scissor(he),be.setScissorTest(fe),$=-1;return}else if(Te.__webglFramebuffer===void 0)$e.setupRenderTarget(w);else if(Te.__hasExternalTextures)$e.rebindTextures(w,ke.get(w.texture).__webglTexture,ke.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let tt=w.depthTexture;if(Te.__boundDepthTexture!==tt){if(tt!==null&&ke.has(tt)&&(w.width!==tt.image.width||w.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(w)}}let De=w.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(we=!0);let Ge=ke.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Ge[z])?q=Ge[z][J]:q=Ge[z],K=!0):w.samples>0&&$e.useMultisampledRTT(w)===!1?q=ke.get(w).__webglMultisampledFramebuffer:Array.isArray(Ge)?q=Ge[J]:q=Ge,ne.copy(w.viewport),he.copy(w.scissor),fe=w.scissorTest}else ne.copy(He).multiplyScalar(ye).floor(),he.copy(dt).multiplyScalar(ye).floor(),fe=ut;if(J!==0&&(q=k),be.bindFramebuffer(B.FRAMEBUFFER,q)&&be.drawBuffers(w,q),be.viewport(ne),be.scissor(he),be.setScissorTest(fe),K){let Te=ke.get(w.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+z,Te.__webglTexture,J)}else if(we){let Te=z;for(let De=0;De<w.textures.length;De++){let Ge=ke.get(w.textures[De]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+De,Ge.__webglTexture,J,Te)}}else if(w!==null&&J!==0){let Te=ke.get(w.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Te.__webglTexture,J)}$=-1};function Es(w){let z=ke.get(w);return(z.__readFormat!==w.format||z.__readType!==w.type)&&(z.__readFormat=w.format,z.__readType=w.type,z.__formatReadable=ot.textureFormatReadable(w.format),z.__typeReadable=ot.textureTypeReadable(w.type)),z}this.readRenderTargetPixels=function(w,z,J,q,K,we,Pe,Te=0){if(!(w&&w.isWebGLRenderTarget)){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=ke.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(De=De[Pe],Array.isArray(De)&&(De=De[0])),De){be.bindFramebuffer(B.FRAMEBUFFER,De);try{let Ge=w.textures[Te],tt=Ge.format,pt=Ge.type;w.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let Be=Es(Ge);if(Be.__formatReadable===!1){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=w.width-q&&J>=0&&J<=w.height-K&&B.readPixels(z,J,q,K,ge.convert(tt),ge.convert(pt),we)}finally{let Ge=ce!==null?ke.get(ce).__webglFramebuffer:null;be.bindFramebuffer(B.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(w,z,J,q,K,we,Pe,Te=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=ke.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(De=De[Pe],Array.isArray(De)&&(De=De[0])),De)if(z>=0&&z<=w.width-q&&J>=0&&J<=w.height-K){be.bindFramebuffer(B.FRAMEBUFFER,De);let Ge=w.textures[Te],tt=Ge.format,pt=Ge.type;w.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let Be=Es(Ge);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.bufferData(B.PIXEL_PACK_BUFFER,we.byteLength,B.STREAM_READ),B.readPixels(z,J,q,K,ge.convert(tt),ge.convert(pt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Zt=ce!==null?ke.get(ce).__webglFramebuffer:null;be.bindFramebuffer(B.FRAMEBUFFER,Zt);let At=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await kp(B,At,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,we),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(mt),B.deleteSync(At),we}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,z=null,J=0){let q=Math.pow(2,-J),K=Math.floor(w.image.width*q),we=Math.floor(w.image.height*q),Pe=z!==null?z.x:0,Te=z!==null?z.y:0;$e.setTexture2D(w,0),B.copyTexSubImage2D(B.TEXTURE_2D,J,0,0,Pe,Te,K,we),be.unbindTexture()},this.copyTextureToTexture=function(w,z,J=null,q=null,K=0,we=0){let Pe,Te,De,Ge,tt,pt,Be,mt,Zt,At=w.isCompressedTexture?w.mipmaps[we]:w.image;if(J!==null)Pe=J.max.x-J.min.x,Te=J.max.y-J.min.y,De=J.isBox3?J.max.z-J.min.z:1,Ge=J.min.x,tt=J.min.y,pt=J.isBox3?J.min.z:0;else{let ft=Math.pow(2,-K);Pe=Math.floor(At.width*ft),Te=Math.floor(At.height*ft),w.isDataArrayTexture?De=At.depth:w.isData3DTexture?De=Math.floor(At.depth*ft):De=1,Ge=0,tt=0,pt=0}q!==null?(Be=q.x,mt=q.y,Zt=q.z):(Be=0,mt=0,Zt=0);let Rt=ge.convert(z.format),Si=ge.convert(z.type),Ue;z.isData3DTexture?($e.setTexture3D(z,0),Ue=B.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?($e.setTexture2DArray(z,0),Ue=B.TEXTURE_2D_ARRAY):($e.setTexture2D(z,0),Ue=B.TEXTURE_2D),be.activeTexture(B.TEXTURE0),be.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,z.flipY),be.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),be.pixelStorei(B.UNPACK_ALIGNMENT,z.unpackAlignment);let ui=be.getParameter(B.UNPACK_ROW_LENGTH),xt=be.getParameter(B.UNPACK_IMAGE_HEIGHT),ur=be.getParameter(B.UNPACK_SKIP_PIXELS),fi=be.getParameter(B.UNPACK_SKIP_ROWS),ws=be.getParameter(B.UNPACK_SKIP_IMAGES);be.pixelStorei(B.UNPACK_ROW_LENGTH,At.width),be.pixelStorei(B.UNPACK_IMAGE_HEIGHT,At.height),be.pixelStorei(B.UNPACK_SKIP_PIXELS,Ge),be.pixelStorei(B.UNPACK_SKIP_ROWS,tt),be.pixelStorei(B.UNPACK_SKIP_IMAGES,pt);let Zn=w.isDataArrayTexture||w.isData3DTexture,fr=z.isDataArrayTexture||z.isData3DTexture;if(w.isDepthTexture){let ft=ke.get(w),ei=ke.get(z),Ki=ke.get(ft.__renderTarget),Ct=ke.get(ei.__renderTarget);be.bindFramebuffer(B.READ_FRAMEBUFFER,Ki.__webglFramebuffer),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ct.__webglFramebuffer);for(let hi=0;hi<De;hi++)Zn&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ke.get(w).__webglTexture,K,pt+hi),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ke.get(z).__webglTexture,we,Zt+hi)),B.blitFramebuffer(Ge,tt,Ge+Pe,tt+Te,Be,mt,Be+Pe,mt+Te,B.DEPTH_BUFFER_BIT,B.NEAREST);be.bindFramebuffer(B.READ_FRAMEBUFFER,null),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(K!==0||w.isRenderTargetTexture||ke.has(w)){let ft=ke.get(w),ei=ke.get(z);be.bindFramebuffer(B.READ_FRAMEBUFFER,N),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,W);for(let Ki=0;Ki<De;Ki++)Zn?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ft.__webglTexture,K,pt+Ki):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ft.__webglTexture,K),fr?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ei.__webglTexture,we,Zt+Ki):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ei.__webglTexture,we),K!==0?B.blitFramebuffer(Ge,tt,Ge+Pe,tt+Te,Be,mt,Be+Pe,mt+Te,B.COLOR_BUFFER_BIT,B.NEAREST):fr?B.copyTexSubImage3D(Ue,we,Be,mt,Zt+Ki,Ge,tt,Pe,Te):B.copyTexSubImage2D(Ue,we,Be,mt,Ge,tt,Pe,Te);be.bindFramebuffer(B.READ_FRAMEBUFFER,null),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else fr?w.isDataTexture||w.isData3DTexture?B.texSubImage3D(Ue,we,Be,mt,Zt,Pe,Te,De,Rt,Si,At.data):z.isCompressedArrayTexture?B.compressedTexSubImage3D(Ue,we,Be,mt,Zt,Pe,Te,De,Rt,At.data):B.texSubImage3D(Ue,we,Be,mt,Zt,Pe,Te,De,Rt,Si,At):w.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,we,Be,mt,Pe,Te,Rt,Si,At.data):w.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,we,Be,mt,At.width,At.height,Rt,At.data):B.texSubImage2D(B.TEXTURE_2D,we,Be,mt,Pe,Te,Rt,Si,At);be.pixelStorei(B.UNPACK_ROW_LENGTH,ui),be.pixelStorei(B.UNPACK_IMAGE_HEIGHT,xt),be.pixelStorei(B.UNPACK_SKIP_PIXELS,ur),be.pixelStorei(B.UNPACK_SKIP_ROWS,fi),be.pixelStorei(B.UNPACK_SKIP_IMAGES,ws),we===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&B.generateMipmap(Ue),be.unbindTexture()},this.initRenderTarget=function(w){ke.get(w).__webglFramebuffer===void 0&&$e.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?$e.setTextureCube(w,0):w.isData3DTexture?$e.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?$e.setTexture2DArray(w,0):$e.setTexture2D(w,0),be.unbindTexture()},this.resetState=function(){Y=0,H=0,ce=null,be.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Fi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=it._getDrawingBufferColorSpace(e),t.unpackColorSpace=it._getUnpackColorSpace()}};var hb=.07,Yc=Math.PI/2-.001,Zc=class{constructor(e,t,i,r){this.camera=e,this.element=t,this.changed=i,this.up=new F(...r).normalize(),this.basis=new qt().setFromUnitVectors(new F(0,1,0),this.up),this.now={target:new F,azimuth:.6,elevation:.4,distance:1},this.goal={target:new F,azimuth:.6,elevation:.4,distance:1},this.nearest=1e-6,this.farthest=1e6,this.chosen=!1,this.takesWheel=()=>!0,this.pointers=new Map,t.addEventListener("pointerdown",s=>this.#i(s)),t.addEventListener("pointermove",s=>this.#r(s));for(let s of["pointerup","pointercancel"])t.addEventListener(s,o=>this.#n(o));t.addEventListener("wheel",s=>this.#s(s),{passive:!1}),t.addEventListener("contextmenu",s=>s.preventDefault())}get pixel(){return 2*this.now.distance*Math.tan(this.camera.fov*Math.PI/360)/Math.max(this.element.clientHeight,1)}direction(e=this.now){let t=Math.cos(e.elevation);return new F(t*Math.sin(e.azimuth),Math.sin(e.elevation),t*Math.cos(e.azimuth)).applyQuaternion(this.basis)}look({target:e,direction:t,distance:i},r=!1){if(this.chosen=!0,e&&this.goal.target.copy(e),i&&(this.goal.distance=this.#t(i)),t){let s=t.clone().normalize().applyQuaternion(this.basis.clone().invert());if(this.goal.elevation=Math.max(-Yc,Math.min(Yc,Math.asin(Math.max(-1,Math.min(1,s.y))))),Math.hypot(s.x,s.z)>1e-6){let o=Math.atan2(s.x,s.z);this.goal.azimuth=o+2*Math.PI*Math.round((this.now.azimuth-o)/(2*Math.PI))}}r&&this.settle(),this.changed()}settle(){this.now.target.copy(this.goal.target);for(let e of["azimuth","elevation","distance"])this.now[e]=this.goal[e];this.#e()}step(e){let t=1-Math.exp(-e/hb),{now:i,goal:r}=this,s=i.target.distanceTo(r.target)/i.distance+Math.abs(i.azimuth-r.azimuth)+Math.abs(i.elevation-r.elevation)+Math.abs(Math.log(i.distance/r.distance));return s<1e-4?(s&&this.settle(),!1):(i.target.lerp(r.target,t),i.azimuth+=t*(r.azimuth-i.azimuth),i.elevation+=t*(r.elevation-i.elevation),i.distance*=(r.distance/i.distance)**t,this.#e(),!0)}#e(){let{camera:e,now:t}=this;e.position.copy(t.target).addScaledVector(this.direction(),t.distance),o_.lookAt(this.direction(),db,this.up),e.quaternion.setFromRotationMatrix(o_),e.updateMatrixWorld(!0)}#t(e){return Math.max(this.nearest,Math.min(this.farthest,e))}#i(e){e.button>2||(this.element.setPointerCapture?.(e.pointerId),this.pointers.set(e.pointerId,{x:e.clientX,y:e.clientY,pan:e.button!==0||e.shiftKey||e.ctrlKey}))}#n(e){this.pointers.delete(e.pointerId)}get dragging(){return this.pointers.size>0}#r(e){let t=this.pointers.get(e.pointerId);if(!t)return;let i=[...this.pointers.entries()].filter(([o])=>o!==e.pointerId).map(([,o])=>o),r=e.clientX-t.x,s=e.clientY-t.y;if(i.length){let[o]=i,a=Math.hypot(t.x-o.x,t.y-o.y),l=Math.hypot(e.clientX-o.x,e.clientY-o.y);a>0&&l>0&&this.zoom(a/l,(e.clientX+o.x)/2,(e.clientY+o.y)/2),this.pan(r/2,s/2)}else t.pan?this.pan(r,s):this.turn(r,s);t.x=e.clientX,t.y=e.clientY}turn(e,t){this.chosen=!0;let i=1.1*Math.PI/Math.max(this.element.clientHeight,1);this.goal.azimuth-=i*e,this.goal.elevation=Math.max(-Yc,Math.min(Yc,this.goal.elevation+i*t)),this.changed()}pan(e,t){this.chosen=!0;let i=this.pixel;this.goal.target.addScaledVector(Kc.set(1,0,0).applyQuaternion(this.camera.quaternion),-e*i),this.goal.target.addScaledVector(Kc.set(0,1,0).applyQuaternion(this.camera.quaternion),t*i),this.changed()}zoom(e,t,i){this.chosen=!0;let r=this.goal.distance;if(this.goal.distance=this.#t(r*e),t!==void 0){let s=this.element.getBoundingClientRect(),o=this.pixel*r/this.now.distance*(1-this.goal.distance/r);this.goal.target.addScaledVector(Kc.set(1,0,0).applyQuaternion(this.camera.quaternion),(t-s.left-this.middle(t-s.left))*o),this.goal.target.addScaledVector(Kc.set(0,1,0).applyQuaternion(this.camera.quaternion),(s.height/2-(i-s.top))*o)}this.changed()}middle(e){let t=this.element.clientWidth/(this.pictures??1);return(Math.floor(e/t)+.5)*t}#s(e){if(!this.takesWheel(e))return;e.preventDefault();let t=e.deltaMode===1?33:1;this.zoom(Math.exp(Math.max(-1,Math.min(1,e.deltaY*t*.0015))),e.clientX,e.clientY)}},o_=new Ve,db=new F,Kc=new F;var[pb,mb]=[5126,5125],[a_,gb]=[34962,34963],Vf=class{constructor(){this.pieces=[],this.length=0,this.json={asset:{version:"2.0",generator:"pitchpoint"},scene:0,scenes:[{nodes:[]}],nodes:[],meshes:[],materials:[],accessors:[],bufferViews:[],buffers:[{byteLength:0}]}}put(e,t,i,r=!1){let s={SCALAR:1,VEC3:3,VEC4:4}[t];this.json.bufferViews.push({buffer:0,byteOffset:this.length,byteLength:e.byteLength,...i&&{target:i}});let o={bufferView:this.json.bufferViews.length-1,componentType:e instanceof Float32Array?pb:mb,count:e.length/s,type:t};return r&&(o.min=Array(s).fill(1/0),o.max=Array(s).fill(-1/0),e.forEach((a,l)=>{o.min[l%s]=Math.min(o.min[l%s],a),o.max[l%s]=Math.max(o.max[l%s],a)})),this.pieces.push(new Uint8Array(e.buffer,e.byteOffset,e.byteLength)),this.length+=e.byteLength,this.json.accessors.push(o)-1}bytes(){this.json.buffers[0].byteLength=this.length;let e=new TextEncoder().encode(JSON.stringify(this.json)),t=Math.ceil(e.length/4)*4,i=new Uint8Array(20+t+8+this.length),r=new DataView(i.buffer);[1179937895,2,i.length,t,1313821514].forEach((o,a)=>r.setUint32(4*a,o,!0)),i.fill(32,20,20+t),i.set(e,20),r.setUint32(20+t,this.length,!0),r.setUint32(24+t,5130562,!0);let s=28+t;for(let o of this.pieces)i.set(o,s),s+=o.length;return i}};function l_(n,e,t,i){let r=new Vf,{json:s}=r,o=new F,a=new qt,l=new F,c=new qt,h=i.length>1,u=h?r.put(Float32Array.from(i,d=>d-i[0]),"SCALAR",void 0,!0):0,f={name:"record",samplers:[],channels:[]},m=new Set(n.map(({solid:d})=>d.skin?d.skin.bodies[0]:d.body)),x=new Map;for(let d of m){let p={name:d<0?"ground":e[d].name,children:[]};if(x.set(d,p),s.scenes[0].nodes.push(s.nodes.push(p)-1),d<0)continue;let v=new Float32Array(3*i.length),A=new Float32Array(4*i.length);if(t[d].forEach((M,R)=>{M.decompose(o,a,l),R&&a.dot(c)<0&&a.set(-a.x,-a.y,-a.z,-a.w),c.copy(a),o.toArray(v,3*R),a.toArray(A,4*R)}),p.translation=[...v.slice(0,3)],p.rotation=[...A.slice(0,4)],!!h)for(let[M,R,T,g]of[["translation",v,"VEC3",3],["rotation",A,"VEC4",4]]){if(R.every((U,P)=>U===R[P%g]))continue;let E=f.samplers.push({input:u,output:r.put(R,T),interpolation:"LINEAR"})-1;f.channels.push({sampler:E,target:{node:s.nodes.indexOf(p),path:M}})}}let S=new Map;for(let{solid:d,geometry:p,colour:v}of n){let A=v+!!d.see_through;if(!S.has(A)){let{r:P,g:D,b:G}=new Xe(v),k={baseColorFactor:[P,D,G,d.see_through?.22:1],metallicFactor:.1,roughnessFactor:.7};S.set(A,s.materials.push({pbrMetallicRoughness:k,...d.see_through&&{alphaMode:"BLEND"}})-1)}let{position:M,normal:R}=p.attributes,T={POSITION:r.put(M.array,"VEC3",a_,!0),NORMAL:r.put(R.array,"VEC3",a_)},g=r.put(Uint32Array.from(p.index.array),"SCALAR",gb),E=s.meshes.push({name:d.name,primitives:[{attributes:T,indices:g,material:S.get(A)}]})-1,U=s.nodes.push({name:d.name,mesh:E})-1;x.get(d.skin?d.skin.bodies[0]:d.body).children.push(U)}for(let d of x.values())d.children.length||delete d.children;return f.channels.length&&(s.animations=[f]),r.bytes()}function el(n,e){let t=URL.createObjectURL(n),i=ae("a",{href:t,download:e});document.body.append(i),i.click(),i.remove(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}function tl(n,e){return`${n.scenes[0].title.toLowerCase().replace(/[^a-z0-9]+/g,"-").replace(/^-|-$/g,"")||"scene"}.${e}`}function $c(n,e=1){let{stage:t}=n,{renderer:i,canvas:r}=t;i.setPixelRatio(t.ratio*e),i.setSize(t.size.width,t.size.height),n.draw();let s=ae("canvas",{width:r.width,height:r.height}),o=s.getContext("2d");o.drawImage(r,0,0),t.resize(),n.draw();let a=t.ratio*e;o.scale(a,a);let l=getComputedStyle(n.root),c=l.getPropertyValue("--v-ink").trim()||"#222",h=l.getPropertyValue("--v-soft").trim()||"#666",{width:u,height:f}=t.size;o.textBaseline="top",o.font=`600 14px ${l.fontFamily}`,o.fillStyle=c;let m=u/n.scenes.length;n.scenes.forEach((A,M)=>o.fillText(A.title,12+M*m,10)),o.font=`12px ${l.fontFamily}`,o.fillStyle=h;let x=n.modes?.active?n.modes.words:`t = ${$o(n.player.time,n.transport.stepLength/10)}`;n.scenes.forEach((A,M)=>o.fillText([A.subtitle,x].filter(Boolean).join(", "),12+M*m,28)),n.legends.forEach((A,M)=>{A.element.hidden||xb(o,n,M,(M+1)*m,c,l)});let[S,d]=n.scale.children;o.fillStyle=o.strokeStyle=h,o.fillText(S.textContent,12,f-30);let p=parseFloat(d.style.width);o.beginPath(),o.moveTo(12,f-15),o.lineTo(12,f-10),o.lineTo(12+p,f-10),o.lineTo(12+p,f-15),o.stroke();let v=atob(s.toDataURL("image/png").split(",")[1]);return new Blob([Uint8Array.from(v,A=>A.charCodeAt(0))],{type:"image/png"})}function xb(n,e,t,i,r,s){let{arrows:o}=e.stage.pictures[t],a=e.legends[t],{columns:l}=a,c=a.lines(o.now,o.shown).slice(0,20),h=92*l.length+24+Math.max(0,...c.map(({name:u})=>n.measureText(u).width));n.globalAlpha=.85,n.fillStyle=s.getPropertyValue("--v-paper").trim()||"#fff",n.fillRect(i-h,0,h,34+16*c.length),n.globalAlpha=1,n.textAlign="right",l.forEach((u,f)=>{n.fillStyle=Zo(e.root,u),n.fillText(u,i-12-92*(l.length-1-f),10)}),c.forEach(({name:u,values:f},m)=>{let x=27+16*m;n.fillStyle=r,n.font=`12px ${s.fontFamily}`,n.fillText(u,i-12-92*l.length,x);for(let{part:S,text:d}of f)n.fillText(d,i-12-92*(l.length-1-l.indexOf(S)),x)}),n.textAlign="left"}function Jc(n){let e=n.stage.pictures[0].solids.parts,t=e.reduce((h,u)=>h+u.geometry.index.count/3,0),i=new ArrayBuffer(84+50*t),r=new DataView(i);r.setUint32(80,t,!0);let s=84,o=[new F,new F,new F],a=new F,l=new F,c=h=>{for(let u of[h.x,h.y,h.z])r.setFloat32(s,u,!0),s+=4};for(let{solid:h,geometry:u}of e){let f=n.stage.pictures[0].poses.ofSolid(h),m=u.attributes.position.array,x=u.index.array;for(let S=0;S<x.length;S+=3)o.forEach((d,p)=>d.fromArray(m,3*x[S+p]).applyMatrix4(f)),a.subVectors(o[1],o[0]).cross(l.subVectors(o[2],o[0])).normalize(),c(a),o.forEach(c),s+=2}return new Blob([i],{type:"model/stl"})}var c_=1e3;function Qc(n){let{solids:e,poses:t,data:i}=n.stage.pictures[0],r=t.times.length,s=Math.max(1,Math.ceil((r-1)/(c_-1))),o=[];for(let c=0;c<r;c+=s)o.push(c);let a=_b(o.map(c=>t.times[c]),t),l=t.world.map(()=>[]);for(let c of a)t.at(c),t.world.forEach((h,u)=>l[u].push(new Ve().copy(h)));return t.at(n.player.time),n.changed(),new Blob([l_(e.parts,i.bodies,l,a)],{type:"model/gltf-binary"})}function _b(n,e){let t=s=>(e.at(s),e.bodies.map((o,a)=>e.angle(a))),i=[n[0]],r=t(n[0]);for(let s=1;s<n.length&&i.length<8*c_;s++){let o=t(n[s]),a=Math.max(0,...o.map((c,h)=>Math.abs(c-r[h]))),l=Math.min(64,Math.max(1,Math.ceil(a/(Math.PI/2))));for(let c=1;c<=l;c++)i.push(n[s-1]+(n[s]-n[s-1])*c/l);r=o}return i}function u_(n){if(typeof MediaRecorder>"u"||!n.captureStream)return null;let t=["video/mp4;codecs=avc1.42E01E","video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm"].find(i=>MediaRecorder.isTypeSupported(i));return t?{ending:t.slice(6,t.includes(";")?t.indexOf(";"):void 0),start(){let i=new MediaRecorder(n.captureStream(30),{mimeType:t,videoBitsPerSecond:6e6}),r=[];return i.ondataavailable=({data:s})=>s.size&&r.push(s),i.start(500),()=>new Promise(s=>{i.onstop=()=>s(new Blob(r,{type:t.split(";")[0]})),i.stop()})}}:null}var jc=class{constructor(){this.bar=ae("div",{className:"ppv-tools",role:"toolbar","aria-label":"Scene"}),this.panel=ae("div",{className:"ppv-panel",hidden:!0}),this.open=null,this.panel.addEventListener("keydown",e=>{e.key==="Escape"&&this.close()})}action(e,t,i){let r=kt(e,t,i);return this.bar.append(r),r}add(e,t,i){let r=kt(e,t,()=>this.open===e?this.close():this.show(e,i,r),{"aria-expanded":"false"});return this.bar.append(r),r}show(e,t,i){this.close(),this.open=e,this.opener=i,i.setAttribute("aria-expanded","true"),this.panel.replaceChildren(ae("div",{className:"ppv-panel-head"},ae("b",{},e),kt("\xD7","Close",()=>this.close())),...t),this.panel.hidden=!1}close(){if(!this.open)return;let e=this.panel.contains(document.activeElement);this.open=null,this.panel.hidden=!0,this.opener.setAttribute("aria-expanded","false"),e&&this.opener.focus()}};function f_(n){let{stage:e}=n,t=e.pictures[0].data,i=[["axis","Along the axis"],["front","From the side"],["top","From above"],["iso","Oblique"]];n.followed=dr("follow",[["-1","nothing"],...t.bodies.map((l,c)=>[String(c),l.name])],l=>n.follow(Number(l)),"Body that the camera follows (1 to 9, 0)");let r=Is("turn with it",!1,l=>{n.views.turning=l,n.views.follow(n.views.body,l)}),s=t.solids.some(l=>l.see_through)?dr("housing",[["see-through","see-through"],["solid","solid"],["hidden","hidden"]],l=>{for(let c of e.pictures)c.solids.cover(l);n.changed()}).row:null,a=t.arrows.filter(l=>l.kind==="mesh").map(l=>kt(l.name.replaceAll("_"," "),`Look into the mesh ${l.name}, along its axis`,()=>n.intoMesh(l)));return[ae("div",{className:"ppv-buttons"},...i.map(([l,c])=>kt(l,c,()=>n.views.named(l)))),n.followed.row,r.row,s,a.length?ae("div",{},ae("span",{className:"ppv-soft"},"look into a mesh"),ae("div",{className:"ppv-buttons"},...a)):null].filter(Boolean)}function h_(n){let e=n.stage.pictures.map(r=>r.arrows),t=[...new Set(e.flatMap(r=>[...r.kinds]))],i=ts({label:"length",title:"Length of the arrows",least:.05,most:20,value:1,show:r=>`\xD7 ${zi(r,2)}`,changed:r=>{for(let s of e)s.scale=r;n.changed()}});return[...t.map(r=>Is({mesh:"mesh forces",bearing:"bearing forces",load:"loads"}[r]??r,!0,s=>{for(let o of e)s?o.shown.add(r):o.shown.delete(r);n.changed()}).row),i.row]}function d_(n){let{stage:e}=n,t=o=>el($c(n,o),tl(n,"png")),i=u_(e.canvas),r=null,s=i?kt("film",`Film what is played, ${i.ending}`,async()=>{if(s.setAttribute("aria-pressed",String(!r)),!r){n.filming=!0,e.coarsen(!1),r=i.start(),s.textContent="stop the film",n.toggle(!0);return}let o=r;r=null,n.filming=!1,s.textContent="film",el(await o(),tl(n,i.ending))}):null;return[ae("div",{className:"ppv-buttons"},kt("picture","PNG of the scene with title, time and forces",()=>t(1)),kt("picture \xD7 2","The same with twice as many pixels each way",()=>t(2)),s),ae("div",{className:"ppv-buttons"},kt("GLB, moving","Solids and their motion, binary glTF",()=>el(Qc(n),tl(n,"glb"))),kt("STL","Solids where they are now, metres",()=>el(Jc(n),tl(n,"stl"))))]}function p_(n){return n.magnification=ts({label:"\xD7 ",title:"How much vibrations are magnified; turning is not (m)",least:1,most:1e4,value:1,show:e=>zi(e<10?Number(e.toPrecision(2)):Math.round(e),e<10?2:5),changed:e=>n.magnify(e)}),[n.magnification.row,ae("p",{className:"ppv-soft"},"Displacements, tilts and torsion about their means; the turning itself is not magnified.")]}var dU=new F(1,0,0),tu=new F(0,0,1);function m_(n,e,t,i){let r=Math.hypot(e,t,i);if(r<1e-300)return n.identity();let s=Math.sin(r/2)/r;return n.set(s*e,s*t,s*i,Math.cos(r/2))}var Io=class{constructor(e){this.bodies=e.bodies,this.times=e.times?.data??new Float64Array([0]),this.where={low:0,share:0},this.magnification=1,this.world=this.bodies.map(()=>new Ve),this.still=this.bodies.map(()=>new Ve),this.rest=this.bodies.map(()=>new Ve),this.means=this.bodies.map(t=>({position:t.position&&Cl(t.position),turn:t.turn&&Cl(t.turn),spin:t.spin&&Cl(t.spin)})),this.bodies.forEach((t,i)=>{let[r,s,o]=t.place??[0,0,0],a=new qt(...t.axes??[0,0,0,1]).normalize();t.frame=new Ve().compose(new F(r,s,o),a,new F(1,1,1)),this.rest[i].multiplyMatrices(this.#e(this.rest,i),t.frame)}),this.at(this.times[0])}#e(e,t){let i=this.bodies[t].parent??-1;return i<0?g_:e[i]}ofSolid(e){let t=e.skin?e.skin.bodies[0]:e.body;return t<0?g_:this.world[t]}#t({gross:e,ratio:t=1},i){return e?t*zn(e,i):0}angle(e,t=this.where){let{spin:i}=this.bodies[e];return this.#t(this.bodies[e],t)+(i?zn(i,t):0)}at(e){this.where=tr(this.times,e);let{where:t,magnification:i}=this,r=(s,o,a)=>{let l=zn(s,t,a);return i===1?l:o[a]+i*(l-o[a])};return this.bodies.forEach((s,o)=>{this.still[o].multiplyMatrices(this.#e(this.world,o),s.frame),Hf.set(0,0,0);let a=this.means[o];if(s.position&&Hf.set(r(s.position,a.position,0),r(s.position,a.position,1),r(s.position,a.position,2)),s.quaternion)wr.set(...[0,1,2,3].map(l=>s.quaternion.data[l+(s.quaternion.count>1?4*t.low:0)])),s.quaternion.count>1&&t.share&&(Wf.set(...[4,5,6,7].map(l=>s.quaternion.data[l+4*t.low])),wr.slerp(Wf,t.share)),wr.normalize();else{wr.identity(),s.turn&&m_(wr,r(s.turn,a.turn,0),r(s.turn,a.turn,1),r(s.turn,a.turn,2));let l=this.#t(s,t)+(s.spin?r(s.spin,a.spin,0):0);wr.multiply(Wf.setFromAxisAngle(tu,l))}eu.compose(Hf,wr,vb),this.world[o].multiplyMatrices(this.still[o],eu)}),this}ofMode(e,t,i){let r=i*Math.cos(t),s=-i*Math.sin(t),o=(a,l,c)=>a?r*a.data[6*l+c]+s*a.data[6*l+3+c]:0;return this.bodies.forEach((a,l)=>{m_(wr,o(e.turn,l,0),o(e.turn,l,1),o(e.turn,l,2));let c=this.rest[l];eu.makeRotationFromQuaternion(wr),this.world[l].multiplyMatrices(eu,c);let h=this.world[l].elements;for(let u=0;u<3;u++)h[12+u]=c.elements[12+u]+o(e.position,l,u);this.still[l].copy(this.world[l])}),this}axis(){let e=new F;return this.bodies.forEach((t,i)=>{if(!t.gross&&!t.spin)return;let r=new F().setFromMatrixColumn(this.rest[i],2);e.addScaledVector(r,e.dot(r)<0?-1:1)}),e.length()>1e-9?e.normalize():tu.clone()}},g_=new Ve,eu=new Ve,Hf=new F,vb=new F(1,1,1),wr=new qt,Wf=new qt;var il={x:new F(1,0,0),y:new F(0,1,0),z:new F(0,0,1)},iu=class{constructor(e,t){this.stage=e,this.changed=t,this.on=!1,this.normal=new F(0,0,1),this.flipped=!1,this.at=0,this.plane=new Wi;let[i]=Object.entries(il).reduce((r,s)=>Math.abs(s[1].dot(e.pictures[0].poses.axis()))>Math.abs(r[1].dot(e.pictures[0].poses.axis()))?s:r);this.enable=Is("cut the solids (s)",!1,r=>this.turn(r)),this.axis=dr("square to",[...Object.keys(il).map(r=>[r,r]),["mesh","axis of the mesh"]],r=>this.along(r)),this.axis.select.lastChild.hidden=!0,this.place=ae("input",{type:"range",min:"0",max:"1000",title:"Place of the cut","aria-label":"Place of the cut"}),this.place.addEventListener("input",()=>this.#t()),this.said=ae("output",{}),this.flip=Is("other half",!1,r=>{this.flipped=r,this.update(),t()}),this.rows=[this.enable.row,this.axis.row,ae("label",{className:"ppv-slider"},ae("span",{},"place"),this.place,this.said),this.flip.row],this.along(i)}along(e){e in il&&this.normal.copy(il[e]),this.axis.select.value=e;let[t,i]=this.#e();this.#i((t+i)/2)}through(e,t){let i=Object.entries(il).find(([,r])=>Math.abs(r.dot(t))>.999999999);this.normal.copy(t).normalize(),i&&this.normal.copy(i[1]),this.axis.select.lastChild.hidden=!!i,this.axis.select.value=i?i[0]:"mesh",this.flipped=this.normal.dot(t)<0,this.flip.input.checked=this.flipped,this.#i(this.normal.dot(e)),this.turn(!0)}#e(){let{low:e,high:t}=this.stage.pictures[0].bounds,i=1/0,r=-1/0;for(let s=0;s<8;s++){let o=new F(s&1?t.x:e.x,s&2?t.y:e.y,s&4?t.z:e.z).dot(this.normal);i=Math.min(i,o),r=Math.max(r,o)}return[i,r]}#t(){let[e,t]=this.#e();this.at=e+Number(this.place.value)/1e3*(t-e),this.said.textContent=`${zi(this.at*1e3,4)} mm`,this.update(),this.changed()}#i(e){let[t,i]=this.#e();this.at=e,this.place.value=String(1e3*(e-t)/(i-t||1)),this.said.textContent=`${zi(e*1e3,4)} mm`,this.update(),this.changed()}turn(e){this.on=e,this.enable.input.checked=e;for(let t of this.stage.pictures)t.solids.cut(e?[this.plane]:[]);this.update(),this.changed()}update(){let e=this.flipped?1:-1;this.plane.normal.copy(this.normal).multiplyScalar(e),this.plane.constant=-e*this.at,this.plane.applyMatrix4(this.stage.seen)}};function Sb(){let n=new wo(.19,.19,.72,12,1,!1).translate(0,.36,0),e=new Rc(.5,.3,16,1,!1).translate(0,.85,0),t=[n.toNonIndexed(),e.toNonIndexed()],i=s=>t.flatMap(o=>[...o.attributes[s].array]),r=new Kt;return r.setAttribute("position",new Ft(i("position"),3)),r.setAttribute("normal",new Ft(i("normal"),3)),r.rotateX(Math.PI/2)}var nu=class{constructor(e,t,i,r,s){this.arrows=e.arrows,this.poses=i,this.radius=s,this.scale=1,this.kinds=new Set(this.arrows.map(u=>u.kind)),this.shown=new Set(this.kinds),this.hidden=!1;let o=Sb(),a=new Cc(.5,14,10),l=u=>new Ss({color:u,emissive:u,emissiveIntensity:.35}),c=Object.fromEntries(gr.map(u=>[u,l(Zo(r,u))]));this.states=Object.fromEntries(Object.entries(Ws).map(([u,{colour:f}])=>[u,l(f)]));let h=(u,f)=>{let m=new Jt(u,f);return m.matrixAutoUpdate=!1,t.add(m),m};this.drawn=this.arrows.map(u=>({parts:Object.fromEntries(gr.filter(f=>u.components?.[f]).map(f=>[f,h(o,c[f])])),ball:u.state?h(a,this.states[0]):null})),this.largest=this.arrows.map(u=>Object.fromEntries(gr.filter(f=>u.components?.[f]).map(f=>[f,bb(u.components[f].data)]))),this.size=Math.max(0,...this.arrows.map(u=>u.size??0))}get longest(){return .55*this.radius*this.scale}forces(){let{where:e}=this.poses;return this.arrows.map(t=>{let i=t.body<0?null:this.poses.still[t.body],r=new F(zn(t.at,e,0),zn(t.at,e,1),zn(t.at,e,2));i&&r.applyMatrix4(i);let s={},o={},a=new F;for(let u of gr){let f=t.components?.[u];if(!f)continue;let m=new F(zn(f,e,0),zn(f,e,1),zn(f,e,2));o[u]=m.length(),a.add(m),i&&(x_.extractRotation(i),m.applyMatrix4(x_)),s[u]=m}let l=t.state?e.share===1?e.low+1:e.low:0,c=t.state?t.state.data[t.state.count>1?l:0]:null,h=c===255?-1:c;return{name:t.name,kind:t.kind,unit:t.unit??"N",state:h,vectors:s,values:o,at:r,total:a.length()}})}ends(){return this.hidden||!(this.size>0)?[]:this.forces().flatMap((e,t)=>this.shown.has(e.kind)?Object.entries(e.vectors).map(([i,r])=>{let s=this.longest*this.largest[t][i]/this.size;return r.clone().setLength(r.length()?s:0).add(e.at)}):[])}update(e){this.now=this.forces(),this.now.forEach((t,i)=>{let r=!this.hidden&&this.shown.has(t.kind),{parts:s,ball:o}=this.drawn[i],a=Math.min(.055*this.radius*Math.sqrt(this.scale),22*e||1/0);for(let[l,c]of Object.entries(s)){let h=t.vectors[l],u=this.size>0?this.longest*h.length()/this.size:0;if(c.visible=r&&u>2*e&&u>0,!c.visible)continue;let f=Math.min(a,.5*u);__.copy(h).normalize(),c.matrix.compose(t.at,Mb.setFromUnitVectors(tu,__),yb.set(f,f,u))}o&&(o.visible=r,o.material=this.states[t.state]??this.states[0],o.matrix.makeScale(.6*a,.6*a,.6*a).setPosition(t.at))})}},x_=new Ve,Mb=new qt,__=new F,yb=new F;function bb(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}function v_(n,e,t=40){let i=n.length/3,r=e.length/3,s=new Float64Array(3*r),o=new Float64Array(r);for(let S=0;S<r;S++){let[d,p,v]=[3*e[3*S],3*e[3*S+1],3*e[3*S+2]],A=n[p]-n[d],M=n[p+1]-n[d+1],R=n[p+2]-n[d+2],T=n[v]-n[d],g=n[v+1]-n[d+1],E=n[v+2]-n[d+2],U=M*E-R*g,P=R*T-A*E,D=A*g-M*T,G=Math.hypot(U,P,D);o[S]=G,G&&s.set([U/G,P/G,D/G],3*S)}let a=new Uint32Array(i+1);for(let S=0;S<e.length;S++)a[e[S]+1]++;for(let S=0;S<i;S++)a[S+1]+=a[S];let l=a.slice(0,i),c=new Uint32Array(e.length);for(let S=0;S<e.length;S++)c[l[e[S]]++]=S;let h=Math.cos(t*Math.PI/180),u=[],f=[],m=[],x=new Uint32Array(e.length);for(let S=0;S<i;S++){let d=[];for(let p=a[S];p<a[S+1];p++){let v=3*(c[p]/3|0),A=0,M=0,R=0;for(let E=a[S];E<a[S+1];E++){let U=c[E]/3|0;s[v]*s[3*U]+s[v+1]*s[3*U+1]+s[v+2]*s[3*U+2]<h||(A+=o[U]*s[3*U],M+=o[U]*s[3*U+1],R+=o[U]*s[3*U+2])}let T=Math.hypot(A,M,R)||1;A/=T,M/=T,R/=T;let g=d.find(E=>Math.abs(f[3*E]-A)+Math.abs(f[3*E+1]-M)+Math.abs(f[3*E+2]-R)<1e-6);g===void 0&&(g=m.length,d.push(g),m.push(S),u.push(n[3*S],n[3*S+1],n[3*S+2]),f.push(A,M,R)),x[c[p]]=g}}return{points:Float32Array.from(u),normals:Float32Array.from(f),index:x,source:Uint32Array.from(m)}}var ru=class{constructor(e,t,i,r){this.skin=e,this.geometry=t,this.source=i,this.poses=r,this.points=t.attributes.position.array.slice(),this.normals=t.attributes.normal.array.slice();let s=r.rest[e.bodies[0]];this.toBody=e.bodies.map(o=>r.rest[o].clone().invert().multiply(s)),this.moved=e.bodies.map(()=>new Ve),this.drawn=e.bodies.map(()=>new Ve)}update(e,t){let{skin:i,poses:r,moved:s,drawn:o}=this,a=r.world[i.bodies[0]].clone().invert(),l=0;if(s.forEach((x,S)=>{x.multiplyMatrices(a,r.world[i.bodies[S]]).multiply(this.toBody[S]);for(let d=0;d<16;d++)l=Math.max(l,Math.abs(x.elements[d]-o[S].elements[d])*(d<12?t:1))}),l<=e)return;s.forEach((x,S)=>o[S].copy(x));let{position:c,normal:h}=this.geometry.attributes,{first:u,second:f,weight:m}=i;for(let x=0;x<this.source.length;x++){let S=this.source[x],d=f.data[S],p=m.data[S],v=o[u?u.data[S]:0].elements,A=o[d].elements,M=this.points[3*x],R=this.points[3*x+1],T=this.points[3*x+2],g=this.normals[3*x],E=this.normals[3*x+1],U=this.normals[3*x+2];for(let P=0;P<3;P++){let D=v[P]+p*(A[P]-v[P]),G=v[4+P]+p*(A[4+P]-v[4+P]),k=v[8+P]+p*(A[8+P]-v[8+P]);c.array[3*x+P]=D*M+G*R+k*T+v[12+P]+p*(A[12+P]-v[12+P]),h.array[3*x+P]=D*g+G*E+k*U}}c.needsUpdate=h.needsUpdate=!0,this.geometry.computeBoundingSphere()}};var S_=300;function Eb(n){n.onBeforeCompile=e=>{e.fragmentShader=e.fragmentShader.replace("#include <opaque_fragment>",`#ifdef DOUBLE_SIDED
        if (!gl_FrontFacing) {
          float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0);
          outgoingLight = diffuseColor.rgb * (stripe < 1.1 ? 0.66 : 0.86);
        }
      #endif
      #include <opaque_fragment>`)}}function M_(n,e){let t=new Ss({color:n});return e&&Object.assign(t,{transparent:!0,opacity:.22,depthWrite:!1}),Eb(t),t}var su=class{constructor(e,t,i){this.solids=e.solids,this.root=t,this.poses=i;let r={};this.parts=e.solids.map(s=>{let o=r[s.kind]=(r[s.kind]??-1)+1,{points:a,normals:l,index:c,source:h}=v_(s.points.data,s.triangles.data,s.creases??40),u=new Kt;u.setAttribute("position",new Ei(a,3)),u.setAttribute("normal",new Ei(l,3)),u.setIndex(a.length/3<65536?new Ei(Uint16Array.from(c),1):new Ei(c,1)),u.computeBoundingSphere();let f=s.skin?new ru(s.skin,u,h,i):null;return{solid:s,geometry:u,skin:f,colour:qd(s.kind,o),radius:Tb(a),rim:wb(a)}}),this.triangles=e.solids.reduce((s,o)=>s+o.triangles.count,0),this.materials=[],this.meshes=[],this.batches=[],this.parts.length>S_?this.#t():this.#e(),this.update(0)}#e(){let e=new Map;for(let t of this.parts){let i=t.colour+!!t.solid.see_through;e.has(i)||e.set(i,M_(t.colour,t.solid.see_through));let r=new Jt(t.geometry,e.get(i));r.matrixAutoUpdate=!1,r.renderOrder=t.solid.see_through?1:0,r.userData.part=t,t.mesh=r,this.meshes.push(r),this.root.add(r)}this.materials=[...e.values()]}#t(){for(let e of[!1,!0]){let t=this.parts.filter(a=>!!a.solid.see_through===e);if(!t.length)continue;let i=a=>t.reduce((l,c)=>l+a(c.geometry),0),r=M_("#ffffff",e),s=new Xa(t.length,i(a=>a.attributes.position.count),i(a=>a.index.count),r);s.perObjectFrustumCulled=!1,s.frustumCulled=!1,s.sortObjects=!1;let o=new Xe;for(let a of t)a.skin=null,a.batch=s,a.instance=s.addInstance(s.addGeometry(a.geometry)),s.setColorAt(a.instance,o.set(a.colour));s.renderOrder=e?1:0,s.userData.parts=t,this.materials.push(r),this.batches.push(s),this.root.add(s)}}update(e){for(let t of this.parts){let i=this.poses.ofSolid(t.solid);t.batch?t.batch.setMatrixAt(t.instance,i):t.mesh.matrix.copy(i),t.skin?.update(e,t.radius)}}cut(e){for(let t of this.materials)t.clippingPlanes=e.length?e:null,t.side=e.length?ji:nn,t.needsUpdate=!0}cover(e){let t=new Set;for(let i of this.parts){if(!i.solid.see_through)continue;i.batch?i.batch.visible=e!=="hidden":i.mesh.visible=e!=="hidden";let r=i.batch?.material??i.mesh.material;t.has(r)||(t.add(r),Object.assign(r,e==="solid"?{transparent:!1,opacity:1,depthWrite:!0}:{transparent:!0,opacity:.22,depthWrite:!1}),r.needsUpdate=!0)}}hit(e){let i=e.intersectObjects([...this.meshes,...this.batches].filter(r=>r.visible)).map(({object:r,batchId:s,point:o})=>({part:r.userData.part??r.userData.parts.find(a=>a.instance===s),point:o}));return i.find(({part:r,point:s})=>!r.solid.see_through&&this.#i(s))??i.find(({point:r})=>this.#i(r))??null}#i(e){return!this.materials[0]?.clippingPlanes?.some(t=>t.distanceToPoint(e)<0)}bounds(){let e=this.parts.filter(o=>!o.solid.see_through),t=new F(1/0,1/0,1/0),i=t.clone().negate(),r=new F,s=[];for(let o of e.length?e:this.parts){let a=this.poses.ofSolid(o.solid),{center:l,radius:c}=o.geometry.boundingSphere;o.geometry.computeBoundingBox();let{min:h,max:u}=o.geometry.boundingBox;if(!(c>=0))continue;let f=o.geometry.attributes.position,m=Math.max(1,Math.ceil(f.count/(this.parts.length>S_?4:80)));for(let x=0;x<f.count;x+=m)s.push(new F().fromBufferAttribute(f,x).applyMatrix4(a));for(let x=0;x<8;x++)r.set(x&1?u.x:h.x,x&2?u.y:h.y,x&4?u.z:h.z),r.sub(l).clampLength(0,c).add(l).applyMatrix4(a),t.min(r),i.max(r)}return i.x>=t.x?{centre:t.clone().add(i).multiplyScalar(.5),radius:Math.max(t.distanceTo(i)/2,1e-9),low:t,high:i,outline:s}:{centre:r.set(0,0,0),radius:1,low:r.clone().set(-1,-1,-1),high:r.clone().set(1,1,1),outline:s}}reachOf(e){return Math.max(0,...this.parts.filter(t=>t.solid.body===e).map(t=>t.radius))}};function wb(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1]));return e}function Tb(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}var Ab=/swiftshader|llvmpipe|softpipe|software|basic render/i;function y_(){try{let n=document.createElement("canvas").getContext("webgl2");if(!n)return null;let e=n.getExtension("WEBGL_debug_renderer_info"),t=String(n.getParameter(e?e.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),{software:Ab.test(t)}}catch{return null}}var Xf=class{constructor(e,t){this.data=e,this.scene=new uo,this.over=new uo,this.root=new Wn,this.overRoot=new Wn,this.root.matrixAutoUpdate=this.overRoot.matrixAutoUpdate=!1,this.scene.add(this.root),this.over.add(this.overRoot),this.lights=[this.scene,this.over].map(i=>{let r=new Ya("#ffffff",2.1),s=new qa("#ffffff","#8f98a3",1.25);return i.add(r,r.target,s),{light:r,sky:s}}),this.poses=new Io(e),this.solids=new su(e,this.root,this.poses),this.bounds=this.solids.bounds(),this.arrows=new nu(e,this.overRoot,this.poses,t,this.bounds.radius)}},ou=class{constructor(e,t,i){this.host=e,this.software=i,this.renderer=new ja({antialias:!i,powerPreference:"high-performance"}),this.renderer.autoClear=!1,this.renderer.localClippingEnabled=!0,this.canvas=this.renderer.domElement,this.canvas.className="ppv-canvas",e.append(this.canvas),this.camera=new Ni(28,1,.01,100),this.pictures=t.map(o=>new Xf(o,e));let r=Math.max(...this.pictures.map(o=>o.arrows.size)),s=Math.max(...this.pictures.map(o=>o.bounds.radius));for(let{arrows:o}of this.pictures)Object.assign(o,{size:r,radius:s});this.background=new Xe("#ffffff"),this.size={width:1,height:1},this.drawn=0,this.coarse=!1,this.seen=new Ve}coarsen(e){return e===this.coarse?!1:(this.coarse=e,this.resize(),!0)}get ratio(){return this.coarse?.6:this.software?1:Math.min(window.devicePixelRatio||1,2)}resize(){let{clientWidth:e,clientHeight:t}=this.host;!e||!t||(this.size={width:e,height:t},this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(e,t),this.camera.aspect=e/this.pictures.length/t,this.camera.updateProjectionMatrix())}bounds(){let e=Math.max(...this.pictures.map(t=>t.bounds.radius));return{centre:this.pictures[0].bounds.centre.clone().applyMatrix4(this.seen),radius:e,low:this.pictures[0].bounds.low,high:this.pictures[0].bounds.high}}render(e){let{renderer:t,camera:i}=this,{centre:r,radius:s}=this.bounds(),{distance:o,target:a}=e.now,l=a.distanceTo(r);i.near=Math.max(.01*o,o-l-1.3*s),i.far=o+l+2.5*s,i.updateProjectionMatrix(),this.setLights(),t.setScissorTest(!0);let c=this.size.width/this.pictures.length;this.pictures.forEach((h,u)=>{t.setViewport(u*c,0,c,this.size.height),t.setScissor(u*c,0,c,this.size.height),t.setClearColor(this.background,1),t.clear(),h.root.matrix.copy(this.seen),h.overRoot.matrix.copy(this.seen),t.render(h.scene,i),!(h.arrows.hidden||!h.arrows.shown.size)&&(t.clearDepth(),t.render(h.over,i))}),this.drawn++}setLights(){let e=new F(-.45,.7,.9).applyQuaternion(this.camera.quaternion),t=new F(0,1,0).applyQuaternion(this.camera.quaternion);for(let i of this.pictures)for(let r of i.lights)r.light.position.copy(e),r.sky.position.copy(t)}hit(e,t){let i=this.canvas.getBoundingClientRect(),r=i.width/this.pictures.length,s=Math.floor((e-i.left)/r),o=this.pictures[s];if(!o)return null;let a=new Ze((e-i.left-s*r)/r*2-1,1-(t-i.top)/i.height*2),l=new Ka;l.setFromCamera(a,this.camera);let c=o.solids.hit(l);return c&&{...c,picture:s}}onScreen(e,t=0){let i=e.clone().applyMatrix4(this.seen).project(this.camera),r=this.size.width/this.pictures.length;return{x:(t+(i.x+1)/2)*r,y:(1-i.y)/2*this.size.height,front:i.z<1}}};var qf=1e6,au=class{constructor(e,t,i){this.player=e,this.marks=[...t].sort((r,s)=>r.time-s.time),this.kinds=[...new Set(this.marks.map(r=>r.kind))],this.does=i,this.stepLength=1/0;for(let r=1;r<e.times.length;r++)this.stepLength=Math.min(this.stepLength,e.times[r]-e.times[r-1]||1/0);Number.isFinite(this.stepLength)||(this.stepLength=1),this.play=kt("","Play (space)",i.toggle,{className:"ppv-play"}),this.range=ae("input",{type:"range",min:"0",max:String(qf),step:"1",className:"ppv-range",title:"Time","aria-label":"Time"}),this.range.addEventListener("input",()=>i.seek(this.#e(Number(this.range.value)/qf))),this.strip=ae("canvas",{className:"ppv-marks",role:"img","aria-label":`${this.marks.length} marks`}),this.tip=ae("div",{className:"ppv-tip",hidden:!0}),this.strip.addEventListener("pointermove",r=>this.#n(r)),this.strip.addEventListener("pointerleave",()=>this.tip.hidden=!0),this.strip.addEventListener("click",r=>{let s=this.#i(r);i.seek(s?s.time:this.#e(this.#t(r)))}),this.read=ae("output",{className:"ppv-now",title:"Time of the record"}),this.speed=ts({label:"",title:"Speed, part of real time (+ and \u2212)",least:Jo,most:1,value:e.speed,show:Qd,changed:i.speed}),this.loop=dr("repeat",[["record","whole record"],["turn","one turn"],["cycle","one mesh cycle"]],r=>{let s=i.loop(r);this.loop.select.value=e.loop,this.say(s)}),this.said=ae("span",{className:"ppv-said",role:"status"}),this.jump=this.marks.length?[kt("\u27E8","Mark before ([)",()=>this.toMark(-1)),kt("\u27E9","Next mark (])",()=>this.toMark(1))]:[],this.element=ae("div",{className:"ppv-time"},ae("div",{className:"ppv-track"},this.strip,this.range,this.tip),ae("div",{className:"ppv-transport"},this.play,kt("|\u25C2","To the start (Home)",()=>i.seek(e.window[0])),kt("\u25C2","One frame back (left arrow)",()=>i.step(-1)),kt("\u25B8","One frame on (right arrow)",()=>i.step(1)),...this.jump,this.read,this.speed.row,this.loop.row,this.said)),e.times.length<2&&this.element.classList.add("ppv-still")}#e(e){return this.player.first+e*(this.player.last-this.player.first)}#t(e){let t=this.strip.getBoundingClientRect();return Math.max(0,Math.min(1,(e.clientX-t.left)/t.width))}#i(e){let t=this.strip.getBoundingClientRect(),i=this.#e(this.#t(e)),r=6*(this.player.last-this.player.first)/Math.max(t.width,1),s=null;for(let o of this.marks)Math.abs(o.time-i)<=r&&(!s||Math.abs(o.time-i)<Math.abs(s.time-i))&&(s=o);return s}#n(e){let t=this.#i(e);if(this.tip.hidden=!t,this.strip.style.cursor="pointer",!t)return;this.tip.textContent=`${t.kind.replaceAll("_"," ")}${t.what?`, ${t.what}`:""}, ${$o(t.time,this.stepLength/10)}`;let i=this.strip.getBoundingClientRect(),r=e.clientX-i.left;this.tip.style.left=`${Math.max(0,Math.min(i.width-180,r))}px`}say(e){this.said.textContent=e}toMark(e){let t=this.player.time,i=1e-9*(this.player.last-this.player.first),r=e>0?this.marks.find(s=>s.time>t+i):this.marks.findLast(s=>s.time<t-i);r&&this.does.seek(r.time)}draw(){let{strip:e,player:t}=this,i=e.clientWidth,r=e.clientHeight;if(!i)return;let s=window.devicePixelRatio||1;e.width=i*s,e.height=r*s;let o=e.getContext("2d");o.scale(s,s);let a=t.last-t.first||1,l=h=>(h-t.first)/a*i,c=getComputedStyle(this.element);t.loop!=="record"&&(o.fillStyle=c.getPropertyValue("--v-accent"),o.globalAlpha=.35,o.fillRect(l(t.window[0]),r-4,Math.max(2,l(t.window[1])-l(t.window[0])),4),o.globalAlpha=1);for(let h of this.marks)o.fillStyle=El(this.kinds,h.kind),o.fillRect(l(h.time)-.75,1,1.5,r-5)}update(){let{player:e}=this,t=e.last-e.first,i=t>0?(e.time-e.first)/t:0;this.range.value=String(Math.round(i*qf));let r=$o(e.time,e.playing?this.stepLength:this.stepLength/10);this.range.ariaValueText=r,this.read.textContent=r,this.read.title=`Time of the record; it lasts ${Jd(t)}`;let s=e.playing?"pause":"play";this.play.dataset.state!==s&&(this.play.dataset.state=s,this.play.textContent=e.playing?"\u275A\u275A":"\u25B6\uFE0E",this.play.title=e.playing?"Pause (space)":"Play (space)",this.play.setAttribute("aria-label",this.play.title))}};var lu=class{constructor(e,t){this.stage=e,this.orbit=t,this.body=-1,this.turning=!1,this.anchor=new Ve}get poses(){return this.stage.pictures[0].poses}directions(){let e=this.poses.axis().transformDirection(this.stage.seen),t=this.orbit.up,i=new F().crossVectors(t,e);i.length()<.001&&i.crossVectors(new F(1,0,0),e),i.length()<.001&&i.crossVectors(new F(0,0,1),e),i.normalize();let r=new F().crossVectors(e,i);return{axis:e,front:i,top:r,iso:e.clone().addScaledVector(i,.75).addScaledVector(r,.55)}}distanceFor(e){let{camera:t}=this.stage,i=Math.atan(Math.tan(t.fov*Math.PI/360)*Math.min(1,t.aspect));return e/Math.sin(i)}fit(e=!1){let{centre:t,radius:i}=this.stage.bounds(),{camera:r,seen:s,pictures:o}=this.stage,a=this.orbit.direction(this.orbit.goal),l=new F().crossVectors(this.orbit.up,a).normalize(),c=new F().crossVectors(a,l),h=.9*Math.tan(r.fov*Math.PI/360),u=h*r.aspect,f=t.clone(),m=this.distanceFor(i),x=o.flatMap(S=>[...S.bounds.outline,...S.arrows.ends()].map(d=>d.clone().applyMatrix4(s)));for(let S=0;x.length&&S<3;S++){let d=[1/0,-1/0,1/0,-1/0],p=0;for(let v of x){let A=v.clone().sub(f),[M,R,T]=[A.dot(l),A.dot(c),A.dot(a)],g=Math.max(m-T,.001*i);d[0]=Math.min(d[0],M/g),d[1]=Math.max(d[1],M/g),d[2]=Math.min(d[2],R/g),d[3]=Math.max(d[3],R/g),p=Math.max(p,T+Math.abs(M)/u,T+Math.abs(R)/h)}if(S===2){m=p;break}f.addScaledVector(l,m*(d[0]+d[1])/2),f.addScaledVector(c,m*(d[2]+d[3])/2)}this.orbit.look({target:f,distance:Math.max(m,.1*i)},e),this.orbit.chosen=!1}named(e,t=!1){this.orbit.look({direction:this.directions()[e]},t),this.fit(t)}follow(e,t=this.turning){if(this.body=e,this.turning=t,e<0){let i=this.orbit.goal.target.clone().applyMatrix4(this.stage.seen.clone().invert());this.stage.seen.identity(),this.anchor.identity(),this.orbit.look({target:i},!0);return}this.anchor.multiplyMatrices(this.stage.seen,this.#e()),this.orbit.changed()}#e(){let e=this.poses.world[this.body];return this.turning?e.clone():new Ve().setPosition(new F().setFromMatrixPosition(e))}update(){this.body>=0&&this.stage.seen.multiplyMatrices(this.anchor,this.#e().invert())}look(e,t,i){let r=i/(2*Math.tan(this.stage.camera.fov*Math.PI/360));this.orbit.look({target:new F(...e),direction:t&&new F(...t),distance:r},!0)}closeUp(){if(this.body<0)return;let{solids:e}=this.stage.pictures[0],t=new F().setFromMatrixPosition(this.poses.world[this.body]).applyMatrix4(this.stage.seen),i=e.reachOf(this.body);this.orbit.look({target:t,distance:i>0?this.distanceFor(1.15*i):void 0})}#t(e){let t=null;for(let i of this.stage.pictures[0].solids.parts){if(!i.solid.teeth)continue;let r=this.poses.ofSolid(i.solid),s=new F().setFromMatrixColumn(r,2),o=e.clone().sub(new F().setFromMatrixPosition(r)),a=o.addScaledVector(s,-o.dot(s)).length(),l=Math.abs(i.rim-a)/i.rim;(!t||l<t.off)&&(t={off:l,axis:s,pitch:2*Math.PI*a/i.solid.teeth})}return t}intoMesh(e){let{poses:t,arrows:i}=this.stage.pictures[0],r=i.forces()[this.stage.pictures[0].data.arrows.indexOf(e)],s=this.#t(r.at),o=s?s.axis:t.axis(),a=s?s.pitch:.1*this.stage.bounds().radius;return this.orbit.look({target:r.at.clone().applyMatrix4(this.stage.seen),direction:o.clone().transformDirection(this.stage.seen),distance:1.6*a/(2*Math.tan(this.stage.camera.fov*Math.PI/360))}),{point:r.at,axis:o}}};var Rb="This browser or machine offers no WebGL 2, so the solids cannot be drawn; curves and time work.",cu=class{constructor(e,t){this.root=e,this.scenes=t,this.last=0,this.waiting=0,this.stage=null;let i=Pb(t);this.poses=new Io(t[0]),this.player=new Pl(i,this.poses);let r=Cb(t),s=[this.player.first,this.player.last];this.curves=new Al(t,s,r,c=>this.seek(c)),this.transport=new au(this.player,r,{seek:c=>this.seek(c),toggle:()=>this.toggle(),step:c=>this.step(c),speed:c=>this.player.speed=c,loop:c=>this.loop(c)}),this.panels=new jc,this.host=ae("div",{className:"ppv-view"}),this.area=ae("div",{className:"ppv-scene"},this.host,this.panels.panel);let o=[...new Set(t.map(c=>c.title))].join(" and "),a=t.length>1?"":t[0].subtitle,l=ae("div",{className:"ppv-head"},ae("div",{className:"ppv-title",title:`${o} ${a}`},ae("b",{},o),ae("span",{},a)),this.panels.bar);e.replaceChildren(l,this.area,this.transport.element,this.curves.element),this.#t(),this.#i(),np(this),this.watch=new ResizeObserver(()=>this.resize()),this.watch.observe(e),this.watch.observe(this.curves.body),window.addEventListener("beforeprint",()=>this.draw()),this.dark=window.matchMedia("(prefers-color-scheme: dark)"),this.dark.addEventListener("change",()=>this.colours()),this.resize(),this.curves.build(),this.colours()}#e(e){this.area.append(ae("div",{className:"ppv-message",role:"alert"},ae("p",{},e)))}#t(){if(!this.scenes.some(o=>o.solids.length)){this.#e("This scene holds no solids: the model gives no shapes, or the result none that moves.");return}let e=y_();if(!e){this.#e(Rb);return}this.stage=new ou(this.host,this.scenes,e.software);let{stage:t}=this;t.canvas.tabIndex=0,t.canvas.setAttribute("aria-label","3-D scene: drag to turn, right button to shift, wheel to zoom"),t.canvas.addEventListener("webglcontextlost",()=>this.#e("The graphics card gave the scene up. Load the page again.")),this.orbit=new Zc(t.camera,t.canvas,()=>this.changed(),this.scenes[0].up),this.orbit.takesWheel=o=>{let a=this.fills||o.ctrlKey||document.activeElement===t.canvas;return a||this.#o("click the scene first, then the wheel zooms"),a},this.orbit.pictures=t.pictures.length;let{radius:i}=t.bounds();this.orbit.nearest=2e-5*i,this.orbit.farthest=40*i,this.views=new lu(t,this.orbit),this.hover=new Rl(t,this.orbit,o=>this.follow(o)),this.legends=this.scenes.map(o=>new Ll(o.arrows)),this.scale=ae("div",{className:"ppv-scale","aria-hidden":"true"},ae("span"),ae("i")),this.status=ae("div",{className:"ppv-status",role:"status"});let r=b_(this.scenes),s=this.legends.map((o,a)=>ae("div",{className:"ppv-half"},o.element,r[a]&&ae("span",{className:"ppv-name"},r[a])));this.host.append(ae("div",{className:"ppv-halves"},...s),this.hover.label,this.scale,this.status)}#i(){let{panels:e,stage:t}=this;if(t){e.action("Fit","Show all of it (f)",()=>this.views.fit()),e.add("View","Views, following a body, housing, meshes",f_(this)),this.scenes.some(o=>o.arrows.length)&&e.add("Forces","Arrows of forces",h_(this)),this.player.times.length>1&&e.add("Vibration","Magnify vibrations",p_(this)),this.section=new iu(t,()=>this.changed()),e.add("Section","Cut the solids by a plane",this.section.rows);let{modes:s}=this.scenes[0];s.length&&!this.scenes[1]&&(this.modes=new Dl(s,t,()=>this.changed()),e.add("Modes","Mode shapes",this.modes.rows)),e.add("Save","Picture, solids, film",d_(this))}let i=[...new Set(this.scenes.flatMap(s=>s.notes))],r=[ae("dl",{},...ip.flatMap(([s,o])=>[ae("dt",{},s),ae("dd",{},o)]))];i.length&&r.unshift(ae("ul",{className:"ppv-notes"},...i.map(s=>ae("li",{},s)))),e.add(i.length?`Notes (${i.length})`:"?","Notes and keys",r)}colours(){this.stage?.background.set(getComputedStyle(this.area).backgroundColor),this.curves.build(),this.transport.draw(),this.changed()}resize(){if(!(!this.root.clientWidth||!this.root.clientHeight)){if(this.stage){let e=this.stage.size.width===1;this.stage.resize(),e&&this.views.named("iso",!0),this.orbit.chosen||this.views.fit(!0),this.draw()}this.curves.resize(),this.transport.draw(),this.update()}}changed(){this.waiting||(this.waiting=requestAnimationFrame(e=>this.#n(e)))}#n(e){this.waiting=0;let t=this.player.playing||this.easing||this.modes?.active,i=t&&this.last?Math.min(.25,Math.max(0,(e-this.last)/1e3)):1/60;this.last=e,this.player.advance(i),this.modes?.advance(i),this.easing=this.orbit?.step(i)??!1,this.#r(i,t),this.update(),this.draw(),this.frames=(this.frames??0)+1,this.player.playing||this.easing||this.modes?.active?this.changed():this.last=0}#r(e,t){let i=this.player.playing||this.easing||this.modes?.active;t&&i&&(this.pace=.7*(this.pace??e)+.3*e),!this.filming&&this.stage?.coarsen(!!i&&this.pace>(this.stage.coarse?.03:.085))}update(){this.transport.update(),this.curves.plots.cursor(this.player.time)}draw(){let{stage:e,orbit:t}=this;if(!(!e||e.size.width===1)){for(let i of e.pictures)this.modes?.active?this.modes.pose(i):i.poses.at(this.player.time);this.modes?.active||this.views.update(),this.section?.update();for(let i of e.pictures)i.solids.update(.25*t.pixel),i.arrows.hidden=!!this.modes?.active,i.arrows.update(t.pixel);e.render(t),e.pictures.forEach(({arrows:i},r)=>this.legends[r].update(i.now,i.shown,i.hidden)),this.#s()}}#s(){let e=Qo(90*this.orbit.pixel),[t,i]=this.scale.children;t.textContent=$d(e),i.style.width=`${e/this.orbit.pixel}px`;let r=this.views.body,s=r>=0?`following ${this.scenes[0].bodies[r].name}`:"",o=this.stage.pictures[0].poses.magnification>1?`vibrations \xD7 ${this.magnification.row.lastChild.textContent}`:"";this.status.textContent=[s,o,this.modes?.words].filter(Boolean).join(" \xB7 ")}get fills(){return this.root.clientHeight>.8*window.innerHeight}#o(e){this.status.textContent=e,clearTimeout(this.hinted),this.hinted=setTimeout(()=>this.changed(),2500)}advance(e){this.player.advance(e),this.modes?.advance(e),this.update(),this.draw()}seek(e){this.player.seek(e),this.update(),this.changed()}toggle(e=!this.player.playing){this.player.playing=e&&this.player.last>this.player.first,this.transport.update(),this.changed()}step(e){this.player.step(e),this.update(),this.changed()}loop(e){let t=this.player.repeat(e,this.views?.body??-1,this.scenes[0].solids);return this.transport.loop.select.value=this.player.loop,this.transport.draw(),this.changed(),t}follow(e){e>=this.scenes[0].bodies.length||!this.stage||(this.views.follow(e),e>=0&&this.views.closeUp(),this.followed.select.value=String(e),this.changed())}magnify(e){for(let t of this.stage.pictures)t.poses.magnification=e;this.changed()}intoMesh(e){let{point:t,axis:i}=this.views.intoMesh(e);this.section.through(t,i)}};function b_(n){if(n.length<2)return[""];let[e,t]=n;return e.title!==t.title?[e.title,t.title]:e.subtitle===t.subtitle?["first","second"]:[e.subtitle,t.subtitle]}function Cb(n){let e=b_(n);return n.flatMap((t,i)=>t.marks.map(r=>({...r,what:[r.what,e[i]].filter(Boolean).join(", ")})))}function Pb(n){let e=n.map(t=>t.times?.data??[]);return e.length===1?e[0]:Float64Array.from(new Set(e.flatMap(t=>[...t]))).sort()}var E_="pitchpoint-scene-1",Lb={f8:Float64Array,f4:Float32Array,i4:Int32Array,u4:Uint32Array,i2:Int16Array,u2:Uint16Array,u1:Uint8Array},ln=class extends Error{};function Db(n){let e;try{e=atob(n.trim())}catch{throw new ln("The numbers of this scene cannot be read: they are not base64. The file may be damaged.")}let t=new Uint8Array(e.length);for(let i=0;i<t.length;i++)t[i]=e.charCodeAt(i);return t}async function Ib(n){if(typeof DecompressionStream>"u")throw new ln("This browser cannot unpack the numbers of the scene (no DecompressionStream); a newer one can.");try{let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip"));return await new Response(e).arrayBuffer()}catch{throw new ln("The numbers of this scene cannot be unpacked: the file is truncated or damaged.")}}function Nb(n,e,t){let i=Lb[e?.type],r=e?.shape;if(!i||!Array.isArray(r)||!r.length||r.some(S=>!Number.isInteger(S)||S<0))throw new ln(`This scene cannot be read: ${t} has no type or shape that this viewer knows.`);let s=r.reduce((S,d)=>S*d,1),o=e.at;if(!Number.isInteger(o)||o<0||o%8||o+s*i.BYTES_PER_ELEMENT>n.byteLength)throw new ln(`This scene is truncated: ${t} lies beyond the end of the numbers.`);let a=new i(n,o,s),l=r[r.length-1],c=r.length>1?s/Math.max(r[0],1):1,h=r[0];if(!e.scale&&!e.offset)return{data:a,shape:r,width:c,count:h};let u=r.length>1?l:1,f=e.scale??Array(u).fill(1),m=e.offset??Array(u).fill(0),x=new Float64Array(s);for(let S=0;S<s;S++)x[S]=m[S%u]+f[S%u]*a[S];return{data:x,shape:r,width:c,count:h}}function Yf(n,e,t,i=new Map){if(Array.isArray(n))return n.map((s,o)=>Yf(s,e,s?.name?`${t} ${s.name}`:`${t} ${o+1}`,i));if(n===null||typeof n!="object")return n;if("at"in n&&"type"in n&&"shape"in n){let s=JSON.stringify(n);return i.has(s)||i.set(s,Nb(e,n,t)),i.get(s)}let r={};for(let[s,o]of Object.entries(n))r[s]=Yf(o,e,`${s} of ${t}`,i);return r}function Jr(n,e){if(!n)throw new ln(`This scene cannot be read: ${e}.`)}function Ub(n){let e=n.times?.count??0,t=(i,r)=>Jr(!i||i.count===e||i.count===1,`${r} has ${i?.count} rows for ${e} times`);n.bodies.forEach((i,r)=>{Jr(Number.isInteger(i.parent??-1)&&(i.parent??-1)<r,`body ${i.name} comes before its parent`);for(let s of["position","turn","spin","gross","quaternion"])t(i[s],`${s} of body ${i.name}`)});for(let i of n.solids){Jr(i.body>=-1&&i.body<n.bodies.length,`solid ${i.name} belongs to no body`),Jr(i.points?.width===3&&i.triangles?.width===3,`solid ${i.name} has no surface`);for(let r of i.triangles.data)Jr(r<i.points.count,`solid ${i.name} has a triangle without a point`);for(let r of i.skin?.bodies??[])Jr(r in n.bodies,`the skin of ${i.name} names a body that is not there`)}for(let i of n.arrows){Jr(i.body>=-1&&i.body<n.bodies.length,`arrow ${i.name} belongs to no body`);for(let r of["circumferential","radial","axial"])t(i.components?.[r],`the ${r} force ${i.name}`);t(i.at,`the place of arrow ${i.name}`),t(i.state,`the state of arrow ${i.name}`)}for(let i of n.channels){let r=i.least?.count;Jr(i.times&&r&&i.times.count===r&&(i.most?.count??r)===r,`channel ${i.name} has times and values of different length`)}}async function Kf(n=""){let e=document.getElementById(`pp-scene${n}`),t=document.getElementById(`pp-scene-numbers${n}`);if(!e||!t)throw new ln("This page holds no scene.");let i;try{i=JSON.parse(e.textContent??"")}catch{throw new ln("The header of this scene cannot be read: the file is truncated or damaged.")}if(i?.format!==E_)throw new ln(`This scene is of the format "${i?.format}"; this viewer reads "${E_}".`);let r=await Ib(Db(t.textContent??"")),o={title:"",subtitle:"",up:[0,1,0],...{bodies:[],solids:[],arrows:[],channels:[],spectra:[],marks:[],modes:[],notes:[]},...Yf(i,r,"this scene")};return Ub(o),o}function w_(n){let{player:e,stage:t,curves:i}=n,r=s=>[s.x,s.y,s.z];return{time:e.time,playing:e.playing,frame:e.frame,speed:e.speed,loop:e.loop,window:[...e.window],channels:[...i.plots.names],cursor:i.plots.drawn.map(({plot:s,line:o})=>({at:o.hidden?null:s.posToVal(new DOMMatrix(getComputedStyle(o).transform).m41,"x"),readings:[...o.closest(".ppv-plot").querySelectorAll("output")].map(a=>a.textContent)})),marks:n.transport.marks.length,message:n.area.querySelector(".ppv-message")?.textContent??null,drawn:t?.drawn??0,section:n.section?{on:n.section.on,normal:r(n.section.normal),at:n.section.at}:null,mode:n.modes?.number??-1,following:n.views?.body??-1,camera:n.orbit?{position:r(t.camera.position),target:r(n.orbit.now.target),distance:n.orbit.now.distance,near:t.camera.near,far:t.camera.far}:null,pictures:(t?.pictures??[]).map(s=>({bodies:s.poses.world.map(o=>[...o.elements]),seen:[...t.seen.elements],magnification:s.poses.magnification,triangles:s.solids.triangles,batches:s.solids.batches.length,arrows:(s.arrows.now??[]).map((o,a)=>({name:o.name,kind:o.kind,state:o.state,at:r(o.at),vectors:Object.fromEntries(Object.entries(o.vectors).map(([l,c])=>[l,r(c)])),lengths:Object.fromEntries(Object.entries(s.arrows.drawn[a].parts).map(([l,c])=>[l,c.visible?new F().setFromMatrixColumn(c.matrix,2).length():0]))}))}))}}var nl=null;async function Fb(n,{compare:e=!1}={}){document.getElementById("ppv-style")||document.head.append(ae("style",{id:"ppv-style"},ph+mh));let t=ae("div",{className:"ppv"}),i=ae("p",{},"Reading the scene \u2026");t.append(ae("div",{className:"ppv-message",role:"status"},i)),n.replaceChildren(t);try{let r=[await Kf()];return e&&r.push(await Kf("-2")),nl=new cu(t,r),t.dataset.ready="scene",!0}catch(r){return i.textContent=r instanceof ln?r.message:`The viewer failed: ${r instanceof Error?r.message:r}.`,t.replaceChildren(ae("div",{className:"ppv-message",role:"alert"},i)),t.dataset.ready="failed",r instanceof ln||console.error(r),!1}}var Bi=()=>{if(!nl)throw new Error("no scene is shown");return nl};window.pitchpointViewer={mount:Fb,state:()=>nl?w_(nl):null,seek:n=>Bi().seek(n),play:()=>Bi().toggle(!0),pause:()=>Bi().toggle(!1),step:n=>Bi().step(n),repeat:n=>Bi().loop(n),advance:n=>Bi().advance(n),follow:n=>Bi().follow(n),look:(n,e,t)=>Bi().views?.look(n,e,t),view:n=>Bi().views?.named(n,!0),show:(n,e=!0)=>Bi().curves.plots.show(n,e),magnify:n=>Bi().magnify(n),mode:n=>Bi().modes.choose(n),file:(n,e=1)=>n==="png"?$c(Bi(),e):n==="glb"?Qc(Bi()):Jc(Bi()),draw:()=>{Bi().orbit?.settle(),Bi().draw()}};})();
