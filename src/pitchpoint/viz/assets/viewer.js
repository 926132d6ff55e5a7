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
(()=>{var od='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var ad=`.ppv { --v-paper: var(--pp-paper, #fff); --v-ink: var(--pp-ink, #1f2933); --v-soft: var(--pp-soft, #5b6672); --v-grid: var(--pp-grid, #e3e7ec);
  --v-accent: #2f6fb3; --v-scene: #f3f5f8; --v-panel: #fff; --v-hover: rgba(31, 41, 51, .07);
  position: relative; display: flex; flex-direction: column; width: 100%; height: 100%; min-height: 240px; min-width: 0; overflow: hidden; box-sizing: border-box;
  color: var(--v-ink); background: var(--v-paper); font: 13px/1.35 var(--pp-font, system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif); text-align: left; color-scheme: light; }
@media (prefers-color-scheme: dark) {
  .ppv { --v-paper: var(--pp-paper, #14181d); --v-ink: var(--pp-ink, #e6e9ed); --v-soft: var(--pp-soft, #a3adb8); --v-grid: var(--pp-grid, #2c343d);
    --v-accent: #6aa5e0; --v-scene: #1b2026; --v-panel: #181d23; --v-hover: rgba(230, 233, 237, .1); color-scheme: dark; }
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
.ppv-legend table { border-collapse: collapse; width: auto; margin: 0; font-size: inherit; }
.ppv-legend :is(th, td, tr) { border: 0; background: none; font-size: inherit; }
.ppv-legend thead button[aria-expanded] { background: none; padding: 0 4px; margin-left: -4px; color: var(--v-soft); }
.ppv-legend thead button::before { content: "\u25BE "; }
.ppv-folded thead button::before { content: "\u25B8 "; }
.ppv-folded tbody, .ppv-folded .ppv-states { display: none; }
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
.ppv-flanks { position: absolute; left: 12px; bottom: 34px; max-width: calc(100% - 24px); padding: 4px 8px; background: var(--v-panel); border: 1px solid var(--v-grid); border-radius: 8px; font-size: 11px; color: var(--v-soft); font-variant-numeric: tabular-nums; }
.ppv-flanks i { display: block; width: 210px; max-width: 100%; height: 8px; border-radius: 2px; margin: 2px 0; }
.ppv-ends { display: flex; flex-wrap: wrap; justify-content: space-between; gap: 0 8px; width: 210px; max-width: 100%; }
@container (min-width: 520px) { .ppv-scene:has(.ppv-panel:not([hidden])) .ppv-half:first-child .ppv-flanks { left: 266px; max-width: calc(100% - 278px); } }
.ppv-gap { color: var(--v-ink); }
.ppv-marklist { display: flex; flex-direction: column; max-height: 230px; overflow: auto; }
.ppv-marklist button { display: flex; align-items: baseline; gap: 6px; text-align: left; white-space: normal; flex: none; font-size: 12px; }
.ppv-marklist i, .ppv-dot { flex: none; width: 8px; height: 8px; border-radius: 50%; }
.ppv-marklist b { font-weight: 600; white-space: nowrap; font-variant-numeric: tabular-nums; }
.ppv-label { position: absolute; left: 0; top: 0; padding: 2px 7px; background: var(--v-ink); color: var(--v-paper); border-radius: 4px; font-size: 12px; pointer-events: none; white-space: nowrap; z-index: 2; }
.ppv-scale, .ppv-status:not(:empty) { background: var(--v-panel); border-radius: 5px; }
.ppv-scale { position: absolute; left: 8px; bottom: 5px; padding: 1px 5px 4px; font-size: 11px; color: var(--v-soft); pointer-events: none; }
.ppv-scale i { display: block; height: 5px; border: 1px solid var(--v-soft); border-top: 0; }
.ppv-status { position: absolute; left: 50%; bottom: 6px; padding: 1px 7px; transform: translateX(-50%); color: var(--v-soft); font-size: 12px; pointer-events: none; white-space: nowrap; }
.ppv-halves { position: absolute; inset: 0; display: flex; pointer-events: none; }
.ppv-half { position: relative; flex: 1; min-width: 0; container-type: inline-size; }
@container (max-width: 320px) { .ppv-folded thead th { display: none; } }
@container (max-width: 240px) { .ppv-half .ppv-name::before { content: none; } .ppv-flanks { font-size: 10px; } .ppv-name { max-width: 46%; font-size: 11px; } }
.ppv-half + .ppv-half { border-left: 1px solid var(--v-grid); }
.ppv-name { position: absolute; right: 12px; bottom: 8px; max-width: 60%; font-weight: 600; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.ppv-half .ppv-name::before { content: "\u2014 "; color: var(--v-soft); }
.ppv-half + .ppv-half .ppv-name::before { content: "\u2504 "; }
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
.ppv-spectra select { max-width: 260px; }
.ppv-maps:not([hidden]) { display: flex; position: relative; }
.ppv-maps .ppv-box { flex: 1; }
.ppv-maps .ppv-cursor { background: #fff; box-shadow: 0 0 0 1px rgb(0 0 0 / 55%); }
.ppv-map-scale { position: relative; flex: none; width: 92px; font-size: 11px; color: var(--v-soft); }
.ppv-map-scale i { position: absolute; left: 14px; top: 8px; bottom: 26px; width: 12px; border-radius: 2px; }
.ppv-map-scale span { position: absolute; left: 32px; top: 4px; }
.ppv-map-scale span:last-child { top: auto; bottom: 22px; }
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
.ppv-modes { display: flex; flex-direction: column; overflow: auto; }
.ppv-panel > .ppv-modes { flex: 0 1 auto; min-height: 96px; }
.ppv-modes button { text-align: left; display: flex; justify-content: space-between; align-items: baseline; gap: 8px; flex: none; white-space: normal; }
.ppv-modes span:first-child { min-width: 0; overflow-wrap: anywhere; }
.ppv-modes span:last-child { flex: none; white-space: nowrap; font-variant-numeric: tabular-nums; }
@media (max-width: 640px) {
  .ppv-caption { padding-right: 8px; }
  .ppv-curve { white-space: normal; }
  .ppv-curve :is(output, small, button) { flex: none; white-space: nowrap; }
  .ppv-bar { position: static; }
  .ppv-now { min-width: 6em; }
  .ppv-legend { font-size: 11px; max-height: 45%; }
  .ppv-head { padding: 3px 6px 3px 8px; }
  .ppv-title { flex-basis: 100%; }
  .ppv-tools { flex-wrap: nowrap; overflow-x: auto; scrollbar-width: none; }
  .ppv-tools button { padding: 5px 7px; }
  .ppv-transport .ppv-slider input { width: 84px; }
  .ppv-transport .ppv-slider output { min-width: 0; }
  .ppv-transport .ppv-choice span { display: none; }
  .ppv-status { max-width: 50%; overflow: hidden; text-overflow: ellipsis; }
}
@media print { .ppv-tools, .ppv-time, .ppv-bar { display: none; } }
`;function J(n,e={},...t){let i=document.createElement(n);for(let[r,s]of Object.entries(e))s==null||s===!1||(r.startsWith("on")?i.addEventListener(r.slice(2),s):r in i&&r!=="list"&&typeof s!="string"?i[r]=s:i.setAttribute(r==="className"?"class":r,s===!0?"":String(s)));return i.append(...t.filter(r=>r!=null)),i}function Tt(n,e,t,i={}){return J("button",{type:"button",title:e,"aria-label":e,onclick:t,...i},n)}function _r({label:n,title:e,least:t,most:i,value:r,show:s,changed:o}){let a=Math.log(i/t),l=J("output",{},s(r)),c=J("input",{type:"range",min:"0",max:"1",step:"0.001",title:e,"aria-label":e}),h=()=>t*Math.exp(a*Number(c.value)),f=u=>{c.value=String(Math.log(u/t)/a),l.textContent=c.ariaValueText=s(u)};return c.addEventListener("input",()=>{let u=h();l.textContent=c.ariaValueText=s(u),o(u)}),f(r),{row:J("label",{className:"ppv-slider"},J("span",{},n),c,l),set:f,input:c}}function rn(n,e,t,i=n){let r=J("select",{title:i,"aria-label":i,onchange:()=>t(r.value)},...e.map(([s,o])=>J("option",{value:s},o)));return{row:J("label",{className:"ppv-choice"},J("span",{},n),r),select:r}}function tr(n,e,t,i=null){let r=J("input",{type:"checkbox",checked:e,onchange:()=>t(r.checked)});return{row:J("label",{className:"ppv-tick"},r,i,J("span",{},n)),input:r}}var ld=0,af=1,cd=2;var Gs=1,hd=2,os=3,sn=0,ei=1,zi=2,ir=0,kr=1,lf=2,cf=3,hf=4,fd=5;var zr=100,ud=101,dd=102,pd=103,md=104,gd=200,xd=201,_d=202,vd=203,El=204,Tl=205,Md=206,Sd=207,yd=208,bd=209,wd=210,Ed=211,Td=212,Ad=213,Rd=214,ea=0,ta=1,ia=2,Gr=3,na=4,ra=5,sa=6,oa=7,Hs=0,Cd=1,Pd=2,mn=0,Al=1,Rl=2,Cl=3,Pl=4,Ll=5,Dl=6,Nl=7;var ff=300,nr=301,Hr=302,Il=303,Ul=304,aa=1e3,on=1001,la=1002,Zt=1003,Ld=1004;var ca=1005;var Mi=1006,Fl=1007;var gn=1008;var hi=1009,Ol=1010,Bl=1011,vr=1012,Vs=1013,Ii=1014,fi=1015,Ui=1016,Ws=1017,Xs=1018,zn=1020,kl=35902,zl=35899,Gl=1021,Hl=1022,Fi=1023,an=1026,xn=1027,qs=1028,Ys=1029,_n=1030,$s=1031;var Ks=1033,Zs=33776,Js=33777,Qs=33778,js=33779,ha=35840,fa=35841,ua=35842,da=35843,pa=36196,ma=37492,ga=37496,xa=37488,_a=37489,as=37490,va=37491,Ma=37808,Sa=37809,ya=37810,ba=37811,wa=37812,Ea=37813,Ta=37814,Aa=37815,Ra=37816,Ca=37817,Pa=37818,La=37819,Da=37820,Na=37821,Ia=36492,Ua=36494,Fa=36495,Oa=36283,Ba=36284,ls=36285,ka=36286;var Dd=3200;var za=0,Nd=1,Rn="",en="srgb",cs="srgb-linear",hs="linear",_t="srgb";var Vl=7680;var Id=519,Ud=512,Fd=513,Od=514,Wl=515,Bd=516,kd=517,Xl=518,ql=519,zd=35044,Gd=35048;var uf="300 es",Gi=2e3,Mr=2001;function Vd(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function to(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Wd(){let n=to("canvas");return n.style.display="block",n}var Hd={},eo=null;function df(...n){let e="THREE."+n.shift();eo?eo("log",e,...n):console.log(e,...n)}function Xd(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ge(...n){n=Xd(n);let e="THREE."+n.shift();if(eo)eo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function ut(...n){n=Xd(n);let e="THREE."+n.shift();if(eo)eo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function fs(...n){let e=n.join(" ");e in Hd||(Hd[e]=!0,Ge(...n))}function qd(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var Yd={[ea]:ea,[ia]:sa,[na]:na,[Gr]:ra,[ta]:ta,[sa]:ia,[oa]:oa,[ra]:Gr};var Wi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}};var Xi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Yl=Math.PI/180,Ga=180/Math.PI;function rr(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Xi[n&255]+Xi[n>>8&255]+Xi[n>>16&255]+Xi[n>>24&255]+"-"+Xi[e&255]+Xi[e>>8&255]+"-"+Xi[e>>16&15|64]+Xi[e>>24&255]+"-"+Xi[t&63|128]+Xi[t>>8&255]+"-"+Xi[t>>16&255]+Xi[t>>24&255]+Xi[i&255]+Xi[i>>8&255]+Xi[i>>16&255]+Xi[i>>24&255]).toLowerCase()}function ct(n,e,t){return Math.max(e,Math.min(t,n))}function $d(n,e){return(n%e+e)%e}function $l(n,e,t){return(1-t)*n+t*e}function Kd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Kl(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Zd(n,e){if(e.constructor===Float32Array)return n;let t=Kl(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Jd(n,e){if(e.constructor===Float32Array)return n;let t=Kl(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Ke=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};var Ft=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let l=i[r+0],c=i[r+1],h=i[r+2],f=i[r+3],u=s[o+0],d=s[o+1],g=s[o+2],M=s[o+3];if(f!==M||l!==u||c!==d||h!==g){let p=l*u+c*d+h*g+f*M;p<0&&(u=-u,d=-d,g=-g,M=-M,p=-p);let m=1-a;if(p<.9995){let _=Math.acos(p),w=Math.sin(_);m=Math.sin(m*_)/w,a=Math.sin(a*_)/w,l=l*m+u*a,c=c*m+d*a,h=h*m+g*a,f=f*m+M*a}else{l=l*m+u*a,c=c*m+d*a,h=h*m+g*a,f=f*m+M*a;let _=1/Math.sqrt(l*l+c*c+h*h+f*f);l*=_,c*=_,h*=_,f*=_}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],l=i[r+1],c=i[r+2],h=i[r+3],f=s[o],u=s[o+1],d=s[o+2],g=s[o+3];return e[t]=a*g+h*f+l*d-c*u,e[t+1]=l*g+h*u+c*f-a*d,e[t+2]=c*g+h*d+a*u-l*f,e[t+3]=h*g-a*f-l*u-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(r/2),f=a(s/2),u=l(i/2),d=l(r/2),g=l(s/2);switch(o){case"XYZ":this._x=u*h*f+c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f-u*d*g;break;case"YXZ":this._x=u*h*f+c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f+u*d*g;break;case"ZXY":this._x=u*h*f-c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f-u*d*g;break;case"ZYX":this._x=u*h*f-c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f+u*d*g;break;case"YZX":this._x=u*h*f+c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f-u*d*g;break;case"XZY":this._x=u*h*f-c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f+u*d*g;break;default:Ge("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],f=t[10],u=i+a+f;if(u>0){let d=.5/Math.sqrt(u+1);this._w=.25/d,this._x=(h-l)*d,this._y=(s-c)*d,this._z=(o-r)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(h-l)/d,this._x=.25*d,this._y=(r+o)/d,this._z=(s+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(s-c)/d,this._x=(r+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-r)/d,this._x=(s+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+o*a+r*c-s*l,this._y=r*h+o*l+s*a-i*c,this._z=s*h+o*c+i*l-r*a,this._w=o*h-i*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}};var I=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Qd.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Qd.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*i),h=2*(a*t-s*r),f=2*(s*i-o*t);return this.x=t+l*c+o*f-a*h,this.y=i+l*h+a*c-s*f,this.z=r+l*f+s*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-i*l,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return pf.copy(this).projectOnVector(e),this.sub(pf)}reflect(e){return this.sub(pf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},pf=new I,Qd=new Ft;var $e=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c)}set(e,t,i,r,s,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=r,h[2]=a,h[3]=t,h[4]=s,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],f=i[7],u=i[2],d=i[5],g=i[8],M=r[0],p=r[3],m=r[6],_=r[1],w=r[4],S=r[7],R=r[2],A=r[5],x=r[8];return s[0]=o*M+a*_+l*R,s[3]=o*p+a*w+l*A,s[6]=o*m+a*S+l*x,s[1]=c*M+h*_+f*R,s[4]=c*p+h*w+f*A,s[7]=c*m+h*S+f*x,s[2]=u*M+d*_+g*R,s[5]=u*p+d*w+g*A,s[8]=u*m+d*S+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-i*s*h+i*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],f=h*o-a*c,u=a*l-h*s,d=c*s-o*l,g=t*f+i*u+r*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/g;return e[0]=f*M,e[1]=(r*c-h*i)*M,e[2]=(a*i-r*o)*M,e[3]=u*M,e[4]=(h*t-r*l)*M,e[5]=(r*s-a*t)*M,e[6]=d*M,e[7]=(i*l-c*t)*M,e[8]=(o*t-i*s)*M,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return fs("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(mf.makeScale(e,t)),this}rotate(e){return fs("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(mf.makeRotation(-e)),this}translate(e,t){return fs("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(mf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},mf=new $e;var jd=new $e().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ep=new $e().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Qv(){let n={enabled:!0,workingColorSpace:cs,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===_t&&(r.r=Gn(r.r),r.g=Gn(r.g),r.b=Gn(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===_t&&(r.r=us(r.r),r.g=us(r.g),r.b=us(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Rn?hs:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[cs]:{primaries:e,whitePoint:i,transfer:hs,toXYZ:jd,fromXYZ:ep,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:en},outputColorSpaceConfig:{drawingBufferColorSpace:en}},[en]:{primaries:e,whitePoint:i,transfer:_t,toXYZ:jd,fromXYZ:ep,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:en}}}),n}var ot=Qv();function Gn(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function us(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var io,Zl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{io===void 0&&(io=to("canvas")),io.width=e.width,io.height=e.height;let r=io.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=io}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=to("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Gn(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Gn(t[i]/255)*255):t[i]=Gn(t[i]);return{data:t,width:e.width,height:e.height}}else return Ge("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}};var jv=0,Vr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:jv++}),this.uuid=rr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(gf(r[o].image)):s.push(gf(r[o]))}else s=gf(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function gf(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Zl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ge("Texture: Unable to serialize Texture."),{})}var eM=0,xf=new I,ui=class n extends Wi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=on,r=on,s=Mi,o=gn,a=Fi,l=hi,c=n.DEFAULT_ANISOTROPY,h=Rn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:eM++}),this.uuid=rr(),this.name="",this.source=new Vr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new $e,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(xf).x}get height(){return this.source.getSize(xf).y}get depth(){return this.source.getSize(xf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ge(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ge(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ff)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case aa:e.x=e.x-Math.floor(e.x);break;case on:e.x=e.x<0?0:1;break;case la:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case aa:e.y=e.y-Math.floor(e.y);break;case on:e.y=e.y<0?0:1;break;case la:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ui.DEFAULT_IMAGE=null;ui.DEFAULT_MAPPING=ff;ui.DEFAULT_ANISOTROPY=1;var bt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,l=e.elements,c=l[0],h=l[4],f=l[8],u=l[1],d=l[5],g=l[9],M=l[2],p=l[6],m=l[10];if(Math.abs(h-u)<.01&&Math.abs(f-M)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+u)<.1&&Math.abs(f+M)<.1&&Math.abs(g+p)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let w=(c+1)/2,S=(d+1)/2,R=(m+1)/2,A=(h+u)/4,x=(f+M)/4,b=(g+p)/4;return w>S&&w>R?w<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(w),r=A/i,s=x/i):S>R?S<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(S),i=A/r,s=b/r):R<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(R),i=x/s,r=b/s),this.set(i,r,s,t),this}let _=Math.sqrt((p-g)*(p-g)+(f-M)*(f-M)+(u-h)*(u-h));return Math.abs(_)<.001&&(_=1),this.x=(p-g)/_,this.y=(f-M)/_,this.z=(u-h)/_,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};var Jl=class extends Wi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Mi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new bt(0,0,e,t),this.scissorTest=!1,this.viewport=new bt(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new ui({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Mi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Vr(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Hi=class extends Jl{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}};var no=class extends ui{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Zt,this.minFilter=Zt,this.wrapR=on,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ql=class extends ui{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Zt,this.minFilter=Zt,this.wrapR=on,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Le=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,l,c,h,f,u,d,g,M,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c,h,f,u,d,g,M,p)}set(e,t,i,r,s,o,a,l,c,h,f,u,d,g,M,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=r,m[1]=s,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=f,m[14]=u,m[3]=d,m[7]=g,m[11]=M,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/ro.setFromMatrixColumn(e,0).length(),s=1/ro.setFromMatrixColumn(e,1).length(),o=1/ro.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(r),c=Math.sin(r),h=Math.cos(s),f=Math.sin(s);if(e.order==="XYZ"){let u=o*h,d=o*f,g=a*h,M=a*f;t[0]=l*h,t[4]=-l*f,t[8]=c,t[1]=d+g*c,t[5]=u-M*c,t[9]=-a*l,t[2]=M-u*c,t[6]=g+d*c,t[10]=o*l}else if(e.order==="YXZ"){let u=l*h,d=l*f,g=c*h,M=c*f;t[0]=u+M*a,t[4]=g*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*h,t[9]=-a,t[2]=d*a-g,t[6]=M+u*a,t[10]=o*l}else if(e.order==="ZXY"){let u=l*h,d=l*f,g=c*h,M=c*f;t[0]=u-M*a,t[4]=-o*f,t[8]=g+d*a,t[1]=d+g*a,t[5]=o*h,t[9]=M-u*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let u=o*h,d=o*f,g=a*h,M=a*f;t[0]=l*h,t[4]=g*c-d,t[8]=u*c+M,t[1]=l*f,t[5]=M*c+u,t[9]=d*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let u=o*l,d=o*c,g=a*l,M=a*c;t[0]=l*h,t[4]=M-u*f,t[8]=g*f+d,t[1]=f,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=d*f+g,t[10]=u-M*f}else if(e.order==="XZY"){let u=o*l,d=o*c,g=a*l,M=a*c;t[0]=l*h,t[4]=-f,t[8]=c*h,t[1]=u*f+M,t[5]=o*h,t[9]=d*f-g,t[2]=g*f-d,t[6]=a*h,t[10]=M*f+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(tM,e,iM)}lookAt(e,t,i){let r=this.elements;return vn.subVectors(e,t),vn.lengthSq()===0&&(vn.z=1),vn.normalize(),Wr.crossVectors(i,vn),Wr.lengthSq()===0&&(Math.abs(i.z)===1?vn.x+=1e-4:vn.z+=1e-4,vn.normalize(),Wr.crossVectors(i,vn)),Wr.normalize(),jl.crossVectors(vn,Wr),r[0]=Wr.x,r[4]=jl.x,r[8]=vn.x,r[1]=Wr.y,r[5]=jl.y,r[9]=vn.y,r[2]=Wr.z,r[6]=jl.z,r[10]=vn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],f=i[5],u=i[9],d=i[13],g=i[2],M=i[6],p=i[10],m=i[14],_=i[3],w=i[7],S=i[11],R=i[15],A=r[0],x=r[4],b=r[8],F=r[12],L=r[1],D=r[5],k=r[9],G=r[13],U=r[2],W=r[6],Y=r[10],V=r[14],ce=r[3],Z=r[7],j=r[11],re=r[15];return s[0]=o*A+a*L+l*U+c*ce,s[4]=o*x+a*D+l*W+c*Z,s[8]=o*b+a*k+l*Y+c*j,s[12]=o*F+a*G+l*V+c*re,s[1]=h*A+f*L+u*U+d*ce,s[5]=h*x+f*D+u*W+d*Z,s[9]=h*b+f*k+u*Y+d*j,s[13]=h*F+f*G+u*V+d*re,s[2]=g*A+M*L+p*U+m*ce,s[6]=g*x+M*D+p*W+m*Z,s[10]=g*b+M*k+p*Y+m*j,s[14]=g*F+M*G+p*V+m*re,s[3]=_*A+w*L+S*U+R*ce,s[7]=_*x+w*D+S*W+R*Z,s[11]=_*b+w*k+S*Y+R*j,s[15]=_*F+w*G+S*V+R*re,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],f=e[6],u=e[10],d=e[14],g=e[3],M=e[7],p=e[11],m=e[15],_=l*d-c*u,w=a*d-c*f,S=a*u-l*f,R=o*d-c*h,A=o*u-l*h,x=o*f-a*h;return t*(M*_-p*w+m*S)-i*(g*_-p*R+m*A)+r*(g*w-M*R+m*x)-s*(g*S-M*A+p*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-i*(s*h-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],f=e[9],u=e[10],d=e[11],g=e[12],M=e[13],p=e[14],m=e[15],_=t*a-i*o,w=t*l-r*o,S=t*c-s*o,R=i*l-r*a,A=i*c-s*a,x=r*c-s*l,b=h*M-f*g,F=h*p-u*g,L=h*m-d*g,D=f*p-u*M,k=f*m-d*M,G=u*m-d*p,U=_*G-w*k+S*D+R*L-A*F+x*b;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/U;return e[0]=(a*G-l*k+c*D)*W,e[1]=(r*k-i*G-s*D)*W,e[2]=(M*x-p*A+m*R)*W,e[3]=(u*A-f*x-d*R)*W,e[4]=(l*L-o*G-c*F)*W,e[5]=(t*G-r*L+s*F)*W,e[6]=(p*S-g*x-m*w)*W,e[7]=(h*x-u*S+d*w)*W,e[8]=(o*k-a*L+c*b)*W,e[9]=(i*L-t*k-s*b)*W,e[10]=(g*A-M*S+m*_)*W,e[11]=(f*S-h*A-d*_)*W,e[12]=(a*F-o*D-l*b)*W,e[13]=(t*D-i*F+r*b)*W,e[14]=(M*w-g*R-p*_)*W,e[15]=(h*R-f*w+u*_)*W,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,l=e.z,c=s*o,h=s*a;return this.set(c*o+i,c*a-r*l,c*l+r*a,0,c*a+r*l,h*a+i,h*l-r*o,0,c*l-r*a,h*l+r*o,s*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,h=o+o,f=a+a,u=s*c,d=s*h,g=s*f,M=o*h,p=o*f,m=a*f,_=l*c,w=l*h,S=l*f,R=i.x,A=i.y,x=i.z;return r[0]=(1-(M+m))*R,r[1]=(d+S)*R,r[2]=(g-w)*R,r[3]=0,r[4]=(d-S)*A,r[5]=(1-(u+m))*A,r[6]=(p+_)*A,r[7]=0,r[8]=(g+w)*x,r[9]=(p-_)*x,r[10]=(1-(u+M))*x,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=ro.set(r[0],r[1],r[2]).length(),a=ro.set(r[4],r[5],r[6]).length(),l=ro.set(r[8],r[9],r[10]).length();s<0&&(o=-o),Hn.copy(this);let c=1/o,h=1/a,f=1/l;return Hn.elements[0]*=c,Hn.elements[1]*=c,Hn.elements[2]*=c,Hn.elements[4]*=h,Hn.elements[5]*=h,Hn.elements[6]*=h,Hn.elements[8]*=f,Hn.elements[9]*=f,Hn.elements[10]*=f,t.setFromRotationMatrix(Hn),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,r,s,o,a=Gi,l=!1){let c=this.elements,h=2*s/(t-e),f=2*s/(i-r),u=(t+e)/(t-e),d=(i+r)/(i-r),g,M;if(l)g=s/(o-s),M=o*s/(o-s);else if(a===Gi)g=-(o+s)/(o-s),M=-2*o*s/(o-s);else if(a===Mr)g=-o/(o-s),M=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=M,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=Gi,l=!1){let c=this.elements,h=2/(t-e),f=2/(i-r),u=-(t+e)/(t-e),d=-(i+r)/(i-r),g,M;if(l)g=1/(o-s),M=o/(o-s);else if(a===Gi)g=-2/(o-s),M=-(o+s)/(o-s);else if(a===Mr)g=-1/(o-s),M=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=M,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},ro=new I,Hn=new Le,tM=new I(0,0,0),iM=new I(1,1,1),Wr=new I,jl=new I,vn=new I;var tp=new Le,ip=new Ft,Cn=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],h=r[9],f=r[2],u=r[6],d=r[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,s),this._z=0);break;case"ZXY":this._x=Math.asin(ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-ct(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(u,d),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-f,s)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-h,d),this._y=0);break;default:Ge("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return tp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(tp,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return ip.setFromEuler(this),this.setFromQuaternion(ip,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Cn.DEFAULT_ORDER="XYZ";var Xr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}};var nM=0,np=new I,so=new Ft,Sr=new Le,ec=new I,Ha=new I,rM=new I,sM=new Ft,rp=new I(1,0,0),sp=new I(0,1,0),op=new I(0,0,1),ap={type:"added"},oM={type:"removed"},oo={type:"childadded",child:null},_f={type:"childremoved",child:null},Jt=class n extends Wi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:nM++}),this.uuid=rr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new I,t=new Cn,i=new Ft,r=new I(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new Le},normalMatrix:{value:new $e}}),this.matrix=new Le,this.matrixWorld=new Le,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Xr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return so.setFromAxisAngle(e,t),this.quaternion.multiply(so),this}rotateOnWorldAxis(e,t){return so.setFromAxisAngle(e,t),this.quaternion.premultiply(so),this}rotateX(e){return this.rotateOnAxis(rp,e)}rotateY(e){return this.rotateOnAxis(sp,e)}rotateZ(e){return this.rotateOnAxis(op,e)}translateOnAxis(e,t){return np.copy(e).applyQuaternion(this.quaternion),this.position.add(np.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(rp,e)}translateY(e){return this.translateOnAxis(sp,e)}translateZ(e){return this.translateOnAxis(op,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Sr.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?ec.copy(e):ec.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),Ha.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Sr.lookAt(Ha,ec,this.up):Sr.lookAt(ec,Ha,this.up),this.quaternion.setFromRotationMatrix(Sr),r&&(Sr.extractRotation(r.matrixWorld),so.setFromRotationMatrix(Sr),this.quaternion.premultiply(so.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ut("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(ap),oo.child=e,this.dispatchEvent(oo),oo.child=null):ut("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(oM),_f.child=e,this.dispatchEvent(_f),_f.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Sr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Sr.multiply(e.parent.matrixWorld)),e.applyMatrix4(Sr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(ap),oo.child=e,this.dispatchEvent(oo),oo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ha,e,rM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ha,sM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let f=l[c];s(e.shapes,f)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),f=o(e.shapes),u=o(e.skeletons),d=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),f.length>0&&(i.shapes=f),u.length>0&&(i.skeletons=u),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=r,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Jt.DEFAULT_UP=new I(0,1,0);Jt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Jt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Mn=class extends Jt{constructor(){super(),this.isGroup=!0,this.type="Group"}};var aM={type:"move"},ao=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Mn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Mn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new I,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new I),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Mn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new I,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new I,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let M of e.hand.values()){let p=t.getJointPose(M,i),m=this._getHandJoint(c,M);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],u=h.position.distanceTo(f.position),d=.02,g=.005;c.inputState.pinching&&u>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(aM)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Mn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}};var lp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},qr={h:0,s:0,l:0},tc={h:0,s:0,l:0};function vf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Xe=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=en){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,ot.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=ot.workingColorSpace){return this.r=e,this.g=t,this.b=i,ot.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=ot.workingColorSpace){if(e=$d(e,1),t=ct(t,0,1),i=ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=vf(o,s,e+1/3),this.g=vf(o,s,e),this.b=vf(o,s,e-1/3)}return ot.colorSpaceToWorking(this,r),this}setStyle(e,t=en){function i(s){s!==void 0&&parseFloat(s)<1&&Ge("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Ge("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);Ge("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=en){let i=lp[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ge("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Gn(e.r),this.g=Gn(e.g),this.b=Gn(e.b),this}copyLinearToSRGB(e){return this.r=us(e.r),this.g=us(e.g),this.b=us(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=en){return ot.workingToColorSpace(qi.copy(this),e),Math.round(ct(qi.r*255,0,255))*65536+Math.round(ct(qi.g*255,0,255))*256+Math.round(ct(qi.b*255,0,255))}getHexString(e=en){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=ot.workingColorSpace){ot.workingToColorSpace(qi.copy(this),t);let i=qi.r,r=qi.g,s=qi.b,o=Math.max(i,r,s),a=Math.min(i,r,s),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=h<=.5?f/(o+a):f/(2-o-a),o){case i:l=(r-s)/f+(r<s?6:0);break;case r:l=(s-i)/f+2;break;case s:l=(i-r)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=ot.workingColorSpace){return ot.workingToColorSpace(qi.copy(this),t),e.r=qi.r,e.g=qi.g,e.b=qi.b,e}getStyle(e=en){ot.workingToColorSpace(qi.copy(this),e);let t=qi.r,i=qi.g,r=qi.b;return e!==en?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(qr),this.setHSL(qr.h+e,qr.s+t,qr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(qr),e.getHSL(tc);let i=$l(qr.h,tc.h,t),r=$l(qr.s,tc.s,t),s=$l(qr.l,tc.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},qi=new Xe;Xe.NAMES=lp;var lo=class extends Jt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Cn,this.environmentIntensity=1,this.environmentRotation=new Cn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}};var Vn=new I,yr=new I,Mf=new I,br=new I,co=new I,ho=new I,cp=new I,Sf=new I,yf=new I,bf=new I,wf=new bt,Ef=new bt,Tf=new bt,Yr=class n{constructor(e=new I,t=new I,i=new I){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),Vn.subVectors(e,t),r.cross(Vn);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){Vn.subVectors(r,t),yr.subVectors(i,t),Mf.subVectors(e,t);let o=Vn.dot(Vn),a=Vn.dot(yr),l=Vn.dot(Mf),c=yr.dot(yr),h=yr.dot(Mf),f=o*c-a*a;if(f===0)return s.set(0,0,0),null;let u=1/f,d=(c*l-a*h)*u,g=(o*h-a*l)*u;return s.set(1-d-g,g,d)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,br)===null?!1:br.x>=0&&br.y>=0&&br.x+br.y<=1}static getInterpolation(e,t,i,r,s,o,a,l){return this.getBarycoord(e,t,i,r,br)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,br.x),l.addScaledVector(o,br.y),l.addScaledVector(a,br.z),l)}static getInterpolatedAttribute(e,t,i,r,s,o){return wf.setScalar(0),Ef.setScalar(0),Tf.setScalar(0),wf.fromBufferAttribute(e,t),Ef.fromBufferAttribute(e,i),Tf.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(wf,s.x),o.addScaledVector(Ef,s.y),o.addScaledVector(Tf,s.z),o}static isFrontFacing(e,t,i,r){return Vn.subVectors(i,t),yr.subVectors(e,t),Vn.cross(yr).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Vn.subVectors(this.c,this.b),yr.subVectors(this.a,this.b),Vn.cross(yr).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;co.subVectors(r,i),ho.subVectors(s,i),Sf.subVectors(e,i);let l=co.dot(Sf),c=ho.dot(Sf);if(l<=0&&c<=0)return t.copy(i);yf.subVectors(e,r);let h=co.dot(yf),f=ho.dot(yf);if(h>=0&&f<=h)return t.copy(r);let u=l*f-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(i).addScaledVector(co,o);bf.subVectors(e,s);let d=co.dot(bf),g=ho.dot(bf);if(g>=0&&d<=g)return t.copy(s);let M=d*c-l*g;if(M<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(ho,a);let p=h*g-d*f;if(p<=0&&f-h>=0&&d-g>=0)return cp.subVectors(s,r),a=(f-h)/(f-h+(d-g)),t.copy(r).addScaledVector(cp,a);let m=1/(p+M+u);return o=M*m,a=u*m,t.copy(i).addScaledVector(co,o).addScaledVector(ho,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}};var Pn=class{constructor(e=new I(1/0,1/0,1/0),t=new I(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Wn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Wn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Wn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Wn):Wn.fromBufferAttribute(s,o),Wn.applyMatrix4(e.matrixWorld),this.expandByPoint(Wn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),ic.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ic.copy(i.boundingBox)),ic.applyMatrix4(e.matrixWorld),this.union(ic)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Wn),Wn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Va),nc.subVectors(this.max,Va),fo.subVectors(e.a,Va),uo.subVectors(e.b,Va),po.subVectors(e.c,Va),$r.subVectors(uo,fo),Kr.subVectors(po,uo),ds.subVectors(fo,po);let t=[0,-$r.z,$r.y,0,-Kr.z,Kr.y,0,-ds.z,ds.y,$r.z,0,-$r.x,Kr.z,0,-Kr.x,ds.z,0,-ds.x,-$r.y,$r.x,0,-Kr.y,Kr.x,0,-ds.y,ds.x,0];return!Af(t,fo,uo,po,nc)||(t=[1,0,0,0,1,0,0,0,1],!Af(t,fo,uo,po,nc))?!1:(rc.crossVectors($r,Kr),t=[rc.x,rc.y,rc.z],Af(t,fo,uo,po,nc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Wn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Wn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(wr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),wr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),wr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),wr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),wr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),wr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),wr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),wr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(wr),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},wr=[new I,new I,new I,new I,new I,new I,new I,new I],Wn=new I,ic=new Pn,fo=new I,uo=new I,po=new I,$r=new I,Kr=new I,ds=new I,Va=new I,nc=new I,rc=new I,ps=new I;function Af(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){ps.fromArray(n,s);let a=r.x*Math.abs(ps.x)+r.y*Math.abs(ps.y)+r.z*Math.abs(ps.z),l=e.dot(ps),c=t.dot(ps),h=i.dot(ps);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Si=new I,sc=new Ke,lM=0,Rt=class extends Wi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:lM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=zd,this.updateRanges=[],this.gpuType=fi,this.version=0,this._normalizationScale=e!==void 0?Kl(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)sc.fromBufferAttribute(this,t),sc.applyMatrix3(e),this.setXY(t,sc.x,sc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.applyMatrix3(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.applyMatrix4(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.applyNormalMatrix(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.transformDirection(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Zd(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Jd(e,this.array)}};var mo=class extends Rt{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var go=class extends Rt{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Gt=class extends Rt{constructor(e,t,i){super(new Float32Array(e),t,i)}};var cM=new Pn,Wa=new I,Rf=new I,ln=class{constructor(e=new I,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):cM.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Wa.subVectors(e,this.center);let t=Wa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(Wa,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Rf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Wa.copy(e.center).add(Rf)),this.expandByPoint(Wa.copy(e.center).sub(Rf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}};var hM=0,Ln=new Le,Cf=new Jt,xo=new I,Sn=new Pn,Xa=new Pn,Oi=new I,Ot=class n extends Wi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:hM++}),this.uuid=rr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Vd(e)?go:mo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new $e().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ln.makeRotationFromQuaternion(e),this.applyMatrix4(Ln),this}rotateX(e){return Ln.makeRotationX(e),this.applyMatrix4(Ln),this}rotateY(e){return Ln.makeRotationY(e),this.applyMatrix4(Ln),this}rotateZ(e){return Ln.makeRotationZ(e),this.applyMatrix4(Ln),this}translate(e,t,i){return Ln.makeTranslation(e,t,i),this.applyMatrix4(Ln),this}scale(e,t,i){return Ln.makeScale(e,t,i),this.applyMatrix4(Ln),this}lookAt(e){return Cf.lookAt(e),Cf.updateMatrix(),this.applyMatrix4(Cf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(xo).negate(),this.translate(xo.x,xo.y,xo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Gt(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Ge("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Pn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ut("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new I(-1/0,-1/0,-1/0),new I(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];Sn.setFromBufferAttribute(s),this.morphTargetsRelative?(Oi.addVectors(this.boundingBox.min,Sn.min),this.boundingBox.expandByPoint(Oi),Oi.addVectors(this.boundingBox.max,Sn.max),this.boundingBox.expandByPoint(Oi)):(this.boundingBox.expandByPoint(Sn.min),this.boundingBox.expandByPoint(Sn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ut('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ln);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ut("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new I,1/0);return}if(e){let i=this.boundingSphere.center;if(Sn.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];Xa.setFromBufferAttribute(a),this.morphTargetsRelative?(Oi.addVectors(Sn.min,Xa.min),Sn.expandByPoint(Oi),Oi.addVectors(Sn.max,Xa.max),Sn.expandByPoint(Oi)):(Sn.expandByPoint(Xa.min),Sn.expandByPoint(Xa.max))}Sn.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)Oi.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(Oi));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Oi.fromBufferAttribute(a,c),l&&(xo.fromBufferAttribute(e,c),Oi.add(xo)),r=Math.max(r,i.distanceToSquared(Oi))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&ut('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ut("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Rt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let F=0;F<i.count;F++)a[F]=new I,l[F]=new I;let h=new I,f=new I,u=new I,d=new Ke,g=new Ke,M=new Ke,p=new I,m=new I;function _(F,L,D){c[F]=c[L]=c[D]=1,h.fromBufferAttribute(i,F),f.fromBufferAttribute(i,L),u.fromBufferAttribute(i,D),d.fromBufferAttribute(s,F),g.fromBufferAttribute(s,L),M.fromBufferAttribute(s,D),f.sub(h),u.sub(h),g.sub(d),M.sub(d);let k=1/(g.x*M.y-M.x*g.y);isFinite(k)&&(p.copy(f).multiplyScalar(M.y).addScaledVector(u,-g.y).multiplyScalar(k),m.copy(u).multiplyScalar(g.x).addScaledVector(f,-M.x).multiplyScalar(k),a[F].add(p),a[L].add(p),a[D].add(p),l[F].add(m),l[L].add(m),l[D].add(m))}let w=this.groups;w.length===0&&(w=[{start:0,count:e.count}]);for(let F=0,L=w.length;F<L;++F){let D=w[F],k=D.start,G=D.count;for(let U=k,W=k+G;U<W;U+=3)_(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let S=new I,R=new I,A=new I,x=new I;function b(F){A.fromBufferAttribute(r,F),x.copy(A);let L=a[F];S.copy(L),S.sub(A.multiplyScalar(A.dot(L))).normalize(),R.crossVectors(x,L);let k=R.dot(l[F])<0?-1:1;o.setXYZW(F,S.x,S.y,S.z,k)}for(let F=0,L=i.count;F<L;++F)c[F]&&b(F);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Rt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let u=0,d=i.count;u<d;u++)i.setXYZ(u,0,0,0);let r=new I,s=new I,o=new I,a=new I,l=new I,c=new I,h=new I,f=new I;if(e)for(let u=0,d=e.count;u<d;u+=3){let g=e.getX(u+0),M=e.getX(u+1),p=e.getX(u+2);r.fromBufferAttribute(t,g),s.fromBufferAttribute(t,M),o.fromBufferAttribute(t,p),h.subVectors(o,s),f.subVectors(r,s),h.cross(f),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,M),c.fromBufferAttribute(i,p),a.add(h),l.add(h),c.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(M,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let u=0,d=t.count;u<d;u+=3)r.fromBufferAttribute(t,u+0),s.fromBufferAttribute(t,u+1),o.fromBufferAttribute(t,u+2),h.subVectors(o,s),f.subVectors(r,s),h.cross(f),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Oi.fromBufferAttribute(e,t),Oi.normalize(),e.setXYZ(t,Oi.x,Oi.y,Oi.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,f=a.normalized,u=new c.constructor(l.length*h),d=0,g=0;for(let M=0,p=l.length;M<p;M++){a.isInterleavedBufferAttribute?d=l[M]*a.data.stride+a.offset:d=l[M]*h;for(let m=0;m<h;m++)u[g++]=c[d++]}return new Rt(u,h,f)}if(this.index===null)return Ge("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,i);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let h=0,f=c.length;h<f;h++){let u=c[h],d=e(u,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let f=0,u=c.length;f<u;f++){let d=c[f];h.push(d.toJSON(e.data))}h.length>0&&(r[l]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let c in r){let h=r[c];this.setAttribute(c,h.clone(t))}let s=e.morphAttributes;for(let c in s){let h=[],f=s[c];for(let u=0,d=f.length;u<d;u++)h.push(f[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Pf=new I,fM=new I,uM=new $e,Yi=class{constructor(e=new I(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=Pf.subVectors(i,t).cross(fM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(Pf),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||uM.getNormalMatrix(e),r=this.coplanarPoint(Pf).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}};var dM=0,Dn=class extends Wi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:dM++}),this.uuid=rr(),this.name="",this.type="Material",this.blending=kr,this.side=sn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=El,this.blendDst=Tl,this.blendEquation=zr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Xe(0,0,0),this.blendAlpha=0,this.depthFunc=Gr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Id,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Vl,this.stencilZFail=Vl,this.stencilZPass=Vl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ge(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ge(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Xe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Yi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ke().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Er=new I,Lf=new I,oc=new I,ac=new I,_o=class{constructor(e=new I,t=new I(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Er)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Er.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Er.copy(this.origin).addScaledVector(this.direction,t),Er.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){Lf.copy(e).add(t).multiplyScalar(.5),oc.copy(t).sub(e).normalize(),ac.copy(this.origin).sub(Lf);let s=e.distanceTo(t)*.5,o=-this.direction.dot(oc),a=ac.dot(this.direction),l=-ac.dot(oc),c=ac.lengthSq(),h=Math.abs(1-o*o),f,u,d,g;if(h>0)if(f=o*l-a,u=o*a-l,g=s*h,f>=0)if(u>=-g)if(u<=g){let M=1/h;f*=M,u*=M,d=f*(f+o*u+2*a)+u*(o*f+u+2*l)+c}else u=s,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;else u=-s,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;else u<=-g?(f=Math.max(0,-(-o*s+a)),u=f>0?-s:Math.min(Math.max(-s,-l),s),d=-f*f+u*(u+2*l)+c):u<=g?(f=0,u=Math.min(Math.max(-s,-l),s),d=u*(u+2*l)+c):(f=Math.max(0,-(o*s+a)),u=f>0?s:Math.min(Math.max(-s,-l),s),d=-f*f+u*(u+2*l)+c);else u=o>0?-s:s,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),r&&r.copy(Lf).addScaledVector(oc,u),d}intersectSphere(e,t){if(e.radius<0)return null;Er.subVectors(e.center,this.origin);let i=Er.dot(this.direction),r=Er.dot(Er)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,l,c=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,u=this.origin;return c>=0?(i=(e.min.x-u.x)*c,r=(e.max.x-u.x)*c):(i=(e.max.x-u.x)*c,r=(e.min.x-u.x)*c),h>=0?(s=(e.min.y-u.y)*h,o=(e.max.y-u.y)*h):(s=(e.max.y-u.y)*h,o=(e.min.y-u.y)*h),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),f>=0?(a=(e.min.z-u.z)*f,l=(e.max.z-u.z)*f):(a=(e.max.z-u.z)*f,l=(e.min.z-u.z)*f),i>l||a>r)||((a>i||i!==i)&&(i=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,Er)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,f=e.x-o.x,u=e.y-o.y,d=e.z-o.z,g=t.x-o.x,M=t.y-o.y,p=t.z-o.z,m=i.x-o.x,_=i.y-o.y,w=i.z-o.z,S=Math.abs(l),R=Math.abs(c),A=Math.abs(h),x,b,F,L,D,k,G,U,W,Y,V,ce;if(S>=R&&S>=A?(F=l,k=f,W=g,ce=m,l>=0?(x=c,b=h,L=u,D=d,G=M,U=p,Y=_,V=w):(x=h,b=c,L=d,D=u,G=p,U=M,Y=w,V=_)):R>=A?(F=c,k=u,W=M,ce=_,c>=0?(x=h,b=l,L=d,D=f,G=p,U=g,Y=w,V=m):(x=l,b=h,L=f,D=d,G=g,U=p,Y=m,V=w)):(F=h,k=d,W=p,ce=w,h>=0?(x=l,b=c,L=f,D=u,G=g,U=M,Y=m,V=_):(x=c,b=l,L=u,D=f,G=M,U=g,Y=_,V=m)),F===0)return null;let Z=x/F,j=b/F,re=1/F,ue=L-Z*k,fe=D-j*k,ee=G-Z*W,me=U-j*W,_e=Y-Z*ce,Ae=V-j*ce,ye=_e*me-Ae*ee,qe=ue*Ae-fe*_e,rt=ee*fe-me*ue;if(r){if(ye<0||qe<0||rt<0)return null}else if((ye<0||qe<0||rt<0)&&(ye>0||qe>0||rt>0))return null;let Ve=ye+qe+rt;if(Ve===0)return null;let dt=re*(ye*k+qe*W+rt*ce);return(Ve>0?dt<0:dt>0)?null:this.at(dt/Ve,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}};var sr=class extends Dn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cn,this.combine=Hs,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var hp=new Le,ms=new _o,lc=new ln,fp=new I,cc=new I,hc=new I,fc=new I,Df=new I,uc=new I,up=new I,dc=new I,St=class extends Jt{constructor(e=new Ot,t=new sr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){uc.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let h=a[l],f=s[l];h!==0&&(Df.fromBufferAttribute(f,e),o?uc.addScaledVector(Df,h):uc.addScaledVector(Df.sub(t),h))}t.add(uc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),lc.copy(i.boundingSphere),lc.applyMatrix4(s),ms.copy(e.ray).recast(e.near),!(lc.containsPoint(ms.origin)===!1&&(ms.intersectSphere(lc,fp)===null||ms.origin.distanceToSquared(fp)>(e.far-e.near)**2))&&(hp.copy(s).invert(),ms.copy(e.ray).applyMatrix4(hp),!(i.boundingBox!==null&&ms.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,ms)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,h=s.attributes.uv1,f=s.attributes.normal,u=s.groups,d=s.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,M=u.length;g<M;g++){let p=u[g],m=o[p.materialIndex],_=Math.max(p.start,d.start),w=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let S=_,R=w;S<R;S+=3){let A=a.getX(S),x=a.getX(S+1),b=a.getX(S+2);r=pc(this,m,e,i,c,h,f,A,x,b),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=p.materialIndex,t.push(r))}}else{let g=Math.max(0,d.start),M=Math.min(a.count,d.start+d.count);for(let p=g,m=M;p<m;p+=3){let _=a.getX(p),w=a.getX(p+1),S=a.getX(p+2);r=pc(this,o,e,i,c,h,f,_,w,S),r&&(r.faceIndex=Math.floor(p/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,M=u.length;g<M;g++){let p=u[g],m=o[p.materialIndex],_=Math.max(p.start,d.start),w=Math.min(l.count,Math.min(p.start+p.count,d.start+d.count));for(let S=_,R=w;S<R;S+=3){let A=S,x=S+1,b=S+2;r=pc(this,m,e,i,c,h,f,A,x,b),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=p.materialIndex,t.push(r))}}else{let g=Math.max(0,d.start),M=Math.min(l.count,d.start+d.count);for(let p=g,m=M;p<m;p+=3){let _=p,w=p+1,S=p+2;r=pc(this,o,e,i,c,h,f,_,w,S),r&&(r.faceIndex=Math.floor(p/3),t.push(r))}}}};function pM(n,e,t,i,r,s,o,a){let l;if(e.side===ei?l=i.intersectTriangle(o,s,r,!0,a):l=i.intersectTriangle(r,s,o,e.side===sn,a),l===null)return null;dc.copy(a),dc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(dc);return c<t.near||c>t.far?null:{distance:c,point:dc.clone(),object:n}}function pc(n,e,t,i,r,s,o,a,l,c){n.getVertexPosition(a,cc),n.getVertexPosition(l,hc),n.getVertexPosition(c,fc);let h=pM(n,e,t,i,cc,hc,fc,up);if(h){let f=new I;Yr.getBarycoord(up,cc,hc,fc,f),r&&(h.uv=Yr.getInterpolatedAttribute(r,a,l,c,f,new Ke)),s&&(h.uv1=Yr.getInterpolatedAttribute(s,a,l,c,f,new Ke)),o&&(h.normal=Yr.getInterpolatedAttribute(o,a,l,c,f,new I),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new I,materialIndex:0};Yr.getNormal(cc,hc,fc,u.normal),h.face=u,h.barycoord=f}return h}var Tr=class extends ui{constructor(e=null,t=1,i=1,r,s,o,a,l,c=Zt,h=Zt,f,u){super(null,o,a,l,c,h,r,s,f,u),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Zr=class extends Rt{constructor(e,t,i,r=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var vo=new Le,dp=new Le,mc=[],pp=new Pn,mM=new Le,qa=new St,Ya=new ln,$a=class extends St{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Zr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<i;r++)this.setMatrixAt(r,mM)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Pn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,vo),pp.copy(e.boundingBox).applyMatrix4(vo),this.boundingBox.union(pp)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new ln),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,vo),Ya.copy(e.boundingSphere).applyMatrix4(vo),this.boundingSphere.union(Ya)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,r=this.morphTexture.source.data.data,s=i.length+1,o=e*s+1;for(let a=0;a<i.length;a++)i[a]=r[o+a]}raycast(e,t){let i=this.matrixWorld,r=this.count;if(qa.geometry=this.geometry,qa.material=this.material,qa.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ya.copy(this.boundingSphere),Ya.applyMatrix4(i),e.ray.intersectsSphere(Ya)!==!1))for(let s=0;s<r;s++){this.getMatrixAt(s,vo),dp.multiplyMatrices(i,vo),qa.matrixWorld=dp,qa.raycast(e,mc);for(let o=0,a=mc.length;o<a;o++){let l=mc[o];l.instanceId=s,l.object=this,t.push(l)}mc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Zr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,r=i.length+1;this.morphTexture===null&&(this.morphTexture=new Tr(new Float32Array(r*this.count),r,this.count,qs,fi));let s=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=r*e;return s[l]=a,s.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}};var gs=new ln,gM=new Ke(.5,.5),gc=new I,cn=class{constructor(e=new Yi,t=new Yi,i=new Yi,r=new Yi,s=new Yi,o=new Yi){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Gi,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],h=s[4],f=s[5],u=s[6],d=s[7],g=s[8],M=s[9],p=s[10],m=s[11],_=s[12],w=s[13],S=s[14],R=s[15];if(r[0].setComponents(c-o,d-h,m-g,R-_).normalize(),r[1].setComponents(c+o,d+h,m+g,R+_).normalize(),r[2].setComponents(c+a,d+f,m+M,R+w).normalize(),r[3].setComponents(c-a,d-f,m-M,R-w).normalize(),i)r[4].setComponents(l,u,p,S).normalize(),r[5].setComponents(c-l,d-u,m-p,R-S).normalize();else if(r[4].setComponents(c-l,d-u,m-p,R-S).normalize(),t===Gi)r[5].setComponents(c+l,d+u,m+p,R+S).normalize();else if(t===Mr)r[5].setComponents(l,u,p,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),gs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),gs.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(gs)}intersectsSprite(e){gs.center.set(0,0,0);let t=gM.distanceTo(e.center);return gs.radius=.7071067811865476+t,gs.applyMatrix4(e.matrixWorld),this.intersectsSphere(gs)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(gc.x=r.normal.x>0?e.max.x:e.min.x,gc.y=r.normal.y>0?e.max.y:e.min.y,gc.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(gc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var mp=new Le,xc=class n{constructor(){this.coordinateSystem=Gi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];mp.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new cn),i[r].setFromProjectionMatrix(mp,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new cn),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Mo=class extends ui{constructor(e=[],t=nr,i,r,s,o,a,l,c,h){super(e,t,i,r,s,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var yn=class extends ui{constructor(e,t,i=Ii,r,s,o,a=Zt,l=Zt,c,h=an,f=1){if(h!==an&&h!==xn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:f};super(u,r,s,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Vr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}};var So=class extends yn{constructor(e,t=Ii,i=nr,r,s,o=Zt,a=Zt,l,c=an){let h={width:e,height:e,depth:1},f=[h,h,h,h,h,h];super(e,e,t,i,r,s,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}};var yo=class extends ui{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var or=class n extends Ot{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],h=[],f=[],u=0,d=0;g("z","y","x",-1,-1,i,t,e,o,s,0),g("z","y","x",1,-1,i,t,-e,o,s,1),g("x","z","y",1,1,e,i,t,r,o,2),g("x","z","y",1,-1,e,i,-t,r,o,3),g("x","y","z",1,-1,e,t,i,r,s,4),g("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(l),this.setAttribute("position",new Gt(c,3)),this.setAttribute("normal",new Gt(h,3)),this.setAttribute("uv",new Gt(f,2));function g(M,p,m,_,w,S,R,A,x,b,F){let L=S/x,D=R/b,k=S/2,G=R/2,U=A/2,W=x+1,Y=b+1,V=0,ce=0,Z=new I;for(let j=0;j<Y;j++){let re=j*D-G;for(let ue=0;ue<W;ue++){let fe=ue*L-k;Z[M]=fe*_,Z[p]=re*w,Z[m]=U,c.push(Z.x,Z.y,Z.z),Z[M]=0,Z[p]=0,Z[m]=A>0?1:-1,h.push(Z.x,Z.y,Z.z),f.push(ue/x),f.push(1-j/b),V+=1}}for(let j=0;j<b;j++)for(let re=0;re<x;re++){let ue=u+re+W*j,fe=u+re+W*(j+1),ee=u+(re+1)+W*(j+1),me=u+(re+1)+W*j;l.push(ue,fe,me),l.push(fe,ee,me),ce+=6}a.addGroup(d,ce,F),d+=ce,u+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var bo=class n extends Ot{constructor(e=1,t=1,i=1,r=32,s=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:l};let c=this;r=Math.floor(r),s=Math.floor(s);let h=[],f=[],u=[],d=[],g=0,M=[],p=i/2,m=0;_(),o===!1&&(e>0&&w(!0),t>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new Gt(f,3)),this.setAttribute("normal",new Gt(u,3)),this.setAttribute("uv",new Gt(d,2));function _(){let S=new I,R=new I,A=0,x=(t-e)/i;for(let b=0;b<=s;b++){let F=[],L=b/s,D=L*(t-e)+e;for(let k=0;k<=r;k++){let G=k/r,U=G*l+a,W=Math.sin(U),Y=Math.cos(U);R.x=D*W,R.y=-L*i+p,R.z=D*Y,f.push(R.x,R.y,R.z),S.set(W,x,Y).normalize(),u.push(S.x,S.y,S.z),d.push(G,1-L),F.push(g++)}M.push(F)}for(let b=0;b<r;b++)for(let F=0;F<s;F++){let L=M[F][b],D=M[F+1][b],k=M[F+1][b+1],G=M[F][b+1];(e>0||F!==0)&&(h.push(L,D,G),A+=3),(t>0||F!==s-1)&&(h.push(D,k,G),A+=3)}c.addGroup(m,A,0),m+=A}function w(S){let R=g,A=new Ke,x=new I,b=0,F=S===!0?e:t,L=S===!0?1:-1;for(let k=1;k<=r;k++)f.push(0,p*L,0),u.push(0,L,0),d.push(.5,.5),g++;let D=g;for(let k=0;k<=r;k++){let U=k/r*l+a,W=Math.cos(U),Y=Math.sin(U);x.x=F*Y,x.y=p*L,x.z=F*W,f.push(x.x,x.y,x.z),u.push(0,L,0),A.x=W*.5+.5,A.y=Y*.5*L+.5,d.push(A.x,A.y),g++}for(let k=0;k<r;k++){let G=R+k,U=D+k;S===!0?h.push(U,U+1,G):h.push(U+1,U,G),b+=3}c.addGroup(m,b,S===!0?1:2),m+=b}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var _c=class n extends bo{constructor(e=1,t=1,i=32,r=1,s=!1,o=0,a=Math.PI*2){super(0,e,t,i,r,s,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:r,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var wo=class n extends Ot{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),l=Math.floor(r),c=a+1,h=l+1,f=e/a,u=t/l,d=[],g=[],M=[],p=[];for(let m=0;m<h;m++){let _=m*u-o;for(let w=0;w<c;w++){let S=w*f-s;g.push(S,-_,0),M.push(0,0,1),p.push(w/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let _=0;_<a;_++){let w=_+c*m,S=_+c*(m+1),R=_+1+c*(m+1),A=_+1+c*m;d.push(w,S,A),d.push(S,R,A)}this.setIndex(d),this.setAttribute("position",new Gt(g,3)),this.setAttribute("normal",new Gt(M,3)),this.setAttribute("uv",new Gt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Eo=class n extends Ot{constructor(e=1,t=32,i=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],f=new I,u=new I,d=[],g=[],M=[],p=[];for(let m=0;m<=i;m++){let _=[],w=m/i,S=o+w*a,R=e*Math.cos(S),A=Math.sqrt(e*e-R*R),x=0;m===0&&o===0?x=.5/t:m===i&&l===Math.PI&&(x=-.5/t);for(let b=0;b<=t;b++){let F=b/t,L=r+F*s;f.x=-A*Math.cos(L),f.y=R,f.z=A*Math.sin(L),g.push(f.x,f.y,f.z),u.copy(f).normalize(),M.push(u.x,u.y,u.z),p.push(F+x,1-w),_.push(c++)}h.push(_)}for(let m=0;m<i;m++)for(let _=0;_<t;_++){let w=h[m][_+1],S=h[m][_],R=h[m+1][_],A=h[m+1][_+1];(m!==0||o>0)&&d.push(w,S,A),(m!==i-1||l<Math.PI)&&d.push(S,R,A)}this.setIndex(d),this.setAttribute("position",new Gt(g,3)),this.setAttribute("normal",new Gt(M,3)),this.setAttribute("uv",new Gt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Ar(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(gp(r))r.isRenderTargetTexture?(Ge("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(gp(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function $i(n){let e={};for(let t=0;t<n.length;t++){let i=Ar(n[t]);for(let r in i)e[r]=i[r]}return e}function gp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function xp(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function vc(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:ot.workingColorSpace}var _p={clone:Ar,merge:$i};var vp=`
void main() {
gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}
`;var Mp=`
void main() {
gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}
`;var tn=class extends Dn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=vp,this.fragmentShader=Mp,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ar(e.uniforms),this.uniformsGroups=xp(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new Xe().setHex(r.value);break;case"v2":this.uniforms[i].value=new Ke().fromArray(r.value);break;case"v3":this.uniforms[i].value=new I().fromArray(r.value);break;case"v4":this.uniforms[i].value=new bt().fromArray(r.value);break;case"m3":this.uniforms[i].value=new $e().fromArray(r.value);break;case"m4":this.uniforms[i].value=new Le().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}};var Mc=class extends tn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Rr=class extends Dn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Xe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=za,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cn,this.combine=Hs,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Sc=class extends Dn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Dd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}};var yc=class extends Dn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var To=class extends Jt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Xe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Ka=class extends To{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Jt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Xe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}};var Nf=new Le,Sp=new I,yp=new I,bc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=hi,this.map=null,this.mapPass=null,this.matrix=new Le,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new cn,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new bt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Sp.setFromMatrixPosition(e.matrixWorld),t.position.copy(Sp),yp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(yp),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,r){Nf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Nf,e.coordinateSystem,e.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,l=r?r.x/s.x:0,c=r?r.y/s.y:0;e.coordinateSystem===Mr||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Nf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var wc=new I,Ec=new Ft,ar=new I,Ao=class extends Jt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Le,this.projectionMatrix=new Le,this.projectionMatrixInverse=new Le,this.coordinateSystem=Gi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(wc,Ec,ar),ar.x===1&&ar.y===1&&ar.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(wc,Ec,ar.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(wc,Ec,ar),ar.x===1&&ar.y===1&&ar.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(wc,Ec,ar.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}};var Jr=new I,bp=new Ke,wp=new Ke,Bi=class extends Ao{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ga*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Yl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ga*2*Math.atan(Math.tan(Yl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Jr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Jr.x,Jr.y).multiplyScalar(-e/Jr.z),Jr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Jr.x,Jr.y).multiplyScalar(-e/Jr.z)}getViewSize(e,t){return this.getViewBounds(e,bp,wp),t.subVectors(wp,bp)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Yl*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*i/c,r*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ro=class extends Ao{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Tc=class extends bc{constructor(){super(new Ro(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}};var Za=class extends To{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Jt.DEFAULT_UP),this.updateMatrix(),this.target=new Jt,this.shadow=new Tc}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Co=-90,Po=1,xs=class extends Jt{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Bi(Co,Po,e,t);r.layers=this.layers,this.add(r);let s=new Bi(Co,Po,e,t);s.layers=this.layers,this.add(s);let o=new Bi(Co,Po,e,t);o.layers=this.layers,this.add(o);let a=new Bi(Co,Po,e,t);a.layers=this.layers,this.add(a);let l=new Bi(Co,Po,e,t);l.layers=this.layers,this.add(l);let c=new Bi(Co,Po,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===Gi)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Mr)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,h]=this.children,f=e.getRenderTarget(),u=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let M=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,r),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=M,e.setRenderTarget(i,5,r),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(f,u,d),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}};var Ac=class extends Bi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Ep=new Le,Ja=class{constructor(e,t,i=0,r=1/0){this.ray=new _o(e,t),this.near=i,this.far=r,this.camera=null,this.layers=new Xr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):ut("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Ep.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Ep),this}intersectObject(e,t=!0,i=[]){return If(e,this,i,t),i.sort(Tp),i}intersectObjects(e,t=!0,i=[]){for(let r=0,s=e.length;r<s;r++)If(e[r],this,i,t);return i.sort(Tp),i}};function Tp(n,e){return n.distance-e.distance}function If(n,e,t,i){let r=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(r=!1),r===!0&&i===!0){let s=n.children;for(let o=0,a=s.length;o<a;o++)If(s[o],e,t,!0)}}function Uf(n,e,t,i){let r=xM(i);switch(t){case Gl:return n*e;case qs:return n*e/r.components*r.byteLength;case Ys:return n*e/r.components*r.byteLength;case _n:return n*e*2/r.components*r.byteLength;case $s:return n*e*2/r.components*r.byteLength;case Hl:return n*e*3/r.components*r.byteLength;case Fi:return n*e*4/r.components*r.byteLength;case Ks:return n*e*4/r.components*r.byteLength;case Zs:case Js:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Qs:case js:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case fa:case da:return Math.max(n,16)*Math.max(e,8)/4;case ha:case ua:return Math.max(n,8)*Math.max(e,8)/2;case pa:case ma:case xa:case _a:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case ga:case as:case va:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ma:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Sa:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case ya:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case ba:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case wa:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Ea:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Ta:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Aa:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Ra:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Ca:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Pa:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case La:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Da:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Na:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Ia:case Ua:case Fa:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Oa:case Ba:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ls:case ka:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function xM(n){switch(n){case hi:case Ol:return{byteLength:1,components:1};case vr:case Bl:case Ui:return{byteLength:2,components:1};case Ws:case Xs:return{byteLength:2,components:4};case Ii:case Vs:case fi:return{byteLength:4,components:1};case kl:case zl:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ge("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Rc(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function Ap(n){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,f=c.byteLength,u=n.createBuffer();n.bindBuffer(l,u),n.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let h=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,h);else{f.sort((d,g)=>d.start-g.start);let u=0;for(let d=1;d<f.length;d++){let g=f[u],M=f[d];M.start<=g.start+g.count+1?g.count=Math.max(g.count,M.start+M.count-g.start):(++u,f[u]=M)}f.length=u+1;for(let d=0,g=f.length;d<g;d++){let M=f[d];n.bufferSubData(c,M.start*h.BYTES_PER_ELEMENT,h,M.start,M.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var Rp=`
#ifdef USE_ALPHAHASH
if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif
`;var Cp=`
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
`;var Pp=`
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif
`;var Lp=`
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif
`;var Dp=`
#ifdef USE_ALPHATEST
#ifdef ALPHA_TO_COVERAGE
diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
if ( diffuseColor.a == 0.0 ) discard;
#else
if ( diffuseColor.a < alphaTest ) discard;
#endif
#endif
`;var Np=`
#ifdef USE_ALPHATEST
uniform float alphaTest;
#endif
`;var Ip=`
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
`;var Up=`
#ifdef USE_AOMAP
uniform sampler2D aoMap;
uniform float aoMapIntensity;
#endif
`;var Fp=`
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
`;var Op=`
#ifdef USE_BATCHING
mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif
`;var Bp=`
vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
vPosition = vec3( position );
#endif
`;var kp=`
vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
vec3 objectTangent = vec3( tangent.xyz );
#endif
`;var zp=`
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
`;var Gp=`
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
`;var Hp=`
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
`;var Vp=`
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
`;var Wp=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif
`;var Xp=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
#endif
`;var qp=`
#if NUM_CLIPPING_PLANES > 0
vClipPosition = - mvPosition.xyz;
#endif
`;var Yp=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
diffuseColor *= vColor;
#endif
`;var $p=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
varying vec4 vColor;
#endif
`;var Kp=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
varying vec4 vColor;
#endif
`;var Zp=`
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
`;var Jp=`
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
`;var Qp=`
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
`;var jp=`
#ifdef USE_DISPLACEMENTMAP
uniform sampler2D displacementMap;
uniform float displacementScale;
uniform float displacementBias;
#endif
`;var em=`
#ifdef USE_DISPLACEMENTMAP
transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif
`;var tm=`
#ifdef USE_EMISSIVEMAP
vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
emissiveColor = sRGBTransferEOTF( emissiveColor );
#endif
totalEmissiveRadiance *= emissiveColor.rgb;
#endif
`;var im=`
#ifdef USE_EMISSIVEMAP
uniform sampler2D emissiveMap;
#endif
`;var nm=`
gl_FragColor = linearToOutputTexel( gl_FragColor );
`;var rm=`
vec4 LinearTransferOETF( in vec4 value ) {
return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}
`;var sm=`
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
`;var om=`
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
`;var am=`
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
`;var lm=`
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
`;var cm=`
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
`;var hm=`
#ifdef USE_FOG
vFogDepth = - mvPosition.z;
#endif
`;var fm=`
#ifdef USE_FOG
varying float vFogDepth;
#endif
`;var um=`
#ifdef USE_FOG
#ifdef FOG_EXP2
float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
#else
float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
#endif
gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif
`;var dm=`
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
`;var pm=`
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
`;var mm=`
#ifdef USE_LIGHTMAP
uniform sampler2D lightMap;
uniform float lightMapIntensity;
#endif
`;var gm=`
LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;
`;var xm=`
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
`;var _m=`
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
`;var vm=`
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
`;var Mm=`
ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;
`;var Sm=`
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
`;var ym=`
BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;
`;var bm=`
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
`;var wm=`
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
`;var Em=`
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
`;var Tm=`
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
`;var Am=`
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
`;var Rm=`
#if defined( RE_IndirectDiffuse )
#if defined( LAMBERT ) || defined( PHONG )
irradiance += iblIrradiance;
#endif
RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
`;var Cm=`
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
`;var Pm=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif
`;var Lm=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
uniform float logDepthBufFC;
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var Dm=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var Nm=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
vFragDepth = 1.0 + gl_Position.w;
vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif
`;var Im=`
#ifdef USE_MAP
vec4 sampledDiffuseColor = texture2D( map, vMapUv );
#ifdef DECODE_VIDEO_TEXTURE
sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
#endif
diffuseColor *= sampledDiffuseColor;
#endif
`;var Um=`
#ifdef USE_MAP
uniform sampler2D map;
#endif
`;var Fm=`
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
`;var Om=`
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
`;var Bm=`
float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
metalnessFactor *= texelMetalness.b;
#endif
`;var km=`
#ifdef USE_METALNESSMAP
uniform sampler2D metalnessMap;
#endif
`;var zm=`
#ifdef USE_INSTANCING_MORPH
float morphTargetInfluences[ MORPHTARGETS_COUNT ];
float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
}
#endif
`;var Gm=`
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
`;var Hm=`
#ifdef USE_MORPHNORMALS
objectNormal *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var Vm=`
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
`;var Wm=`
#ifdef USE_MORPHTARGETS
transformed *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var Xm=`
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
`;var qm=`
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
`;var Ym=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var $m=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var Km=`
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
`;var Zm=`
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
`;var Jm=`
#ifdef USE_CLEARCOAT
vec3 clearcoatNormal = nonPerturbedNormal;
#endif
`;var Qm=`
#ifdef USE_CLEARCOAT_NORMALMAP
vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
clearcoatMapN.xy *= clearcoatNormalScale;
clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif
`;var jm=`
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
`;var eg=`
#ifdef USE_IRIDESCENCEMAP
uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform sampler2D iridescenceThicknessMap;
#endif
`;var tg=`
#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );
`;var ig=`
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
`;var ng=`
#ifdef PREMULTIPLIED_ALPHA
gl_FragColor.rgb *= gl_FragColor.a;
#endif
`;var rg=`
vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;
`;var sg=`
#ifdef DITHERING
gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif
`;var og=`
#ifdef DITHERING
vec3 dithering( vec3 color ) {
float grid_position = rand( gl_FragCoord.xy );
vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
return color + dither_shift_RGB;
}
#endif
`;var ag=`
float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
roughnessFactor *= texelRoughness.g;
#endif
`;var lg=`
#ifdef USE_ROUGHNESSMAP
uniform sampler2D roughnessMap;
#endif
`;var cg=`
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
`;var hg=`
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
`;var fg=`
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
`;var ug=`
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
`;var dg=`
#ifdef USE_SKINNING
mat4 boneMatX = getBoneMatrix( skinIndex.x );
mat4 boneMatY = getBoneMatrix( skinIndex.y );
mat4 boneMatZ = getBoneMatrix( skinIndex.z );
mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif
`;var pg=`
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
`;var mg=`
#ifdef USE_SKINNING
vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
vec4 skinned = vec4( 0.0 );
skinned += boneMatX * skinVertex * skinWeight.x;
skinned += boneMatY * skinVertex * skinWeight.y;
skinned += boneMatZ * skinVertex * skinWeight.z;
skinned += boneMatW * skinVertex * skinWeight.w;
transformed = ( bindMatrixInverse * skinned ).xyz;
#endif
`;var gg=`
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
`;var xg=`
float specularStrength;
#ifdef USE_SPECULARMAP
vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
specularStrength = texelSpecular.r;
#else
specularStrength = 1.0;
#endif
`;var _g=`
#ifdef USE_SPECULARMAP
uniform sampler2D specularMap;
#endif
`;var vg=`
#if defined( TONE_MAPPING )
gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif
`;var Mg=`
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
`;var Sg=`
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
`;var yg=`
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
`;var bg=`
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
`;var wg=`
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
`;var Eg=`
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
`;var Tg=`
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
`;var Ag=`
varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
gl_Position = vec4( position.xy, 1.0, 1.0 );
}
`,Rg=`
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
`;var Cg=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,Pg=`
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
`;var Lg=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,Dg=`
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
`;var Ng=`
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
`,Ig=`
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
`;var Ug=`
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
`,Fg=`
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
`;var Og=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
}
`,Bg=`
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
`;var kg=`
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
`,zg=`
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
`;var Gg=`
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
`,Hg=`
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
`;var Vg=`
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
`,Wg=`
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
`;var Xg=`
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
`,qg=`
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
`;var Yg=`
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
`,$g=`
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
`;var Kg=`
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
`,Zg=`
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
`;var Jg=`
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
`,Qg=`
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
`;var jg=`
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
`,e0=`
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
`;var t0=`
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
`,i0=`
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
`;var n0=`
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
`,r0=`
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
`;var s0=`
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
`,o0=`
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
`;var at={alphahash_fragment:Rp,alphahash_pars_fragment:Cp,alphamap_fragment:Pp,alphamap_pars_fragment:Lp,alphatest_fragment:Dp,alphatest_pars_fragment:Np,aomap_fragment:Ip,aomap_pars_fragment:Up,batching_pars_vertex:Fp,batching_vertex:Op,begin_vertex:Bp,beginnormal_vertex:kp,bsdfs:zp,iridescence_fragment:Gp,bumpmap_pars_fragment:Hp,clipping_planes_fragment:Vp,clipping_planes_pars_fragment:Wp,clipping_planes_pars_vertex:Xp,clipping_planes_vertex:qp,color_fragment:Yp,color_pars_fragment:$p,color_pars_vertex:Kp,color_vertex:Zp,common:Jp,defaultnormal_vertex:Qp,displacementmap_pars_vertex:jp,displacementmap_vertex:em,emissivemap_fragment:tm,emissivemap_pars_fragment:im,colorspace_fragment:nm,colorspace_pars_fragment:rm,envmap_fragment:sm,envmap_common_pars_fragment:om,envmap_pars_fragment:am,envmap_pars_vertex:lm,envmap_physical_pars_fragment:vm,envmap_vertex:cm,fog_vertex:hm,fog_pars_vertex:fm,fog_fragment:um,fog_pars_fragment:dm,gradientmap_pars_fragment:pm,lightmap_pars_fragment:mm,lights_lambert_fragment:gm,lights_lambert_pars_fragment:xm,lights_pars_begin:_m,lights_toon_fragment:Mm,lights_toon_pars_fragment:Sm,lights_phong_fragment:ym,lights_phong_pars_fragment:bm,lights_physical_fragment:wm,lights_physical_pars_fragment:Em,lights_fragment_begin:Tm,lights_fragment_maps:Am,lights_fragment_end:Rm,lightprobes_pars_fragment:Cm,logdepthbuf_fragment:Pm,logdepthbuf_pars_fragment:Lm,logdepthbuf_pars_vertex:Dm,logdepthbuf_vertex:Nm,map_fragment:Im,map_pars_fragment:Um,map_particle_fragment:Fm,map_particle_pars_fragment:Om,metalnessmap_fragment:Bm,metalnessmap_pars_fragment:km,morphinstance_vertex:zm,morphcolor_vertex:Gm,morphnormal_vertex:Hm,morphtarget_pars_vertex:Vm,morphtarget_vertex:Wm,normal_fragment_begin:Xm,normal_fragment_maps:qm,normal_pars_fragment:Ym,normal_pars_vertex:$m,normal_vertex:Km,normalmap_pars_fragment:Zm,clearcoat_normal_fragment_begin:Jm,clearcoat_normal_fragment_maps:Qm,clearcoat_pars_fragment:jm,iridescence_pars_fragment:eg,opaque_fragment:tg,packing:ig,premultiplied_alpha_fragment:ng,project_vertex:rg,dithering_fragment:sg,dithering_pars_fragment:og,roughnessmap_fragment:ag,roughnessmap_pars_fragment:lg,shadowmap_pars_fragment:cg,shadowmap_pars_vertex:hg,shadowmap_vertex:fg,shadowmask_pars_fragment:ug,skinbase_vertex:dg,skinning_pars_vertex:pg,skinning_vertex:mg,skinnormal_vertex:gg,specularmap_fragment:xg,specularmap_pars_fragment:_g,tonemapping_fragment:vg,tonemapping_pars_fragment:Mg,transmission_fragment:Sg,transmission_pars_fragment:yg,uv_pars_fragment:bg,uv_pars_vertex:wg,uv_vertex:Eg,worldpos_vertex:Tg,background_vert:Ag,background_frag:Rg,backgroundCube_vert:Cg,backgroundCube_frag:Pg,cube_vert:Lg,cube_frag:Dg,depth_vert:Ng,depth_frag:Ig,distance_vert:Ug,distance_frag:Fg,equirect_vert:Og,equirect_frag:Bg,linedashed_vert:kg,linedashed_frag:zg,meshbasic_vert:Gg,meshbasic_frag:Hg,meshlambert_vert:Vg,meshlambert_frag:Wg,meshmatcap_vert:Xg,meshmatcap_frag:qg,meshnormal_vert:Yg,meshnormal_frag:$g,meshphong_vert:Kg,meshphong_frag:Zg,meshphysical_vert:Jg,meshphysical_frag:Qg,meshtoon_vert:jg,meshtoon_frag:e0,points_vert:t0,points_frag:i0,shadow_vert:n0,shadow_frag:r0,sprite_vert:s0,sprite_frag:o0};var De={common:{diffuse:{value:new Xe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new $e},alphaMap:{value:null},alphaMapTransform:{value:new $e},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new $e}},envmap:{envMap:{value:null},envMapRotation:{value:new $e},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new $e}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new $e}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new $e},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new $e},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new $e},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new $e}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new $e}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new $e}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Xe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Xe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new $e},alphaTest:{value:0},uvTransform:{value:new $e}},sprite:{diffuse:{value:new Xe(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new $e},alphaMap:{value:null},alphaMapTransform:{value:new $e},alphaTest:{value:0}}};var Nn={basic:{uniforms:$i([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:at.meshbasic_vert,fragmentShader:at.meshbasic_frag},lambert:{uniforms:$i([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new Xe(0)},envMapIntensity:{value:1}}]),vertexShader:at.meshlambert_vert,fragmentShader:at.meshlambert_frag},phong:{uniforms:$i([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new Xe(0)},specular:{value:new Xe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:at.meshphong_vert,fragmentShader:at.meshphong_frag},standard:{uniforms:$i([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new Xe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag},toon:{uniforms:$i([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new Xe(0)}}]),vertexShader:at.meshtoon_vert,fragmentShader:at.meshtoon_frag},matcap:{uniforms:$i([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:at.meshmatcap_vert,fragmentShader:at.meshmatcap_frag},points:{uniforms:$i([De.points,De.fog]),vertexShader:at.points_vert,fragmentShader:at.points_frag},dashed:{uniforms:$i([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:at.linedashed_vert,fragmentShader:at.linedashed_frag},depth:{uniforms:$i([De.common,De.displacementmap]),vertexShader:at.depth_vert,fragmentShader:at.depth_frag},normal:{uniforms:$i([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:at.meshnormal_vert,fragmentShader:at.meshnormal_frag},sprite:{uniforms:$i([De.sprite,De.fog]),vertexShader:at.sprite_vert,fragmentShader:at.sprite_frag},background:{uniforms:{uvTransform:{value:new $e},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:at.background_vert,fragmentShader:at.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new $e}},vertexShader:at.backgroundCube_vert,fragmentShader:at.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:at.cube_vert,fragmentShader:at.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:at.equirect_vert,fragmentShader:at.equirect_frag},distance:{uniforms:$i([De.common,De.displacementmap,{referencePosition:{value:new I},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:at.distance_vert,fragmentShader:at.distance_frag},shadow:{uniforms:$i([De.lights,De.fog,{color:{value:new Xe(0)},opacity:{value:1}}]),vertexShader:at.shadow_vert,fragmentShader:at.shadow_frag}};Nn.physical={uniforms:$i([Nn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new $e},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new $e},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new $e},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new $e},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new $e},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new $e},sheen:{value:0},sheenColor:{value:new Xe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new $e},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new $e},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new $e},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new $e},attenuationDistance:{value:0},attenuationColor:{value:new Xe(0)},specularColor:{value:new Xe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new $e},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new $e},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new $e}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag};var Cc={r:0,b:0,g:0},UM=new Le,a0=new $e;a0.set(-1,0,0,0,1,0,0,0,1);function l0(n,e,t,i,r,s){let o=new Xe(0),a=r===!0?0:1,l,c,h=null,f=0,u=null;function d(_){let w=_.isScene===!0?_.background:null;if(w&&w.isTexture){let S=_.backgroundBlurriness>0;w=e.get(w,S)}return w}function g(_){let w=!1,S=d(_);S===null?p(o,a):S&&S.isColor&&(p(S,1),w=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,s):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||w)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function M(_,w){let S=d(w);S&&S.isCubeTexture?(c===void 0&&(c=new St(new or(1,1,1),new tn({name:"BackgroundCubeMaterial",uniforms:Ar(Nn.backgroundCube.uniforms),vertexShader:Nn.backgroundCube.vertexShader,fragmentShader:Nn.backgroundCube.fragmentShader,side:ei,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(UM.makeRotationFromEuler(w.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(a0),c.material.toneMapped=ot.getTransfer(S.colorSpace)!==_t,(h!==S||f!==S.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=S,f=S.version,u=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new St(new wo(2,2),new tn({name:"BackgroundMaterial",uniforms:Ar(Nn.background.uniforms),vertexShader:Nn.background.vertexShader,fragmentShader:Nn.background.fragmentShader,side:sn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=ot.getTransfer(S.colorSpace)!==_t,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||f!==S.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=S,f=S.version,u=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function p(_,w){_.getRGB(Cc,vc(n)),t.buffers.color.setClear(Cc.r,Cc.g,Cc.b,w,s)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,w=1){o.set(_),a=w,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,p(o,a)},render:g,addToRenderList:M,dispose:m}}function c0(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=u(null),s=r,o=!1;function a(D,k,G,U,W){let Y=!1,V=f(D,U,G,k);s!==V&&(s=V,c(s.object)),Y=d(D,U,G,W),Y&&g(D,U,G,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(D,k,G,U),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function h(D){return n.deleteVertexArray(D)}function f(D,k,G,U){let W=U.wireframe===!0,Y=i[k.id];Y===void 0&&(Y={},i[k.id]=Y);let V=D.isInstancedMesh===!0?D.id:0,ce=Y[V];ce===void 0&&(ce={},Y[V]=ce);let Z=ce[G.id];Z===void 0&&(Z={},ce[G.id]=Z);let j=Z[W];return j===void 0&&(j=u(l()),Z[W]=j),j}function u(D){let k=[],G=[],U=[];for(let W=0;W<t;W++)k[W]=0,G[W]=0,U[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:G,attributeDivisors:U,object:D,attributes:{},index:null}}function d(D,k,G,U){let W=s.attributes,Y=k.attributes,V=0,ce=G.getAttributes();for(let Z in ce)if(ce[Z].location>=0){let re=W[Z],ue=Y[Z];if(ue===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(ue=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(ue=D.instanceColor)),re===void 0||re.attribute!==ue||ue&&re.data!==ue.data)return!0;V++}return s.attributesNum!==V||s.index!==U}function g(D,k,G,U){let W={},Y=k.attributes,V=0,ce=G.getAttributes();for(let Z in ce)if(ce[Z].location>=0){let re=Y[Z];re===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(re=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(re=D.instanceColor));let ue={};ue.attribute=re,re&&re.data&&(ue.data=re.data),W[Z]=ue,V++}s.attributes=W,s.attributesNum=V,s.index=U}function M(){let D=s.newAttributes;for(let k=0,G=D.length;k<G;k++)D[k]=0}function p(D){m(D,0)}function m(D,k){let G=s.newAttributes,U=s.enabledAttributes,W=s.attributeDivisors;G[D]=1,U[D]===0&&(n.enableVertexAttribArray(D),U[D]=1),W[D]!==k&&(n.vertexAttribDivisor(D,k),W[D]=k)}function _(){let D=s.newAttributes,k=s.enabledAttributes;for(let G=0,U=k.length;G<U;G++)k[G]!==D[G]&&(n.disableVertexAttribArray(G),k[G]=0)}function w(D,k,G,U,W,Y,V){V===!0?n.vertexAttribIPointer(D,k,G,W,Y):n.vertexAttribPointer(D,k,G,U,W,Y)}function S(D,k,G,U){M();let W=U.attributes,Y=G.getAttributes(),V=k.defaultAttributeValues;for(let ce in Y){let Z=Y[ce];if(Z.location>=0){let j=W[ce];if(j===void 0&&(ce==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),ce==="instanceColor"&&D.instanceColor&&(j=D.instanceColor)),j!==void 0){let re=j.normalized,ue=j.itemSize,fe=e.get(j);if(fe===void 0)continue;let ee=fe.buffer,me=fe.type,_e=fe.bytesPerElement,Ae=me===n.INT||me===n.UNSIGNED_INT||j.gpuType===Vs;if(j.isInterleavedBufferAttribute){let ye=j.data,qe=ye.isInterleavedBuffer===!0?ye.stride:ye.itemSize,rt=j.offset;if(ye.isInstancedInterleavedBuffer||ye.isInstancedBufferAttribute){for(let Ve=0;Ve<Z.locationSize;Ve++)m(Z.location+Ve,ye.meshPerAttribute);D.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=ye.meshPerAttribute*ye.count)}else for(let Ve=0;Ve<Z.locationSize;Ve++)p(Z.location+Ve);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ve=0;Ve<Z.locationSize;Ve++)w(Z.location+Ve,ue/Z.locationSize,me,re,qe*_e,(rt+ue/Z.locationSize*Ve)*_e,Ae)}else{if(j.isInstancedBufferAttribute){for(let ye=0;ye<Z.locationSize;ye++)m(Z.location+ye,j.meshPerAttribute);D.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let ye=0;ye<Z.locationSize;ye++)p(Z.location+ye);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let ye=0;ye<Z.locationSize;ye++)w(Z.location+ye,ue/Z.locationSize,me,re,ue*_e,ue/Z.locationSize*ye*_e,Ae)}}else if(V!==void 0){let re=V[ce];if(re!==void 0)switch(re.length){case 2:n.vertexAttrib2fv(Z.location,re);break;case 3:n.vertexAttrib3fv(Z.location,re);break;case 4:n.vertexAttrib4fv(Z.location,re);break;default:n.vertexAttrib1fv(Z.location,re)}}}}_()}function R(){F();for(let D in i){let k=i[D];for(let G in k){let U=k[G];for(let W in U){let Y=U[W];for(let V in Y)h(Y[V].object),delete Y[V];delete U[W]}}delete i[D]}}function A(D){if(i[D.id]===void 0)return;let k=i[D.id];for(let G in k){let U=k[G];for(let W in U){let Y=U[W];for(let V in Y)h(Y[V].object),delete Y[V];delete U[W]}}delete i[D.id]}function x(D){for(let k in i){let G=i[k];for(let U in G){let W=G[U];if(W[D.id]===void 0)continue;let Y=W[D.id];for(let V in Y)h(Y[V].object),delete Y[V];delete W[D.id]}}}function b(D){for(let k in i){let G=i[k],U=D.isInstancedMesh===!0?D.id:0,W=G[U];if(W!==void 0){for(let Y in W){let V=W[Y];for(let ce in V)h(V[ce].object),delete V[ce];delete W[Y]}delete G[U],Object.keys(G).length===0&&delete i[k]}}}function F(){L(),o=!0,s!==r&&(s=r,c(s.object))}function L(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:F,resetDefaultState:L,dispose:R,releaseStatesOfGeometry:A,releaseStatesOfObject:b,releaseStatesOfProgram:x,initAttributes:M,enableAttribute:p,disableUnusedAttributes:_}}function h0(n,e,t){let i;function r(l){i=l}function s(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),t.update(c,i,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let u=0;for(let d=0;d<h;d++)u+=c[d];t.update(u,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function f0(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(x){return!(x!==Fi&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let b=x===Ui&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==hi&&x!==fi&&!b&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ge("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Ge("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Ge("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:M,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:_,maxVaryings:w,maxFragmentUniforms:S,maxSamples:R,samples:A}}function u0(n){let e=this,t=null,i=0,r=!1,s=!1,o=new Yi,a=new $e,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,u){let d=f.length!==0||u||i!==0||r;return r=u,i=f.length,d},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(f,u){t=h(f,u,0)},this.setState=function(f,u,d){let g=f.clippingPlanes,M=f.clipIntersection,p=f.clipShadows,m=n.get(f);if(!r||g===null||g.length===0||s&&!p)s?h(null):c();else{let _=s?0:i,w=_*4,S=m.clippingState||null;l.value=S,S=h(g,u,w,d);for(let R=0;R!==w;++R)S[R]=t[R];m.clippingState=S,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(f,u,d,g){let M=f!==null?f.length:0,p=null;if(M!==0){if(p=l.value,g!==!0||p===null){let m=d+M*4,_=u.matrixWorldInverse;a.getNormalMatrix(_),(p===null||p.length<m)&&(p=new Float32Array(m));for(let w=0,S=d;w!==M;++w,S+=4)o.copy(f[w]).applyMatrix4(_,a),o.normal.toArray(p,S),p[S+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=M,e.numIntersection=0,p}}var Qr=class extends Hi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new Mo(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new or(5,5,5),s=new tn({name:"CubemapFromEquirect",uniforms:Ar(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ei,blending:ir});s.uniforms.tEquirect.value=t;let o=new St(r,s),a=t.minFilter;return t.minFilter===gn&&(t.minFilter=Mi),new xs(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}};var d0=256,FM=3,OM=20,x0=256,_0=16,BM=3,kM=new I,zM=new Xe,Qa=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new xs(1,10,null),this._boxMesh=new St(new or(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=kM}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,u=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,M=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,M===null&&(e.background=l.getClearColor(zM));let p=new xs(i,r,h);return p.position.copy(a),p.update(l,e),l.autoClear=f,l.autoClearColor=u,l.autoClearDepth=d,l.autoClearStencil=g,e.background=M,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=g0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=m0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(d0,Kd(e))}_fromTexture(e,t){e.mapping===nr||e.mapping===Hr?this._setSize(e.image.length===0?d0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=p0(e,!1,!1),i=Math.log2(e)-FM;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=p0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===nr||e.mapping===Hr?(this._cubemapMaterial===null&&(this._cubemapMaterial=g0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=m0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=GM(),this._integrationMaterial=HM());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/_0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-BM)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(x0*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=VM());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function p0(n,e,t){return new Qr(n,{minFilter:gn,generateMipmaps:e,type:Ui,colorSpace:cs,depthBuffer:t})}function ja(n,e,t){return new tn({name:n,uniforms:e,vertexShader:at.cube_vert,fragmentShader:t,side:ei,blending:ir,depthTest:!1,depthWrite:!1})}function GM(){return ja("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${x0}u

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
	`)}function HM(){return ja("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:_0}},`

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
	`)}function VM(){return ja("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${OM}
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
	`)}function m0(){return ja("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function g0(){return ja("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function v0(n){let e=new WeakMap,t=new WeakMap,i=null;function r(u,d=!1){return u==null?null:d?o(u):s(u)}function s(u){if(u&&u.isTexture){let d=u.mapping;if(d===Il||d===Ul)if(e.has(u)){let g=e.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let M=new Qr(g.height);return M.fromEquirectangularTexture(n,u),e.set(u,M),u.addEventListener("dispose",c),a(M.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let d=u.mapping,g=d===Il||d===Ul,M=d===nr||d===Hr;if(g||M){let p=t.get(u),m=p!==void 0?p.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==m)return i===null&&(i=new Qa(n)),p=g?i.fromEquirectangular(u,p):i.fromCubemap(u,p),p.texture.pmremVersion=u.pmremVersion,t.set(u,p),p.texture;if(p!==void 0)return p.texture;{let _=u.image;return g&&_&&_.height>0||M&&_&&l(_)?(i===null&&(i=new Qa(n)),p=g?i.fromEquirectangular(u):i.fromCubemap(u),p.texture.pmremVersion=u.pmremVersion,t.set(u,p),u.addEventListener("dispose",h),p.texture):null}}}return u}function a(u,d){return d===Il?u.mapping=nr:d===Ul&&(u.mapping=Hr),u}function l(u){let d=0,g=6;for(let M=0;M<g;M++)u[M]!==void 0&&d++;return d===g}function c(u){let d=u.target;d.removeEventListener("dispose",c);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function h(u){let d=u.target;d.removeEventListener("dispose",h);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:f}}function M0(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&fs("WebGLRenderer: "+i+" extension not supported."),r}}}function S0(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(g=>delete r[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete r[g.id],o.unregister(g);let M=s.get(g);M&&(e.remove(M),s.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,M){return r[M.id]!==void 0||(M.addEventListener("dispose",a),r[M.id]=new WeakRef(M),o.register(M,M.id,M),t.memory.geometries++),M}function h(g){let M=g.attributes;for(let p in M)e.update(M[p],n.ARRAY_BUFFER)}function f(g){let M=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let _=M!==null?M.array.length:p.array.length/3-1,w=p.count>=65535?go:mo,S=new w(Math.ceil(_/3)*6,1),R=S.array;if(M!==null){let x=M.array;m=M.version;for(let b=0,F=0;b<_;b+=3){let L=x[b+0],D=x[b+1],k=x[b+2];R[F++]=L,R[F++]=D,R[F++]=D,R[F++]=k,R[F++]=k,R[F++]=L}}else{m=p.version;for(let x=0,b=0;x<_;x+=3){let F=x+0,L=x+1,D=x+2;R[b++]=F,R[b++]=L,R[b++]=L,R[b++]=D,R[b++]=D,R[b++]=F}}S.version=m;let A=s.get(g);A&&e.remove(A),s.set(g,S)}function u(g){let M=s.get(g);if(M){let p=g.index;p!==null&&M.version<p.version&&f(g)}else f(g);return s.get(g)}function d(){for(let g in r){let M=r[g].deref();M!==void 0&&l(M)}}return{get:c,update:h,getWireframeAttribute:u,dispose:d}}function y0(n,e,t){let i;function r(f){i=f}let s,o;function a(f){s=f.type,o=f.bytesPerElement}function l(f,u){n.drawElements(i,u,s,f*o),t.update(u,i,1)}function c(f,u,d){d!==0&&(n.drawElementsInstanced(i,u,s,f*o,d),t.update(u,i,d))}function h(f,u,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,s,f,0,d);let M=0;for(let p=0;p<d;p++)M+=u[p];t.update(M,i,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function b0(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:ut("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function w0(n,e,t){let i=new WeakMap,r=new bt;function s(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=h!==void 0?h.length:0,u=i.get(a);if(u===void 0||u.count!==f){let F=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",F)};u!==void 0&&u.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,M=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],w=0;d===!0&&(w=1),g===!0&&(w=2),M===!0&&(w=3);let S=a.attributes.position.count*w,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let A=new Float32Array(S*R*4*f),x=new no(A,S,R,f);x.type=fi,x.needsUpdate=!0;let b=w*4;for(let L=0;L<f;L++){let D=p[L],k=m[L],G=_[L],U=S*R*4*L;for(let W=0;W<D.count;W++){let Y=W*b;d===!0&&(r.fromBufferAttribute(D,W),A[U+Y+0]=r.x,A[U+Y+1]=r.y,A[U+Y+2]=r.z,A[U+Y+3]=0),g===!0&&(r.fromBufferAttribute(k,W),A[U+Y+4]=r.x,A[U+Y+5]=r.y,A[U+Y+6]=r.z,A[U+Y+7]=0),M===!0&&(r.fromBufferAttribute(G,W),A[U+Y+8]=r.x,A[U+Y+9]=r.y,A[U+Y+10]=r.z,A[U+Y+11]=G.itemSize===4?r.w:1)}}u={count:f,texture:x,size:new Ke(S,R)},i.set(a,u),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let M=0;M<c.length;M++)d+=c[M];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:s}}function E0(n,e,t,i,r){let s=new WeakMap;function o(c){let h=r.render.frame,f=c.geometry,u=e.get(c,f);if(s.get(u)!==h&&(e.update(u),s.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==h&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),s.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;s.get(d)!==h&&(d.update(),s.set(d,h))}return u}function a(){s=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var WM={[Al]:"LINEAR_TONE_MAPPING",[Rl]:"REINHARD_TONE_MAPPING",[Cl]:"CINEON_TONE_MAPPING",[Pl]:"ACES_FILMIC_TONE_MAPPING",[Dl]:"AGX_TONE_MAPPING",[Nl]:"NEUTRAL_TONE_MAPPING",[Ll]:"CUSTOM_TONE_MAPPING"};function T0(n,e,t,i,r,s){let o=new Hi(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Ot;h.setAttribute("position",new Gt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Gt([0,2,0,0,2,0],2));let f=new Mc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new St(h,f),d=new Ro(-1,1,1,-1,0,1),g=null,M=null,p=!1,m,_=null,w=[],S=!1;this.setSize=function(R,A){o.setSize(R,A),a!==null&&a.setSize(R,A),l!==null&&l.setSize(R,A);for(let x=0;x<w.length;x++){let b=w[x];b.setSize&&b.setSize(R,A)}},this.setEffects=function(R){w=R,S=w.length>0&&w[0].isRenderPass===!0;let A=o.width,x=o.height;w.length>0&&a===null&&(a=new Hi(A,x,{type:Ui,depthBuffer:!1,stencilBuffer:!1}),l=new Hi(A,x,{type:Ui,depthBuffer:!1,stencilBuffer:!1}));let b=r===!0&&w.some(F=>F.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new yn(A,x),s===!0&&(c.format=xn,c.type=zn)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let F=0;F<w.length;F++){let L=w[F];L.setSize&&L.setSize(A,x),b&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(R,A){if(p||R.toneMapping===mn&&w.length===0)return!1;if(_=A,A!==null){let x=A.width,b=A.height;(o.width!==x||o.height!==b)&&this.setSize(x,b)}return S===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=mn,!0},this.hasRenderPass=function(){return S},this.end=function(R,A){R.toneMapping=m,p=!0;let x=o,b=a;for(let F=0;F<w.length;F++){let L=w[F];L.enabled!==!1&&(L.render(R,b,x,A),L.needsSwap!==!1&&(x=b,b=b===a?l:a))}if(g!==R.outputColorSpace||M!==R.toneMapping){g=R.outputColorSpace,M=R.toneMapping,f.defines={},ot.getTransfer(g)===_t&&(f.defines.SRGB_TRANSFER="");let F=WM[M];F&&(f.defines[F]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,R.setRenderTarget(_),R.render(u,d),_=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),f.dispose()}}var N0=new ui,I0=new yn(1,1),U0=new So(1),F0=new no,O0=new Ql,B0=new Mo,A0=[],R0=[],C0=new Float32Array(16),P0=new Float32Array(9),L0=new Float32Array(4);function Lo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=A0[r];if(s===void 0&&(s=new Float32Array(r),A0[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function Ei(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Ti(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Pc(n,e){let t=R0[e];t===void 0&&(t=new Int32Array(e),R0[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function XM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function qM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ei(t,e))return;n.uniform2fv(this.addr,e),Ti(t,e)}}function YM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ei(t,e))return;n.uniform3fv(this.addr,e),Ti(t,e)}}function $M(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ei(t,e))return;n.uniform4fv(this.addr,e),Ti(t,e)}}function KM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ei(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Ti(t,e)}else{if(Ei(t,i))return;L0.set(i),n.uniformMatrix2fv(this.addr,!1,L0),Ti(t,i)}}function ZM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ei(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Ti(t,e)}else{if(Ei(t,i))return;P0.set(i),n.uniformMatrix3fv(this.addr,!1,P0),Ti(t,i)}}function JM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ei(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Ti(t,e)}else{if(Ei(t,i))return;C0.set(i),n.uniformMatrix4fv(this.addr,!1,C0),Ti(t,i)}}function QM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function jM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ei(t,e))return;n.uniform2iv(this.addr,e),Ti(t,e)}}function eS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ei(t,e))return;n.uniform3iv(this.addr,e),Ti(t,e)}}function tS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ei(t,e))return;n.uniform4iv(this.addr,e),Ti(t,e)}}function iS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function nS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ei(t,e))return;n.uniform2uiv(this.addr,e),Ti(t,e)}}function rS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ei(t,e))return;n.uniform3uiv(this.addr,e),Ti(t,e)}}function sS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ei(t,e))return;n.uniform4uiv(this.addr,e),Ti(t,e)}}function Lc(n){return n.version===0&&(n.compareFunction=ql,n.needsUpdate=!0),n}function oS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=Lc(I0):s=N0,t.setTexture2D(e||s,r)}function aS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||O0,r)}function lS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=Lc(U0):s=B0,t.setTextureCube(e||s,r)}function cS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||F0,r)}function hS(n){switch(n){case 5126:return XM;case 35664:return qM;case 35665:return YM;case 35666:return $M;case 35674:return KM;case 35675:return ZM;case 35676:return JM;case 5124:case 35670:return QM;case 35667:case 35671:return jM;case 35668:case 35672:return eS;case 35669:case 35673:return tS;case 5125:return iS;case 36294:return nS;case 36295:return rS;case 36296:return sS;case 35678:case 36198:case 36298:case 36306:case 35682:return oS;case 35679:case 36299:case 36307:return aS;case 35680:case 36300:case 36308:case 36293:return lS;case 36289:case 36303:case 36311:case 36292:return cS}}function fS(n,e){n.uniform1fv(this.addr,e)}function uS(n,e){let t=Lo(e,this.size,2);n.uniform2fv(this.addr,t)}function dS(n,e){let t=Lo(e,this.size,3);n.uniform3fv(this.addr,t)}function pS(n,e){let t=Lo(e,this.size,4);n.uniform4fv(this.addr,t)}function mS(n,e){let t=Lo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function gS(n,e){let t=Lo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function xS(n,e){let t=Lo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function _S(n,e){n.uniform1iv(this.addr,e)}function vS(n,e){n.uniform2iv(this.addr,e)}function MS(n,e){n.uniform3iv(this.addr,e)}function SS(n,e){n.uniform4iv(this.addr,e)}function yS(n,e){n.uniform1uiv(this.addr,e)}function bS(n,e){n.uniform2uiv(this.addr,e)}function wS(n,e){n.uniform3uiv(this.addr,e)}function ES(n,e){n.uniform4uiv(this.addr,e)}function TS(n,e,t){let i=this.cache,r=e.length,s=Pc(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=Lc(I0):o=N0;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function AS(n,e,t){let i=this.cache,r=e.length,s=Pc(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||O0,s[o])}function RS(n,e,t){let i=this.cache,r=e.length,s=Pc(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Lc(U0):o=B0;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function CS(n,e,t){let i=this.cache,r=e.length,s=Pc(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||F0,s[o])}function PS(n){switch(n){case 5126:return fS;case 35664:return uS;case 35665:return dS;case 35666:return pS;case 35674:return mS;case 35675:return gS;case 35676:return xS;case 5124:case 35670:return _S;case 35667:case 35671:return vS;case 35668:case 35672:return MS;case 35669:case 35673:return SS;case 5125:return yS;case 36294:return bS;case 36295:return wS;case 36296:return ES;case 35678:case 36198:case 36298:case 36306:case 35682:return TS;case 35679:case 36299:case 36307:return AS;case 35680:case 36300:case 36308:case 36293:return RS;case 36289:case 36303:case 36311:case 36292:return CS}}var Bf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=hS(t.type)}},kf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=PS(t.type)}},zf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},Of=/(\w+)(\])?(\[|\.)?/g;function D0(n,e){n.seq.push(e),n.map[e.id]=e}function LS(n,e,t){let i=n.name,r=i.length;for(Of.lastIndex=0;;){let s=Of.exec(i),o=Of.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){D0(t,c===void 0?new Bf(a,n,e):new kf(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new zf(a),D0(t,f)),t=f}}}var jr=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);LS(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function Gf(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var DS=37297,NS=0;function IS(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var k0=new $e;function US(n){ot._getMatrix(k0,ot.workingColorSpace,n);let e=`mat3( ${k0.elements.map(t=>t.toFixed(4))} )`;switch(ot.getTransfer(n)){case hs:return[e,"LinearTransferOETF"];case _t:return[e,"sRGBTransferOETF"];default:return Ge("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function z0(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+IS(n.getShaderSource(e),a)}else return s}function FS(n,e){let t=US(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var OS={[Al]:"Linear",[Rl]:"Reinhard",[Cl]:"Cineon",[Pl]:"ACESFilmic",[Dl]:"AgX",[Nl]:"Neutral",[Ll]:"Custom"};function BS(n,e){let t=OS[e];return t===void 0?(Ge("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Dc=new I;function kS(){ot.getLuminanceCoefficients(Dc);let n=Dc.x.toFixed(4),e=Dc.y.toFixed(4),t=Dc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function zS(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(el).join(`
`)}function GS(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function HS(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function el(n){return n!==""}function G0(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function H0(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var VS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Hf(n){return n.replace(VS,WS)}function WS(n,e){let t=at[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Hf(t)}var XS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function V0(n){return n.replace(XS,qS)}function qS(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function W0(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var YS={[Gs]:"SHADOWMAP_TYPE_PCF",[os]:"SHADOWMAP_TYPE_VSM"};function $S(n){return YS[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var KS={[Hr]:"ENVMAP_MODE_REFRACTION"};function ZS(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":KS[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var JS={[Hs]:"ENVMAP_BLENDING_MULTIPLY",[Cd]:"ENVMAP_BLENDING_MIX",[Pd]:"ENVMAP_BLENDING_ADD"};function QS(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":JS[n.combine]||"ENVMAP_BLENDING_NONE"}function X0(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=$S(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=ZS(t),f=QS(t),u=zS(t),d=GS(s),g=r.createProgram(),M,p,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(M=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(el).join(`
`),M.length>0&&(M+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(el).join(`
`),p.length>0&&(p+=`
`)):(M=[W0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(el).join(`
`),p=[W0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==mn?"#define TONE_MAPPING":"",t.toneMapping!==mn?at.tonemapping_pars_fragment:"",t.toneMapping!==mn?BS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",at.colorspace_pars_fragment,FS("linearToOutputTexel",t.outputColorSpace),kS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(el).join(`
`)),o=Hf(o),o=G0(o,t),o=H0(o,t),a=Hf(a),a=G0(a,t),a=H0(a,t),o=V0(o),a=V0(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,M=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+M,p=["#define varying in",t.glslVersion===uf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===uf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let _=m+M+o,w=m+p+a,S=Gf(r,r.VERTEX_SHADER,_),R=Gf(r,r.FRAGMENT_SHADER,w);r.attachShader(g,S),r.attachShader(g,R),t.index0AttributeName!==void 0?r.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(g,0,"position"),r.linkProgram(g);function A(L){if(n.debug.checkShaderErrors){let D=r.getProgramInfoLog(g)||"",k=r.getShaderInfoLog(S)||"",G=r.getShaderInfoLog(R)||"",U=D.trim(),W=k.trim(),Y=G.trim(),V=!0,ce=!0;if(r.getProgramParameter(g,r.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,g,S,R);else{let Z=z0(r,S,"vertex"),j=z0(r,R,"fragment");ut("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(g,r.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+U+`
`+Z+`
`+j)}else U!==""?Ge("WebGLProgram: Program Info Log:",U):(W===""||Y==="")&&(ce=!1);ce&&(L.diagnostics={runnable:V,programLog:U,vertexShader:{log:W,prefix:M},fragmentShader:{log:Y,prefix:p}})}r.deleteShader(S),r.deleteShader(R),x=new jr(r,g),b=HS(r,g)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let b;this.getAttributes=function(){return b===void 0&&A(this),b};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=r.getProgramParameter(g,DS)),F},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=NS++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=R,this}var jS=0,Nc=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Vf(e),t.set(e,i)),i}},Vf=class{constructor(e){this.id=jS++,this.code=e,this.usedTimes=0}};function ey(n){return n===_n||n===as||n===ls}function q0(n,e,t,i,r,s){let o=new Xr,a=new Nc,l=new Set,c=[],h=new Map,f=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,b,F,L,D,k){let G=L.fog,U=D.geometry,W=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?L.environment:null,Y=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,V=e.get(x.envMap||W,Y),ce=u[x.type],Z=i.precision;x.precision!==null&&(Z=i.getMaxPrecision(x.precision),Z!==x.precision&&Ge("WebGLProgram.getParameters:",x.precision,"not supported, using",Z,"instead."));let j=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,re=j!==void 0?j.length:0,ue=0;U.morphAttributes.position!==void 0&&(ue=1),U.morphAttributes.normal!==void 0&&(ue=2),U.morphAttributes.color!==void 0&&(ue=3);let fe,ee,me,_e;if(ce){let Re=Nn[ce];fe=Re.vertexShader,ee=Re.fragmentShader}else{fe=x.vertexShader,ee=x.fragmentShader;let Re=a.getVertexShaderStage(x),lt=a.getFragmentShaderStage(x);a.update(x,Re,lt),me=Re.id,_e=lt.id}let Ae=n.getRenderTarget(),ye=n.state.buffers.depth.getReversed(),qe=D.isInstancedMesh===!0,rt=D.isBatchedMesh===!0,Ve=!!x.map,dt=!!x.matcap,ht=!!V,it=ht&&V.isPMREMTexture===!0,$t=!!x.aoMap,zt=!!x.lightMap,pi=!!x.bumpMap&&x.wireframe===!1,Nt=!!x.normalMap,Ci=!!x.displacementMap,Mt=!!x.emissiveMap,bi=!!x.metalnessMap,ni=!!x.roughnessMap,mi=x.anisotropy>0,B=x.clearcoat>0,Ce=x.diffuseRoughness>0,Je=x.dispersion>0,st=x.retroreflectivity>0,be=x.iridescence>0,Ut=x.sheen>0,He=x.transmission>0,Ze=mi&&!!x.anisotropyMap,C=B&&!!x.clearcoatMap,y=B&&!!x.clearcoatNormalMap,X=B&&!!x.clearcoatRoughnessMap,he=Ce&&!!x.diffuseRoughnessMap,oe=be&&!!x.iridescenceMap,xe=be&&!!x.iridescenceThicknessMap,ve=Ut&&!!x.sheenColorMap,te=Ut&&!!x.sheenRoughnessMap,ne=!!x.specularMap,pe=!!x.specularColorMap,O=!!x.specularIntensityMap,se=He&&!!x.transmissionMap,ie=He&&!!x.thicknessMap,we=!!x.gradientMap,ge=!!x.alphaMap,Se=x.alphaTest>0,We=!!x.alphaHash,je=!!x.extensions,le=mn;x.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(le=n.toneMapping);let Be=it?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,et={shaderID:ce,shaderType:x.type,shaderName:x.name,vertexShader:fe,fragmentShader:ee,defines:x.defines,customVertexShaderID:me,customFragmentShaderID:_e,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Z,batching:rt,batchingColor:rt&&D._colorsTexture!==null,instancing:qe,instancingColor:qe&&D.instanceColor!==null,instancingMorph:qe&&D.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:ot.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ve,matcap:dt,envMap:ht,envMapMode:ht&&V.mapping,envMapPMREM:it,envMapMaxLod:it?Be.length-1:null,envMapSize:it?Be[0].width:null,aoMap:$t,lightMap:zt,bumpMap:pi,normalMap:Nt,displacementMap:Ci,emissiveMap:Mt,normalMapObjectSpace:Nt&&x.normalMapType===Nd,normalMapTangentSpace:Nt&&x.normalMapType===za,packedNormalMap:Nt&&x.normalMapType===za&&ey(x.normalMap.format),metalnessMap:bi,roughnessMap:ni,anisotropy:mi,anisotropyMap:Ze,clearcoat:B,clearcoatMap:C,clearcoatNormalMap:y,clearcoatRoughnessMap:X,diffuseRoughness:Ce,diffuseRoughnessMap:he,dispersion:Je,retroreflection:st,iridescence:be,iridescenceMap:oe,iridescenceThicknessMap:xe,sheen:Ut,sheenColorMap:ve,sheenRoughnessMap:te,specularMap:ne,specularColorMap:pe,specularIntensityMap:O,transmission:He,transmissionMap:se,thicknessMap:ie,gradientMap:we,opaque:x.transparent===!1&&x.blending===kr&&x.alphaToCoverage===!1,alphaMap:ge,alphaTest:Se,alphaHash:We,combine:x.combine,mapUv:Ve&&d(x.map.channel),aoMapUv:$t&&d(x.aoMap.channel),lightMapUv:zt&&d(x.lightMap.channel),bumpMapUv:pi&&d(x.bumpMap.channel),normalMapUv:Nt&&d(x.normalMap.channel),displacementMapUv:Ci&&d(x.displacementMap.channel),emissiveMapUv:Mt&&d(x.emissiveMap.channel),metalnessMapUv:bi&&d(x.metalnessMap.channel),roughnessMapUv:ni&&d(x.roughnessMap.channel),anisotropyMapUv:Ze&&d(x.anisotropyMap.channel),clearcoatMapUv:C&&d(x.clearcoatMap.channel),clearcoatNormalMapUv:y&&d(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&d(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&d(x.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(x.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&d(x.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&d(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(x.sheenRoughnessMap.channel),specularMapUv:ne&&d(x.specularMap.channel),specularColorMapUv:pe&&d(x.specularColorMap.channel),specularIntensityMapUv:O&&d(x.specularIntensityMap.channel),transmissionMapUv:se&&d(x.transmissionMap.channel),thicknessMapUv:ie&&d(x.thicknessMap.channel),alphaMapUv:ge&&d(x.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Nt||mi),vertexNormals:!!U.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!U.attributes.uv&&(Ve||ge),fog:!!G,useFog:x.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||U.attributes.normal===void 0&&Nt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:ye,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:re,morphTextureStride:ue,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:k.filter(Re=>Re.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&F.length>0,shadowMapType:n.shadowMap.type,toneMapping:le,decodeVideoTexture:Ve&&x.map.isVideoTexture===!0&&ot.getTransfer(x.map.colorSpace)===_t,decodeVideoTextureEmissive:Mt&&x.emissiveMap.isVideoTexture===!0&&ot.getTransfer(x.emissiveMap.colorSpace)===_t,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===zi,flipSided:x.side===ei,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:je&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&x.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function M(x){let b=[];if(x.shaderID?b.push(x.shaderID):(b.push(x.customVertexShaderID),b.push(x.customFragmentShaderID)),x.defines!==void 0)for(let F in x.defines)b.push(F),b.push(x.defines[F]);return x.isRawShaderMaterial===!1&&(p(b,x),m(b,x),b.push(n.outputColorSpace)),b.push(x.customProgramCacheKey),b.join()}function p(x,b){x.push(b.precision),x.push(b.outputColorSpace),x.push(b.envMapMode),x.push(b.envMapPMREM),x.push(b.envMapMaxLod),x.push(b.envMapSize),x.push(b.mapUv),x.push(b.alphaMapUv),x.push(b.lightMapUv),x.push(b.aoMapUv),x.push(b.bumpMapUv),x.push(b.normalMapUv),x.push(b.displacementMapUv),x.push(b.emissiveMapUv),x.push(b.metalnessMapUv),x.push(b.roughnessMapUv),x.push(b.anisotropyMapUv),x.push(b.clearcoatMapUv),x.push(b.clearcoatNormalMapUv),x.push(b.clearcoatRoughnessMapUv),x.push(b.diffuseRoughnessMapUv),x.push(b.iridescenceMapUv),x.push(b.iridescenceThicknessMapUv),x.push(b.sheenColorMapUv),x.push(b.sheenRoughnessMapUv),x.push(b.specularMapUv),x.push(b.specularColorMapUv),x.push(b.specularIntensityMapUv),x.push(b.transmissionMapUv),x.push(b.thicknessMapUv),x.push(b.combine),x.push(b.fogExp2),x.push(b.sizeAttenuation),x.push(b.morphTargetsCount),x.push(b.numSunLights),x.push(b.numDirLights),x.push(b.numPointLights),x.push(b.numSpotLights),x.push(b.numSpotLightMaps),x.push(b.numHemiLights),x.push(b.numRectAreaLights),x.push(b.numSunLightShadows),x.push(b.numDirLightShadows),x.push(b.numPointLightShadows),x.push(b.numSpotLightShadows),x.push(b.numSpotLightShadowsWithMaps),x.push(b.numLightProbes),x.push(b.numLightProbeGrids),x.push(b.shadowMapType),x.push(b.toneMapping),x.push(b.numClippingPlanes),x.push(b.numClipIntersection),x.push(b.depthPacking)}function m(x,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function _(x){let b=u[x.type],F;if(b){let L=Nn[b];F=_p.clone(L.uniforms)}else F=x.uniforms;return F}function w(x,b){let F=h.get(b);return F!==void 0?++F.usedTimes:(F=new X0(n,b,x,r),c.push(F),h.set(b,F)),F}function S(x){if(--x.usedTimes===0){let b=c.indexOf(x);c[b]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function R(x){a.remove(x)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:M,getUniforms:_,acquireProgram:w,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:A}}function Y0(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,l){n.get(o)[a]=l}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function ty(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function $0(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function K0(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(u){let d=0;return u.isInstancedMesh&&(d+=2),u.isSkinnedMesh&&(d+=1),d}function a(u,d,g,M,p,m){let _=n[e];return _===void 0?(_={id:u.id,object:u,geometry:d,material:g,materialVariant:o(u),groupOrder:M,renderOrder:u.renderOrder,z:p,group:m},n[e]=_):(_.id=u.id,_.object=u,_.geometry=d,_.material=g,_.materialVariant=o(u),_.groupOrder=M,_.renderOrder=u.renderOrder,_.z=p,_.group=m),e++,_}function l(u,d,g,M,p,m,_){_.reversedDepth===!0&&(p=-p);let w=a(u,d,g,M,p,m);g.transmission>0?i.push(w):g.transparent===!0?r.push(w):t.push(w)}function c(u,d,g,M,p,m){let _=a(u,d,g,M,p,m);g.transmission>0?i.unshift(_):g.transparent===!0?r.unshift(_):t.unshift(_)}function h(u,d){t.length>1&&t.sort(u||ty),i.length>1&&i.sort(d||$0),r.length>1&&r.sort(d||$0)}function f(){for(let u=e,d=n.length;u<d;u++){let g=n[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:l,unshift:c,finish:f,sort:h}}function Z0(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new K0,n.set(i,[o])):r>=s.length?(o=new K0,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function iy(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new I,color:new Xe};break;case"SpotLight":t={position:new I,direction:new I,color:new Xe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new I,color:new Xe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new I,skyColor:new Xe,groundColor:new Xe};break;case"RectAreaLight":t={color:new Xe,position:new I,halfWidth:new I,halfHeight:new I};break}return n[e.id]=t,t}}}function ny(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var ry=0;function sy(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function J0(n){let e=new iy,t=ny(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new I);let r=new I,s=new Le,o=new Le;function a(c){let h=0,f=0,u=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let d=0,g=0,M=0,p=0,m=0,_=0,w=0,S=0,R=0,A=0,x=0,b=0,F=0,L=0;c.sort(sy);for(let k=0,G=c.length;k<G;k++){let U=c[k],W=U.color,Y=U.intensity,V=U.distance,ce=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===_n?ce=U.shadow.map.texture:ce=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)h+=W.r*Y,f+=W.g*Y,u+=W.b*Y;else if(U.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(U.sh.coefficients[Z],Y);L++}else if(U.isSunLight){let Z=e.get(U);if(Z.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let j=U.shadow,re=t.get(U);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[g]=re,i.sunShadowMap[g]=ce;let ue=j.getViewportCount();for(let fe=0;fe<ue;fe++)i.sunShadowMatrix[M+fe]=j.getMatrix(fe),i.sunShadowCascade[M+fe]=j._cascadeData[fe];M+=ue,g++}i.sun[d]=Z,d++}else if(U.isDirectionalLight){let Z=e.get(U);if(Z.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let j=U.shadow,re=t.get(U);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize=j.mapSize,i.directionalShadow[p]=re,i.directionalShadowMap[p]=ce,i.directionalShadowMatrix[p]=U.shadow.matrix,R++}i.directional[p]=Z,p++}else if(U.isSpotLight){let Z=e.get(U);Z.position.setFromMatrixPosition(U.matrixWorld),Z.color.copy(W).multiplyScalar(Y),Z.distance=V,Z.coneCos=Math.cos(U.angle),Z.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),Z.decay=U.decay,i.spot[_]=Z;let j=U.shadow;if(U.map&&(i.spotLightMap[b]=U.map,b++,j.updateMatrices(U),U.castShadow&&F++),i.spotLightMatrix[_]=j.matrix,U.castShadow){let re=t.get(U);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize=j.mapSize,i.spotShadow[_]=re,i.spotShadowMap[_]=ce,x++}_++}else if(U.isRectAreaLight){let Z=e.get(U);Z.color.copy(W).multiplyScalar(Y),Z.halfWidth.set(U.width*.5,0,0),Z.halfHeight.set(0,U.height*.5,0),i.rectArea[w]=Z,w++}else if(U.isPointLight){let Z=e.get(U);if(Z.color.copy(U.color).multiplyScalar(U.intensity),Z.distance=U.distance,Z.decay=U.decay,U.castShadow){let j=U.shadow,re=t.get(U);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize=j.mapSize,re.shadowCameraNear=j.camera.near,re.shadowCameraFar=j.camera.far,i.pointShadow[m]=re,i.pointShadowMap[m]=ce,i.pointShadowMatrix[m]=U.shadow.matrix,A++}i.point[m]=Z,m++}else if(U.isHemisphereLight){let Z=e.get(U);Z.skyColor.copy(U.color).multiplyScalar(Y),Z.groundColor.copy(U.groundColor).multiplyScalar(Y),i.hemi[S]=Z,S++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=De.LTC_FLOAT_1,i.rectAreaLTC2=De.LTC_FLOAT_2):(i.rectAreaLTC1=De.LTC_HALF_1,i.rectAreaLTC2=De.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=f,i.ambient[2]=u;let D=i.hash;(D.sunLength!==d||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==_||D.rectAreaLength!==w||D.hemiLength!==S||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==A||D.numSpotShadows!==x||D.numSpotMaps!==b||D.numLightProbes!==L)&&(i.sun.length=d,i.directional.length=p,i.spot.length=_,i.rectArea.length=w,i.point.length=m,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=M,i.sunShadowCascade.length=M,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+b-F,i.spotLightMap.length=b,i.numSpotLightShadowsWithMaps=F,i.numLightProbes=L,D.sunLength=d,D.directionalLength=p,D.pointLength=m,D.spotLength=_,D.rectAreaLength=w,D.hemiLength=S,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=A,D.numSpotShadows=x,D.numSpotMaps=b,D.numLightProbes=L,i.version=ry++)}function l(c,h){let f=0,u=0,d=0,g=0,M=0,p=0,m=h.matrixWorldInverse;for(let _=0,w=c.length;_<w;_++){let S=c[_];if(S.isSunLight){let R=i.sun[f];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),f++}else if(S.isDirectionalLight){let R=i.directional[u];R.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(r),R.direction.transformDirection(m),u++}else if(S.isSpotLight){let R=i.spot[g];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(r),R.direction.transformDirection(m),g++}else if(S.isRectAreaLight){let R=i.rectArea[M];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),o.identity(),s.copy(S.matrixWorld),s.premultiply(m),o.extractRotation(s),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),M++}else if(S.isPointLight){let R=i.point[d];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),d++}else if(S.isHemisphereLight){let R=i.hemi[p];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:i}}function Q0(n){let e=new J0(n),t=[],i=[],r=[];function s(f){h.camera=f,t.length=0,i.length=0,r.length=0}function o(f){f.isLightProbeGrid?r.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),r.sort((f,u)=>f.priority-u.priority||f.id-u.id)}function c(f){e.setupView(t,f)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function j0(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new Q0(n),e.set(r,[a])):s>=o.length?(a=new Q0(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var ex=`
void main() {
gl_Position = vec4( position, 1.0 );
}
`,tx=`
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
`;var ay=[new I(1,0,0),new I(-1,0,0),new I(0,1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1)],ly=[new I(0,-1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1),new I(0,-1,0),new I(0,-1,0)],ix=new Le,tl=new I,Wf=new I;function nx(n,e,t){let i=new cn,r=new Ke,s=new Ke,o=new bt,a=new Sc,l=new yc,c={},h=t.maxTextureSize,f={[sn]:ei,[ei]:sn,[zi]:zi},u=new tn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:ex,fragmentShader:tx}),d=u.clone();d.defines.HORIZONTAL_PASS=1;let g=new Ot;g.setAttribute("position",new Rt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new St(g,u),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Gs;let m=this.type;this.render=function(A,x,b){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||A.length===0)return;this.type===hd&&(Ge("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Gs);let F=n.getRenderTarget(),L=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),k=n.state;k.setBlending(ir),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let G=m!==this.type;G&&x.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(W=>W.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,W=A.length;U<W;U++){let Y=A[U],V=Y.shadow;if(V===void 0){Ge("WebGLShadowMap:",Y,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;r.copy(V.mapSize);let ce=V.getFrameExtents();r.multiply(ce),s.copy(V.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/ce.x),r.x=s.x*ce.x,V.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/ce.y),r.y=s.y*ce.y,V.mapSize.y=s.y));let Z=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=Z,V.map===null||G===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===os){if(Y.isPointLight){Ge("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new Hi(r.x,r.y,{format:_n,type:Ui,minFilter:Mi,magFilter:Mi,generateMipmaps:!1}),V.map.texture.name=Y.name+".shadowMap",V.map.depthTexture=new yn(r.x,r.y,fi),V.map.depthTexture.name=Y.name+".shadowMapDepth",V.map.depthTexture.format=an,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Zt,V.map.depthTexture.magFilter=Zt}else Y.isPointLight?(V.map=new Qr(r.x),V.map.depthTexture=new So(r.x,Ii)):(V.map=new Hi(r.x,r.y),V.map.depthTexture=new yn(r.x,r.y,Ii)),V.map.depthTexture.name=Y.name+".shadowMap",V.map.depthTexture.format=an,this.type===Gs?(V.map.depthTexture.compareFunction=Z?Xl:Wl,V.map.depthTexture.minFilter=Mi,V.map.depthTexture.magFilter=Mi):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Zt,V.map.depthTexture.magFilter=Zt);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==r.x||V.map.height!==r.y)&&V.map.setSize(r.x,r.y);let j=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();Y.isPointLight!==!0&&V.updateMatrices(Y,b);let re=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:b.layers;for(let ue=0;ue<j;ue++){let fe=V.getCamera(ue);if(Y.isPointLight){let ee=V.camera,me=V.matrix,_e=Y.distance||ee.far;_e!==ee.far&&(ee.far=_e,ee.updateProjectionMatrix()),tl.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(tl),Wf.copy(ee.position),Wf.add(ay[ue]),ee.up.copy(ly[ue]),ee.lookAt(Wf),ee.updateMatrixWorld(),me.makeTranslation(-tl.x,-tl.y,-tl.z),ix.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),V._frustum.setFromProjectionMatrix(ix,ee.coordinateSystem,ee.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,ue),n.clear();else{ue===0&&(n.setRenderTarget(V.map),n.clear());let ee=V.getViewport(ue);o.set(s.x*ee.x,s.y*ee.y,s.x*ee.z,s.y*ee.w),k.viewport(o)}i=V.getFrustum(ue),S(x,b,fe,Y,re,this.type)}V.isPointLightShadow!==!0&&this.type===os&&_(V,b),V.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(F,L,D)};function _(A,x){let b=e.update(M);u.defines.VSM_SAMPLES!==A.blurSamples&&(u.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,u.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null?A.mapPass=new Hi(r.x,r.y,{format:_n,type:Ui}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),u.uniforms.shadow_pass.value=A.map.depthTexture,u.uniforms.resolution.value.set(A.map.width,A.map.height),u.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(x,null,b,u,M,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(x,null,b,d,M,null)}function w(A,x,b,F){let L=null,D=b.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(D!==void 0)L=D;else if(L=b.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let k=L.uuid,G=x.uuid,U=c[k];U===void 0&&(U={},c[k]=U);let W=U[G];W===void 0&&(W=L.clone(),U[G]=W,x.addEventListener("dispose",R)),L=W}if(L.visible=x.visible,L.wireframe=x.wireframe,F===os?L.side=x.shadowSide!==null?x.shadowSide:x.side:L.side=x.shadowSide!==null?x.shadowSide:f[x.side],L.alphaMap=x.alphaMap,L.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,L.map=x.map,L.clipShadows=x.clipShadows,L.clippingPlanes=x.clippingPlanes,L.clipIntersection=x.clipIntersection,L.displacementMap=x.displacementMap,L.displacementScale=x.displacementScale,L.displacementBias=x.displacementBias,L.wireframeLinewidth=x.wireframeLinewidth,L.linewidth=x.linewidth,b.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let k=n.properties.get(L);k.light=b}return L}function S(A,x,b,F,L,D){if(A.visible===!1)return;if(A.layers.test(L)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&D===os)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,A.matrixWorld);let U=e.update(A),W=A.material;if(Array.isArray(W)){let Y=U.groups;for(let V=0,ce=Y.length;V<ce;V++){let Z=Y[V],j=W[Z.materialIndex];if(j&&j.visible){let re=w(A,j,F,D);A.onBeforeShadow(n,A,x,b,U,re,Z),n.renderBufferDirect(b,null,U,re,A,Z),A.onAfterShadow(n,A,x,b,U,re,Z)}}}else if(W.visible){let Y=w(A,W,F,D);A.onBeforeShadow(n,A,x,b,U,Y,null),n.renderBufferDirect(b,null,U,Y,A,null),A.onAfterShadow(n,A,x,b,U,Y,null)}}let G=A.children;for(let U=0,W=G.length;U<W;U++)S(G[U],x,b,F,L,D)}function R(A){A.target.removeEventListener("dispose",R);for(let b in c){let F=c[b],L=A.target.uuid;L in F&&(F[L].dispose(),delete F[L])}}}function rx(n,e){function t(){let O=!1,se=new bt,ie=null,we=new bt(0,0,0,0);return{setMask:function(ge){ie!==ge&&!O&&(n.colorMask(ge,ge,ge,ge),ie=ge)},setLocked:function(ge){O=ge},setClear:function(ge,Se,We,je,le){le===!0&&(ge*=je,Se*=je,We*=je),se.set(ge,Se,We,je),we.equals(se)===!1&&(n.clearColor(ge,Se,We,je),we.copy(se))},reset:function(){O=!1,ie=null,we.set(-1,0,0,0)}}}function i(){let O=!1,se=!1,ie=null,we=null,ge=null;return{setReversed:function(Se){if(se!==Se){let We=e.get("EXT_clip_control");Se?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),se=Se;let je=ge;ge=null,this.setClear(je)}},getReversed:function(){return se},setTest:function(Se){Se?ye(n.DEPTH_TEST):qe(n.DEPTH_TEST)},setMask:function(Se){ie!==Se&&!O&&(n.depthMask(Se),ie=Se)},setFunc:function(Se){if(se&&(Se=Yd[Se]),we!==Se){switch(Se){case ea:n.depthFunc(n.NEVER);break;case ta:n.depthFunc(n.ALWAYS);break;case ia:n.depthFunc(n.LESS);break;case Gr:n.depthFunc(n.LEQUAL);break;case na:n.depthFunc(n.EQUAL);break;case ra:n.depthFunc(n.GEQUAL);break;case sa:n.depthFunc(n.GREATER);break;case oa:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=Se}},setLocked:function(Se){O=Se},setClear:function(Se){ge!==Se&&(ge=Se,se&&(Se=1-Se),n.clearDepth(Se))},reset:function(){O=!1,ie=null,we=null,ge=null,se=!1}}}function r(){let O=!1,se=null,ie=null,we=null,ge=null,Se=null,We=null,je=null,le=null;return{setTest:function(Be){O||(Be?ye(n.STENCIL_TEST):qe(n.STENCIL_TEST))},setMask:function(Be){se!==Be&&!O&&(n.stencilMask(Be),se=Be)},setFunc:function(Be,et,Re){(ie!==Be||we!==et||ge!==Re)&&(n.stencilFunc(Be,et,Re),ie=Be,we=et,ge=Re)},setOp:function(Be,et,Re){(Se!==Be||We!==et||je!==Re)&&(n.stencilOp(Be,et,Re),Se=Be,We=et,je=Re)},setLocked:function(Be){O=Be},setClear:function(Be){le!==Be&&(n.clearStencil(Be),le=Be)},reset:function(){O=!1,se=null,ie=null,we=null,ge=null,Se=null,We=null,je=null,le=null}}}let s=new t,o=new i,a=new r,l={},c=new WeakMap,h={},f={},u={},d=new WeakMap,g=[],M=null,p=!1,m=null,_=null,w=null,S=null,R=null,A=null,x=null,b=new Xe(0,0,0),F=0,L=!1,D=null,k=null,G=null,U=null,W=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ce=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(Z)[1]),V=ce>=1):Z.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),V=ce>=2);let j=null,re={},ue=n.getParameter(n.SCISSOR_BOX),fe=n.getParameter(n.VIEWPORT),ee=new bt().fromArray(ue),me=new bt().fromArray(fe);function _e(O,se,ie,we){let ge=new Uint8Array(4),Se=n.createTexture();n.bindTexture(O,Se),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<ie;We++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(se,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(se+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return Se}let Ae={};Ae[n.TEXTURE_2D]=_e(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=_e(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=_e(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=_e(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ye(n.DEPTH_TEST),o.setFunc(Gr),pi(!1),Nt(af),ye(n.CULL_FACE),$t(ir);function ye(O){h[O]!==!0&&(n.enable(O),h[O]=!0)}function qe(O){h[O]!==!1&&(n.disable(O),h[O]=!1)}function rt(O,se){return u[O]!==se?(n.bindFramebuffer(O,se),u[O]=se,O===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=se),O===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=se),!0):!1}function Ve(O,se){let ie=g,we=!1;if(O){ie=d.get(se),ie===void 0&&(ie=[],d.set(se,ie));let ge=O.textures;if(ie.length!==ge.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,We=ge.length;Se<We;Se++)ie[Se]=n.COLOR_ATTACHMENT0+Se;ie.length=ge.length,we=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,we=!0);we&&n.drawBuffers(ie)}function dt(O){return M!==O?(n.useProgram(O),M=O,!0):!1}let ht={[zr]:n.FUNC_ADD,[ud]:n.FUNC_SUBTRACT,[dd]:n.FUNC_REVERSE_SUBTRACT};ht[pd]=n.MIN,ht[md]=n.MAX;let it={[gd]:n.ZERO,[xd]:n.ONE,[_d]:n.SRC_COLOR,[El]:n.SRC_ALPHA,[wd]:n.SRC_ALPHA_SATURATE,[yd]:n.DST_COLOR,[Md]:n.DST_ALPHA,[vd]:n.ONE_MINUS_SRC_COLOR,[Tl]:n.ONE_MINUS_SRC_ALPHA,[bd]:n.ONE_MINUS_DST_COLOR,[Sd]:n.ONE_MINUS_DST_ALPHA,[Ed]:n.CONSTANT_COLOR,[Td]:n.ONE_MINUS_CONSTANT_COLOR,[Ad]:n.CONSTANT_ALPHA,[Rd]:n.ONE_MINUS_CONSTANT_ALPHA};function $t(O,se,ie,we,ge,Se,We,je,le,Be){if(O===ir){p===!0&&(qe(n.BLEND),p=!1);return}if(p===!1&&(ye(n.BLEND),p=!0),O!==fd){if(O!==m||Be!==L){if((_!==zr||R!==zr)&&(n.blendEquation(n.FUNC_ADD),_=zr,R=zr),Be)switch(O){case kr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case lf:n.blendFunc(n.ONE,n.ONE);break;case cf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case hf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ut("WebGLState: Invalid blending: ",O);break}else switch(O){case kr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case lf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case cf:ut("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case hf:ut("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ut("WebGLState: Invalid blending: ",O);break}w=null,S=null,A=null,x=null,b.set(0,0,0),F=0,m=O,L=Be}return}ge=ge||se,Se=Se||ie,We=We||we,(se!==_||ge!==R)&&(n.blendEquationSeparate(ht[se],ht[ge]),_=se,R=ge),(ie!==w||we!==S||Se!==A||We!==x)&&(n.blendFuncSeparate(it[ie],it[we],it[Se],it[We]),w=ie,S=we,A=Se,x=We),(je.equals(b)===!1||le!==F)&&(n.blendColor(je.r,je.g,je.b,le),b.copy(je),F=le),m=O,L=!1}function zt(O,se){O.side===zi?qe(n.CULL_FACE):ye(n.CULL_FACE);let ie=O.side===ei;se&&(ie=!ie),pi(ie),O.blending===kr&&O.transparent===!1?$t(ir):$t(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),s.setMask(O.colorWrite);let we=O.stencilWrite;a.setTest(we),we&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),Mt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?ye(n.SAMPLE_ALPHA_TO_COVERAGE):qe(n.SAMPLE_ALPHA_TO_COVERAGE)}function pi(O){D!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),D=O)}function Nt(O){O!==ld?(ye(n.CULL_FACE),O!==k&&(O===af?n.cullFace(n.BACK):O===cd?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):qe(n.CULL_FACE),k=O}function Ci(O){O!==G&&(V&&n.lineWidth(O),G=O)}function Mt(O,se,ie){O?(ye(n.POLYGON_OFFSET_FILL),(U!==se||W!==ie)&&(U=se,W=ie,o.getReversed()&&(se=-se,ie=-ie),n.polygonOffset(se,ie))):qe(n.POLYGON_OFFSET_FILL)}function bi(O){O?ye(n.SCISSOR_TEST):qe(n.SCISSOR_TEST)}function ni(O){O===void 0&&(O=n.TEXTURE0+Y-1),j!==O&&(n.activeTexture(O),j=O)}function mi(O,se,ie){ie===void 0&&(j===null?ie=n.TEXTURE0+Y-1:ie=j);let we=re[ie];we===void 0&&(we={type:void 0,texture:void 0},re[ie]=we),(we.type!==O||we.texture!==se)&&(j!==ie&&(n.activeTexture(ie),j=ie),n.bindTexture(O,se||Ae[O]),we.type=O,we.texture=se)}function B(){let O=re[j];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Ce(){try{n.compressedTexImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function st(){try{n.texSubImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function be(){try{n.texSubImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function Ut(){try{n.compressedTexSubImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function He(){try{n.compressedTexSubImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function Ze(){try{n.texStorage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function C(){try{n.texStorage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function y(){try{n.texImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function X(){try{n.texImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function he(O){return f[O]!==void 0?f[O]:n.getParameter(O)}function oe(O,se){f[O]!==se&&(n.pixelStorei(O,se),f[O]=se)}function xe(O){ee.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function ve(O){me.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function te(O,se){let ie=c.get(se);ie===void 0&&(ie=new WeakMap,c.set(se,ie));let we=ie.get(O);we===void 0&&(we=n.getUniformBlockIndex(se,O.name),n.uniformBlockBinding(se,we,we),ie.set(O,we))}function ne(O,se,ie){let ge=c.get(se).get(O);l[ge]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,ie),l[ge]=ie)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},f={},j=null,re={},u={},l={},d=new WeakMap,g=[],M=null,p=!1,m=null,_=null,w=null,S=null,R=null,A=null,x=null,b=new Xe(0,0,0),F=0,L=!1,D=null,k=null,G=null,U=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:ye,disable:qe,bindFramebuffer:rt,drawBuffers:Ve,useProgram:dt,setBlending:$t,setMaterial:zt,setFlipSided:pi,setCullFace:Nt,setLineWidth:Ci,setPolygonOffset:Mt,setScissorTest:bi,activeTexture:ni,bindTexture:mi,unbindTexture:B,compressedTexImage2D:Ce,compressedTexImage3D:Je,texImage2D:y,texImage3D:X,pixelStorei:oe,getParameter:he,updateUBOMapping:te,uniformBlockBinding:ne,texStorage2D:Ze,texStorage3D:C,texSubImage2D:st,texSubImage3D:be,compressedTexSubImage2D:Ut,compressedTexSubImage3D:He,scissor:xe,viewport:ve,reset:pe}}function sx(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ke,h=new WeakMap,f=new Set,u,d=new WeakMap,g=new Set,M=new FinalizationRegistry(C=>g.delete(C)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(C,y){return p?new OffscreenCanvas(C,y):to("canvas")}function _(C,y,X){let he=1,oe=Ze(C);if((oe.width>X||oe.height>X)&&(he=X/Math.max(oe.width,oe.height)),he<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let xe=Math.floor(he*oe.width),ve=Math.floor(he*oe.height);u===void 0&&(u=m(xe,ve));let te=y?m(xe,ve):u;return te.width=xe,te.height=ve,te.getContext("2d").drawImage(C,0,0,xe,ve),Ge("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+xe+"x"+ve+")."),te}else return"data"in C&&Ge("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),C;return C}function w(C){return C.generateMipmaps}function S(C){n.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?n.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(C,y,X,he,oe,xe=!1){if(C!==null){if(n[C]!==void 0)return n[C];Ge("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ve;he&&(ve=e.get("EXT_texture_norm16"),ve||Ge("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=y;if(y===n.RED&&(X===n.FLOAT&&(te=n.R32F),X===n.HALF_FLOAT&&(te=n.R16F),X===n.UNSIGNED_BYTE&&(te=n.R8),X===n.UNSIGNED_SHORT&&ve&&(te=ve.R16_EXT),X===n.SHORT&&ve&&(te=ve.R16_SNORM_EXT)),y===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.R8UI),X===n.UNSIGNED_SHORT&&(te=n.R16UI),X===n.UNSIGNED_INT&&(te=n.R32UI),X===n.BYTE&&(te=n.R8I),X===n.SHORT&&(te=n.R16I),X===n.INT&&(te=n.R32I)),y===n.RG&&(X===n.FLOAT&&(te=n.RG32F),X===n.HALF_FLOAT&&(te=n.RG16F),X===n.UNSIGNED_BYTE&&(te=n.RG8),X===n.UNSIGNED_SHORT&&ve&&(te=ve.RG16_EXT),X===n.SHORT&&ve&&(te=ve.RG16_SNORM_EXT)),y===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RG8UI),X===n.UNSIGNED_SHORT&&(te=n.RG16UI),X===n.UNSIGNED_INT&&(te=n.RG32UI),X===n.BYTE&&(te=n.RG8I),X===n.SHORT&&(te=n.RG16I),X===n.INT&&(te=n.RG32I)),y===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGB8UI),X===n.UNSIGNED_SHORT&&(te=n.RGB16UI),X===n.UNSIGNED_INT&&(te=n.RGB32UI),X===n.BYTE&&(te=n.RGB8I),X===n.SHORT&&(te=n.RGB16I),X===n.INT&&(te=n.RGB32I)),y===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),X===n.UNSIGNED_INT&&(te=n.RGBA32UI),X===n.BYTE&&(te=n.RGBA8I),X===n.SHORT&&(te=n.RGBA16I),X===n.INT&&(te=n.RGBA32I)),y===n.RGB&&(X===n.UNSIGNED_SHORT&&ve&&(te=ve.RGB16_EXT),X===n.SHORT&&ve&&(te=ve.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),y===n.RGBA){let ne=xe?hs:ot.getTransfer(oe);X===n.FLOAT&&(te=n.RGBA32F),X===n.HALF_FLOAT&&(te=n.RGBA16F),X===n.UNSIGNED_BYTE&&(te=ne===_t?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&ve&&(te=ve.RGBA16_EXT),X===n.SHORT&&ve&&(te=ve.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(C,y){let X;return C?y===null||y===Ii||y===zn?X=n.DEPTH24_STENCIL8:y===fi?X=n.DEPTH32F_STENCIL8:y===vr&&(X=n.DEPTH24_STENCIL8,Ge("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Ii||y===zn?X=n.DEPTH_COMPONENT24:y===fi?X=n.DEPTH_COMPONENT32F:y===vr&&(X=n.DEPTH_COMPONENT16),X}function b(C,y){return w(C)===!0||C.isFramebufferTexture&&C.minFilter!==Zt&&C.minFilter!==Mi?Math.log2(Math.max(y.width,y.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?y.mipmaps.length:1}function F(C){let y=new WeakRef(C);i.get(C).__ref=y,g.add(y),M.register(C,y,y)}function L(C){let y=i.get(C).__ref;y!==void 0&&(g.delete(y),M.unregister(y))}function D(C){G(C.target)}function k(C){U(C.target)}function G(C){C.removeEventListener("dispose",D),L(C),Y(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&f.delete(C)}function U(C){C.removeEventListener("dispose",k),L(C),ce(C)}function W(){for(let C of g){let y=C.deref();y!==void 0&&(y.isRenderTarget===!0?U(y):G(y))}g.clear(),f.clear()}function Y(C){let y=i.get(C);if(y.__webglInit===void 0)return;let X=C.source,he=d.get(X);if(he){let oe=he[y.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&V(C),Object.keys(he).length===0&&d.delete(X)}i.remove(C)}function V(C){let y=i.get(C);n.deleteTexture(y.__webglTexture);let X=C.source,he=d.get(X);delete he[y.__cacheKey],o.memory.textures--}function ce(C){let y=i.get(C);y.__depthDisposeCallback&&y.__depthDisposeCallback();let X=C.depthTexture;if(X&&X.renderTarget===C&&G(X),C.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(y.__webglFramebuffer[oe]))for(let xe=0;xe<y.__webglFramebuffer[oe].length;xe++)n.deleteFramebuffer(y.__webglFramebuffer[oe][xe]);else n.deleteFramebuffer(y.__webglFramebuffer[oe]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[oe])}else{if(Array.isArray(y.__webglFramebuffer))for(let oe=0;oe<y.__webglFramebuffer.length;oe++)n.deleteFramebuffer(y.__webglFramebuffer[oe]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let oe=0;oe<y.__webglColorRenderbuffer.length;oe++)y.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[oe]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let he=C.textures;for(let oe=0,xe=he.length;oe<xe;oe++){let ve=i.get(he[oe]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(he[oe])}i.remove(C)}let Z=0;function j(){Z=0}function re(){return Z}function ue(C){Z=C}function fe(){let C=Z;return C>=r.maxTextures&&Ge("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+r.maxTextures),Z+=1,C}function ee(C){let y=[];return y.push(C.wrapS),y.push(C.wrapT),y.push(C.wrapR||0),y.push(C.magFilter),y.push(C.minFilter),y.push(C.anisotropy),y.push(C.internalFormat),y.push(C.format),y.push(C.type),y.push(C.generateMipmaps),y.push(C.mipmapsAutoUpdate),y.push(C.premultiplyAlpha),y.push(C.flipY),y.push(C.unpackAlignment),y.push(C.colorSpace),y.join()}function me(C,y){let X=i.get(C);if(C.isVideoTexture&&Ut(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&X.__version!==C.version){let he=C.image;if(he===null)Ge("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Ge("WebGLRenderer: Texture marked for update but image is incomplete");else{zt(X,C,y);return}}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+y)}function _e(C,y){let X=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){zt(X,C,y);return}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+y)}function Ae(C,y){let X=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){zt(X,C,y);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+y)}function ye(C,y){let X=i.get(C);if(C.version>0&&X.__version!==C.version){pi(X,C,y);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+y)}let qe={[aa]:n.REPEAT,[on]:n.CLAMP_TO_EDGE,[la]:n.MIRRORED_REPEAT},rt={[Zt]:n.NEAREST,[Ld]:n.NEAREST_MIPMAP_NEAREST,[ca]:n.NEAREST_MIPMAP_LINEAR,[Mi]:n.LINEAR,[Fl]:n.LINEAR_MIPMAP_NEAREST,[gn]:n.LINEAR_MIPMAP_LINEAR},Ve={[Ud]:n.NEVER,[ql]:n.ALWAYS,[Fd]:n.LESS,[Wl]:n.LEQUAL,[Od]:n.EQUAL,[Xl]:n.GEQUAL,[Bd]:n.GREATER,[kd]:n.NOTEQUAL};function dt(C,y){if(y.type===fi&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===Mi||y.magFilter===Fl||y.magFilter===ca||y.magFilter===gn||y.minFilter===Mi||y.minFilter===Fl||y.minFilter===ca||y.minFilter===gn)&&Ge("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(C,n.TEXTURE_WRAP_S,qe[y.wrapS]),n.texParameteri(C,n.TEXTURE_WRAP_T,qe[y.wrapT]),(C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY)&&n.texParameteri(C,n.TEXTURE_WRAP_R,qe[y.wrapR]),n.texParameteri(C,n.TEXTURE_MAG_FILTER,rt[y.magFilter]),n.texParameteri(C,n.TEXTURE_MIN_FILTER,rt[y.minFilter]),y.compareFunction&&(n.texParameteri(C,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(C,n.TEXTURE_COMPARE_FUNC,Ve[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===Zt||y.minFilter!==ca&&y.minFilter!==gn||y.type===fi&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(C,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,r.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function ht(C,y){let X=!1;C.__webglInit===void 0&&(C.__webglInit=!0,y.addEventListener("dispose",D),F(y));let he=y.source,oe=d.get(he);oe===void 0&&(oe={},d.set(he,oe));let xe=ee(y);if(xe!==C.__cacheKey){oe[xe]===void 0&&(oe[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[xe].usedTimes++;let ve=oe[C.__cacheKey];ve!==void 0&&(oe[C.__cacheKey].usedTimes--,ve.usedTimes===0&&V(y)),C.__cacheKey=xe,C.__webglTexture=oe[xe].texture}return X}function it(C,y,X){return Math.floor(Math.floor(C/X)/y)}function $t(C,y,X,he){let xe=C.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,y.width,y.height,X,he,y.data);else{xe.sort((O,se)=>O.start-se.start);let ve=0;for(let O=1;O<xe.length;O++){let se=xe[ve],ie=xe[O],we=se.start+se.count,ge=it(ie.start,y.width,4),Se=it(se.start,y.width,4);ie.start<=we+1&&ge===Se&&it(ie.start+ie.count-1,y.width,4)===ge?se.count=Math.max(se.count,ie.start+ie.count-se.start):(++ve,xe[ve]=ie)}xe.length=ve+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ne=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,y.width);for(let O=0,se=xe.length;O<se;O++){let ie=xe[O],we=Math.floor(ie.start/4),ge=Math.ceil(ie.count/4),Se=we%y.width,We=Math.floor(we/y.width),je=ge,le=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,Se,We,je,le,X,he,y.data)}C.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function zt(C,y,X){let he=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(he=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(he=n.TEXTURE_3D);let oe=ht(C,y),xe=y.source;t.bindTexture(he,C.__webglTexture,n.TEXTURE0+X);let ve=i.get(xe);if(xe.version!==ve.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let le=ot.getPrimaries(ot.workingColorSpace),Be=y.colorSpace===Rn?null:ot.getPrimaries(y.colorSpace),et=y.colorSpace===Rn||le===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment);let ne=_(y.image,!1,r.maxTextureSize);ne=He(y,ne);let pe=s.convert(y.format,y.colorSpace),O=s.convert(y.type),se=A(y.internalFormat,pe,O,y.normalized,y.colorSpace,y.isVideoTexture);dt(he,y);let ie,we=y.mipmaps,ge=y.isVideoTexture!==!0,Se=ve.__version===void 0||oe===!0,We=xe.dataReady,je=b(y,ne);if(y.isDepthTexture)se=x(y.format===xn,y.type),Se&&(ge?t.texStorage2D(n.TEXTURE_2D,1,se,ne.width,ne.height):t.texImage2D(n.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,O,null));else if(y.isDataTexture)if(we.length>0){ge&&Se&&t.texStorage2D(n.TEXTURE_2D,je,se,we[0].width,we[0].height);for(let le=0,Be=we.length;le<Be;le++)ie=we[le],ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,ie.width,ie.height,pe,O,ie.data):t.texImage2D(n.TEXTURE_2D,le,se,ie.width,ie.height,0,pe,O,ie.data);y.generateMipmaps=!1}else ge?(Se&&t.texStorage2D(n.TEXTURE_2D,je,se,ne.width,ne.height),We&&$t(y,ne,pe,O)):t.texImage2D(n.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,O,ne.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){ge&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,se,we[0].width,we[0].height,ne.depth);for(let le=0,Be=we.length;le<Be;le++)if(ie=we[le],y.format!==Fi)if(pe!==null)if(ge){if(We)if(y.layerUpdates.size>0){let et=Uf(ie.width,ie.height,y.format,y.type);for(let Re of y.layerUpdates){let lt=ie.data.subarray(Re*et/ie.data.BYTES_PER_ELEMENT,(Re+1)*et/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,Re,ie.width,ie.height,1,pe,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,ie.width,ie.height,ne.depth,pe,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,le,se,ie.width,ie.height,ne.depth,0,ie.data,0,0);else Ge("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,ie.width,ie.height,ne.depth,pe,O,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,le,se,ie.width,ie.height,ne.depth,0,pe,O,ie.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{ge&&Se&&t.texStorage2D(n.TEXTURE_2D,je,se,we[0].width,we[0].height);for(let le=0,Be=we.length;le<Be;le++)ie=we[le],y.format!==Fi?pe!==null?ge?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,le,0,0,ie.width,ie.height,pe,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,le,se,ie.width,ie.height,0,ie.data):Ge("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,ie.width,ie.height,pe,O,ie.data):t.texImage2D(n.TEXTURE_2D,le,se,ie.width,ie.height,0,pe,O,ie.data)}else if(y.isDataArrayTexture)if(ge){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,se,ne.width,ne.height,ne.depth),We)if(y.layerUpdates.size>0){let le=Uf(ne.width,ne.height,y.format,y.type);for(let Be of y.layerUpdates){let et=ne.data.subarray(Be*le/ne.data.BYTES_PER_ELEMENT,(Be+1)*le/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,ne.width,ne.height,1,pe,O,et)}y.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,pe,O,ne.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,se,ne.width,ne.height,ne.depth,0,pe,O,ne.data);else if(y.isData3DTexture)ge?(Se&&t.texStorage3D(n.TEXTURE_3D,je,se,ne.width,ne.height,ne.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,pe,O,ne.data)):t.texImage3D(n.TEXTURE_3D,0,se,ne.width,ne.height,ne.depth,0,pe,O,ne.data);else if(y.isFramebufferTexture){if(Se)if(ge)t.texStorage2D(n.TEXTURE_2D,je,se,ne.width,ne.height);else{let le=ne.width,Be=ne.height;for(let et=0;et<je;et++)t.texImage2D(n.TEXTURE_2D,et,se,le,Be,0,pe,O,null),le>>=1,Be>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in n){let le=n.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),ne.parentNode!==le){le.appendChild(ne),f.add(y),le.onpaint=Be=>{let et=Be.changedElements;for(let Re of f)et.includes(Re.image)&&(Re.needsUpdate=!0)},le.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ne);else{let et=n.RGBA,Re=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Re,lt,ne)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&Se){let le=Ze(we[0]);t.texStorage2D(n.TEXTURE_2D,je,se,le.width,le.height)}for(let le=0,Be=we.length;le<Be;le++)ie=we[le],ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,pe,O,ie):t.texImage2D(n.TEXTURE_2D,le,se,pe,O,ie);y.generateMipmaps=!1}else if(ge){if(Se){let le=Ze(ne);t.texStorage2D(n.TEXTURE_2D,je,se,le.width,le.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,O,ne)}else t.texImage2D(n.TEXTURE_2D,0,se,pe,O,ne);w(y)&&y.mipmapsAutoUpdate===!0&&S(he),ve.__version=xe.version,y.onUpdate&&y.onUpdate(y)}C.__version=y.version}function pi(C,y,X){if(y.image.length!==6)return;let he=ht(C,y),oe=y.source;t.bindTexture(n.TEXTURE_CUBE_MAP,C.__webglTexture,n.TEXTURE0+X);let xe=i.get(oe);if(oe.version!==xe.__version||he===!0){t.activeTexture(n.TEXTURE0+X);let ve=ot.getPrimaries(ot.workingColorSpace),te=y.colorSpace===Rn?null:ot.getPrimaries(y.colorSpace),ne=y.colorSpace===Rn||ve===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let pe=y.isCompressedTexture||y.image[0].isCompressedTexture,O=y.image[0]&&y.image[0].isDataTexture,se=[];for(let Re=0;Re<6;Re++)!pe&&!O?se[Re]=_(y.image[Re],!0,r.maxCubemapSize):se[Re]=O?y.image[Re].image:y.image[Re],se[Re]=He(y,se[Re]);let ie=se[0],we=s.convert(y.format,y.colorSpace),ge=s.convert(y.type),Se=A(y.internalFormat,we,ge,y.normalized,y.colorSpace),We=y.isVideoTexture!==!0,je=xe.__version===void 0||he===!0,le=oe.dataReady,Be=b(y,ie);dt(n.TEXTURE_CUBE_MAP,y);let et;if(y.isDepthTexture){if(Se=x(y.format===xn,y.type),je)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ie.width,ie.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,ie.width,ie.height,0,we,ge,null)}else if(pe){We&&je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,ie.width,ie.height);for(let Re=0;Re<6;Re++){et=se[Re].mipmaps;for(let lt=0;lt<et.length;lt++){let Vt=et[lt];y.format!==Fi?we!==null?We?le&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Vt.width,Vt.height,we,Vt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Se,Vt.width,Vt.height,0,Vt.data):Ge("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Vt.width,Vt.height,we,ge,Vt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Se,Vt.width,Vt.height,0,we,ge,Vt.data)}}}else{if(et=y.mipmaps,We&&je){et.length>0&&Be++;let Re=Ze(se[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(O){We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,se[Re].width,se[Re].height,we,ge,se[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,se[Re].width,se[Re].height,0,we,ge,se[Re].data);for(let lt=0;lt<et.length;lt++){let Ki=et[lt].image[Re].image;We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,Ki.width,Ki.height,we,ge,Ki.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Se,Ki.width,Ki.height,0,we,ge,Ki.data)}}else{We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,we,ge,se[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,we,ge,se[Re]);for(let lt=0;lt<et.length;lt++){let Vt=et[lt];We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,we,ge,Vt.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Se,we,ge,Vt.image[Re])}}}w(y)&&y.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),xe.__version=oe.version,y.onUpdate&&y.onUpdate(y)}C.__version=y.version}function Nt(C,y,X,he,oe,xe){let ve=s.convert(X.format,X.colorSpace),te=s.convert(X.type),ne=A(X.internalFormat,ve,te,X.normalized,X.colorSpace),pe=i.get(y),O=i.get(X);if(O.__renderTarget=y,!pe.__hasExternalTextures){let se=Math.max(1,y.width>>xe),ie=Math.max(1,y.height>>xe);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,xe,ne,se,ie,y.depth,0,ve,te,null):t.texImage2D(oe,xe,ne,se,ie,0,ve,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,C),be(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,he,oe,O.__webglTexture,0,st(y)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,he,oe,O.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Ci(C,y,X){if(n.bindRenderbuffer(n.RENDERBUFFER,C),y.depthBuffer){let he=y.depthTexture,oe=he&&he.isDepthTexture?he.type:null,xe=x(y.stencilBuffer,oe),ve=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;be(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(y),xe,y.width,y.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(y),xe,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,xe,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,C)}else{let he=y.textures;for(let oe=0;oe<he.length;oe++){let xe=he[oe],ve=s.convert(xe.format,xe.colorSpace),te=s.convert(xe.type),ne=A(xe.internalFormat,ve,te,xe.normalized,xe.colorSpace);be(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(y),ne,y.width,y.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(y),ne,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,ne,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Mt(C,y,X){let he=y.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,C),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(y.depthTexture);oe.__renderTarget=y;let xe=he?y.depthTexture.image[0]:y.depthTexture.image;(!oe.__webglTexture||xe.width!==y.width||xe.height!==y.height)&&(xe.width=y.width,xe.height=y.height,y.depthTexture.needsUpdate=!0),he?ye(y.depthTexture,0):me(y.depthTexture,0);let ve=oe.__webglTexture,te=st(y),ne=he?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,pe=y.depthTexture.format===xn?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(y.depthTexture.format===an)be(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ne,ve,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ne,ve,0);else if(y.depthTexture.format===xn)be(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ne,ve,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ne,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function bi(C){let y=i.get(C),X=C.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==C.depthTexture){let he=C.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),he){let oe=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,he.removeEventListener("dispose",oe)};he.addEventListener("dispose",oe),y.__depthDisposeCallback=oe}y.__boundDepthTexture=he}if(C.depthTexture&&!y.__autoAllocateDepthBuffer)if(X)for(let he=0;he<6;he++)Mt(y.__webglFramebuffer[he],C,he);else C.texture.mipmaps.length>0?Mt(y.__webglFramebuffer[0],C,0):Mt(y.__webglFramebuffer,C,0);else if(X){y.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[he]),y.__webglDepthbuffer[he]===void 0)y.__webglDepthbuffer[he]=n.createRenderbuffer(),Ci(y.__webglDepthbuffer[he],C,!1);else{let oe=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=y.__webglDepthbuffer[he];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),Ci(y.__webglDepthbuffer,C,!1);else{let oe=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function ni(C,y,X){let he=i.get(C);y!==void 0&&Nt(he.__webglFramebuffer,C,C.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&bi(C)}function mi(C){let y=C.texture,X=i.get(C),he=i.get(y);C.addEventListener("dispose",k),F(C);let oe=C.textures,xe=C.isWebGLCubeRenderTarget===!0,ve=oe.length>1;if(ve||(he.__webglTexture===void 0&&(he.__webglTexture=n.createTexture()),he.__version=y.version,o.memory.textures++),xe){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(y.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let ne=0;ne<y.mipmaps.length;ne++)X.__webglFramebuffer[te][ne]=n.createFramebuffer()}else X.__webglFramebuffer[te]=n.createFramebuffer()}else{if(y.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<y.mipmaps.length;te++)X.__webglFramebuffer[te]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(ve)for(let te=0,ne=oe.length;te<ne;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(C.samples>0&&be(C)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ne=oe[te];X.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let pe=s.convert(ne.format,ne.colorSpace),O=s.convert(ne.type),se=A(ne.internalFormat,pe,O,ne.normalized,ne.colorSpace,C.isXRRenderTarget===!0),ie=st(C);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,se,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,X.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),C.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),Ci(X.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,he.__webglTexture),dt(n.TEXTURE_CUBE_MAP,y);for(let te=0;te<6;te++)if(y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)Nt(X.__webglFramebuffer[te][ne],C,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ne);else Nt(X.__webglFramebuffer[te],C,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);w(y)?S(n.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let te=0,ne=oe.length;te<ne;te++){let pe=oe[te],O=i.get(pe),se=n.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(se=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(se,O.__webglTexture),dt(se,pe),Nt(X.__webglFramebuffer,C,pe,n.COLOR_ATTACHMENT0+te,se,0),w(pe)&&S(se)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(te=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,he.__webglTexture),dt(te,y),y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)Nt(X.__webglFramebuffer[ne],C,y,n.COLOR_ATTACHMENT0,te,ne);else Nt(X.__webglFramebuffer,C,y,n.COLOR_ATTACHMENT0,te,0);w(y)?S(te):y.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&bi(C)}function B(C){let y=C.textures;for(let X=0,he=y.length;X<he;X++){let oe=y[X];if(w(oe)&&oe.mipmapsAutoUpdate===!0){let xe=R(C),ve=i.get(oe).__webglTexture;t.bindTexture(xe,ve),S(xe),t.unbindTexture()}}}let Ce=[];function Je(C){if(C.samples>0){if(be(C)===!1){let y=C.textures,X=C.width,he=C.height,oe=n.COLOR_BUFFER_BIT,xe=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(C),te=y.length>1;if(te)for(let pe=0;pe<y.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let pe=0;pe<y.length;pe++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=i.get(y[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,X,he,0,0,X,he,oe,n.NEAREST),l===!0&&(Ce.length=0,Ce.push(n.COLOR_ATTACHMENT0+pe),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ce.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<y.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=i.get(y[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let y=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function st(C){return Math.min(r.maxSamples,C.samples)}function be(C){let y=i.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Ut(C){let y=o.render.frame;h.get(C)!==y&&(h.set(C,y),C.update())}function He(C,y){let X=C.colorSpace,he=C.format,oe=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||X!==cs&&X!==Rn&&(ot.getTransfer(X)===_t?(he!==Fi||oe!==hi)&&Ge("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ut("WebGLTextures: Unsupported texture color space:",X)),y}function Ze(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=j,this.getTextureUnits=re,this.setTextureUnits=ue,this.setTexture2D=me,this.setTexture2DArray=_e,this.setTexture3D=Ae,this.setTextureCube=ye,this.rebindTextures=ni,this.setupRenderTarget=mi,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=bi,this.setupFrameBufferTexture=Nt,this.useMultisampledRTT=be,this.dispose=W}function ox(n,e){function t(i,r=Rn){let s,o=ot.getTransfer(r);if(i===hi)return n.UNSIGNED_BYTE;if(i===Ws)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Xs)return n.UNSIGNED_SHORT_5_5_5_1;if(i===kl)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===zl)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Ol)return n.BYTE;if(i===Bl)return n.SHORT;if(i===vr)return n.UNSIGNED_SHORT;if(i===Vs)return n.INT;if(i===Ii)return n.UNSIGNED_INT;if(i===fi)return n.FLOAT;if(i===Ui)return n.HALF_FLOAT;if(i===Gl)return n.ALPHA;if(i===Hl)return n.RGB;if(i===Fi)return n.RGBA;if(i===an)return n.DEPTH_COMPONENT;if(i===xn)return n.DEPTH_STENCIL;if(i===qs)return n.RED;if(i===Ys)return n.RED_INTEGER;if(i===_n)return n.RG;if(i===$s)return n.RG_INTEGER;if(i===Ks)return n.RGBA_INTEGER;if(i===Zs||i===Js||i===Qs||i===js)if(o===_t)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===Zs)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Js)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Qs)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===js)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===Zs)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Js)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Qs)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===js)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ha||i===fa||i===ua||i===da)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===ha)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===fa)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ua)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===da)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===pa||i===ma||i===ga||i===xa||i===_a||i===as||i===va)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===pa||i===ma)return o===_t?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===ga)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===xa)return s.COMPRESSED_R11_EAC;if(i===_a)return s.COMPRESSED_SIGNED_R11_EAC;if(i===as)return s.COMPRESSED_RG11_EAC;if(i===va)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ma||i===Sa||i===ya||i===ba||i===wa||i===Ea||i===Ta||i===Aa||i===Ra||i===Ca||i===Pa||i===La||i===Da||i===Na)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===Ma)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Sa)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ya)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ba)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===wa)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ea)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ta)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Aa)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Ra)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ca)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Pa)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===La)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Da)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Na)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ia||i===Ua||i===Fa)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===Ia)return o===_t?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Ua)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Fa)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Oa||i===Ba||i===ls||i===ka)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===Oa)return s.COMPRESSED_RED_RGTC1_EXT;if(i===Ba)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ls)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===ka)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===zn?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var cy=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,hy=`
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

}`,Ic=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new yo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new tn({vertexShader:cy,fragmentShader:hy,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new St(new wo(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}};var Uc=class extends Wi{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,h=null,f=null,u=null,d=null,g=null,M=typeof XRWebGLBinding<"u",p=new Ic,m={},_=t.getContextAttributes(),w=null,S=null,R=[],A=[],x=new Ke,b=null,F=null,L=new Bi;L.viewport=new bt;let D=new Bi;D.viewport=new bt;let k=[L,D],G=new Ac,U=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=R[ee];return me===void 0&&(me=new ao,R[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=R[ee];return me===void 0&&(me=new ao,R[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=R[ee];return me===void 0&&(me=new ao,R[ee]=me),me.getHandSpace()};function Y(ee){let me=A.indexOf(ee.inputSource);if(me===-1)return;let _e=R[me];_e!==void 0&&(_e.update(ee.inputSource,ee.frame,c||o),_e.dispatchEvent({type:ee.type,data:ee.inputSource}))}function V(){r.removeEventListener("select",Y),r.removeEventListener("selectstart",Y),r.removeEventListener("selectend",Y),r.removeEventListener("squeeze",Y),r.removeEventListener("squeezestart",Y),r.removeEventListener("squeezeend",Y),r.removeEventListener("end",V),r.removeEventListener("inputsourceschange",ce);for(let ee=0;ee<R.length;ee++){let me=A[ee];me!==null&&(A[ee]=null,R[ee].disconnect(me))}U=null,W=null,p.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(w),d=null,u=null,f=null,r=null,S=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(b),e.setSize(x.width,x.height,!1),F!==null){let ee=F.camera;ee.fov=F.fov,ee.zoom=F.zoom,ee.updateProjectionMatrix(),F=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){s=ee,i.isPresenting===!0&&Ge("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ge("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return u!==null?u:d},this.getBinding=function(){return f===null&&M&&(f=new XRWebGLBinding(r,t)),f},this.getFrame=function(){return g},this.getSession=function(){return r},this.setSession=async function(ee){if(r=ee,r!==null){if(w=e.getRenderTarget(),r.addEventListener("select",Y),r.addEventListener("selectstart",Y),r.addEventListener("selectend",Y),r.addEventListener("squeeze",Y),r.addEventListener("squeezestart",Y),r.addEventListener("squeezeend",Y),r.addEventListener("end",V),r.addEventListener("inputsourceschange",ce),_.xrCompatible!==!0&&await t.makeXRCompatible(),b=e.getPixelRatio(),e.getSize(x),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,Ae=null,ye=null;_.depth&&(ye=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=_.stencil?xn:an,Ae=_.stencil?zn:Ii);let qe={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:s};f=this.getBinding(),u=f.createProjectionLayer(qe),r.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),S=new Hi(u.textureWidth,u.textureHeight,{format:Fi,type:hi,depthTexture:new yn(u.textureWidth,u.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let _e={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:s};d=new XRWebGLLayer(r,t,_e),r.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new Hi(d.framebufferWidth,d.framebufferHeight,{format:Fi,type:hi,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),fe.setContext(r),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ce(ee){for(let me=0;me<ee.removed.length;me++){let _e=ee.removed[me],Ae=A.indexOf(_e);Ae>=0&&(A[Ae]=null,R[Ae].disconnect(_e))}for(let me=0;me<ee.added.length;me++){let _e=ee.added[me],Ae=A.indexOf(_e);if(Ae===-1){for(let qe=0;qe<R.length;qe++)if(qe>=A.length){A.push(_e),Ae=qe;break}else if(A[qe]===null){A[qe]=_e,Ae=qe;break}if(Ae===-1)break}let ye=R[Ae];ye&&ye.connect(_e)}}function Z(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(r===null)return;let me=ee.near,_e=ee.far;p.texture!==null&&(p.depthNear>0&&(me=p.depthNear),p.depthFar>0&&(_e=p.depthFar)),G.near=D.near=L.near=me,G.far=D.far=L.far=_e,(U!==G.near||W!==G.far)&&(r.updateRenderState({depthNear:G.near,depthFar:G.far}),U=G.near,W=G.far),G.layers.mask=ee.layers.mask|6,L.layers.mask=G.layers.mask&-5,D.layers.mask=G.layers.mask&-3;let Ae=ee.parent,ye=G.cameras;Z(G,Ae);for(let qe=0;qe<ye.length;qe++)Z(ye[qe],Ae);G.projectionMatrix.copy(L.projectionMatrix),G.projectionMatrixInverse.copy(L.projectionMatrixInverse),F===null&&ee.isPerspectiveCamera&&(F={camera:ee,fov:ee.fov,zoom:ee.zoom}),j(ee,G,Ae)};function j(ee,me,_e){_e===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(_e.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Ga*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(u===null&&d===null))return l},this.setFoveation=function(ee){l=ee,u!==null&&(u.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(G)},this.getCameraTexture=function(ee){return m[ee]};let re=null;function ue(ee,me){if(h=me.getViewerPose(c||o),g=me,h!==null){let _e=h.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let Ae=!1;_e.length!==G.cameras.length&&(G.cameras.length=0,Ae=!0);for(let Ve=0;Ve<_e.length;Ve++){let dt=_e[Ve],ht=null;if(d!==null)ht=d.getViewport(dt);else{let $t=f.getViewSubImage(u,dt);ht=$t.viewport,Ve===0&&(e.setRenderTargetTextures(S,$t.colorTexture,$t.depthStencilTexture),e.setRenderTarget(S))}let it=k[Ve];it===void 0&&(it=new Bi,it.layers.enable(Ve),it.viewport=new bt,k[Ve]=it),it.matrix.fromArray(dt.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(dt.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ht.x,ht.y,ht.width,ht.height),Ve===0&&(G.matrix.copy(it.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Ae===!0&&G.cameras.push(it)}let ye=r.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&M){f=i.getBinding();let Ve=f.getDepthInformation(_e[0]);Ve&&Ve.isValid&&Ve.texture&&p.init(Ve,r.renderState)}if(ye&&ye.includes("camera-access")&&M){e.state.unbindTexture(),f=i.getBinding();for(let Ve=0;Ve<_e.length;Ve++){let dt=_e[Ve].camera;if(dt){let ht=m[dt];ht||(ht=new yo,m[dt]=ht);let it=f.getCameraImage(dt);ht.sourceTexture=it}}}}for(let _e=0;_e<R.length;_e++){let Ae=A[_e],ye=R[_e];Ae!==null&&ye!==void 0&&ye.update(Ae,me,c||o)}re&&re(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let fe=new Rc;fe.setAnimationLoop(ue),this.setAnimationLoop=function(ee){re=ee},this.dispose=function(){}}};var fy=new Le,ax=new $e;ax.set(-1,0,0,0,1,0,0,0,1);function lx(n,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,vc(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function r(p,m,_,w,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?s(p,m):m.isMeshLambertMaterial?(s(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(s(p,m),f(p,m)):m.isMeshPhongMaterial?(s(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(s(p,m),u(p,m),m.isMeshPhysicalMaterial&&d(p,m,S)):m.isMeshMatcapMaterial?(s(p,m),g(p,m)):m.isMeshDepthMaterial?s(p,m):m.isMeshDistanceMaterial?(s(p,m),M(p,m)):m.isMeshNormalMaterial?s(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,_,w):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function s(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===ei&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===ei&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let _=e.get(m),w=_.envMap,S=_.envMapRotation;w&&(p.envMap.value=w,p.envMapRotation.value.setFromMatrix4(fy.makeRotationFromEuler(S)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(ax),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,_,w){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*_,p.scale.value=w*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function f(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function u(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function d(p,m,_){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ei&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=_.texture,p.transmissionSamplerSize.value.set(_.width,_.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function M(p,m){let _=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(_.matrixWorld),p.nearDistance.value=_.shadow.camera.near,p.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function cx(n,e,t,i){let r={},s={};function o(_,w){let S=w.program;i.uniformBlockBinding(_,S,r[_.id])}function a(_,w){let S=r[_.id];S===void 0&&(g(_),S=l(_),r[_.id]=S,_.addEventListener("dispose",p));let R=w.program;i.updateUBOMapping(_,R);let A=e.render.frame;s[_.id]!==A&&(c(_),s[_.id]=A)}function l(_){let w=n.createBuffer(),S=_.__size,R=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,S,R),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(_){let w=r[_.id],S=_.uniforms,R=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let A=0,x=S.length;A<x;A++){let b=S[A];if(Array.isArray(b))for(let F=0,L=b.length;F<L;F++)h(b[F],A,F,R);else h(b,A,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(_,w,S,R){if(u(_,w,S,R)===!0){let A=_.__offset,x=_.value;if(Array.isArray(x)){let b=0;for(let F=0;F<x.length;F++){let L=x[F],D=M(L,!0);f(L,_.__data,b),b+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,_.__data)}}function f(_,w,S){typeof _=="number"||typeof _=="boolean"?w[S]=_:_.isMatrix3?(w[S]=_.elements[0],w[S+1]=_.elements[1],w[S+2]=_.elements[2],w[S+3]=0,w[S+4]=_.elements[3],w[S+5]=_.elements[4],w[S+6]=_.elements[5],w[S+7]=0,w[S+8]=_.elements[6],w[S+9]=_.elements[7],w[S+10]=_.elements[8],w[S+11]=0):ArrayBuffer.isView(_)?w.set(_.subarray(0,w.length-S),S):_.toArray(w,S)}function u(_,w,S,R){let A=_.value,x=w+"_"+S;if(Array.isArray(A)){R[x]===void 0&&(R[x]=[]);let b=R[x],F=!1;for(let L=0;L<A.length;L++)d(A[L],b,L)===!0&&(F=!0);return F}return d(A,R,x)}function d(_,w,S){if(w[S]===void 0)return typeof _=="number"||typeof _=="boolean"?w[S]=_:ArrayBuffer.isView(_)?w[S]=_.slice():w[S]=_.clone(),!0;{let R=w[S];if(typeof _=="number"||typeof _=="boolean"){if(R!==_)return w[S]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(R.equals(_)===!1)return R.copy(_),!0}}return!1}function g(_){let w=_.uniforms,S=0,R=16;for(let x=0,b=w.length;x<b;x++){let F=Array.isArray(w[x])?w[x]:[w[x]];for(let L=0,D=F.length;L<D;L++){let k=F[L],G=Array.isArray(k.value)?k.value:[k.value],U=Array.isArray(w[x])||Array.isArray(k.value),W=S;for(let V=0,ce=G.length;V<ce;V++){let Z=G[V],j=M(Z,U),re=S%R,ue=re%j.boundary,fe=re+ue;S+=ue,fe!==0&&R-fe<j.storage&&(S+=R-fe),V===0&&(W=S),S+=j.storage}let Y=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new Y((S-W)/Float32Array.BYTES_PER_ELEMENT),k.__offset=W}}let A=S%R;return A>0&&(S+=R-A),_.__size=S,_.__cache={},this}function M(_,w){let S={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(S.boundary=4,S.storage=4):_.isVector2?(S.boundary=8,S.storage=8):_.isVector3||_.isColor?(S.boundary=16,S.storage=12):_.isVector4?(S.boundary=16,S.storage=16):_.isMatrix3?(S.boundary=16,S.storage=48):_.isMatrix4?(S.boundary=16,S.storage=64):_.isTexture?Ge("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(S.boundary=16,S.storage=_.byteLength):Ge("WebGLRenderer: Unsupported uniform value type.",_),w===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function p(_){let w=_.target;w.removeEventListener("dispose",p),n.deleteBuffer(r[w.id]),delete r[w.id],delete s[w.id]}function m(){for(let _ in r)n.deleteBuffer(r[_]);r={},s={}}return{bind:o,update:a,dispose:m}}var uy=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),lr=null;function hx(){return lr===null&&(lr=new Tr(uy,16,16,_n,Ui),lr.name="DFG_LUT",lr.minFilter=Mi,lr.magFilter=Mi,lr.wrapS=on,lr.wrapT=on,lr.generateMipmaps=!1,lr.needsUpdate=!0),lr}var il=class{constructor(e={}){let{canvas:t=Wd(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:u=!1,outputBufferType:d=hi}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let M=d,p=new Set([Ks,$s,Ys]),m=new Set([hi,Ii,vr,zn,Ws,Xs]),_=new Uint32Array(4),w=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,A=null,x=[],b=[],F=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=mn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,D=!1,k=null,G=null,U=null,W=null;this._outputColorSpace=en;let Y=0,V=0,ce=null,Z=-1,j=null,re=new bt,ue=new bt,fe=null,ee=new Xe(0),me=0,_e=t.width,Ae=t.height,ye=1,qe=null,rt=null,Ve=new bt(0,0,_e,Ae),dt=new bt(0,0,_e,Ae),ht=!1,it=new cn,$t=new xc,zt=!1,pi=!1,Nt=new Le,Ci=new I,Mt=new bt,bi={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ni=!1;function mi(){return ce===null?ye:1}let B=i;function Ce(T,z){return t.getContext(T,z)}let Je,st,be,Ut,He,Ze,C,y,X,he,oe,xe,ve,te,ne,pe,O,se,ie,we,ge,Se,We;try{let T={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Re,!1),B===null){let z="webgl2";if(B=Ce(z,T),B===null)throw Ce(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(T){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),ut("WebGLRenderer: "+T.message),T}function je(){Je=new M0(B),Je.init(),ge=new ox(B,Je),st=new f0(B,Je,e,ge),be=new rx(B,Je),st.reversedDepthBuffer&&u&&be.buffers.depth.setReversed(!0),G=B.createFramebuffer(),U=B.createFramebuffer(),W=B.createFramebuffer(),Ut=new b0(B),He=new Y0,Ze=new sx(B,Je,be,He,st,ge,Ut),C=new v0(L),y=new Ap(B),Se=new c0(B,y),X=new S0(B,y,Ut,Se),he=new E0(B,X,y,Se,Ut),se=new w0(B,st,Ze),ne=new u0(He),oe=new q0(L,C,Je,st,Se,ne),xe=new lx(L,He),ve=new Z0,te=new j0(Je),O=new l0(L,C,be,he,g,l),pe=new nx(L,he,st),We=new cx(B,Ut,st,be),ie=new h0(B,Je,Ut),we=new y0(B,Je,Ut),Ut.programs=oe.programs,L.capabilities=st,L.extensions=Je,L.properties=He,L.renderLists=ve,L.shadowMap=pe,L.state=be,L.info=Ut}M!==hi&&(F=new T0(M,t.width,t.height,a,r,s));let le=new Uc(L,B);this.xr=le,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let T=Je.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Je.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return ye},this.setPixelRatio=function(T){T!==void 0&&(ye=T,this.setSize(_e,Ae,!1))},this.getSize=function(T){return T.set(_e,Ae)},this.setSize=function(T,z,Q=!0){if(le.isPresenting){Ge("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=T,Ae=z,t.width=Math.floor(T*ye),t.height=Math.floor(z*ye),Q===!0&&(t.style.width=T+"px",t.style.height=z+"px"),F!==null&&F.setSize(t.width,t.height),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(_e*ye,Ae*ye).floor()},this.setDrawingBufferSize=function(T,z,Q){_e=T,Ae=z,ye=Q,t.width=Math.floor(T*Q),t.height=Math.floor(z*Q),this.setViewport(0,0,T,z)},this.setEffects=function(T){if(M===hi){ut("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let z=0;z<T.length;z++)if(T[z].isOutputPass===!0){Ge("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(re)},this.getViewport=function(T){return T.copy(Ve)},this.setViewport=function(T,z,Q,q){T.isVector4?Ve.set(T.x,T.y,T.z,T.w):Ve.set(T,z,Q,q),be.viewport(re.copy(Ve).multiplyScalar(mi()).round())},this.getScissor=function(T){return T.copy(dt)},this.setScissor=function(T,z,Q,q){T.isVector4?dt.set(T.x,T.y,T.z,T.w):dt.set(T,z,Q,q),be.scissor(ue.copy(dt).multiplyScalar(mi()).round())},this.getScissorTest=function(){return ht},this.setScissorTest=function(T){be.setScissorTest(ht=T)},this.setOpaqueSort=function(T){qe=T},this.setTransparentSort=function(T){rt=T},this.getClearColor=function(T){return T.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(T=!0,z=!0,Q=!0){let q=0;if(T){let $=!1;if(ce!==null){let Ee=ce.texture.format;$=p.has(Ee)}if($){let Ee=ce.texture.type,Pe=m.has(Ee),Te=O.getClearColor(),Ne=O.getClearAlpha(),ze=Te.r,tt=Te.g,pt=Te.b;Pe?(_[0]=ze,_[1]=tt,_[2]=pt,_[3]=Ne,B.clearBufferuiv(B.COLOR,0,_)):(w[0]=ze,w[1]=tt,w[2]=pt,w[3]=Ne,B.clearBufferiv(B.COLOR,0,w))}else q|=B.COLOR_BUFFER_BIT}z&&(q|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(q|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&B.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),k=T},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),O.dispose(),ve.dispose(),te.dispose(),Ze.dispose(),He.dispose(),C.dispose(),he.dispose(),X.dispose(),Se.dispose(),We.dispose(),oe.dispose(),le.dispose(),le.removeEventListener("sessionstart",Sl),le.removeEventListener("sessionend",$n),dr.stop()};function Be(T){T.preventDefault(),df("WebGLRenderer: Context Lost."),D=!0}function et(){df("WebGLRenderer: Context Restored."),D=!1;let T=Ut.autoReset,z=pe.enabled,Q=pe.autoUpdate,q=pe.needsUpdate,$=pe.type;je(),Ut.autoReset=T,pe.enabled=z,pe.autoUpdate=Q,pe.needsUpdate=q,pe.type=$}function Re(T){ut("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function lt(T){let z=T.target;z.removeEventListener("dispose",lt),Vt(z)}function Vt(T){Ki(T),He.remove(T)}function Ki(T){let z=He.get(T).programs;z!==void 0&&(z.forEach(function(Q){oe.releaseProgram(Q)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,Q,q,$,Ee){z===null&&(z=bi);let Pe=$.isMesh&&$.matrixWorld.determinantAffine()<0,Te=Ko(T,z,Q,q,$);be.setMaterial(q,Pe);let Ne=Q.index,ze=1;if(q.wireframe===!0){if(Ne=X.getWireframeAttribute(Q),Ne===void 0)return;ze=2}let tt=Q.drawRange,pt=Q.attributes.position,ke=tt.start*ze,mt=(tt.start+tt.count)*ze;Ee!==null&&(ke=Math.max(ke,Ee.start*ze),mt=Math.min(mt,(Ee.start+Ee.count)*ze)),Ne!==null?(ke=Math.max(ke,0),mt=Math.min(mt,Ne.count)):pt!=null&&(ke=Math.max(ke,0),mt=Math.min(mt,pt.count));let jt=mt-ke;if(jt<0||jt===1/0)return;Se.setup($,q,Te,Q,Ne);let Pt,Lt=ie;if(Ne!==null&&(Pt=y.get(Ne),Lt=we,Lt.setIndex(Pt)),$.isMesh)q.wireframe===!0?(be.setLineWidth(q.wireframeLinewidth*mi()),Lt.setMode(B.LINES)):Lt.setMode(B.TRIANGLES);else if($.isLine){let wi=q.linewidth;wi===void 0&&(wi=1),be.setLineWidth(wi*mi()),$.isLineSegments?Lt.setMode(B.LINES):$.isLineLoop?Lt.setMode(B.LINE_LOOP):Lt.setMode(B.LINE_STRIP)}else $.isPoints?Lt.setMode(B.POINTS):$.isSprite&&Lt.setMode(B.TRIANGLES);if($.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Lt.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let wi=$._multiDrawStarts,Fe=$._multiDrawCounts,gi=$._multiDrawCount,xt=Ne?y.get(Ne).bytesPerElement:1,mr=He.get(q).currentProgram.getUniforms();for(let xi=0;xi<gi;xi++)mr.setValue(B,"_gl_DrawID",xi),Lt.render(wi[xi]/xt,Fe[xi])}else if($.isInstancedMesh)Lt.renderInstances(ke,jt,$.count);else if(Q.isInstancedBufferGeometry){let wi=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Fe=Math.min(Q.instanceCount,wi);Lt.renderInstances(ke,jt,Fe)}else Lt.render(ke,jt)};function qo(T,z,Q,q){k!==null&&T.isNodeMaterial&&k.setObject(q,T),zt===!0&&ne.setState(T,Q,!1),T.transparent===!0&&T.side===zi&&T.forceSinglePass===!1?(T.side=ei,T.needsUpdate=!0,Kn(T,z,q),T.side=sn,T.needsUpdate=!0,Kn(T,z,q),T.side=zi):Kn(T,z,q)}this.compile=function(T,z,Q=null){Q===null&&(Q=T),k!==null&&k.renderStart(T,z,Q),A=te.get(Q),A.init(z),b.push(A),Q.traverseVisible(function($){$.isLight&&$.layers.test(z.layers)&&(A.pushLight($),$.castShadow&&A.pushShadow($))}),T!==Q&&T.traverseVisible(function($){$.isLight&&$.layers.test(z.layers)&&(A.pushLight($),$.castShadow&&A.pushShadow($))}),A.setupLights(),k!==null&&k.updateLights(A.state.lightsArray),pi=this.localClippingEnabled,zt=ne.init(this.clippingPlanes,pi),zt===!0&&ne.setGlobalState(this.clippingPlanes,z),k!==null&&pe.render(A.state.shadowsArray,Q,z);let q=new Set;return T.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Ee=$.material;if(Ee)if(Array.isArray(Ee))for(let Pe=0;Pe<Ee.length;Pe++){let Te=Ee[Pe];qo(Te,Q,z,$),q.add(Te)}else qo(Ee,Q,z,$),q.add(Ee)}),A=b.pop(),k!==null&&k.renderEnd(),q},this.compileAsync=function(T,z,Q=null){let q=this.compile(T,z,Q);return new Promise($=>{function Ee(){if(q.forEach(function(Pe){let Ne=He.get(Pe).currentProgram;(Ne===void 0||Ne.isReady())&&q.delete(Pe)}),q.size===0){$(T);return}setTimeout(Ee,10)}Je.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let Ps=null;function Zh(T){Ps&&Ps(T)}function Sl(){dr.stop()}function $n(){dr.start()}let dr=new Rc;dr.setAnimationLoop(Zh),typeof self<"u"&&dr.setContext(self),this.setAnimationLoop=function(T){Ps=T,le.setAnimationLoop(T),T===null?dr.stop():dr.start()},le.addEventListener("sessionstart",Sl),le.addEventListener("sessionend",$n),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){ut("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;k!==null&&k.renderStart(T,z);let Q=le.enabled===!0&&le.isPresenting===!0,q=F!==null&&(ce===null||Q)&&F.begin(L,ce);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(z),z=le.getCamera()),T.isScene===!0&&T.onBeforeRender(L,T,z,ce),A=te.get(T,b.length),A.init(z),A.state.textureUnits=Ze.getTextureUnits(),b.push(A),Nt.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?$t.setFromArrayCamera(z):it.setFromProjectionMatrix(Nt,Gi,z.reversedDepth),pi=this.localClippingEnabled,zt=ne.init(this.clippingPlanes,pi),R=ve.get(T,x.length),R.init(),x.push(R),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Pe=L.xr.getDepthSensingMesh();Pe!==null&&pr(Pe,z,-1/0,L.sortObjects)}pr(T,z,0,L.sortObjects),R.finish(),k!==null&&k.updateLights(A.state.lightsArray),L.sortObjects===!0&&R.sort(qe,rt),ni=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,ni&&O.addToRenderList(R,T),this.info.autoReset===!0&&this.info.reset(),zt===!0&&ne.beginShadows();let $=A.state.shadowsArray;if(pe.render($,T,z),zt===!0&&ne.endShadows(),(q&&F.hasRenderPass())===!1){let Pe=R.opaque,Te=R.transmissive;if(A.setupLights(),z.isArrayCamera){let Ne=z.cameras;if(Te.length>0)for(let ze=0,tt=Ne.length;ze<tt;ze++){let pt=Ne[ze];On(Pe,Te,T,pt)}ni&&O.render(T);for(let ze=0,tt=Ne.length;ze<tt;ze++){let pt=Ne[ze];Yo(R,T,pt,pt.viewport)}}else Te.length>0&&On(Pe,Te,T,z),ni&&O.render(T),Yo(R,T,z)}ce!==null&&V===0&&(Ze.updateMultisampleRenderTarget(ce),Ze.updateRenderTargetMipmap(ce)),q&&F.end(L),T.isScene===!0&&T.onAfterRender(L,T,z),Se.resetDefaultState(),Z=-1,j=null,b.pop(),b.length>0?(A=b[b.length-1],Ze.setTextureUnits(A.state.textureUnits),zt===!0&&ne.setGlobalState(L.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?R=x[x.length-1]:R=null,k!==null&&k.renderEnd()};function pr(T,z,Q,q){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)Q=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)A.pushLight(T),T.castShadow&&A.pushShadow(T);else if(T.isSprite){let Pe=z.isArrayCamera?$t:it;if(!T.frustumCulled||T.intersectsFrustum(Pe)){q&&Mt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Nt);let Te=he.update(T),Ne=T.material;Ne.visible&&R.push(T,Te,Ne,Q,Mt.z,null,z)}}else if(T.isMesh||T.isLine||T.isPoints){let Pe=z.isArrayCamera?$t:it;if(!T.frustumCulled||T.intersectsFrustum(Pe)){let Te=he.update(T),Ne=T.material;if(q&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),Mt.copy(T.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),Mt.copy(Te.boundingSphere.center)),Mt.applyMatrix4(T.matrixWorld).applyMatrix4(Nt)),Array.isArray(Ne)){let ze=Te.groups;for(let tt=0,pt=ze.length;tt<pt;tt++){let ke=ze[tt],mt=Ne[ke.materialIndex];mt&&mt.visible&&R.push(T,Te,mt,Q,Mt.z,ke,z)}}else Ne.visible&&R.push(T,Te,Ne,Q,Mt.z,null,z)}}}let Ee=T.children;for(let Pe=0,Te=Ee.length;Pe<Te;Pe++)pr(Ee[Pe],z,Q,q)}function Yo(T,z,Q,q){let{opaque:$,transmissive:Ee,transparent:Pe}=T;A.setupLightsView(Q),zt===!0&&ne.setGlobalState(L.clippingPlanes,Q),q&&be.viewport(re.copy(q)),$.length>0&&ri($,z,Q),Ee.length>0&&ri(Ee,z,Q),Pe.length>0&&ri(Pe,z,Q),be.buffers.depth.setTest(!0),be.buffers.depth.setMask(!0),be.buffers.color.setMask(!0),be.setPolygonOffset(!1)}function On(T,z,Q,q){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[q.id]===void 0){let ke=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[q.id]=new Hi(1,1,{generateMipmaps:!0,type:ke?Ui:hi,minFilter:gn,samples:Math.max(4,st.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ot.workingColorSpace})}let Ee=A.state.transmissionRenderTarget[q.id],Pe=q.viewport||re;Ee.setSize(Pe.z*L.transmissionResolutionScale,Pe.w*L.transmissionResolutionScale);let Te=L.getRenderTarget(),Ne=L.getActiveCubeFace(),ze=L.getActiveMipmapLevel();L.setRenderTarget(Ee),L.getClearColor(ee),me=L.getClearAlpha(),me<1&&L.setClearColor(16777215,.5),L.clear(),ni&&O.render(Q);let tt=L.toneMapping;L.toneMapping=mn;let pt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),A.setupLightsView(q),zt===!0&&ne.setGlobalState(L.clippingPlanes,q),ri(T,Q,q),Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee),Je.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let mt=0,jt=z.length;mt<jt;mt++){let Pt=z[mt],{object:Lt,geometry:wi,material:Fe,group:gi}=Pt;if(Fe.side===zi&&Lt.layers.test(q.layers)){let xt=Fe.side;Fe.side=ei,Fe.needsUpdate=!0,li(Lt,Q,q,wi,Fe,gi),Fe.side=xt,Fe.needsUpdate=!0,ke=!0}}ke===!0&&(Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee))}L.setRenderTarget(Te,Ne,ze),L.setClearColor(ee,me),pt!==void 0&&(q.viewport=pt),L.toneMapping=tt}function ri(T,z,Q){let q=z.isScene===!0?z.overrideMaterial:null;for(let $=0,Ee=T.length;$<Ee;$++){let Pe=T[$],{object:Te,geometry:Ne,group:ze}=Pe,tt=Pe.material;tt.allowOverride===!0&&q!==null&&(tt=q),Te.layers.test(Q.layers)&&li(Te,z,Q,Ne,tt,ze)}}function li(T,z,Q,q,$,Ee){k!==null&&$.isNodeMaterial&&k.setObject(T,$),T.onBeforeRender(L,z,Q,q,$,Ee),T.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),$.onBeforeRender(L,z,Q,q,T,Ee),$.transparent===!0&&$.side===zi&&$.forceSinglePass===!1?($.side=ei,$.needsUpdate=!0,L.renderBufferDirect(Q,z,q,$,T,Ee),$.side=sn,$.needsUpdate=!0,L.renderBufferDirect(Q,z,q,$,T,Ee),$.side=zi):L.renderBufferDirect(Q,z,q,$,T,Ee),T.onAfterRender(L,z,Q,q,$,Ee)}function ci(T){let z=0;for(let Q of T)Q.texture!==null&&z++;return z}function Kn(T,z,Q){z.isScene!==!0&&(z=bi);let q=He.get(T),$=A.state.lights,Ee=A.state.shadowsArray,Pe=$.state.version,Te=oe.getParameters(T,$.state,Ee,z,Q,A.state.lightProbeGridArray),Ne=oe.getProgramCacheKey(Te),ze=q.programs;q.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?z.environment:null,q.fog=z.fog;let tt=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;q.envMap=C.get(T.envMap||q.environment,tt),q.envMapRotation=q.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,ze===void 0&&(T.addEventListener("dispose",lt),ze=new Map,q.programs=ze,q.programVariants=new Map);let pt=ze.get(Ne);if(pt!==void 0){if(q.currentProgram===pt&&q.lightsStateVersion===Pe)return $o(T,Te),pt}else Te.uniforms=oe.getUniforms(T),k!==null&&T.isNodeMaterial&&k.build(T,Q,Te),T.onBeforeCompile(Te,L),pt=oe.acquireProgram(Te,Ne),ze.set(Ne,pt),q.uniforms=Te.uniforms;let ke=q.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(ke.clippingPlanes=ne.uniform),$o(T,Te),q.needsLights=Ir(T),q.lightsStateVersion=Pe,q.needsLights&&(ke.ambientLightColor.value=$.state.ambient,ke.lightProbe.value=$.state.probe,ke.sunLights.value=$.state.sun,ke.sunLightShadows.value=$.state.sunShadow,ke.directionalLights.value=$.state.directional,ke.directionalLightShadows.value=$.state.directionalShadow,ke.spotLights.value=$.state.spot,ke.spotLightShadows.value=$.state.spotShadow,ke.rectAreaLights.value=$.state.rectArea,ke.ltc_1.value=$.state.rectAreaLTC1,ke.ltc_2.value=$.state.rectAreaLTC2,ke.pointLights.value=$.state.point,ke.pointLightShadows.value=$.state.pointShadow,ke.hemisphereLights.value=$.state.hemi,ke.sunShadowMatrix.value=$.state.sunShadowMatrix,ke.sunShadowCascade.value=$.state.sunShadowCascade,ke.directionalShadowMatrix.value=$.state.directionalShadowMatrix,ke.spotLightMatrix.value=$.state.spotLightMatrix,ke.spotLightMap.value=$.state.spotLightMap,ke.pointShadowMatrix.value=$.state.pointShadowMatrix),q.numLightProbeGrids=ci(A.state.lightProbeGridArray),q.currentProgram=pt,q.uniformsList=null,pt}function fn(T,z,Q,q,$){let Ee=He.get(T),Pe=Ee.currentProgram.id+","+q+","+$,Te=Ee.programVariants.get(Pe);return Te===void 0?(Te=Kn(T,z,Q),Ee.programVariants.set(Pe,Te)):(Ee.currentProgram=Te,Ee.uniformsList=null,Ee.outputColorSpace=q,Ee.toneMapping=$),Te}function Nr(T){if(T.uniformsList===null){let z=T.currentProgram.getUniforms();T.uniformsList=jr.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function $o(T,z){let Q=He.get(T);Q.outputColorSpace=z.outputColorSpace,Q.batching=z.batching,Q.batchingColor=z.batchingColor,Q.instancing=z.instancing,Q.instancingColor=z.instancingColor,Q.instancingMorph=z.instancingMorph,Q.skinning=z.skinning,Q.morphTargets=z.morphTargets,Q.morphNormals=z.morphNormals,Q.morphColors=z.morphColors,Q.morphTargetsCount=z.morphTargetsCount,Q.numClippingPlanes=z.numClippingPlanes,Q.numIntersection=z.numClipIntersection,Q.vertexAlphas=z.vertexAlphas,Q.vertexTangents=z.vertexTangents,Q.toneMapping=z.toneMapping}function Ko(T,z,Q,q,$){z.isScene!==!0&&(z=bi),Ze.resetTextureUnits();let Ee=z.fog,Pe=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?z.environment:null,Te=ce===null?L.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:ot.workingColorSpace,Ne=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,ze=C.get(q.envMap||Pe,Ne),tt=q.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,pt=!!Q.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),ke=!!Q.morphAttributes.position,mt=!!Q.morphAttributes.normal,jt=!!Q.morphAttributes.color,Pt=mn;q.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Pt=L.toneMapping);let Lt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,wi=Lt!==void 0?Lt.length:0,Fe=He.get(q),gi=A.state.lights;if(zt===!0&&(pi===!0||T!==j)){let Dt=T===j&&q.id===Z;ne.setState(q,T,Dt)}let xt=!1,mr=!1;q.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==gi.state.version||$.isBatchedMesh&&Fe.batching===!1||!$.isBatchedMesh&&Fe.batching===!0||$.isBatchedMesh&&Fe.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&Fe.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&Fe.instancing===!1||!$.isInstancedMesh&&Fe.instancing===!0||$.isSkinnedMesh&&Fe.skinning===!1||!$.isSkinnedMesh&&Fe.skinning===!0||$.isInstancedMesh&&Fe.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&Fe.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&Fe.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&Fe.instancingMorph===!1&&$.morphTexture!==null||Fe.envMap!==ze||q.fog===!0&&Fe.fog!==Ee||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ne.numPlanes||Fe.numIntersection!==ne.numIntersection)||Fe.vertexAlphas!==tt||Fe.vertexTangents!==pt||Fe.morphTargets!==ke||Fe.morphNormals!==mt||Fe.morphColors!==jt||Fe.morphTargetsCount!==wi||Fe.numLightProbeGrids!==ci(A.state.lightProbeGridArray)?xt=!0:(Fe.outputColorSpace!==Te||Fe.toneMapping!==Pt)&&(mr=!0):(xt=!0,Fe.__version=q.version);let xi=Fe.currentProgram;(xt===!0||mr===!0)&&(xi=mr===!0?fn(q,z,$,Te,Pt):Kn(q,z,$),k&&q.isNodeMaterial&&k.onUpdateProgram(q,xi,Fe));let Ns=!1,Zn=!1,gr=!1,ft=xi.getUniforms(),si=Fe.uniforms;if(be.useProgram(xi.program)&&(Ns=!0,Zn=!0,gr=!0),q.id!==Z&&(Z=q.id,Zn=!0),Ns||j!==T){be.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),ft.setValue(B,"projectionMatrix",T.projectionMatrix),ft.setValue(B,"viewMatrix",T.matrixWorldInverse);let _i=ft.map.cameraPosition;_i!==void 0&&_i.setValue(B,Ci.setFromMatrixPosition(T.matrixWorld)),st.logarithmicDepthBuffer&&ft.setValue(B,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&ft.setValue(B,"isOrthographic",T.isOrthographicCamera===!0),j!==T&&(j=T,Zn=!0,gr=!0)}if(Fe.needsLights&&(gi.state.sunShadowMap.length>0&&ft.setValue(B,"sunShadowMap",gi.state.sunShadowMap,Ze),gi.state.directionalShadowMap.length>0&&ft.setValue(B,"directionalShadowMap",gi.state.directionalShadowMap,Ze),gi.state.spotShadowMap.length>0&&ft.setValue(B,"spotShadowMap",gi.state.spotShadowMap,Ze),gi.state.pointShadowMap.length>0&&ft.setValue(B,"pointShadowMap",gi.state.pointShadowMap,Ze)),$.isSkinnedMesh){ft.setOptional(B,$,"bindMatrix"),ft.setOptional(B,$,"bindMatrixInverse");let Dt=$.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),ft.setValue(B,"boneTexture",Dt.boneTexture,Ze))}$.isBatchedMesh&&(ft.setOptional(B,$,"batchingTexture"),ft.setValue(B,"batchingTexture",$._matricesTexture,Ze),ft.setOptional(B,$,"batchingIdTexture"),ft.setValue(B,"batchingIdTexture",$._indirectTexture,Ze),ft.setOptional(B,$,"batchingColorTexture"),$._colorsTexture!==null&&ft.setValue(B,"batchingColorTexture",$._colorsTexture,Ze));let Zi=Q.morphAttributes;if((Zi.position!==void 0||Zi.normal!==void 0||Zi.color!==void 0)&&se.update($,Q,xi),(Zn||Fe.receiveShadow!==$.receiveShadow)&&(Fe.receiveShadow=$.receiveShadow,ft.setValue(B,"receiveShadow",$.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&z.environment!==null&&(si.envMapIntensity.value=z.environmentIntensity),si.dfgLUT!==void 0&&(si.dfgLUT.value=hx()),Zn){if(ft.setValue(B,"toneMappingExposure",L.toneMappingExposure),Fe.needsLights&&Ls(si,gr),Ee&&q.fog===!0&&xe.refreshFogUniforms(si,Ee),xe.refreshMaterialUniforms(si,q,ye,Ae,A.state.transmissionRenderTarget[T.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Dt=S,_i=0;for(let Vi of A.state.lightProbeGridArray)Vi.texture!==null&&(Dt.textures[_i]=Vi.texture,Dt.min[_i]=Vi.boundingBox.min,Dt.max[_i]=Vi.boundingBox.max,Dt.resolution[_i]=Vi.resolution,_i++);for(let Vi in Dt)Dt[Vi].length=_i;si.probesSH.value=Dt.textures,si.probesMin.value=Dt.min,si.probesMax.value=Dt.max,si.probesResolution.value=Dt.resolution}jr.upload(B,Nr(Fe),si,Ze)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(jr.upload(B,Nr(Fe),si,Ze),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&ft.setValue(B,"center",$.center),ft.setValue(B,"modelViewMatrix",$.modelViewMatrix),ft.setValue(B,"normalMatrix",$.normalMatrix),ft.setValue(B,"modelMatrix",$.matrixWorld),q.uniformsGroups!==void 0){let Dt=q.uniformsGroups;for(let _i=0,Vi=Dt.length;_i<Vi;_i++){let yl=Dt[_i];We.update(yl,xi),We.bind(yl,xi)}}return xi}function Ls(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.sunLights.needsUpdate=z,T.sunLightShadows.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function Ir(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(T,z,Q){let q=He.get(T);q.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),He.get(T.texture).__webglTexture=z,He.get(T.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:Q,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,z){let Q=He.get(T);Q.__webglFramebuffer=z,Q.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,Q=0){ce=T,Y=z,V=Q;let q=null,$=!1,Ee=!1;if(T){let Te=He.get(T);if(Te.__useDefaultFramebuffer!==void 0){be.bindFramebuffer(B.FRAMEBUFFER,Te.__webglFramebuffer),re.copy(T.viewport),ue.copy(T.scissor),fe=T.scissorTest,be.viewport(re),be.scissor(ue),be.setScissorTest(fe),Z=-1;return}else if(Te.__webglFramebuffer===void 0)Ze.setupRenderTarget(T);else if(Te.__hasExternalTextures)Ze.rebindTextures(T,He.get(T.texture).__webglTexture,He.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let tt=T.depthTexture;if(Te.__boundDepthTexture!==tt){if(tt!==null&&He.has(tt)&&(T.width!==tt.image.width||T.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(T)}}let Ne=T.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ee=!0);let ze=He.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(ze[z])?q=ze[z][Q]:q=ze[z],$=!0):T.samples>0&&Ze.useMultisampledRTT(T)===!1?q=He.get(T).__webglMultisampledFramebuffer:Array.isArray(ze)?q=ze[Q]:q=ze,re.copy(T.viewport),ue.copy(T.scissor),fe=T.scissorTest}else re.copy(Ve).multiplyScalar(ye).floor(),ue.copy(dt).multiplyScalar(ye).floor(),fe=ht;if(Q!==0&&(q=G),be.bindFramebuffer(B.FRAMEBUFFER,q)&&be.drawBuffers(T,q),be.viewport(re),be.scissor(ue),be.setScissorTest(fe),$){let Te=He.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+z,Te.__webglTexture,Q)}else if(Ee){let Te=z;for(let Ne=0;Ne<T.textures.length;Ne++){let ze=He.get(T.textures[Ne]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ne,ze.__webglTexture,Q,Te)}}else if(T!==null&&Q!==0){let Te=He.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Te.__webglTexture,Q)}Z=-1};function Ds(T){let z=He.get(T);return(z.__readFormat!==T.format||z.__readType!==T.type)&&(z.__readFormat=T.format,z.__readType=T.type,z.__formatReadable=st.textureFormatReadable(T.format),z.__typeReadable=st.textureTypeReadable(T.type)),z}this.readRenderTargetPixels=function(T,z,Q,q,$,Ee,Pe,Te=0){if(!(T&&T.isWebGLRenderTarget)){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=He.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ne=Ne[Pe],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){be.bindFramebuffer(B.FRAMEBUFFER,Ne);try{let ze=T.textures[Te],tt=ze.format,pt=ze.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let ke=Ds(ze);if(ke.__formatReadable===!1){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-q&&Q>=0&&Q<=T.height-$&&B.readPixels(z,Q,q,$,ge.convert(tt),ge.convert(pt),Ee)}finally{let ze=ce!==null?He.get(ce).__webglFramebuffer:null;be.bindFramebuffer(B.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(T,z,Q,q,$,Ee,Pe,Te=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=He.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ne=Ne[Pe],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(z>=0&&z<=T.width-q&&Q>=0&&Q<=T.height-$){be.bindFramebuffer(B.FRAMEBUFFER,Ne);let ze=T.textures[Te],tt=ze.format,pt=ze.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let ke=Ds(ze);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.bufferData(B.PIXEL_PACK_BUFFER,Ee.byteLength,B.STREAM_READ),B.readPixels(z,Q,q,$,ge.convert(tt),ge.convert(pt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let jt=ce!==null?He.get(ce).__webglFramebuffer:null;be.bindFramebuffer(B.FRAMEBUFFER,jt);let Pt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await qd(B,Pt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Ee),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(mt),B.deleteSync(Pt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,z=null,Q=0){let q=Math.pow(2,-Q),$=Math.floor(T.image.width*q),Ee=Math.floor(T.image.height*q),Pe=z!==null?z.x:0,Te=z!==null?z.y:0;Ze.setTexture2D(T,0),B.copyTexSubImage2D(B.TEXTURE_2D,Q,0,0,Pe,Te,$,Ee),be.unbindTexture()},this.copyTextureToTexture=function(T,z,Q=null,q=null,$=0,Ee=0){let Pe,Te,Ne,ze,tt,pt,ke,mt,jt,Pt=T.isCompressedTexture?T.mipmaps[Ee]:T.image;if(Q!==null)Pe=Q.max.x-Q.min.x,Te=Q.max.y-Q.min.y,Ne=Q.isBox3?Q.max.z-Q.min.z:1,ze=Q.min.x,tt=Q.min.y,pt=Q.isBox3?Q.min.z:0;else{let ft=Math.pow(2,-$);Pe=Math.floor(Pt.width*ft),Te=Math.floor(Pt.height*ft),T.isDataArrayTexture?Ne=Pt.depth:T.isData3DTexture?Ne=Math.floor(Pt.depth*ft):Ne=1,ze=0,tt=0,pt=0}q!==null?(ke=q.x,mt=q.y,jt=q.z):(ke=0,mt=0,jt=0);let Lt=ge.convert(z.format),wi=ge.convert(z.type),Fe;z.isData3DTexture?(Ze.setTexture3D(z,0),Fe=B.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Ze.setTexture2DArray(z,0),Fe=B.TEXTURE_2D_ARRAY):(Ze.setTexture2D(z,0),Fe=B.TEXTURE_2D),be.activeTexture(B.TEXTURE0),be.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,z.flipY),be.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),be.pixelStorei(B.UNPACK_ALIGNMENT,z.unpackAlignment);let gi=be.getParameter(B.UNPACK_ROW_LENGTH),xt=be.getParameter(B.UNPACK_IMAGE_HEIGHT),mr=be.getParameter(B.UNPACK_SKIP_PIXELS),xi=be.getParameter(B.UNPACK_SKIP_ROWS),Ns=be.getParameter(B.UNPACK_SKIP_IMAGES);be.pixelStorei(B.UNPACK_ROW_LENGTH,Pt.width),be.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Pt.height),be.pixelStorei(B.UNPACK_SKIP_PIXELS,ze),be.pixelStorei(B.UNPACK_SKIP_ROWS,tt),be.pixelStorei(B.UNPACK_SKIP_IMAGES,pt);let Zn=T.isDataArrayTexture||T.isData3DTexture,gr=z.isDataArrayTexture||z.isData3DTexture;if(T.isDepthTexture){let ft=He.get(T),si=He.get(z),Zi=He.get(ft.__renderTarget),Dt=He.get(si.__renderTarget);be.bindFramebuffer(B.READ_FRAMEBUFFER,Zi.__webglFramebuffer),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let _i=0;_i<Ne;_i++)Zn&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(T).__webglTexture,$,pt+_i),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(z).__webglTexture,Ee,jt+_i)),B.blitFramebuffer(ze,tt,ze+Pe,tt+Te,ke,mt,ke+Pe,mt+Te,B.DEPTH_BUFFER_BIT,B.NEAREST);be.bindFramebuffer(B.READ_FRAMEBUFFER,null),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if($!==0||T.isRenderTargetTexture||He.has(T)){let ft=He.get(T),si=He.get(z);be.bindFramebuffer(B.READ_FRAMEBUFFER,U),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,W);for(let Zi=0;Zi<Ne;Zi++)Zn?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ft.__webglTexture,$,pt+Zi):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ft.__webglTexture,$),gr?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,si.__webglTexture,Ee,jt+Zi):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,si.__webglTexture,Ee),$!==0?B.blitFramebuffer(ze,tt,ze+Pe,tt+Te,ke,mt,ke+Pe,mt+Te,B.COLOR_BUFFER_BIT,B.NEAREST):gr?B.copyTexSubImage3D(Fe,Ee,ke,mt,jt+Zi,ze,tt,Pe,Te):B.copyTexSubImage2D(Fe,Ee,ke,mt,ze,tt,Pe,Te);be.bindFramebuffer(B.READ_FRAMEBUFFER,null),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else gr?T.isDataTexture||T.isData3DTexture?B.texSubImage3D(Fe,Ee,ke,mt,jt,Pe,Te,Ne,Lt,wi,Pt.data):z.isCompressedArrayTexture?B.compressedTexSubImage3D(Fe,Ee,ke,mt,jt,Pe,Te,Ne,Lt,Pt.data):B.texSubImage3D(Fe,Ee,ke,mt,jt,Pe,Te,Ne,Lt,wi,Pt):T.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Ee,ke,mt,Pe,Te,Lt,wi,Pt.data):T.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Ee,ke,mt,Pt.width,Pt.height,Lt,Pt.data):B.texSubImage2D(B.TEXTURE_2D,Ee,ke,mt,Pe,Te,Lt,wi,Pt);be.pixelStorei(B.UNPACK_ROW_LENGTH,gi),be.pixelStorei(B.UNPACK_IMAGE_HEIGHT,xt),be.pixelStorei(B.UNPACK_SKIP_PIXELS,mr),be.pixelStorei(B.UNPACK_SKIP_ROWS,xi),be.pixelStorei(B.UNPACK_SKIP_IMAGES,Ns),Ee===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&B.generateMipmap(Fe),be.unbindTexture()},this.initRenderTarget=function(T){He.get(T).__webglFramebuffer===void 0&&Ze.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Ze.setTextureCube(T,0):T.isData3DTexture?Ze.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Ze.setTexture2DArray(T,0):Ze.setTexture2D(T,0),be.unbindTexture()},this.resetState=function(){Y=0,V=0,ce=null,be.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Gi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=ot._getDrawingBufferColorSpace(e),t.unpackColorSpace=ot._getUnpackColorSpace()}};function fx(n,e,t,i){if(!n)return e.clone().multiplyScalar(t).setZ(i);let[r]=n,s=r*Math.exp(i/r),o=t/r;return e.clone().multiplyScalar(s*Math.sin(o)).setZ(s*Math.cos(o)-r)}function Fc(n,e,t,i,r){let[s,o]=n,a=Math.abs(i),l=i<0?-1:1,c=Math.cos(r/s),h=Math.sin(r/s),f=a*(c-l*t*h),u=a*(-h-l*t*c),d=f*Math.sin(e),g=d*Math.cos(o)-u*Math.sin(o),M=d*Math.sin(o)+u*Math.cos(o);return{circumferential:new I(0,l*f*Math.cos(e),0),radial:new I(Math.cos(o),0,-Math.sin(o)).multiplyScalar(g),axial:new I(Math.sin(o),0,Math.cos(o)).multiplyScalar(M)}}function cr(n,e){let t=n.length;if(t<2||e<=n[0])return{low:0,share:0};if(e>=n[t-1])return{low:t-2,share:1};let i=0,r=t-1;for(;r-i>1;){let o=i+r>>1;n[o]<=e?i=o:r=o}let s=n[i+1]-n[i];return{low:i,share:s>0?(e-n[i])/s:0}}function Qt(n,e,t=0){let{data:i,width:r,count:s}=n;if(s===1)return i[t];let o=e.low*r+t;return e.share?i[o]+e.share*(i[o+r]-i[o]):i[o]}function Do(n){let e=new Float64Array(n.width);for(let t=0;t<n.data.length;t++)e[t%n.width]+=n.data[t];return e.map(t=>t/Math.max(n.count,1))}var ux=(n,e)=>(n%e+e)%e;function _s(n,e,t){let i=e.side*Math.tan(n.base_helix),[r,s]=n.width,[o,a]=n.path,l=n.base_pitch,c=[i*r,i*s],h=[],f=Math.ceil((t+Math.min(...c)-a)/l),u=Math.floor((t+Math.max(...c)-o)/l);for(let d=f;d<=u;d++){let g=t-d*l,M=i?[(o-g)/i,(a-g)/i]:[r,s];if(!i&&(g<o||g>a))continue;let p=Math.max(r,Math.min(...M)),m=Math.min(s,Math.max(...M));m>=p&&h.push({pair:d,place:g,slope:i,from:p,to:m})}return h}var Oc=class{constructor(e,t){this.contact=e,this.poses=t,this.name=e.name,this.greatest=Math.max(0,...e.flanks.map(i=>dy(i.loads))),this.pairs=Math.max(0,...e.flanks.map(i=>i.forces?.width??0)),this.matrix=new Le}frame(){let{contact:e,poses:t}=this,{where:i}=t;return dx.set(...[0,1,2,3].map(r=>Qt(e.axes,i,r))).normalize(),px.set(...[0,1,2].map(r=>Qt(e.at,i,r))),this.matrix.compose(px,dx,py)}normal(e){let t=Qt(this.contact.pressure_angle,this.poses.where);return new I(Math.sin(t),e*Math.cos(t),0)}lines(){let e=this.frame();return this.contact.flanks.flatMap(t=>{let i=Qt(t.travel,this.poses.where),r=this.normal(t.side),s=(o,a)=>fx(this.contact.cone,r,o,a).applyMatrix4(e);return _s(this.contact,t,i).map(({pair:o,place:a,slope:l,from:c,to:h})=>{let{force:f,loads:u}=this.#e(t,o),d=u.reduce((p,m)=>p+m,0),g=d?u.reduce((p,m,_)=>p+m*_/(u.length-1),0)/d:.5,M=p=>{let m=c+p*(h-c);return s(a+l*m,m)};return{pair:o,side:t.side,slot:ux(o,Math.max(1,this.pairs)),from:M(0),to:M(1),at:M,centre:M(g),ray:a+l*(c+g*(h-c)),force:f,loads:u,ends:[c,h].map(p=>[a+l*p,p])}})})}#e(e,t){let i=new Float64Array(e.loads?e.loads.shape[2]:2),r=0;if(!e.loads)return{force:r,loads:i};let s=ux(t,e.forces.width),{low:o,share:a}=this.poses.where;return(a?[o,o+1]:[o]).forEach((c,h)=>{let f=h?a:1-a,u=e.travel.data[c];if(!_s(this.contact,e,u).some(g=>g.pair===t))return;r+=f*e.forces.data[c*e.forces.width+s];let d=c*e.loads.width+s*i.length;for(let g=0;g<i.length;g++)i[g]+=f*e.loads.data[d+g]}),{force:r,loads:i}}penetration(){let{penetration:e}=this.contact;return{1:Qt(e,this.poses.where,0),"-1":Qt(e,this.poses.where,1)}}pairForces(e){let t=this.matrix,i=Qt(this.contact.pressure_angle,this.poses.where),r=Math.tan(this.contact.base_helix),{cone:s}=this.contact,o=(a,l)=>s?Fc(s,i,r,a,l):{circumferential:new I(0,a*Math.cos(i),0),radial:new I(Math.abs(a)*Math.sin(i),0,0),axial:new I(0,0,-a*r)};return Array.from({length:this.pairs},(a,l)=>{let c=e.find(g=>g.slot===l&&g.force),h=o(c?.force??0,c?.ray??0),f={};for(let[g,M]of Object.entries(h))f[g]=M.length(),M.transformDirection(t).setLength(f[g]);let u=Math.hypot(...Object.values(f)),d=c?c.centre:new I().setFromMatrixPosition(t);return{state:c?c.side:0,vectors:h,values:f,at:d,total:u}})}};function dy(n){let e=0;for(let t of n?.data??[])t>e&&(e=t);return e}var dx=new Ft,px=new I,py=new I(1,1,1);var Cr=["circumferential","radial","axial"],my={circumferential:"#d55e00",radial:"#0072b2",axial:"#009e73"},hr={1:{word:"front flank",colour:"#e8b400"},"-1":{word:"back flank",colour:"#b0489a"},2:{word:"both flanks",colour:"#7a5a2a"},0:{word:"no contact",colour:"#8a8f98"}},mx=["#93a9c1","#c1ab8b","#93b5a0","#ad9fc2","#c4a0a0","#8cb0bb"],gx={shaft:"#b3b9bf",bearing:"#6b7885",housing:"#9fb3c6",carrier:"#b9b39c",spring:"#8d97a1",body:"#a9b6c0"},vx="#c2452d";function Mx(n,e,t=!1){return n==="gear"||n==="body"&&t?mx[e%mx.length]:gx[n]??gx.body}function nl(n,e){return getComputedStyle(n).getPropertyValue(`--pp-force-${e}`).trim()||my[e]}var xx=["#2296a0","#c2509a","#a88a1e","#d2484f","#6b8e23","#8f6b52","#8a8f98"],Sx=n=>Cr.some(e=>n.startsWith(`${e}_force`));function Bc(n,e,t){let i=Cr.find(r=>e.startsWith(`${r}_force`));return i?nl(n,i):xx[t%xx.length]}var _x=["#d2484f","#a88a1e","#8a68c4","#2296a0","#2f9e62"],gy={contact_loss:"#8a8f98",impact:"#d2484f",back_flank:"#b0489a",front_flank:"#e8b400",faulty_tooth:"#2296a0"};function vs(n,e){return gy[e]??_x[Math.max(n.indexOf(e),0)%_x.length]}var rl=["#440154","#3b528b","#21918c","#5ec962","#fde725"].map(n=>[1,3,5].map(e=>parseInt(n.slice(e,e+2),16)/255));function sl(n){let e=Math.max(0,Math.min(1,n))*(rl.length-1),t=Math.min(Math.floor(e),rl.length-2);return rl[t].map((i,r)=>i+(e-t)*(rl[t+1][r]-i))}var kc=n=>sl(n).map(e=>e<=.04045?e/12.92:((e+.055)/1.055)**2.4),zc=()=>`linear-gradient(to right, ${rl.map(n=>`rgb(${n.map(e=>Math.round(255*e)).join(" ")})`).join(", ")})`;var In=6,Gc=24,Wc=class{constructor(e,t){this.contact=e,this.stations=e.contact.flanks[0].loads?.shape[2]??2;let i=Gc*this.stations*In,r=new Ot;for(let a of["position","color"])r.setAttribute(a,new Rt(new Float32Array(3*i),3).setUsage(Gd));let s=[];for(let a=0;a<Gc;a++)for(let l=0;l<this.stations-1;l++)for(let c=0;c<In;c++){let h=(a*this.stations+l)*In+c,f=(a*this.stations+l)*In+(c+1)%In;s.push(h,f,h+In,f,f+In,h+In)}r.setIndex(s),this.rods=new St(r,new sr({vertexColors:!0})),this.rods.frustumCulled=!1,t.add(this.rods);let o=new Eo(1,12,8);this.paints=Object.fromEntries([1,-1].map(a=>[a,new sr({color:hr[a].colour})])),this.plain=Object.fromEntries([1,-1].map(a=>[a,this.paints[a].color.toArray()])),this.balls=Array.from({length:2*Gc},()=>{let a=new St(o,this.paints[1]);return a.visible=!1,t.add(a),a})}update(e,t,i,r,s){let o=this.contact.penetration(),a=o[1]>=o[-1]?1:-1,l=t?e.filter(d=>d.force||d.side===a).slice(0,Gc):[];this.rods.visible=l.length>0,this.balls.forEach(d=>d.visible=!1);let{position:c,color:h}=this.rods.geometry.attributes,f=!!this.contact.contact.flanks[0].loads,u=Math.min(2.6*i||1/0,.07*this.contact.contact.base_pitch);l.forEach((d,g)=>{let M=f?d.force!==0:o[d.side]>0,p=M?u:.4*u;ol.subVectors(d.to,d.from),es.set(0,0,1).cross(ol),es.lengthSq()<1e-12*ol.lengthSq()&&es.set(1,0,0).cross(ol),es.normalize(),Hc.crossVectors(ol,es).normalize();for(let m=0;m<this.stations;m++){let _=f&&r>0?kc(s(d,m)/r):this.plain[d.side],w=M?_:xy;Vc.copy(d.at(m/(this.stations-1)));for(let S=0;S<In;S++){let R=2*Math.PI*S/In,A=(g*this.stations+m)*In+S;c.setXYZ(A,Vc.x+p*(Math.cos(R)*es.x+Math.sin(R)*Hc.x),Vc.y+p*(Math.cos(R)*es.y+Math.sin(R)*Hc.y),Vc.z+p*(Math.cos(R)*es.z+Math.sin(R)*Hc.z)),h.setXYZ(A,...w)}}if(M)for(let[m,_]of[d.from,d.to].entries()){let w=this.balls[2*g+m];w.visible=!0,w.material=this.paints[d.side],w.position.copy(_),w.scale.setScalar(1.9*u)}}),c.needsUpdate=h.needsUpdate=!0,this.rods.geometry.setDrawRange(0,l.length*(this.stations-1)*In*6)}},ol=new I,es=new I,Hc=new I,Vc=new I,xy=[.29,.31,.36];var _y=.32,yx=.2,Xc=class{constructor(e,t){this.contact=e,this.root=t,this.times=1,this.plates=null}#e(){let e=new or(1,1,1);this.plates=[1,-1].flatMap(t=>[-1,1].map(i=>{let{colour:r}=hr[t],s={color:r,emissive:r,emissiveIntensity:i>0?.5:.15},o=new St(e,new Rr({...s,transparent:!0,opacity:.85}));return o.matrixAutoUpdate=!1,this.root.add(o),{mesh:o,side:t,end:i}}))}fitting(){let e=this.contact.penetration(),t=Math.max(Math.abs(e[1]),Math.abs(e[-1]),1e-7),i=.25*this.contact.contact.base_pitch/t,r=10**Math.floor(Math.log10(i));return Math.max(1,r*(i/r>=5?5:i/r>=2?2:1))}shown(){return(this.plates??[]).filter(({mesh:e})=>e.visible).map(({mesh:e})=>new I().setFromMatrixPosition(e.matrix).toArray())}update(e){if(!e&&!this.plates)return;this.plates||this.#e();let{contact:t}=this,i=t.contact.base_pitch,r=t.frame(),s=t.penetration();for(let{mesh:o,side:a,end:l}of this.plates){if(o.visible=e,!e)continue;let c=t.normal(a),h=.03*i,f=-.5*this.times*s[a]+.5*h;Xf.set(0,0,1),bx.crossVectors(Xf,c),qf.makeBasis(bx.clone().multiplyScalar(yx*i),c.clone().multiplyScalar(h),Xf.multiplyScalar(yx*i)),qf.setPosition(c.multiplyScalar(_y*i+l*f)),o.matrix.multiplyMatrices(r,qf)}}},Xf=new I,bx=new I,qf=new Le;function Ht(n,e=4){if(!Number.isFinite(n))return"\u2013";if(n===0)return"0";let t=Math.abs(n),i=t>=1e6||t<1e-4?t.toExponential(e-1).replace("e+","e"):vy(t.toPrecision(e));return(n<0?"\u2212":"")+i}function vy(n){let e=String(Number(n));return n.includes(".")&&!n.includes("e")?n:e}function qc(n){let e=n>0?3-Math.floor(Math.log10(n)):0;return e>9||e<-6?t=>Ht(t,4):t=>t.toFixed(Math.max(0,e)).replace(/^-(0(\.0*)?)$/,"$1").replace("-","\u2212")}function wx(n,e,t=n,i=t){let r=Math.abs(t),[s,o]=r>=1e6?[1e-6,"M"]:r>=1e3?[.001,"k"]:[1,""],a=n*s,l=Math.abs(i*s)>=100?1:Math.abs(i*s)>=10?2:3;return`${a<0?"\u2212":""}${Math.abs(a).toFixed(l)}\u2009${o}${e}`}var My=[[1,"m"],[.001,"mm"],[1e-6,"\xB5m"],[1e-9,"nm"]],Yf=[[1,"s"],[.001,"ms"],[1e-6,"\xB5s"]],Ex=n=>Yf[n>=.02?0:n>=2e-5?1:2];function Tx(n,e,t){let[i,r]=e.find(([s])=>Math.abs(n)>=s*.999)??e[e.length-1];return`${Ht(n/i,t)}\u2009${r}`}var Ax=n=>Tx(n,My,1).replace(/\.0+(?=\D)/,""),No=n=>n===0?"0\u2009s":Tx(n,Yf,3);function Ms(n,e){let[t,i]=Yf[e>=5e-4?0:e>=8e-7||Math.abs(n)>=.001?1:2],r=Math.max(0,Math.min(6,Math.ceil(-Math.log10(Math.max(e,1e-12)/t)-1e-9)));return`${(n/t).toFixed(r).replace("-","\u2212")}\u2009${i}`}function Rx(n){if(n>=.999)return"real time";let e=1/n;return`1/${e<10?String(Number(e.toPrecision(2))):String(Math.round(e)).replace(/\B(?=(\d{3})+$)/g,"\u2009")} of real time`}function Cx(n,[e,t],i){let{data:r,count:s}=n.unit_pressure,[o,a]=n.path,l=Math.max(0,Math.min(1,(e-o)/(a-o)))*(s-1),c=Math.min(Math.floor(l),s-2),h=n.cone?Math.exp(t/n.cone[0]):1;return(r[c]+(l-c)*(r[c+1]-r[c]))*Math.sqrt(Math.max(0,i)/h)}var Sy=({place:n,slope:e,from:t,to:i},r)=>{let s=t+r*(i-t);return[n+e*s,s]};function yy(n){if(!n.unit_pressure)return 0;let e=0;for(let t of n.flanks){if(!t.loads)continue;let[i,r,s]=t.loads.shape;for(let o=0;o<i;o++){let a=t.travel.data[t.travel.count>1?o:0];for(let l of _s(n,t,a)){let c=(l.pair%r+r)%r;for(let h=0;h<s;h++){let f=t.loads.data[(o*r+c)*s+h];f>0&&(e=Math.max(e,Cx(n,Sy(l,h/(s-1)),f)))}}}}return e}var Ss={load:{name:"load per width",legend:"load on flanks",told:n=>`${Ht(n/1e3,3)}\u2009N/mm`,of:(n,e,t)=>t,greatest:({greatest:n})=>n},pressure:{name:"pressure (Hertz)",legend:"Hertzian pressure",told:n=>`${Ht(n/1e6,3)}\u2009MPa`,of:Cx,greatest:n=>n.pressure??=yy(n.contact)}};var Px=(n,e)=>(n%e+e)%e,Lx=1.004,$f=class{constructor(e,t){this.contact=e,this.flank=t,[this.nz,this.nx]=t.surfaces[0].points.shape,this.frames=t.travel.count,this.clear()}clear(){let{nz:e,nx:t,flank:i}=this;this.done=-1,this.touched=i.surfaces.map(()=>[]),this.news={all:!0,teeth:i.surfaces.map(()=>new Set)},this.all=new Float32Array(e*t),this.each=i.surfaces.map(r=>new Float32Array(r.teeth*e*t))}upTo(e){for(e<this.done&&this.clear();this.done<e;)this.done++,this.#t(Math.max(0,this.done-1),this.done)}#e(e,t,i){let{flank:r}=this;if(!t||i<t.from||i>t.to)return null;let s=r.loads.shape[2],o=e*r.loads.width+Px(t.pair,r.forces.width)*s,a=t.to>t.from?(i-t.from)/(t.to-t.from)*(s-1):0,l=Math.min(Math.floor(a),s-2),[c,h]=[r.loads.data[o+l],r.loads.data[o+l+1]];return c+(a-l)*(h-c)}#t(e,t){let{contact:i,flank:r,nz:s,nx:o}=this,[a,l]=i.path,[c,h]=i.width,f=(l-a)/(o-1),u=r.travel.data,g=Math.abs(u[t]-u[e])>.75*i.base_pitch?[]:_s(i,r,u[e]);for(let M of _s(i,r,u[t])){let{pair:p,slope:m}=M,_=g.find(w=>w.pair===p);for(let w=0;w<s;w++){let S=c+(h-c)*w/(s-1),R=this.#e(t,M,S);if(R===null)continue;let A=this.#e(e,_,S),x=u[t]-p*i.base_pitch+m*S,b=A===null?x:u[e]-p*i.base_pitch+m*S,F=Math.max(0,Math.ceil((Math.min(b,x)-a)/f-.5)),L=Math.min(o-1,Math.floor((Math.max(b,x)-a)/f+.5));for(let D=F;D<=L;D++){let k=b===x?1:Math.max(0,Math.min(1,(a+D*f-b)/(x-b)));this.#i(p,w*o+D,(A??R)*(1-k)+R*k)}}}}#i(e,t,i){i>0&&(i>Lx*this.all[t]&&(this.all[t]=i,this.news.all=!0),this.flank.surfaces.forEach((r,s)=>{let o=Px(r.tooth+r.step*e,r.teeth),a=o*this.nz*this.nx+t;i>Lx*this.each[s][a]&&(this.each[s][a]=i,this.news.teeth[s].add(o),this.touched[s].includes(o)||this.touched[s].push(o))}))}},Yc=class{constructor(e,t,i){this.poses=i,this.greatest=e.greatest,this.mode="off",this.parts=e.contact.flanks.filter(r=>r.loads).map(r=>{let s=new $f(e.contact,r);return{record:s,meshes:r.surfaces.map((o,a)=>this.#e(s,o,a,t))}})}#e(e,t,i,r){let{nz:s,nx:o}=e,a=s*o,l=new Float32Array(3*a*t.teeth);for(let u=0;u<t.teeth;u++){let d=t.turn*t.step*(u-t.tooth),g=Math.cos(d),M=Math.sin(d);for(let p=0;p<a;p++){let[m,_,w]=t.points.data.subarray(3*p,3*p+3);l.set([g*m-M*_,M*m+g*_,w],3*(u*a+p))}}let c=[];for(let u=0;u<s-1;u++)for(let d=0;d<o-1;d++){let g=u*o+d;c.push(g,g+1,g+o,g+1,g+o+1,g+o)}let h=new Ot;h.setAttribute("position",new Rt(l,3)),h.setAttribute("color",new Rt(new Uint8Array(4*a*t.teeth),4,!0)),h.setIndex(new Rt(new Uint32Array(c.length*t.teeth),1)),h.setDrawRange(0,0);let f=new St(h,new sr({vertexColors:!0,transparent:!0,side:zi,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-40}));return f.matrixAutoUpdate=!1,f.frustumCulled=!1,f.visible=!1,f.userData={body:t.body,gear:i,block:c,drawn:0},r.add(f),f}update(e,t,i,r){let s=this.poses.where.share===1?this.poses.where.low+1:this.poses.where.low;for(let{record:o,meshes:a}of this.parts){let l=e!=="off"&&!t;for(let h of a)h.visible=l,l&&h.matrix.copy(this.poses.world[h.userData.body]);if(!l)continue;o.upTo(s);let c=e!==this.mode||i!==this.painted||r!==this.shade;this.shade=r;for(let h of a)this.#t(o,h,e,i,c);o.news={all:!1,teeth:o.news.teeth.map(()=>new Set)}}this.mode=t?"off":e,this.painted=i}#t(e,t,i,r,s){let{gear:o,block:a}=t.userData,l=e.nz*e.nx,c=e.touched[o];this.#n(t,c,a,l);let f=s||i==="all"&&e.news.all?c:e.news.teeth[o],{color:u}=t.geometry.attributes;for(let d of f){for(let g=0;g<l;g++){let M=i==="all"?e.all[g]:e.each[o][d*l+g],p=4*(d*l+g),m=M>0?kc(this.#i(e,g,M)/r):by;for(let _=0;_<3;_++)u.array[p+_]=Math.round(255*m[_]);u.array[p+3]=M>0?255:0}u.needsUpdate=!0}}#i({contact:e,nx:t,nz:i},r,s){let[o,a]=e.path,[l,c]=e.width,h=[o+(a-o)*(r%t)/(t-1),l+(c-l)*Math.floor(r/t)/(i-1)];return this.shade.of(e,h,s)}#n(e,t,i,r){let{geometry:s,userData:o}=e;if(t.length<o.drawn&&(o.drawn=0),t.length===o.drawn)return;let{array:a}=s.index;for(let l=o.drawn;l<t.length;l++)i.forEach((c,h)=>a[l*i.length+h]=t[l]*r+c);o.drawn=t.length,s.index.needsUpdate=!0,s.setDrawRange(0,t.length*i.length)}cut(e){for(let{meshes:t}of this.parts)for(let{material:i}of t)i.clippingPlanes=e.length?e:null,i.needsUpdate=!0}words(){return this.parts.map(({record:e})=>({side:e.flank.side,greatest:e.all.reduce((t,i)=>Math.max(t,i),0),covered:e.all.filter(t=>t>0).length/e.all.length,teeth:e.touched.map(t=>[...t].sort((i,r)=>i-r))}))}},by=[0,0,0];var $c=class{constructor(e,t,i,r){this.meshes=e.contacts.map(s=>{let o=new Oc(s,r);return{contact:o,rods:new Wc(o,i),pattern:new Yc(o,t,r),gauge:new Xc(o,i),lines:[]}}),this.greatest=Math.max(0,...this.meshes.map(({contact:s})=>s.greatest)),this.shade="load",this.pressures=e.contacts.some(s=>s.unit_pressure),this.showsLines=!0,this.mode="off",this.own=!1,this.gauged=-1,this.hidden=!1}get over(){return!this.hidden&&this.meshes.length>0&&(this.showsLines||this.gauged>=0)}pairs(){return this.meshes.flatMap(e=>Array.from({length:e.contact.pairs},(t,i)=>{let r=this.#e(e.contact,i);return{name:`${e.contact.name}, pair ${i+1}`,kind:"pair",unit:"N",size:r,now:()=>e.forces?.[i]??e.contact.pairForces([])[i],largest:wy(e.contact.contact,r)}}))}#e(e,t){let i=0;for(let{forces:r}of e.contact.flanks)for(let s=t;r&&s<r.data.length;s+=r.width)i=Math.max(i,Math.abs(r.data[s]));return i/Math.cos(e.contact.base_helix)}look(){for(let e of this.meshes)e.lines=e.contact.lines(),e.forces=e.contact.pairForces(e.lines)}top(e){return this.own?Ss[this.shade].greatest(e):this.shade==="load"?this.greatest:this.hardest??=this.greatestPressure()}greatestPressure(){return Math.max(0,...this.meshes.map(({contact:e})=>Ss.pressure.greatest(e)))}value(e,{ends:t,loads:i},r){let s=r/(i.length-1),o=[0,1].map(a=>t[0][a]+(t[1][a]-t[0][a])*s);return Ss[this.shade].of(e.contact,o,i[r])}update(e){this.meshes.forEach(({contact:t,rods:i,pattern:r,gauge:s,lines:o},a)=>{let l=this.top(t),c=(h,f)=>this.value(t,h,f);i.update(o,this.showsLines&&!this.hidden,e,l,c),r.update(t.greatest>0?this.mode:"off",this.hidden,l,Ss[this.shade]),s.update(a===this.gauged&&!this.hidden)})}cut(e){for(let{pattern:t}of this.meshes)t.cut(e)}state(){let e=t=>[t.x,t.y,t.z];return{lines:this.showsLines,pattern:this.mode,gauge:this.gauged,greatest:this.greatest,shade:this.shade,greatestPressure:this.pressures?this.greatestPressure():null,meshes:this.meshes.map(({contact:t,lines:i,pattern:r,gauge:s})=>({name:t.name,penetration:t.penetration(),magnified:s.times,plates:s.shown(),lines:i.map(({pair:o,side:a,force:l,from:c,to:h,loads:f,ends:u})=>({pair:o,side:a,force:l,from:e(c),to:e(h),loads:[...f],values:Array.from(f,(d,g)=>this.value(t,{ends:u,loads:f},g))})),pattern:this.mode==="off"?[]:r.words()}))}}};function wy(n,e){let t=e*Math.cos(n.base_helix),i=n.pressure_angle.data[0];if(n.cone){let r=Fc(n.cone,i,Math.tan(n.base_helix),t,0);return Object.fromEntries(Object.entries(r).map(([s,o])=>[s,o.length()]))}return{circumferential:t*Math.cos(i),radial:t*Math.sin(i),axial:t*Math.abs(Math.tan(n.base_helix))}}var Kc=class{constructor(e){this.flanks=e,this.now=J("span",{}),this.end=J("span",{}),this.gap=J("div",{className:"ppv-gap"}),this.bar=J("div",{hidden:!(e.greatest>0)},this.what=J("span",{}),J("i",{style:`background:${zc()}`}),J("div",{className:"ppv-ends"},J("span",{},"0"),this.now,this.end)),this.element=J("div",{className:"ppv-flanks",role:"status"},this.bar,this.gap)}update(){let{flanks:e}=this,t=e.meshes[e.gauged],i=e.greatest>0&&(e.showsLines||e.mode!=="off");if(this.element.hidden=e.hidden||!(i||t),this.element.hidden)return;let{legend:r,told:s}=Ss[e.shade],o=0;for(let{contact:c,lines:h}of e.meshes)for(let f of h)f.loads.forEach((u,d)=>o=Math.max(o,e.value(c,f,d)));if(this.what.textContent=r,this.now.textContent=o>0?`now ${s(o)}`:"now none",this.end.textContent=e.own?"largest of the mesh":s(e.top(e.meshes[0].contact)),this.gap.hidden=!t,!t)return;let a=t.contact.penetration(),l=(c,h)=>`${h} ${Ey(Math.abs(a[c]))} ${a[c]>0?"deep":"apart"}`;this.gap.textContent=`${t.contact.name.replaceAll("_"," ")}: ${l(1,"front flank")}, ${l(-1,"back flank")}; drawn \xD7 ${Ht(t.gauge.times,2)}`}};function Ey(n){let[e,t]=n<.001?[1e-6,"\xB5m"]:[.001,"mm"];return`${Ht(n/e,3)}\u2009${t}`}function Ty({contact:n,name:e}){let{cone:t,width:i}=n,r=n.flanks[0].surfaces.map(({gear:o,points:a})=>{let[l,c]=a.shape,h=t?-i[0]/(i[1]-i[0])*(l-1):0,f=Math.min(Math.floor(h),l-2),u=(p,m)=>Math.hypot(a.data[3*(p*c+m)],a.data[3*(p*c+m)+1]),d=[0,c-1].map(p=>2e3*(u(f,p)+(h-f)*(u(f+1,p)-u(f,p)))),[g,M]=[Math.min(...d),Math.max(...d)].map(p=>p.toFixed(2));return`${o.replaceAll("_"," ")} ${g} to ${M}`}),s=t?" in the middle of the face":"";return`${e.replaceAll("_"," ")} touches between the diameters ${r.join(", ")} mm${s}.`}function Io(n,e){for(let{flanks:o}of n.stage.pictures)e(o);let{showsLines:t,mode:i,shade:r}=n.stage.pictures[0].flanks,s=r==="load"?0:Math.max(...n.stage.pictures.map(({flanks:o})=>o.greatestPressure()));for(let{flanks:o}of n.stage.pictures)o.hardest=s||void 0;n.flankRows&&(n.flankRows.shade&&(n.flankRows.shade.select.value=r),n.flankRows.lines.input.checked=t,n.flankRows.pattern.select.value=i),n.changed()}function Zc(n,e,t){let i=t??n.stage.pictures[0].flanks.meshes[e]?.gauge.fitting()??1;Io(n,r=>{r.gauged=e;for(let{gauge:s}of r.meshes)s.times=i}),n.flankRows&&(n.flankRows.times.set(i),n.flankRows.tell(e),n.flankRows.gauge.select.value=String(e))}function Ay(n){let{flanks:e,data:t}=n.stage.pictures[0];e.gauged<0&&Zc(n,0);let i=e.meshes[e.gauged]?.contact.name,r=t.arrows.find(s=>s.kind==="mesh"&&s.name===i);r&&n.intoMesh(r)}function Dx(n){let{meshes:e,greatest:t,pressures:i}=n.stage.pictures[0].flanks,r=u=>Io(n,u),s=tr("contact lines",!0,u=>r(d=>d.showsLines=u)),o=rn("pattern so far",[["off","none"],["all","all teeth together"],["each","each tooth"]],u=>r(d=>d.mode=u),"Largest load, or pressure, of every place of a flank so far"),a=i?rn("colours tell",Object.entries(Ss).map(([u,{name:d}])=>[u,d]),u=>r(d=>d.shade=u),"Load per width, or the largest pressure of the line contact that it makes"):null,l=_r({label:"\xD7 ",title:"How much the gap is magnified along the line of action",least:1,most:1e4,value:1,show:u=>Ht(u,2),changed:u=>r(d=>d.meshes.forEach(({gauge:g})=>g.times=u))}),c=rn("gap of",[["-1","none"],...e.map(({contact:u},d)=>[String(d),u.name.replaceAll("_"," ")])],u=>Zc(n,Number(u)),"Mesh whose gap is shown, magnified"),h=tr("colours of each mesh by itself",!1,u=>r(d=>d.own=u)),f=J("p",{className:"ppv-soft"});return n.flankRows={lines:s,pattern:o,shade:a,gauge:c,times:l,tell(u){let d=e[u]??(e.length===1?e[0]:null);f.hidden=!d,d&&(f.textContent=Ty(d.contact))}},n.flankRows.tell(-1),[s.row,t>0?o.row:null,t>0&&a?a.row:null,t>0&&e.length>1?h.row:null,c.row,f,l.row,J("div",{className:"ppv-buttons"},Tt("look at the gap","Look into the mesh whose gap is shown",()=>Ay(n))),J("p",{className:"ppv-soft"},t>0?"Balls at the ends of a line: front or back flank; a thin grey line carries nothing.":"Yellow lines: front flanks; purple: back flanks; thin and grey: none of them touches. The law of the mesh tells no loads.")].filter(Boolean)}var Ry="uplot",Cy="u-hz",Py="u-vt",Ly="u-title",Dy="u-wrap",Ny="u-under",Iy="u-over",Uy="u-axis",ws="u-off",Fy="u-select",Oy="u-cursor-x",By="u-cursor-y",ky="u-cursor-pt",zy="u-legend",Gy="u-live",Hy="u-inline",Vy="u-series",Wy="u-marker",Nx="u-label",Xy="u-value",ll="width",cl="height";var Ix="bottom",Uo="left",Kf="right",uu="#000",Ux=uu+"0",Zf="mousemove",Fx="mousedown",Jf="mouseup",Ox="mouseenter",Bx="mouseleave",kx="dblclick",qy="resize",Yy="scroll",zx="change",th="dppxchange",du="--",Ho=typeof window<"u",iu=Ho?document:null,Oo=Ho?window:null,$y=Ho?navigator:null,At,Jc;function nu(){let n=devicePixelRatio;At!=n&&(At=n,Jc&&su(zx,Jc,nu),Jc=matchMedia(`(min-resolution: ${At-.001}dppx) and (max-resolution: ${At+.001}dppx)`),Es(zx,Jc,nu),Oo.dispatchEvent(new CustomEvent(th)))}function bn(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function ru(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Yt(n,e,t){n.style[e]=t+"px"}function Xn(n,e,t,i){let r=iu.createElement(n);return e!=null&&bn(r,e),t?.insertBefore(r,i),r}function Un(n,e){return Xn("div",n,e)}var Gx=new WeakMap;function fr(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=Gx.get(n);s!=o&&(n.style.transform=s,Gx.set(n,s),e<0||t<0||e>i||t>r?bn(n,ws):ru(n,ws))}var Hx=new WeakMap;function Vx(n,e,t){let i=e+t,r=Hx.get(n);i!=r&&(Hx.set(n,i),n.style.background=e,n.style.borderColor=t)}var Wx=new WeakMap;function Xx(n,e,t,i){let r=e+""+t,s=Wx.get(n);r!=s&&(Wx.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var pu={passive:!0},Ky={...pu,capture:!0};function Es(n,e,t,i){e.addEventListener(n,t,i?Ky:pu)}function su(n,e,t,i){e.removeEventListener(n,t,pu)}Ho&&nu();function qn(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:wn((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function v_(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var M_=n=>n!=null,S_=n=>n!=null&&n>0,rh=v_(M_),Zy=v_(S_);function Jy(n,e,t,i=0,r=!1){let s=r?Zy:rh,o=r?S_:M_;[e,t]=s(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Bt,l??-Bt]}function sh(n,e,t,i){let r=$x(n),s=$x(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Pr:y_,a=r==1?wn:Fn,l=s==1?Fn:wn,c=a(o(Ri(n))),h=l(o(Ri(e))),f=Bo(t,c),u=Bo(t,h);return t==10&&(c<0&&(f=kt(f,-c)),h<0&&(u=kt(u,-h))),i||t==2?(n=f*r,e=u*s):(n=T_(n,f),e=oh(e,u)),[n,e]}function mu(n,e,t,i){let r=sh(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var gu=.1,qx={mode:3,pad:gu},fl={pad:0,soft:null,mode:0},Qy={min:fl,max:fl};function ih(n,e,t,i){return ah(t)?Yx(n,e,t):(fl.pad=t,fl.soft=i?0:null,fl.mode=i?3:0,Yx(n,e,Qy))}function wt(n,e){return n??e}function jy(n,e,t){for(e=wt(e,0),t=wt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Yx(n,e,t){let i=t.min,r=t.max,s=wt(i.pad,0),o=wt(r.pad,0),a=wt(i.hard,-Bt),l=wt(r.hard,Bt),c=wt(i.soft,Bt),h=wt(r.soft,-Bt),f=wt(i.mode,0),u=wt(r.mode,0),d=e-n,g=Pr(d),M=nn(Ri(n),Ri(e)),p=Pr(M),m=Ri(p-g);(d<1e-24||m>10)&&(d=0,(n==0||e==0)&&(d=1e-24,f==2&&c!=Bt&&(s=0),u==2&&h!=-Bt&&(o=0)));let _=d||M||1e3,w=Pr(_),S=Bo(10,wn(w)),R=_*(d==0?n==0?.1:1:s),A=kt(T_(n-R,S/10),24),x=n>=c&&(f==1||f==3&&A<=c||f==2&&A>=c)?c:Bt,b=nn(a,A<x&&n>=x?x:Yn(x,A)),F=_*(d==0?e==0?.1:1:o),L=kt(oh(e+F,S/10),24),D=e<=h&&(u==1||u==3&&L>=h||u==2&&L<=h)?h:-Bt,k=Yn(l,L>D&&e<=D?D:nn(D,L));return b==k&&b==0&&(k=100),[b,k]}var eb=new Intl.NumberFormat(Ho?$y.language:"en-US"),xu=n=>eb.format(n),En=Math,eh=En.PI,Ri=En.abs,wn=En.floor,Ai=En.round,Fn=En.ceil,Yn=En.min,nn=En.max,Bo=En.pow,$x=En.sign,Pr=En.log10,y_=En.log2,tb=(n,e=1)=>En.sinh(n)*e,Qf=(n,e=1)=>En.asinh(n/e),Bt=1/0;function Kx(n){return(Pr((n^n>>31)-(n>>31))|0)+1}function ou(n,e,t){return Yn(nn(n,e),t)}function b_(n){return typeof n=="function"}function vt(n){return b_(n)?n:()=>n}var ib=()=>{},w_=n=>n,E_=(n,e)=>e,nb=n=>null,Zx=n=>!0,Jx=(n,e)=>n==e,rb=/\.\d*?(?=9{6,}|0{6,})/gm,Ts=n=>{if(R_(n)||is.has(n))return n;let e=`${n}`,t=e.match(rb);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${Ts(r)}e${s}`}return kt(n,i)};function ys(n,e){return Ts(kt(Ts(n/e))*e)}function oh(n,e){return Ts(Fn(Ts(n/e))*e)}function T_(n,e){return Ts(wn(Ts(n/e))*e)}function kt(n,e=0){if(R_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Ai(i)/t}var is=new Map;function A_(n){return((""+n).split(".")[1]||"").length}function dl(n,e,t,i){let r=[],s=i.map(A_);for(let o=e;o<t;o++){let a=Ri(o),l=kt(Bo(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=s[c]?0:s[c]),u=n==10?h:kt(h,f);r.push(u),is.set(u,f)}}return r}var ul={},_u=[],ko=[null,null],ts=Array.isArray,R_=Number.isInteger,sb=n=>n===void 0;function Qx(n){return typeof n=="string"}function ah(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function ob(n){return n!=null&&typeof n=="object"}var ab=Object.getPrototypeOf(Uint8Array),C_="__proto__";function zo(n,e=ah){let t;if(ts(n)){let i=n.find(r=>r!=null);if(ts(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=zo(n[r],e)}else t=n.slice()}else if(n instanceof ab)t=n.slice();else if(e(n)){t={};for(let i in n)i!=C_&&(t[i]=zo(n[i],e))}else t=n;return t}function yi(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=C_&&(ah(n[r])?yi(n[r],zo(i[r])):n[r]=zo(i[r]))}return n}var lb=0,cb=1,hb=2;function fb(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function ub(n,e){if(mb(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return gb(o[0])||(o=pb(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],f=Array(r).fill(void 0),u=e?e[o][c]:cb,d=[];for(let g=0;g<h.length;g++){let M=h[g],p=s.get(l[g]);M===null?u!=lb&&(f[p]=M,u==hb&&d.push(p)):f[p]=M}fb(f,d,r),i.push(f)}}return i}var db=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function pb(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];r.push(a)}return r}function mb(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function gb(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=nn(1,wn((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var P_=["January","February","March","April","May","June","July","August","September","October","November","December"],L_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function D_(n){return n.slice(0,3)}var xb=L_.map(D_),_b=P_.map(D_),vb={MMMM:P_,MMM:_b,WWWW:L_,WWW:xb};function al(n){return(n<10?"0":"")+n}function Mb(n){return(n<10?"00":n<100?"0":"")+n}var Sb={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>al(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>al(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>al(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>al(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>al(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Mb(n.getMilliseconds())};function vu(n,e){e=e||vb;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?Sb[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var yb=new Intl.DateTimeFormat().resolvedOptions().timeZone;function bb(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==yb?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var N_=n=>n%1==0,nh=[1,2,2.5,5],wb=dl(10,-32,0,nh),I_=dl(10,0,32,nh),Eb=I_.filter(N_),bs=wb.concat(I_),Mu=`
`,U_="{YYYY}",jx=Mu+U_,F_="{M}/{D}",hl=Mu+F_,Qc=hl+"/{YY}",O_="{aa}",Tb="{h}:{mm}",Fo=Tb+O_,e_=Mu+Fo,t_=":{ss}",Ct=null;function B_(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,l=(n==1?dl(10,0,3,nh).filter(N_):dl(10,-3,0,nh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,U_,Ct,Ct,Ct,Ct,Ct,Ct,1],[r*28,"{MMM}",jx,Ct,Ct,Ct,Ct,Ct,1],[r,F_,jx,Ct,Ct,Ct,Ct,Ct,1],[i,"{h}"+O_,Qc,Ct,hl,Ct,Ct,Ct,1],[t,Fo,Qc,Ct,hl,Ct,Ct,Ct,1],[e,t_,Qc+" "+Fo,Ct,hl+" "+Fo,Ct,e_,Ct,1],[n,t_+".{fff}",Qc+" "+Fo,Ct,hl+" "+Fo,Ct,e_,Ct,1]];function h(f){return(u,d,g,M,p,m)=>{let _=[],w=p>=o,S=p>=s&&p<o,R=f(g),A=kt(R*n,3),x=jf(R.getFullYear(),w?0:R.getMonth(),S||w?1:R.getDate()),b=kt(x*n,3);if(S||w){let F=S?p/s:0,L=w?p/o:0,D=A==b?A:kt(jf(x.getFullYear()+L,x.getMonth()+F,1)*n,3),k=new Date(Ai(D/n)),G=k.getFullYear(),U=k.getMonth();for(let W=0;D<=M;W++){let Y=jf(G+L*W,U+F*W,1),V=Y-f(kt(Y*n,3));D=kt((+Y+V)*n,3),D<=M&&_.push(D)}}else{let F=p>=r?r:p,L=wn(g)-wn(A),D=b+L+oh(A-b,F);_.push(D);let k=f(D),G=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,U=p/i,W=u.axes[d]._space,Y=m/W;for(;D=kt(D+p,n==1?0:3),!(D>M);)if(U>1){let V=wn(kt(G+U,6))%24,j=f(D).getHours()-V;j>1&&(j=-1),D-=j*i,G=(G+U)%24;let re=_[_.length-1];kt((D-re)/p,3)*Y>=.7&&_.push(D)}else _.push(D)}return _}}return[l,c,h]}var[Ab,Rb,Cb]=B_(1),[Pb,Lb,Db]=B_(.001);dl(2,-53,53,[1]);function i_(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function n_(n,e){return(t,i,r,s,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,f,u,d;return i.map(g=>{let M=n(g),p=M.getFullYear(),m=M.getMonth(),_=M.getDate(),w=M.getHours(),S=M.getMinutes(),R=M.getSeconds(),A=p!=l&&a[2]||m!=c&&a[3]||_!=h&&a[4]||w!=f&&a[5]||S!=u&&a[6]||R!=d&&a[7]||a[1];return l=p,c=m,h=_,f=w,u=S,d=R,A(M)})}}function Nb(n,e){let t=vu(e);return(i,r,s,o,a)=>r.map(l=>t(n(l)))}function jf(n,e,t){return new Date(n,e,t)}function r_(n,e){return e(n)}var Ib="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function s_(n,e){return(t,i,r,s)=>s==null?du:e(n(i))}function Ub(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function Fb(n,e){return n.series[e].fill(n,e)}var Ob={show:!0,live:!0,isolate:!1,mount:ib,markers:{show:!0,width:2,stroke:Ub,fill:Fb,dash:"solid"},idx:null,idxs:null,values:[]};function Bb(n,e){let t=n.cursor.points,i=Un(),r=t.size(n,e);Yt(i,ll,r),Yt(i,cl,r);let s=r/-2;Yt(i,"marginLeft",s),Yt(i,"marginTop",s);let o=t.width(n,e,r);return o&&Yt(i,"borderWidth",o),i}function kb(n,e){let t=n.series[e].points;return t._fill||t._stroke}function zb(n,e){let t=n.series[e].points;return t._stroke||t._fill}function Gb(n,e){return n.series[e].points.size}var eu=[0,0];function Hb(n,e,t){return eu[0]=e,eu[1]=t,eu}function jc(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function tu(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var Vb={show:!0,x:!0,y:!0,lock:!1,move:Hb,points:{one:!1,show:Bb,size:Gb,width:0,stroke:zb,fill:kb},bind:{mousedown:jc,mouseup:jc,click:jc,dblclick:jc,mousemove:tu,mouseleave:tu,mouseenter:tu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},k_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Su=yi({},k_,{filter:E_}),z_=yi({},Su,{size:10}),G_=yi({},k_,{show:!1}),yu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',H_="bold "+yu,V_=1.5,o_={show:!0,scale:"x",stroke:uu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:H_,side:2,grid:Su,ticks:z_,border:G_,font:yu,lineGap:V_,rotate:0},Wb="Value",Xb="Time",a_={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function qb(n,e,t,i,r){return e.map(s=>s==null?"":xu(s))}function Yb(n,e,t,i,r,s,o){let a=[],l=is.get(r)||0;t=o?t:kt(oh(t,r),l);for(let c=t;c<=i;c=kt(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function au(n,e,t,i,r,s,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Pr:y_,h=wn(c(t));r=Bo(l,h),l==10&&(r=bs[qn(r,bs)]);let f=t,u=r*l;l==10&&(u=bs[qn(u,bs)]);do a.push(f),f=f+r,l==10&&!is.has(f)&&(f=kt(f,is.get(r))),f>=u&&(r=f,u=r*l,l==10&&(u=bs[qn(u,bs)]));while(f<=i);return a}function $b(n,e,t,i,r,s,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?au(n,e,nn(l,t),i,r):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?au(n,e,nn(l,-i),-t,r):[l]).reverse().map(u=>-u).concat(h,c)}var W_=/./,Kb=/[12357]/,Zb=/[125]/,l_=/1/,lu=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function Jb(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],l=n.valToPos,c=s._space,h=l(10,o),f=l(9,o)-h>=c?W_:l(7,o)-h>=c?Kb:l(5,o)-h>=c?Zb:l_;if(f==l_){let u=Ri(l(1,o)-h);if(u<c)return lu(e.slice().reverse(),a.distr,f,Fn(c/u)).reverse()}return lu(e,a.distr,f,1)}function Qb(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,l=n.valToPos,c=Ri(l(1,o)-l(2,o));return c<a?lu(e.slice().reverse(),3,W_,Fn(a/c)).reverse():e}function jb(n,e,t,i){return i==null?du:e==null?"":xu(e)}var c_={show:!0,scale:"y",stroke:uu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:H_,side:3,grid:Su,ticks:z_,border:G_,font:yu,lineGap:V_,rotate:0};function ew(n,e){let t=3+(n||1)*2;return kt(t*e,3)}function tw(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=Ri(o-s),l=n.series[e],c=a/(l.points.space*At);return i[1]-i[0]<=c}var h_={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},X_=(n,e,t,i,r)=>r,f_={show:!0,auto:!0,sorted:0,gaps:X_,alpha:1,facets:[yi({},h_,{scale:"x"}),yi({},h_,{scale:"y"})]},u_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:X_,alpha:1,points:{show:tw,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function iw(n,e,t,i,r){return t/10}var q_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},nw=yi({},q_,{time:!1,ori:1}),d_={};function Y_(n,e){let t=d_[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=r&&t.plots[h].pub(i,r,s,o,a,l,c)}},n!=null&&(d_[n]=t)),t}var Go=1,cu=2;function As(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=s[0],c=i==2?s[1]:s[e],h=i==2?o[r.facets[0].scale]:o[n.series[0].scale],f=i==2?o[r.facets[1].scale]:o[r.scale],u=a.left,d=a.top,g=a.width,M=a.height,p=n.valToPosH,m=n.valToPosV;return h.ori==0?t(r,l,c,h,f,p,m,u,d,g,M,ch,Vo,fh,K_,J_):t(r,l,c,h,f,m,p,d,u,M,g,hh,Wo,Eu,Z_,Q_)}function bu(n,e){let t=0,i=0,r=wt(n.bands,_u);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function rw(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,l=n.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Lr(n,e,t,i,r,s){return As(n,e,(o,a,l,c,h,f,u,d,g,M,p)=>{let m=o.pxRound,_=c.dir*(c.ori==0?1:-1),w=c.ori==0?Vo:Wo,S,R;_==1?(S=t,R=i):(S=i,R=t);let A=m(f(a[S],c,M,d)),x=m(u(l[S],h,p,g)),b=m(f(a[R],c,M,d)),F=m(u(s==1?h.max:h.min,h,p,g)),L=new Path2D(r);return w(L,b,F),w(L,A,F),w(L,A,x),L})}function lh(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?fh:Eu,l=t;for(let f=0;f<n.length;f++){let u=n[f];if(u[1]>u[0]){let d=u[0]-l;d>0&&a(o,l,i,d,i+s),l=u[1]}}let c=t+r-l,h=10;c>0&&a(o,l,i-h/2,c,i+s+h)}return o}function sw(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function wu(n,e,t,i,r,s,o){let a=[],l=n.length;for(let c=r==1?t:i;c>=t&&c<=i;c+=r)if(e[c]===null){let f=c,u=c;if(r==1)for(;++c<=i&&e[c]===null;)u=c;else for(;--c>=t&&e[c]===null;)u=c;let d=s(n[f]),g=u==f?d:s(n[u]),M=f-r;d=o<=0&&M>=0&&M<l?s(n[M]):d;let m=u+r;g=o>=0&&m>=0&&m<l?s(n[m]):g,g>=d&&a.push([d,g])}return a}function p_(n){return n==0?w_:n==1?Ai:e=>ys(e,n)}function $_(n){let e=n==0?ch:hh,t=n==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},i=n==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,h=0)=>{c==0&&h==0?i(r,s,o,a,l):(c=Yn(c,a/2,l/2),h=Yn(h,a/2,l/2),e(r,s+c,o),t(r,s+a,o,s+a,o+l,c),t(r,s+a,o+l,s,o+l,h),t(r,s,o+l,s,o,h),t(r,s,o,s+a,o,c),r.closePath())}}var ch=(n,e,t)=>{n.moveTo(e,t)},hh=(n,e,t)=>{n.moveTo(t,e)},Vo=(n,e,t)=>{n.lineTo(e,t)},Wo=(n,e,t)=>{n.lineTo(t,e)},fh=$_(0),Eu=$_(1),K_=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},Z_=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},J_=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},Q_=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function j_(n){return(e,t,i,r,s)=>As(e,t,(o,a,l,c,h,f,u,d,g,M,p)=>{let{pxRound:m,points:_}=o,w,S;c.ori==0?(w=ch,S=K_):(w=hh,S=Z_);let R=kt(_.width*At,3),A=(_.size-_.width)/2*At,x=kt(A*2,3),b=new Path2D,F=new Path2D,{left:L,top:D,width:k,height:G}=e.bbox;fh(F,L-x,D-x,k+x*2,G+x*2);let U=W=>{if(l[W]!=null){let Y=m(f(a[W],c,M,d)),V=m(u(l[W],h,p,g));w(b,Y+A,V),S(b,Y,V,A,0,eh*2)}};if(s)s.forEach(U);else for(let W=i;W<=r;W++)U(W);return{stroke:R>0?b:null,fill:b,clip:F,flags:Go|cu}})}function ev(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var ow=ev(Vo),aw=ev(Wo);function tv(n){let e=wt(n?.alignGaps,0);return(t,i,r,s)=>As(t,i,(o,a,l,c,h,f,u,d,g,M,p)=>{[r,s]=rh(l,r,s);let m=o.pxRound,_=G=>m(f(G,c,M,d)),w=G=>m(u(G,h,p,g)),S,R;c.ori==0?(S=Vo,R=ow):(S=Wo,R=aw);let A=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Go},b=x.stroke,F=!1;if(s-r>=M*4){let G=fe=>t.posToVal(fe,c.key,!0),U=null,W=null,Y,V,ce,Z=_(a[A==1?r:s]),j=_(a[r]),re=_(a[s]),ue=G(A==1?j+1:re-1);for(let fe=A==1?r:s;fe>=r&&fe<=s;fe+=A){let ee=a[fe],_e=(A==1?ee<ue:ee>ue)?Z:_(ee),Ae=l[fe];_e==Z?Ae!=null?(V=Ae,U==null?(S(b,_e,w(V)),Y=U=W=V):V<U?U=V:V>W&&(W=V)):Ae===null&&(F=!0):(U!=null&&R(b,Z,w(U),w(W),w(Y),w(V)),Ae!=null?(V=Ae,S(b,_e,w(V)),U=W=Y=V):(U=W=null,Ae===null&&(F=!0)),Z=_e,ue=G(Z+A))}U!=null&&U!=W&&ce!=Z&&R(b,Z,w(U),w(W),w(Y),w(V))}else for(let G=A==1?r:s;G>=r&&G<=s;G+=A){let U=l[G];U===null?F=!0:U!=null&&S(b,_(a[G]),w(U))}let[D,k]=bu(t,i);if(o.fill!=null||D!=0){let G=x.fill=new Path2D(b),U=o.fillTo(t,i,o.min,o.max,D),W=w(U),Y=_(a[r]),V=_(a[s]);A==-1&&([V,Y]=[Y,V]),S(G,V,W),S(G,Y,W)}if(!o.spanGaps){let G=[];F&&G.push(...wu(a,l,r,s,A,_,e)),x.gaps=G=o.gaps(t,i,r,s,G),x.clip=lh(G,c.ori,d,g,M,p)}return k!=0&&(x.band=k==2?[Lr(t,i,r,s,b,-1),Lr(t,i,r,s,b,1)]:Lr(t,i,r,s,b,k)),x})}function lw(n){let e=wt(n.align,1),t=wt(n.ascDesc,!1),i=wt(n.alignGaps,0),r=wt(n.extend,!1);return(s,o,a,l)=>As(s,o,(c,h,f,u,d,g,M,p,m,_,w)=>{[a,l]=rh(f,a,l);let S=c.pxRound,{left:R,width:A}=s.bbox,x=j=>S(g(j,u,_,p)),b=j=>S(M(j,d,w,m)),F=u.ori==0?Vo:Wo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Go},D=L.stroke,k=u.dir*(u.ori==0?1:-1),G=b(f[k==1?a:l]),U=x(h[k==1?a:l]),W=U,Y=U;r&&e==-1&&(Y=R,F(D,Y,G)),F(D,U,G);for(let j=k==1?a:l;j>=a&&j<=l;j+=k){let re=f[j];if(re==null)continue;let ue=x(h[j]),fe=b(re);e==1?F(D,ue,G):F(D,W,fe),F(D,ue,fe),G=fe,W=ue}let V=W;r&&e==1&&(V=R+A,F(D,V,G));let[ce,Z]=bu(s,o);if(c.fill!=null||ce!=0){let j=L.fill=new Path2D(D),re=c.fillTo(s,o,c.min,c.max,ce),ue=b(re);F(j,V,ue),F(j,Y,ue)}if(!c.spanGaps){let j=[];j.push(...wu(h,f,a,l,k,x,i));let re=c.width*At/2,ue=t||e==1?re:-re,fe=t||e==-1?-re:re;j.forEach(ee=>{ee[0]+=ue,ee[1]+=fe}),L.gaps=j=c.gaps(s,o,a,l,j),L.clip=lh(j,u.ori,p,m,_,w)}return Z!=0&&(L.band=Z==2?[Lr(s,o,a,l,D,-1),Lr(s,o,a,l,D,1)]:Lr(s,o,a,l,D,Z)),L})}function m_(n,e,t,i,r,s,o=Bt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let h=Ri(n[l]-n[a]);h<c&&(c=h,o=Ri(t(n[l],i,r,s)-t(n[a],i,r,s)))}a=l}}return o}function cw(n){n=n||ul;let e=wt(n.size,[.6,Bt,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=vt(r),o=1-e[0],a=wt(e[1],Bt),l=wt(e[2],1),c=wt(n.disp,ul),h=wt(n.each,d=>{}),{fill:f,stroke:u}=c;return(d,g,M,p)=>As(d,g,(m,_,w,S,R,A,x,b,F,L,D)=>{let k=m.pxRound,G=t,U=i*At,W=a*At,Y=l*At,V,ce;S.ori==0?[V,ce]=s(d,g):[ce,V]=s(d,g);let Z=S.dir*(S.ori==0?1:-1),j=S.ori==0?fh:Eu,re=S.ori==0?h:(Ce,Je,st,be,Ut,He,Ze)=>{h(Ce,Je,st,Ut,be,Ze,He)},ue=wt(d.bands,_u).find(Ce=>Ce.series[0]==g),fe=ue!=null?ue.dir:0,ee=m.fillTo(d,g,m.min,m.max,fe),me=k(x(ee,R,D,F)),_e,Ae,ye,qe=L,rt=k(m.width*At),Ve=!1,dt=null,ht=null,it=null,$t=null;f!=null&&(rt==0||u!=null)&&(Ve=!0,dt=f.values(d,g,M,p),ht=new Map,new Set(dt).forEach(Ce=>{Ce!=null&&ht.set(Ce,new Path2D)}),rt>0&&(it=u.values(d,g,M,p),$t=new Map,new Set(it).forEach(Ce=>{Ce!=null&&$t.set(Ce,new Path2D)})));let{x0:zt,size:pi}=c;if(zt!=null&&pi!=null){G=1,_=zt.values(d,g,M,p),zt.unit==2&&(_=_.map(st=>d.posToVal(b+st*L,S.key,!0)));let Ce=pi.values(d,g,M,p);pi.unit==2?Ae=Ce[0]*L:Ae=A(Ce[0],S,L,b)-A(0,S,L,b),qe=m_(_,w,A,S,L,b,qe),ye=qe-Ae+U}else qe=m_(_,w,A,S,L,b,qe),ye=qe*o+U,Ae=qe-ye;ye<1&&(ye=0),rt>=Ae/2&&(rt=0),ye<5&&(k=w_);let Nt=ye>0,Ci=qe-ye-(Nt?rt:0);Ae=k(ou(Ci,Y,W)),_e=(G==0?Ae/2:G==Z?0:Ae)-G*Z*((G==0?U/2:0)+(Nt?rt/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},bi=Ve?null:new Path2D,ni=null;if(ue!=null)ni=d.data[ue.series[1]];else{let{y0:Ce,y1:Je}=c;Ce!=null&&Je!=null&&(w=Je.values(d,g,M,p),ni=Ce.values(d,g,M,p))}let mi=V*Ae,B=ce*Ae;for(let Ce=Z==1?M:p;Ce>=M&&Ce<=p;Ce+=Z){let Je=w[Ce];if(Je==null)continue;if(ni!=null){let X=ni[Ce]??0;if(Je-X==0)continue;me=x(X,R,D,F)}let st=S.distr!=2||c!=null?_[Ce]:Ce,be=A(st,S,L,b),Ut=x(wt(Je,ee),R,D,F),He=k(be-_e),Ze=k(nn(Ut,me)),C=k(Yn(Ut,me)),y=Ze-C;if(Je!=null){let X=Je<0?B:mi,he=Je<0?mi:B;Ve?(rt>0&&it[Ce]!=null&&j($t.get(it[Ce]),He,C+wn(rt/2),Ae,nn(0,y-rt),X,he),dt[Ce]!=null&&j(ht.get(dt[Ce]),He,C+wn(rt/2),Ae,nn(0,y-rt),X,he)):j(bi,He,C+wn(rt/2),Ae,nn(0,y-rt),X,he),re(d,g,Ce,He-rt/2,C,Ae+rt,y)}}return rt>0?Mt.stroke=Ve?$t:bi:Ve||(Mt._fill=m.width==0?m._fill:m._stroke??m._fill,Mt.width=0),Mt.fill=Ve?ht:bi,Mt})}function hw(n,e){let t=wt(e?.alignGaps,0);return(i,r,s,o)=>As(i,r,(a,l,c,h,f,u,d,g,M,p,m)=>{[s,o]=rh(c,s,o);let _=a.pxRound,w=V=>_(u(V,h,p,g)),S=V=>_(d(V,f,m,M)),R,A,x;h.ori==0?(R=ch,x=Vo,A=J_):(R=hh,x=Wo,A=Q_);let b=h.dir*(h.ori==0?1:-1),F=w(l[b==1?s:o]),L=F,D=[],k=[];for(let V=b==1?s:o;V>=s&&V<=o;V+=b)if(c[V]!=null){let Z=l[V],j=w(Z);D.push(L=j),k.push(S(c[V]))}let G={stroke:n(D,k,R,x,A,_),fill:null,clip:null,band:null,gaps:null,flags:Go},U=G.stroke,[W,Y]=bu(i,r);if(a.fill!=null||W!=0){let V=G.fill=new Path2D(U),ce=a.fillTo(i,r,a.min,a.max,W),Z=S(ce);x(V,L,Z),x(V,F,Z)}if(!a.spanGaps){let V=[];V.push(...wu(l,c,s,o,b,w,t)),G.gaps=V=a.gaps(i,r,s,o,V),G.clip=lh(V,h.ori,g,M,p,m)}return Y!=0&&(G.band=Y==2?[Lr(i,r,s,o,U,-1),Lr(i,r,s,o,U,1)]:Lr(i,r,s,o,U,Y)),G})}function fw(n){return hw(uw,n)}function uw(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),f=Array(o-1);for(let u=0;u<o-1;u++)h[u]=e[u+1]-e[u],f[u]=n[u+1]-n[u],c[u]=h[u]/f[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(f[u-1]+f[u])/((2*f[u]+f[u-1])/c[u-1]+(f[u]+2*f[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)r(a,n[u]+f[u]/3,e[u]+l[u]*f[u]/3,n[u+1]-f[u]/3,e[u+1]-l[u+1]*f[u]/3,n[u+1],e[u+1])}return a}var hu=new Set;function g_(){for(let n of hu)n.syncRect(!0)}Ho&&(Es(qy,Oo,g_),Es(Yy,Oo,g_,!0),Es(th,Oo,()=>{ti.pxRatio=At}));var dw=tv(),pw=j_();function x_(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>fu(s,o,e,t))}function mw(n,e){return n.map((t,i)=>i==0?{}:yi({},e,t))}function fu(n,e,t,i){return yi({},e==0?t:i,n)}function iv(n,e,t){return e==null?ko:[e,t]}var gw=iv;function xw(n,e,t){return e==null?ko:ih(e,t,gu,!0)}function nv(n,e,t,i){return e==null?ko:sh(e,t,n.scales[i].log,!1)}var _w=nv;function rv(n,e,t,i){return e==null?ko:mu(e,t,n.scales[i].log,!1)}var vw=rv;function Mw(n,e,t,i,r){let s=nn(Kx(n),Kx(e)),o=e-n,a=qn(r/i*o,t);do{let l=t[a],c=i*l/o;if(c>=r&&s+(l<5?is.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function __(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Ai((t=+r)*At))+"px"),[n,e,t]}function Sw(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=kt(e[2]*At,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function ti(n,e,t){let i={mode:wt(n.mode,1)},r=i.mode;function s(v,E,P,N){let H=E.valToPct(v);return N+P*(E.dir==-1?1-H:H)}function o(v,E,P,N){let H=E.valToPct(v);return N+P*(E.dir==-1?H:1-H)}function a(v,E,P,N){return E.ori==0?s(v,E,P,N):o(v,E,P,N)}i.valToPosH=s,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Un(Ry);if(n.id!=null&&(c.id=n.id),bn(c,n.class),n.title){let v=Un(Ly,c);v.textContent=n.title}let h=Xn("canvas"),f=i.ctx=h.getContext("2d"),u=Un(Dy,c);Es("click",u,v=>{v.target===g&&(Wt!=Fs||Kt!=Os)&&ki.click(i,v)},!0);let d=i.under=Un(Ny,u);u.appendChild(h);let g=i.over=Un(Iy,u);n=zo(n);let M=+wt(n.pxAlign,1),p=p_(M);(n.plugins||[]).forEach(v=>{v.opts&&(n=v.opts(i,n)||n)});let m=n.ms||.001,_=i.series=r==1?x_(n.series||[],a_,u_,!1):mw(n.series||[null],f_),w=i.axes=x_(n.axes||[],o_,c_,!0),S=i.scales={},R=i.bands=n.bands||[];R.forEach(v=>{v.fill=vt(v.fill||null),v.dir=wt(v.dir,-1)});let A=r==2?_[1].facets[0].scale:_[0].scale,x={axes:gr,series:mt},b=(n.drawOrder||["axes","series"]).map(v=>x[v]);function F(v){let E=v.distr==3?P=>Pr(P>0?P:v.clamp(i,P,v.min,v.max,v.key)):v.distr==4?P=>Qf(P,v.asinh):v.distr==100?P=>v.fwd(P):P=>P;return P=>{let N=E(P),{_min:H,_max:K}=v,ae=K-H;return(N-H)/ae}}function L(v){let E=S[v];if(E==null){let P=(n.scales||ul)[v]||ul;if(P.from!=null){L(P.from);let N=yi({},S[P.from],P,{key:v});N.valToPct=F(N),S[v]=N}else{E=S[v]=yi({},v==A?q_:nw,P),E.key=v;let N=E.time,H=E.range,K=ts(H);if((v!=A||r==2&&!N)&&(K&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?qx:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?qx:{mode:1,hard:H[1],soft:H[1]}},K=!1),!K&&ah(H))){let ae=H;H=(de,Me,Ie)=>Me==null?ko:ih(Me,Ie,ae)}E.range=vt(H||(N?gw:v==A?E.distr==3?_w:E.distr==4?vw:iv:E.distr==3?nv:E.distr==4?rv:xw)),E.auto=vt(K?!1:E.auto),E.clamp=vt(E.clamp||iw),E._min=E._max=null,E.valToPct=F(E)}}}L("x"),L("y"),r==1&&_.forEach(v=>{L(v.scale)}),w.forEach(v=>{L(v.scale)});for(let v in n.scales)L(v);let D=S[A],k=D.distr,G,U;D.ori==0?(bn(c,Cy),G=s,U=o):(bn(c,Py),G=o,U=s);let W={};for(let v in S){let E=S[v];(E.min!=null||E.max!=null)&&(W[v]={min:E.min,max:E.max},E.min=E.max=null)}let Y=n.tzDate||(v=>new Date(Ai(v/m))),V=n.fmtDate||vu,ce=m==1?Cb(Y):Db(Y),Z=n_(Y,i_(m==1?Rb:Lb,V)),j=s_(Y,r_(Ib,V)),re=[],ue=i.legend=yi({},Ob,n.legend),fe=i.cursor=yi({},Vb,{drag:{y:r==2}},n.cursor),ee=ue.show,me=fe.show,_e=ue.markers;ue.idxs=re,_e.width=vt(_e.width),_e.dash=vt(_e.dash),_e.stroke=vt(_e.stroke),_e.fill=vt(_e.fill);let Ae,ye,qe,rt=[],Ve=[],dt,ht=!1,it={};if(ue.live){let v=_[1]?_[1].values:null;ht=v!=null,dt=ht?v(i,1,0):{_:0};for(let E in dt)it[E]=du}if(ee)if(Ae=Xn("table",zy,c),qe=Xn("tbody",null,Ae),ue.mount(i,Ae),ht){ye=Xn("thead",null,Ae,qe);let v=Xn("tr",null,ye);Xn("th",null,v);for(var $t in dt)Xn("th",Nx,v).textContent=$t}else bn(Ae,Hy),ue.live&&bn(Ae,Gy);let zt={show:!0},pi={show:!1};function Nt(v,E){if(E==0&&(ht||!ue.live||r==2))return ko;let P=[],N=Xn("tr",Vy,qe,qe.childNodes[E]);bn(N,v.class),v.show||bn(N,ws);let H=Xn("th",null,N);if(_e.show){let de=Un(Wy,H);if(E>0){let Me=_e.width(i,E);Me&&(de.style.border=Me+"px "+_e.dash(i,E)+" "+_e.stroke(i,E)),de.style.background=_e.fill(i,E)}}let K=Un(Nx,H);v.label instanceof HTMLElement?K.appendChild(v.label):K.textContent=v.label,E>0&&(_e.show||(K.style.color=v.width>0?_e.stroke(i,E):_e.fill(i,E)),Mt("click",H,de=>{if(fe._lock)return;je(de);let Me=_.indexOf(v);if((de.ctrlKey||de.metaKey)!=ue.isolate){let Ie=_.some((Ue,Oe)=>Oe>0&&Oe!=Me&&Ue.show);_.forEach((Ue,Oe)=>{Oe>0&&Jn(Oe,Ie?Oe==Me?zt:pi:zt,!0,vi.setSeries)})}else Jn(Me,{show:!v.show},!0,vi.setSeries)},!1),et&&Mt(Ox,H,de=>{fe._lock||(je(de),Jn(_.indexOf(v),ks,!0,vi.setSeries))},!1));for(var ae in dt){let de=Xn("td",Xy,N);de.textContent="--",P.push(de)}return[N,P]}let Ci=new Map;function Mt(v,E,P,N=!0){let H=Ci.get(E)||{},K=fe.bind[v](i,E,P,N);K&&(Es(v,E,H[v]=K),Ci.set(E,H))}function bi(v,E,P){let N=Ci.get(E)||{};for(let H in N)(v==null||H==v)&&(su(H,E,N[H]),delete N[H]);v==null&&Ci.delete(E)}let ni=0,mi=0,B=0,Ce=0,Je=0,st=0,be=Je,Ut=st,He=B,Ze=Ce,C=0,y=0,X=0,he=0;i.bbox={};let oe=!1,xe=!1,ve=!1,te=!1,ne=!1,pe=!1;function O(v,E,P){(P||v!=i.width||E!=i.height)&&se(v,E),ft(!1),ve=!0,xe=!0,Vi()}function se(v,E){i.width=ni=B=v,i.height=mi=Ce=E,Je=st=0,Se(),We();let P=i.bbox;C=P.left=ys(Je*At,.5),y=P.top=ys(st*At,.5),X=P.width=ys(B*At,.5),he=P.height=ys(Ce*At,.5)}let ie=3;function we(){let v=!1,E=0;for(;!v;){E++;let P=Ns(E),N=Zn(E);v=E==ie||P&&N,v||(se(i.width,i.height),xe=!0)}}function ge({width:v,height:E}){O(v,E)}i.setSize=ge;function Se(){let v=!1,E=!1,P=!1,N=!1;w.forEach((H,K)=>{if(H.show&&H._show){let{side:ae,_size:de}=H,Me=ae%2,Ie=H.label!=null?H.labelSize:0,Ue=de+Ie;Ue>0&&(Me?(B-=Ue,ae==3?(Je+=Ue,N=!0):P=!0):(Ce-=Ue,ae==0?(st+=Ue,v=!0):E=!0))}}),$n[0]=v,$n[1]=P,$n[2]=E,$n[3]=N,B-=On[1]+On[3],Je+=On[3],Ce-=On[2]+On[0],st+=On[0]}function We(){let v=Je+B,E=st+Ce,P=Je,N=st;function H(K,ae){switch(K){case 1:return v+=ae,v-ae;case 2:return E+=ae,E-ae;case 3:return P-=ae,P+ae;case 0:return N-=ae,N+ae}}w.forEach((K,ae)=>{if(K.show&&K._show){let de=K.side;K._pos=H(de,K._size),K.label!=null&&(K._lpos=H(de,K.labelSize))}})}if(fe.dataIdx==null){let v=fe.hover,E=v.skip=new Set(v.skip??[]);E.add(void 0);let P=v.prox=vt(v.prox),N=v.bias??=0;fe.dataIdx=(H,K,ae,de)=>{if(K==0)return ae;let Me=ae,Ie=P(H,K,ae,de)??Bt,Ue=Ie>=0&&Ie<Bt,Oe=D.ori==0?B:Ce,nt=fe.left,Et=e[0],yt=e[K];if(E.has(yt[ae])){Me=null;let gt=null,Qe=null,Ye;if(N==0||N==-1)for(Ye=ae;gt==null&&Ye-- >0;)E.has(yt[Ye])||(gt=Ye);if(N==0||N==1)for(Ye=ae;Qe==null&&Ye++<yt.length;)E.has(yt[Ye])||(Qe=Ye);if(gt!=null||Qe!=null)if(Ue){let qt=gt==null?-1/0:G(Et[gt],D,Oe,0),oi=Qe==null?1/0:G(Et[Qe],D,Oe,0),Ni=nt-qt,It=oi-nt;Ni<=It?Ni<=Ie&&(Me=gt):It<=Ie&&(Me=Qe)}else Me=Qe==null?gt:gt==null?Qe:ae-gt<=Qe-ae?gt:Qe}else Ue&&Ri(nt-G(Et[ae],D,Oe,0))>Ie&&(Me=null);return Me}}let je=v=>{fe.event=v};fe.idxs=re,fe._lock=!1;let le=fe.points;le.show=vt(le.show),le.size=vt(le.size),le.stroke=vt(le.stroke),le.width=vt(le.width),le.fill=vt(le.fill);let Be=i.focus=yi({},n.focus||{alpha:.3},fe.focus),et=Be.prox>=0,Re=et&&le.one,lt=[],Vt=[],Ki=[];function qo(v,E){let P=le.show(i,E);if(P instanceof HTMLElement)return bn(P,ky),bn(P,v.class),fr(P,-10,-10,B,Ce),g.insertBefore(P,lt[E]),P}function Ps(v,E){if(r==1||E>0){let P=r==1&&S[v.scale].time,N=v.value;v.value=P?Qx(N)?s_(Y,r_(N,V)):N||j:N||jb,v.label=v.label||(P?Xb:Wb)}if(Re||E>0){v.width=v.width==null?1:v.width,v.paths=v.paths||dw||nb,v.fillTo=vt(v.fillTo||rw),v.pxAlign=+wt(v.pxAlign,M),v.pxRound=p_(v.pxAlign),v.stroke=vt(v.stroke||null),v.fill=vt(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let P=ew(nn(1,v.width),1),N=v.points=yi({},{size:P,width:nn(1,P*.2),stroke:v.stroke,space:P*2,paths:pw,_stroke:null,_fill:null},v.points);N.show=vt(N.show),N.filter=vt(N.filter),N.fill=vt(N.fill),N.stroke=vt(N.stroke),N.paths=vt(N.paths),N.pxAlign=v.pxAlign}if(ee){let P=Nt(v,E);rt.splice(E,0,P[0]),Ve.splice(E,0,P[1]),ue.values.push(null)}if(me){re.splice(E,0,null);let P=null;Re?E==0&&(P=qo(v,E)):E>0&&(P=qo(v,E)),lt.splice(E,0,P),Vt.splice(E,0,0),Ki.splice(E,0,0)}Di("addSeries",E)}function Zh(v,E){E=E??_.length,v=r==1?fu(v,E,a_,u_):fu(v,E,{},f_),_.splice(E,0,v),Ps(_[E],E)}i.addSeries=Zh;function Sl(v){if(_.splice(v,1),ee){ue.values.splice(v,1),Ve.splice(v,1);let E=rt.splice(v,1)[0];bi(null,E.firstChild),E.remove()}me&&(re.splice(v,1),lt.splice(v,1)[0].remove(),Vt.splice(v,1),Ki.splice(v,1)),Di("delSeries",v)}i.delSeries=Sl;let $n=[!1,!1,!1,!1];function dr(v,E){if(v._show=v.show,v.show){let P=v.side%2,N=S[v.scale];N==null&&(v.scale=P?_[1].scale:A,N=S[v.scale]);let H=N.time;v.size=vt(v.size),v.space=vt(v.space),v.rotate=vt(v.rotate),ts(v.incrs)&&v.incrs.forEach(ae=>{!is.has(ae)&&is.set(ae,A_(ae))}),v.incrs=vt(v.incrs||(N.distr==2?Eb:H?m==1?Ab:Pb:bs)),v.splits=vt(v.splits||(H&&N.distr==1?ce:N.distr==3?au:N.distr==4?$b:Yb)),v.stroke=vt(v.stroke),v.grid.stroke=vt(v.grid.stroke),v.ticks.stroke=vt(v.ticks.stroke),v.border.stroke=vt(v.border.stroke);let K=v.values;v.values=ts(K)&&!ts(K[0])?vt(K):H?ts(K)?n_(Y,i_(K,V)):Qx(K)?Nb(Y,K):K||Z:K||qb,v.filter=vt(v.filter||(N.distr>=3&&N.log==10?Jb:N.distr==3&&N.log==2?Qb:E_)),v.font=__(v.font),v.labelFont=__(v.labelFont),v._size=v.size(i,null,E,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&($n[E]=!0,v._el=Un(Uy,u))}}function pr(v,E,P,N){let[H,K,ae,de]=P,Me=E%2,Ie=0;return Me==0&&(de||K)&&(Ie=E==0&&!H||E==2&&!ae?Ai(o_.size/3):0),Me==1&&(H||ae)&&(Ie=E==1&&!K||E==3&&!de?Ai(c_.size/2):0),Ie}let Yo=i.padding=(n.padding||[pr,pr,pr,pr]).map(v=>vt(wt(v,pr))),On=i._padding=Yo.map((v,E)=>v(i,E,$n,0)),ri,li=null,ci=null,Kn=r==1?_[0].idxs:null,fn=null,Nr=!1;function $o(v,E){if(e=v??[],i.data=i._data=e,r==2){ri=0;for(let P=1;P<_.length;P++)ri+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),fn=e[0],ri=fn.length;let P=e;if(k==2){P=e.slice();let N=P[0]=Array(ri);for(let H=0;H<ri;H++)N[H]=H}i._data=e=P}if(ft(!0),Di("setData"),k==2&&(ve=!0),E!==!1){let P=D;P.auto(i,Nr)?Ko():Fr(A,P.min,P.max),te=te||fe.left>=0,pe=!0,Vi()}}i.setData=$o;function Ko(){Nr=!0;let v,E;r==1&&(ri>0?(li=Kn[0]=0,ci=Kn[1]=ri-1,v=e[0][li],E=e[0][ci],k==2?(v=li,E=ci):v==E&&(k==3?[v,E]=sh(v,v,D.log,!1):k==4?[v,E]=mu(v,v,D.log,!1):D.time?E=v+Ai(86400/m):[v,E]=ih(v,E,gu,!0))):(li=Kn[0]=v=null,ci=Kn[1]=E=null)),Fr(A,v,E)}let Ls,Ir,Ds,T,z,Q,q,$,Ee,Pe;function Te(v,E,P,N,H,K){v??=Ux,P??=_u,N??="butt",H??=Ux,K??="round",v!=Ls&&(f.strokeStyle=Ls=v),H!=Ir&&(f.fillStyle=Ir=H),E!=Ds&&(f.lineWidth=Ds=E),K!=z&&(f.lineJoin=z=K),N!=Q&&(f.lineCap=Q=N),P!=T&&f.setLineDash(T=P)}function Ne(v,E,P,N){E!=Ir&&(f.fillStyle=Ir=E),v!=q&&(f.font=q=v),P!=$&&(f.textAlign=$=P),N!=Ee&&(f.textBaseline=Ee=N)}function ze(v,E,P,N,H=0){if(N.length>0&&v.auto(i,Nr)&&(E==null||E.min==null)){let K=wt(li,0),ae=wt(ci,N.length-1),de=P.min==null?Jy(N,K,ae,H,v.distr==3):[P.min,P.max];v.min=Yn(v.min,P.min=de[0]),v.max=nn(v.max,P.max=de[1])}}let tt={min:null,max:null};function pt(){for(let N in S){let H=S[N];W[N]==null&&(H.min==null||W[A]!=null&&H.auto(i,Nr))&&(W[N]=tt)}for(let N in S){let H=S[N];W[N]==null&&H.from!=null&&W[H.from]!=null&&(W[N]=tt)}W[A]!=null&&ft(!0);let v={};for(let N in W){let H=W[N];if(H!=null){let K=v[N]=zo(S[N],ob);if(H.min!=null)yi(K,H);else if(N!=A||r==2)if(ri==0&&K.from==null){let ae=K.range(i,null,null,N);K.min=ae[0],K.max=ae[1]}else K.min=Bt,K.max=-Bt}}if(ri>0){_.forEach((N,H)=>{if(r==1){let K=N.scale,ae=W[K];if(ae==null)return;let de=v[K];if(H==0){let Me=de.range(i,de.min,de.max,K);de.min=Me[0],de.max=Me[1],li=qn(de.min,e[0]),ci=qn(de.max,e[0]),ci-li>1&&(e[0][li]<de.min&&li++,e[0][ci]>de.max&&ci--),N.min=fn[li],N.max=fn[ci]}else N.show&&N.auto&&ze(de,ae,N,e[H],N.sorted);N.idxs[0]=li,N.idxs[1]=ci}else if(H>0&&N.show&&N.auto){let[K,ae]=N.facets,de=K.scale,Me=ae.scale,[Ie,Ue]=e[H],Oe=v[de],nt=v[Me];Oe!=null&&ze(Oe,W[de],K,Ie,K.sorted),nt!=null&&ze(nt,W[Me],ae,Ue,ae.sorted),N.min=ae.min,N.max=ae.max}});for(let N in v){let H=v[N],K=W[N];if(H.from==null&&(K==null||K.min==null)){let ae=H.range(i,H.min==Bt?null:H.min,H.max==-Bt?null:H.max,N);H.min=ae[0],H.max=ae[1]}}}for(let N in v){let H=v[N];if(H.from!=null){let K=v[H.from];if(K.min==null)H.min=H.max=null;else{let ae=H.range(i,K.min,K.max,N);H.min=ae[0],H.max=ae[1]}}}let E={},P=!1;for(let N in v){let H=v[N],K=S[N];if(K.min!=H.min||K.max!=H.max){K.min=H.min,K.max=H.max;let ae=K.distr;K._min=ae==3?Pr(K.min):ae==4?Qf(K.min,K.asinh):ae==100?K.fwd(K.min):K.min,K._max=ae==3?Pr(K.max):ae==4?Qf(K.max,K.asinh):ae==100?K.fwd(K.max):K.max,E[N]=P=!0}}if(P){_.forEach((N,H)=>{r==2?H>0&&E.y&&(N._paths=null):E[N.scale]&&(N._paths=null)});for(let N in E)ve=!0,Di("setScale",N);me&&fe.left>=0&&(te=pe=!0)}for(let N in W)W[N]=null}function ke(v){let E=ou(li-1,0,ri-1),P=ou(ci+1,0,ri-1);for(;v[E]==null&&E>0;)E--;for(;v[P]==null&&P<ri-1;)P++;return[E,P]}function mt(){if(ri>0){let v=_.some(E=>E._focus)&&Pe!=Be.alpha;v&&(f.globalAlpha=Pe=Be.alpha),_.forEach((E,P)=>{if(P>0&&E.show&&(jt(P,!1),jt(P,!0),E._paths==null)){let N=Pe;Pe!=E.alpha&&(f.globalAlpha=Pe=E.alpha);let H=r==2?[0,e[P][0].length-1]:ke(e[P]);E._paths=E.paths(i,P,H[0],H[1]),Pe!=N&&(f.globalAlpha=Pe=N)}}),_.forEach((E,P)=>{if(P>0&&E.show){let N=Pe;Pe!=E.alpha&&(f.globalAlpha=Pe=E.alpha),E._paths!=null&&Pt(P,!1);{let H=E._paths!=null?E._paths.gaps:null,K=E.points.show(i,P,li,ci,H),ae=E.points.filter(i,P,K,H);(K||ae)&&(E.points._paths=E.points.paths(i,P,li,ci,ae),Pt(P,!0))}Pe!=N&&(f.globalAlpha=Pe=N),Di("drawSeries",P)}}),v&&(f.globalAlpha=Pe=1)}}function jt(v,E){let P=E?_[v].points:_[v];P._stroke=P.stroke(i,v),P._fill=P.fill(i,v)}function Pt(v,E){let P=E?_[v].points:_[v],{stroke:N,fill:H,clip:K,flags:ae,_stroke:de=P._stroke,_fill:Me=P._fill,_width:Ie=P.width}=P._paths;Ie=kt(Ie*At,3);let Ue=null,Oe=Ie%2/2;E&&Me==null&&(Me=Ie>0?"#fff":de);let nt=P.pxAlign==1&&Oe>0;if(nt&&f.translate(Oe,Oe),!E){let Et=C-Ie/2,yt=y-Ie/2,gt=X+Ie,Qe=he+Ie;Ue=new Path2D,Ue.rect(Et,yt,gt,Qe)}E?Fe(de,Ie,P.dash,P.cap,Me,N,H,ae,K):Lt(v,de,Ie,P.dash,P.cap,Me,N,H,ae,Ue,K),nt&&f.translate(-Oe,-Oe)}function Lt(v,E,P,N,H,K,ae,de,Me,Ie,Ue){let Oe=!1;Me!=0&&R.forEach((nt,Et)=>{if(nt.series[0]==v){let yt=_[nt.series[1]],gt=e[nt.series[1]],Qe=(yt._paths||ul).band;ts(Qe)&&(Qe=nt.dir==1?Qe[0]:Qe[1]);let Ye,qt=null;yt.show&&Qe&&jy(gt,li,ci)?(qt=nt.fill(i,Et)||K,Ye=yt._paths.clip):Qe=null,Fe(E,P,N,H,qt,ae,de,Me,Ie,Ue,Ye,Qe),Oe=!0}}),Oe||Fe(E,P,N,H,K,ae,de,Me,Ie,Ue)}let wi=Go|cu;function Fe(v,E,P,N,H,K,ae,de,Me,Ie,Ue,Oe){Te(v,E,P,N,H),(Me||Ie||Oe)&&(f.save(),Me&&f.clip(Me),Ie&&f.clip(Ie)),Oe?(de&wi)==wi?(f.clip(Oe),Ue&&f.clip(Ue),xt(H,ae),gi(v,K,E)):de&cu?(xt(H,ae),f.clip(Oe),gi(v,K,E)):de&Go&&(f.save(),f.clip(Oe),Ue&&f.clip(Ue),xt(H,ae),f.restore(),gi(v,K,E)):(xt(H,ae),gi(v,K,E)),(Me||Ie||Oe)&&f.restore()}function gi(v,E,P){P>0&&(E instanceof Map?E.forEach((N,H)=>{f.strokeStyle=Ls=H,f.stroke(N)}):E!=null&&v&&f.stroke(E))}function xt(v,E){E instanceof Map?E.forEach((P,N)=>{f.fillStyle=Ir=N,f.fill(P)}):E!=null&&v&&f.fill(E)}function mr(v,E,P,N){let H=w[v],K;if(N<=0)K=[0,0];else{let ae=H._space=H.space(i,v,E,P,N),de=H._incrs=H.incrs(i,v,E,P,N,ae);K=Mw(E,P,de,N,ae)}return H._found=K}function xi(v,E,P,N,H,K,ae,de,Me,Ie){let Ue=ae%2/2;M==1&&f.translate(Ue,Ue),Te(de,ae,Me,Ie,de),f.beginPath();let Oe,nt,Et,yt,gt=H+(N==0||N==3?-K:K);P==0?(nt=H,yt=gt):(Oe=H,Et=gt);for(let Qe=0;Qe<v.length;Qe++)E[Qe]!=null&&(P==0?Oe=Et=v[Qe]:nt=yt=v[Qe],f.moveTo(Oe,nt),f.lineTo(Et,yt));f.stroke(),M==1&&f.translate(-Ue,-Ue)}function Ns(v){let E=!0;return w.forEach((P,N)=>{if(!P.show)return;let H=S[P.scale];if(H.min==null){P._show&&(E=!1,P._show=!1,ft(!1));return}else P._show||(E=!1,P._show=!0,ft(!1));let K=P.side,ae=K%2,{min:de,max:Me}=H,[Ie,Ue]=mr(N,de,Me,ae==0?B:Ce);if(Ue==0)return;let Oe=H.distr==2,nt=P._splits=P.splits(i,N,de,Me,Ie,Ue,Oe),Et=H.distr==2?nt.map(Ye=>fn[Ye]):nt,yt=H.distr==2?fn[nt[1]]-fn[nt[0]]:Ie,gt=P._values=P.values(i,P.filter(i,Et,N,Ue,yt),N,Ue,yt);P._rotate=K==2?P.rotate(i,gt,N,Ue):0;let Qe=P._size;P._size=Fn(P.size(i,gt,N,v)),Qe!=null&&P._size!=Qe&&(E=!1)}),E}function Zn(v){let E=!0;return Yo.forEach((P,N)=>{let H=P(i,N,$n,v);H!=On[N]&&(E=!1),On[N]=H}),E}function gr(){for(let v=0;v<w.length;v++){let E=w[v];if(!E.show||!E._show)continue;let P=E.side,N=P%2,H,K,ae=E.stroke(i,v),de=P==0||P==3?-1:1,[Me,Ie]=E._found;if(E.label!=null){let Qi=E.labelGap*de,pn=Ai((E._lpos+Qi)*At);Ne(E.labelFont[0],ae,"center",P==2?"top":Ix),f.save(),N==1?(H=K=0,f.translate(pn,Ai(y+he/2)),f.rotate((P==3?-eh:eh)/2)):(H=Ai(C+X/2),K=pn);let ss=b_(E.label)?E.label(i,v,Me,Ie):E.label;f.fillText(ss,H,K),f.restore()}if(Ie==0)continue;let Ue=S[E.scale],Oe=N==0?X:he,nt=N==0?C:y,Et=E._splits,yt=Ue.distr==2?Et.map(Qi=>fn[Qi]):Et,gt=Ue.distr==2?fn[Et[1]]-fn[Et[0]]:Me,Qe=E.ticks,Ye=E.border,qt=Qe.show?Qe.size:0,oi=Ai(qt*At),Ni=Ai((E.alignTo==2?E._size-qt-E.gap:E.gap)*At),It=E._rotate*-eh/180,ai=p(E._pos*At),un=(oi+Ni)*de,Ji=ai+un;K=N==0?Ji:0,H=N==1?Ji:0;let Tn=E.font[0],Bn=E.align==1?Uo:E.align==2?Kf:It>0?Uo:It<0?Kf:N==0?"center":P==3?Kf:Uo,jn=It||N==1?"middle":P==2?"top":Ix;Ne(Tn,ae,Bn,jn);let dn=E.font[1]*E.lineGap,An=Et.map(Qi=>p(a(Qi,Ue,Oe,nt))),kn=E._values;for(let Qi=0;Qi<kn.length;Qi++){let pn=kn[Qi];if(pn!=null){N==0?H=An[Qi]:K=An[Qi],pn=""+pn;let ss=pn.indexOf(`
`)==-1?[pn]:pn.split(/\n/gm);for(let ji=0;ji<ss.length;ji++){let sd=ss[ji];It?(f.save(),f.translate(H,K+ji*dn),f.rotate(It),f.fillText(sd,0,0),f.restore()):f.fillText(sd,H,K+ji*dn)}}}Qe.show&&xi(An,Qe.filter(i,yt,v,Ie,gt),N,P,ai,oi,kt(Qe.width*At,3),Qe.stroke(i,v),Qe.dash,Qe.cap);let er=E.grid;er.show&&xi(An,er.filter(i,yt,v,Ie,gt),N,N==0?2:1,N==0?y:C,N==0?he:X,kt(er.width*At,3),er.stroke(i,v),er.dash,er.cap),Ye.show&&xi([ai],[1],N==0?1:0,N==0?1:2,N==1?y:C,N==1?he:X,kt(Ye.width*At,3),Ye.stroke(i,v),Ye.dash,Ye.cap)}Di("drawAxes")}function ft(v){_.forEach((E,P)=>{P>0&&(E._paths=null,v&&(r==1?(E.min=null,E.max=null):E.facets.forEach(N=>{N.min=null,N.max=null})))})}let si=!1,Zi=!1,Dt=[];function _i(){Zi=!1;for(let v=0;v<Dt.length;v++)Di(...Dt[v]);Dt.length=0}function Vi(){si||(db(Gu),si=!0)}function yl(v,E=!1){si=!0,Zi=E,v(i),Gu(),E&&Dt.length>0&&queueMicrotask(_i)}i.batch=yl;function Gu(){if(oe&&(pt(),oe=!1),ve&&(we(),ve=!1),xe){if(Yt(d,Uo,Je),Yt(d,"top",st),Yt(d,ll,B),Yt(d,cl,Ce),Yt(g,Uo,Je),Yt(g,"top",st),Yt(g,ll,B),Yt(g,cl,Ce),Yt(u,ll,ni),Yt(u,cl,mi),h.width=Ai(ni*At),h.height=Ai(mi*At),w.forEach(({_el:v,_show:E,_size:P,_pos:N,side:H})=>{if(v!=null)if(E){let K=H===3||H===0?P:0,ae=H%2==1;Yt(v,ae?"left":"top",N-K),Yt(v,ae?"width":"height",P),Yt(v,ae?"top":"left",ae?st:Je),Yt(v,ae?"height":"width",ae?Ce:B),ru(v,ws)}else bn(v,ws)}),Ls=Ir=Ds=z=Q=q=$=Ee=T=null,Pe=1,Qo(!0),Je!=be||st!=Ut||B!=He||Ce!=Ze){ft(!1);let v=B/He,E=Ce/Ze;if(me&&!te&&fe.left>=0){fe.left*=v,fe.top*=E,Is&&fr(Is,Ai(fe.left),0,B,Ce),Us&&fr(Us,0,Ai(fe.top),B,Ce);for(let P=0;P<lt.length;P++){let N=lt[P];N!=null&&(Vt[P]*=v,Ki[P]*=E,fr(N,Fn(Vt[P]),Fn(Ki[P]),B,Ce))}}if(Xt.show&&!ne&&Xt.left>=0&&Xt.width>0){Xt.left*=v,Xt.width*=v,Xt.top*=E,Xt.height*=E;for(let P in nf)Yt(Bs,P,Xt[P])}be=Je,Ut=st,He=B,Ze=Ce}Di("setSize"),xe=!1}ni>0&&mi>0&&(f.clearRect(0,0,h.width,h.height),Di("drawClear"),b.forEach(v=>v()),Di("draw")),Xt.show&&ne&&(bl(Xt),ne=!1),me&&te&&(rs(null,!0,!1),te=!1),ue.show&&ue.live&&pe&&(ef(),pe=!1),l||(l=!0,i.status=1,Di("ready")),Nr=!1,si=!1}i.redraw=(v,E)=>{ve=E||!1,v!==!1?Fr(A,D.min,D.max):Vi()};function Jh(v,E){let P=S[v];if(P.from==null){if(ri==0){let N=P.range(i,E.min,E.max,v);E.min=N[0],E.max=N[1]}if(E.min>E.max){let N=E.min;E.min=E.max,E.max=N}if(ri>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;v==A&&P.distr==2&&ri>0&&(E.min=qn(E.min,e[0]),E.max=qn(E.max,e[0]),E.min==E.max&&E.max++),W[v]=E,oe=!0,Vi()}}i.setScale=Jh;let Qh,jh,Is,Us,Hu,Vu,Fs,Os,Wu,Xu,Wt,Kt,Ur=!1,ki=fe.drag,Pi=ki.x,Li=ki.y;me&&(fe.x&&(Qh=Un(Oy,g)),fe.y&&(jh=Un(By,g)),D.ori==0?(Is=Qh,Us=jh):(Is=jh,Us=Qh),Wt=fe.left,Kt=fe.top);let Xt=i.select=yi({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Bs=Xt.show?Un(Fy,Xt.over?g:d):null;function bl(v,E){if(Xt.show){for(let P in v)Xt[P]=v[P],P in nf&&Yt(Bs,P,v[P]);E!==!1&&Di("setSelect")}}i.setSelect=bl;function Bv(v){if(_[v].show)ee&&ru(rt[v],ws);else if(ee&&bn(rt[v],ws),me){let P=Re?lt[0]:lt[v];P!=null&&fr(P,-10,-10,B,Ce)}}function Fr(v,E,P){Jh(v,{min:E,max:P})}function Jn(v,E,P,N){E.focus!=null&&Vv(v),E.show!=null&&_.forEach((H,K)=>{K>0&&(v==K||v==null)&&(H.show=E.show,Bv(K),r==2?(Fr(H.facets[0].scale,null,null),Fr(H.facets[1].scale,null,null)):Fr(H.scale,null,null),Vi())}),P!==!1&&Di("setSeries",v,E),N&&jo("setSeries",i,v,E)}i.setSeries=Jn;function kv(v,E){yi(R[v],E)}function zv(v,E){v.fill=vt(v.fill||null),v.dir=wt(v.dir,-1),E=E??R.length,R.splice(E,0,v)}function Gv(v){v==null?R.length=0:R.splice(v,1)}i.addBand=zv,i.setBand=kv,i.delBand=Gv;function Hv(v,E){_[v].alpha=E,me&&lt[v]!=null&&(lt[v].style.opacity=E),ee&&rt[v]&&(rt[v].style.opacity=E)}let xr,Or,ns,ks={focus:!0};function Vv(v){if(v!=ns){let E=v==null,P=Be.alpha!=1;_.forEach((N,H)=>{if(r==1||H>0){let K=E||H==0||H==v;N._focus=E?null:K,P&&Hv(H,K?1:Be.alpha)}}),ns=v,P&&Vi()}}ee&&et&&Mt(Bx,Ae,v=>{fe._lock||(je(v),ns!=null&&Jn(null,ks,!0,vi.setSeries))});function Qn(v,E,P){let N=S[E];P&&(v=v/At-(N.ori==1?st:Je));let H=B;N.ori==1&&(H=Ce,v=H-v),N.dir==-1&&(v=H-v);let K=N._min,ae=N._max,de=v/H,Me=K+(ae-K)*de,Ie=N.distr;return Ie==3?Bo(10,Me):Ie==4?tb(Me,N.asinh):Ie==100?N.bwd(Me):Me}function Wv(v,E){let P=Qn(v,A,E);return qn(P,e[0],li,ci)}i.valToIdx=v=>qn(v,e[0]),i.posToIdx=Wv,i.posToVal=Qn,i.valToPos=(v,E,P)=>S[E].ori==0?s(v,S[E],P?X:B,P?C:0):o(v,S[E],P?he:Ce,P?y:0),i.setCursor=(v,E,P)=>{Wt=v.left,Kt=v.top,rs(null,E,P)};function qu(v,E){Yt(Bs,Uo,Xt.left=v),Yt(Bs,ll,Xt.width=E)}function Yu(v,E){Yt(Bs,"top",Xt.top=v),Yt(Bs,cl,Xt.height=E)}let Zo=D.ori==0?qu:Yu,Jo=D.ori==1?qu:Yu;function Xv(){if(ee&&ue.live)for(let v=r==2?1:0;v<_.length;v++){if(v==0&&ht)continue;let E=ue.values[v],P=0;for(let N in E)Ve[v][P++].firstChild.nodeValue=E[N]}}function ef(v,E){if(v!=null&&(v.idxs?v.idxs.forEach((P,N)=>{re[N]=P}):sb(v.idx)||re.fill(v.idx),ue.idx=re[0]),ee&&ue.live){for(let P=0;P<_.length;P++)(P>0||r==1&&!ht)&&qv(P,re[P]);Xv()}pe=!1,E!==!1&&Di("setLegend")}i.setLegend=ef;function qv(v,E){let P=_[v],N=v==0&&k==2?fn:e[v],H;ht?H=P.values(i,v,E)??it:(H=P.value(i,E==null?null:N[E],v,E),H=H==null?it:{_:H}),ue.values[v]=H}function rs(v,E,P){Wu=Wt,Xu=Kt,[Wt,Kt]=fe.move(i,Wt,Kt),fe.left=Wt,fe.top=Kt,me&&(Is&&fr(Is,Ai(Wt),0,B,Ce),Us&&fr(Us,0,Ai(Kt),B,Ce));let N,H=li>ci;xr=Bt,Or=null;let K=D.ori==0?B:Ce,ae=D.ori==1?B:Ce;if(Wt<0||ri==0||H){N=fe.idx=null;for(let de=0;de<_.length;de++){let Me=lt[de];Me!=null&&fr(Me,-10,-10,B,Ce)}et&&Jn(null,ks,!0,v==null&&vi.setSeries),ue.live&&(re.fill(N),pe=!0)}else{let de,Me,Ie;r==1&&(de=D.ori==0?Wt:Kt,Me=Qn(de,A),N=fe.idx=qn(Me,e[0],li,ci),Ie=G(e[0][N],D,K,0));let Ue=-10,Oe=-10,nt=0,Et=0,yt=!0,gt="",Qe="";for(let Ye=r==2?1:0;Ye<_.length;Ye++){let qt=_[Ye],oi=re[Ye],Ni=oi==null?null:r==1?e[Ye][oi]:e[Ye][1][oi],It=fe.dataIdx(i,Ye,N,Me),ai=It==null?null:r==1?e[Ye][It]:e[Ye][1][It];if(pe=pe||ai!=Ni||It!=oi,re[Ye]=It,Ye>0&&qt.show){let un=It==null?-10:It==N?Ie:G(r==1?e[0][It]:e[Ye][0][It],D,K,0),Ji=ai==null?-10:U(ai,r==1?S[qt.scale]:S[qt.facets[1].scale],ae,0);if(et&&ai!=null){let Tn=D.ori==1?Wt:Kt,Bn=Ri(Be.dist(i,Ye,It,Ji,Tn));if(Bn<xr){let jn=Be.bias;if(jn!=0){let dn=Qn(Tn,qt.scale),An=ai>=0?1:-1,kn=dn>=0?1:-1;kn==An&&(kn==1?jn==1?ai>=dn:ai<=dn:jn==1?ai<=dn:ai>=dn)&&(xr=Bn,Or=Ye)}else xr=Bn,Or=Ye}}if(pe||Re){let Tn,Bn;D.ori==0?(Tn=un,Bn=Ji):(Tn=Ji,Bn=un);let jn,dn,An,kn,er,Qi,pn=!0,ss=le.bbox;if(ss!=null){pn=!1;let ji=ss(i,Ye);An=ji.left,kn=ji.top,jn=ji.width,dn=ji.height}else An=Tn,kn=Bn,jn=dn=le.size(i,Ye);if(Qi=le.fill(i,Ye),er=le.stroke(i,Ye),Re)Ye==Or&&xr<=Be.prox&&(Ue=An,Oe=kn,nt=jn,Et=dn,yt=pn,gt=Qi,Qe=er);else{let ji=lt[Ye];ji!=null&&(Vt[Ye]=An,Ki[Ye]=kn,Xx(ji,jn,dn,pn),Vx(ji,Qi,er),fr(ji,Fn(An),Fn(kn),B,Ce))}}}}if(Re){let Ye=Be.prox,qt=ns==null?xr<=Ye:xr>Ye||Or!=ns;if(pe||qt){let oi=lt[0];oi!=null&&(Vt[0]=Ue,Ki[0]=Oe,Xx(oi,nt,Et,yt),Vx(oi,gt,Qe),fr(oi,Fn(Ue),Fn(Oe),B,Ce))}}}if(Xt.show&&Ur)if(v!=null){let[de,Me]=vi.scales,[Ie,Ue]=vi.match,[Oe,nt]=v.cursor.sync.scales,Et=v.cursor.drag;if(Pi=Et._x,Li=Et._y,Pi||Li){let{left:yt,top:gt,width:Qe,height:Ye}=v.select,qt=v.scales[Oe].ori,oi=v.posToVal,Ni,It,ai,un,Ji,Tn=de!=null&&Ie(de,Oe),Bn=Me!=null&&Ue(Me,nt);Tn&&Pi?(qt==0?(Ni=yt,It=Qe):(Ni=gt,It=Ye),ai=S[de],un=G(oi(Ni,Oe),ai,K,0),Ji=G(oi(Ni+It,Oe),ai,K,0),Zo(Yn(un,Ji),Ri(Ji-un))):Zo(0,K),Bn&&Li?(qt==1?(Ni=yt,It=Qe):(Ni=gt,It=Ye),ai=S[Me],un=U(oi(Ni,nt),ai,ae,0),Ji=U(oi(Ni+It,nt),ai,ae,0),Jo(Yn(un,Ji),Ri(Ji-un))):Jo(0,ae)}else rf()}else{let de=Ri(Wu-Hu),Me=Ri(Xu-Vu);if(D.ori==1){let nt=de;de=Me,Me=nt}Pi=ki.x&&de>=ki.dist,Li=ki.y&&Me>=ki.dist;let Ie=ki.uni;Ie!=null?Pi&&Li&&(Pi=de>=Ie,Li=Me>=Ie,!Pi&&!Li&&(Me>de?Li=!0:Pi=!0)):ki.x&&ki.y&&(Pi||Li)&&(Pi=Li=!0);let Ue,Oe;Pi&&(D.ori==0?(Ue=Fs,Oe=Wt):(Ue=Os,Oe=Kt),Zo(Yn(Ue,Oe),Ri(Oe-Ue)),Li||Jo(0,ae)),Li&&(D.ori==1?(Ue=Fs,Oe=Wt):(Ue=Os,Oe=Kt),Jo(Yn(Ue,Oe),Ri(Oe-Ue)),Pi||Zo(0,K)),!Pi&&!Li&&(Zo(0,0),Jo(0,0))}if(ki._x=Pi,ki._y=Li,v==null){if(P){if(rd!=null){let[de,Me]=vi.scales;vi.values[0]=de!=null?Qn(D.ori==0?Wt:Kt,de):null,vi.values[1]=Me!=null?Qn(D.ori==1?Wt:Kt,Me):null}jo(Zf,i,Wt,Kt,B,Ce,N)}if(et){let de=P&&vi.setSeries,Me=Be.prox;ns==null?xr<=Me&&Jn(Or,ks,!0,de):xr>Me?Jn(null,ks,!0,de):Or!=ns&&Jn(Or,ks,!0,de)}}pe&&(ue.idx=N,ef()),E!==!1&&Di("setCursor")}let Br=null;Object.defineProperty(i,"rect",{get(){return Br==null&&Qo(!1),Br}});function Qo(v=!1){v?Br=null:(Br=g.getBoundingClientRect(),Di("syncRect",Br))}function $u(v,E,P,N,H,K,ae){fe._lock||Ur&&v!=null&&v.movementX==0&&v.movementY==0||(tf(v,E,P,N,H,K,ae,!1,v!=null),v!=null?rs(null,!0,!0):rs(E,!0,!1))}function tf(v,E,P,N,H,K,ae,de,Me){if(Br==null&&Qo(!1),je(v),v!=null)P=v.clientX-Br.left,N=v.clientY-Br.top;else{if(P<0||N<0){Wt=-10,Kt=-10;return}let[Ie,Ue]=vi.scales,Oe=E.cursor.sync,[nt,Et]=Oe.values,[yt,gt]=Oe.scales,[Qe,Ye]=vi.match,qt=E.axes[0].side%2==1,oi=D.ori==0?B:Ce,Ni=D.ori==1?B:Ce,It=qt?K:H,ai=qt?H:K,un=qt?N:P,Ji=qt?P:N;if(yt!=null?P=Qe(Ie,yt)?a(nt,S[Ie],oi,0):-10:P=oi*(un/It),gt!=null?N=Ye(Ue,gt)?a(Et,S[Ue],Ni,0):-10:N=Ni*(Ji/ai),D.ori==1){let Tn=P;P=N,N=Tn}}Me&&(E==null||E.cursor.event.type==Zf)&&((P<=1||P>=B-1)&&(P=ys(P,B)),(N<=1||N>=Ce-1)&&(N=ys(N,Ce))),de?(Hu=P,Vu=N,[Fs,Os]=fe.move(i,P,N)):(Wt=P,Kt=N)}let nf={width:0,height:0,left:0,top:0};function rf(){bl(nf,!1)}let Ku,Zu,Ju,Qu;function ju(v,E,P,N,H,K,ae){Ur=!0,Pi=Li=ki._x=ki._y=!1,tf(v,E,P,N,H,K,ae,!0,!1),v!=null&&(Mt(Jf,iu,ed,!1),jo(Fx,i,Fs,Os,B,Ce,null));let{left:de,top:Me,width:Ie,height:Ue}=Xt;Ku=de,Zu=Me,Ju=Ie,Qu=Ue}function ed(v,E,P,N,H,K,ae){Ur=ki._x=ki._y=!1,tf(v,E,P,N,H,K,ae,!1,!0);let{left:de,top:Me,width:Ie,height:Ue}=Xt,Oe=Ie>0||Ue>0,nt=Ku!=de||Zu!=Me||Ju!=Ie||Qu!=Ue;if(Oe&&nt&&bl(Xt),ki.setScale&&Oe&&nt){let Et=de,yt=Ie,gt=Me,Qe=Ue;if(D.ori==1&&(Et=Me,yt=Ue,gt=de,Qe=Ie),Pi&&Fr(A,Qn(Et,A),Qn(Et+yt,A)),Li)for(let Ye in S){let qt=S[Ye];Ye!=A&&qt.from==null&&qt.min!=Bt&&Fr(Ye,Qn(gt+Qe,Ye),Qn(gt,Ye))}rf()}else fe.lock&&(fe._lock=!fe._lock,rs(E,!0,v!=null));v!=null&&(bi(Jf,iu),jo(Jf,i,Wt,Kt,B,Ce,null))}function Yv(v,E,P,N,H,K,ae){if(fe._lock)return;je(v);let de=Ur;if(Ur){let Me=!0,Ie=!0,Ue=10,Oe,nt;D.ori==0?(Oe=Pi,nt=Li):(Oe=Li,nt=Pi),Oe&&nt&&(Me=Wt<=Ue||Wt>=B-Ue,Ie=Kt<=Ue||Kt>=Ce-Ue),Oe&&Me&&(Wt=Wt<Fs?0:B),nt&&Ie&&(Kt=Kt<Os?0:Ce),rs(null,!0,!0),Ur=!1}Wt=-10,Kt=-10,re.fill(null),rs(null,!0,!0),de&&(Ur=de)}function td(v,E,P,N,H,K,ae){fe._lock||(je(v),Ko(),rf(),v!=null&&jo(kx,i,Wt,Kt,B,Ce,null))}function id(){w.forEach(Sw),O(i.width,i.height,!0)}Es(th,Oo,id);let zs={};zs.mousedown=ju,zs.mousemove=$u,zs.mouseup=ed,zs.dblclick=td,zs.setSeries=(v,E,P,N)=>{let H=vi.match[2];P=H(i,E,P),P!=-1&&Jn(P,N,!0,!1)},me&&(Mt(Fx,g,ju),Mt(Zf,g,$u),Mt(Ox,g,v=>{je(v),Qo(!1)}),Mt(Bx,g,Yv),Mt(kx,g,td),hu.add(i),i.syncRect=Qo);let wl=i.hooks=n.hooks||{};function Di(v,E,P){Zi?Dt.push([v,E,P]):v in wl&&wl[v].forEach(N=>{N.call(null,i,E,P)})}(n.plugins||[]).forEach(v=>{for(let E in v.hooks)wl[E]=(wl[E]||[]).concat(v.hooks[E])});let nd=(v,E,P)=>P,vi=yi({key:null,setSeries:!1,filters:{pub:Zx,sub:Zx},scales:[A,_[1]?_[1].scale:null],match:[Jx,Jx,nd],values:[null,null]},fe.sync);vi.match.length==2&&vi.match.push(nd),fe.sync=vi;let rd=vi.key,sf=Y_(rd);function jo(v,E,P,N,H,K,ae){vi.filters.pub(v,E,P,N,H,K,ae)&&sf.pub(v,E,P,N,H,K,ae)}sf.sub(i);function $v(v,E,P,N,H,K,ae){vi.filters.sub(v,E,P,N,H,K,ae)&&zs[v](null,E,P,N,H,K,ae)}i.pub=$v;function Kv(){sf.unsub(i),hu.delete(i),Ci.clear(),su(th,Oo,id),c.remove(),Ae?.remove(),Di("destroy")}i.destroy=Kv;function of(){Di("init",n,e),$o(e||n.data,!1),W[A]?Jh(A,W[A]):Ko(),ne=Xt.show&&(Xt.width>0||Xt.height>0),te=pe=!0,O(n.width,n.height)}return _.forEach(Ps),w.forEach(dr),t?t instanceof HTMLElement?(t.appendChild(c),of()):t(i,of):of(),i}ti.assign=yi;ti.fmtNum=xu;ti.rangeNum=ih;ti.rangeLog=sh;ti.rangeAsinh=mu;ti.orient=As;ti.pxRatio=At;ti.join=ub;ti.fmtDate=vu,ti.tzDate=bb;ti.sync=Y_;{ti.addGap=sw,ti.clipGaps=lh;let n=ti.paths={points:j_};n.linear=tv,n.stepped=lw,n.bars=cw,n.spline=fw}var sv=84,yw=4;function bw(n){let{data:e}=n.times;if(!n.most||e.length<2)return Float64Array.from(e);let t=e.length;return Float64Array.from(e,(i,r)=>i+(r<t-1?e[r+1]-i:i-e[r-1])/2)}function ov(n,e){let t=n.scale??1;return Float64Array.from(e.data,i=>i*t)}var Tu=(n,e)=>e>n+1e-9*Math.abs(n);function ww(n,e,t=1/0){if(Tu(t,e))return null;let{times:i,least:r,most:s}=n,o=0,a=i.count;for(;a-o>1;){let c=o+a>>1;i.data[c]<=e?o=c:a=c}let l=n.scale??1;return{least:r.data[o]*l,most:(s??r).data[o]*l}}function Ew(n){let e=n.filter(Boolean).map(({least:r,most:s})=>{let o=(a,l)=>a.data.reduce((c,h)=>l(c,h),a.data[0]);return[o(r,Math.min),o(s??r,Math.max)]}),t=Math.min(...e.map(([r])=>r)),i=Math.max(...e.map(([,r])=>r));return{middle:(t+i)/2,span:Math.max(...e.map(([r,s])=>s-r))}}function Tw(n,e){let t=Math.max(n.span,e.span),i=Math.abs(n.middle-e.middle);return i>yw*t&&t>1e-9*i}var uh=class{constructor(e,t,i,r,s=[]){this.channels=e,this.ends=s,this.marks=t,this.kinds=[...new Set(t.map(o=>o.kind))],this.full=i,this.x=i,this.seek=r,this.time=i[0],this.drawn=[],this.element=J("div",{className:"ppv-plots"}),this.names=new Set(e.flat().filter(o=>o.first).map(o=>o.name)),this.order=[...new Set(e.flat().map(o=>o.name))],this.onRemove=()=>{}}show(e,t){t?this.names.add(e):this.names.delete(e),this.build()}#e(){let e=[];for(let i of this.order){if(!this.names.has(i))continue;let r=this.channels.map(l=>l.find(c=>c.name===i)),s=(r.find(Boolean).shown_unit??r.find(Boolean).unit)||"1",o={name:i,found:r,...Ew(r)},a=e.find(l=>l.unit===s&&!l.members.some(c=>Tw(o,c)));a?a.members.push(o):e.push({unit:s,members:[o]})}let t=[...new Set(e.map(({unit:i})=>i))];return e.sort((i,r)=>t.indexOf(i.unit)-t.indexOf(r.unit))}build(){for(let{plot:t}of this.drawn)t.destroy();this.drawn=[],this.element.replaceChildren();let e=this.#e();this.ratio=window.devicePixelRatio||1,this.turns=e.flatMap(({members:t})=>t).map(({name:t})=>t).filter(t=>!Sx(t));for(let{unit:t,members:i}of e){let r=J("div",{className:"ppv-plot"}),s=J("div",{className:"ppv-caption"}),o=J("div",{className:"ppv-box"});r.append(s,o),this.element.append(r);let a=this.#t(t,i,o,s);this.drawn.push({...a,box:o,caption:s})}e.length||this.element.append(J("p",{className:"ppv-none"},this.order.length?"Choose a curve.":"This scene has no curves.")),this.resize(),this.cursor(this.time)}#t(e,t,i,r){let s=[],o=[{}],a=[],l=[],c=getComputedStyle(this.element);t.forEach(({name:m,found:_})=>{let w=Bc(this.element,m,this.turns.indexOf(m)),S=[w,Au(this.element,w)],R=J("output",{}),A=_.find(Boolean);r.append(J("span",{className:"ppv-curve"},...S.filter((b,F)=>_[F]).map(b=>J("i",{style:`background:${b}`})),J("span",{},A.label??m),R,J("small",{},e==="1"?"":e),Tt("\xD7",`Remove ${A.label??m}`,()=>{this.show(m,!1),this.onRemove()})));let x=Math.max(..._.filter(Boolean).map(b=>(b.scale??1)*Math.max(...[b.least,b.most??b.least].map(({data:F})=>F.reduce((L,D)=>Math.max(L,Math.abs(D)),0)))));l.push({values:R,found:_,digits:qc(x)}),_.forEach((b,F)=>{if(!b)return;let L=F?[6,4]:void 0,D={stroke:S[F],width:1.4,dash:L,points:{show:!1},spanGaps:!0},k=[bw(b),ov(b,b.least)];b.most&&(k.push(ov(b,b.most)),a.push({series:[o.length+1,o.length],fill:`color-mix(in srgb, ${S[F]} ${F?8:30}%, transparent)`}),o.push({...D,width:1})),o.push({...D,width:b.most?1:1.4}),s.push(k)})});let f=s.every(([m])=>m.length===s[0][0].length&&m.every((_,w)=>_===s[0][0][w]))?[s[0][0],...s.flatMap(([,...m])=>m)]:ti.join(s.map(m=>m.map(_=>Array.from(_)))),u=c.getPropertyValue("--v-soft").trim()||"#666",d=c.getPropertyValue("--v-grid").trim()||"#ddd",g={stroke:u,grid:{stroke:d,width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},M=new ti({width:300,height:sv,padding:[6,30,0,0],series:o,bands:a,legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,range:()=>this.x},y:{range:(m,_,w)=>Rw(_,w)}},axes:[{...g,size:22,gap:3,values:(m,_)=>Cw(_)},{...g,size:62,gap:4,space:Aw,values:(m,_)=>Rs(_)}],hooks:{draw:[m=>this.#i(m)]}},f,i),p=J("div",{className:"ppv-cursor"});return M.over.append(p),this.#n(M),{plot:M,line:p,shows:l}}#i(e){let{left:t,top:i,width:r}=e.bbox,s=-9;for(let o of this.marks){let a=e.valToPos(o.time,"x",!0);a<t||a>t+r||a-s<1||(s=a,e.ctx.fillStyle=vs(this.kinds,o.kind),e.ctx.fillRect(a-this.ratio/2,i,1.2*this.ratio,6*this.ratio))}}#n(e){let{over:t}=e,i=s=>e.posToVal(s.clientX-t.getBoundingClientRect().left,"x"),r=!1;t.addEventListener("pointerdown",s=>{s.button||(r=!0,t.setPointerCapture?.(s.pointerId),this.seek(i(s)))}),t.addEventListener("pointermove",s=>r&&this.seek(i(s)));for(let s of["pointerup","pointercancel"])t.addEventListener(s,()=>r=!1);t.addEventListener("dblclick",()=>this.zoom(this.full)),t.addEventListener("wheel",s=>{if(!s.ctrlKey&&!s.shiftKey&&s.deltaY>0&&this.x===this.full)return;s.preventDefault();let o=i(s),a=Math.exp(Math.max(-1,Math.min(1,(s.deltaY||s.deltaX)*.002)));this.zoom([o+(this.x[0]-o)*a,o+(this.x[1]-o)*a])},{passive:!1})}zoom([e,t]){let[i,r]=this.full,s=t-e>=r-i;this.x=s?this.full:[Math.max(i,e),Math.min(r,t)];for(let{plot:o}of this.drawn)o.setData(o.data);this.cursor(this.time)}resize(){let e=this.drawn.reduce((r,{caption:s})=>r+s.offsetHeight,0),t=this.element.clientHeight-e-4,i=Math.max(sv,Math.min(260,Math.floor(t/Math.max(1,this.drawn.length))-4));for(let{plot:r,box:s}of this.drawn)r.setSize({width:Math.max(120,s.clientWidth),height:i});this.cursor(this.time)}cursor(e){this.time=e;for(let{plot:t,line:i,shows:r}of this.drawn){let s=t.valToPos(e,"x");i.hidden=!(s>=-.5&&s<=t.over.clientWidth+.5),i.style.transform=`translateX(${s}px)`;for(let{values:o,found:a,digits:l}of r){let c=a.flatMap((h,f)=>{if(!h)return[];let u=ww(h,e,this.ends[f]);if(!u)return["\u2013"];let{least:d,most:g}=u;return[d===g?l(d):`${l(d)} \u2026 ${l(g)}`]}).join(" | ");o.textContent!==c&&(o.textContent=c)}}}};function Au(n,e){let t=getComputedStyle(n).getPropertyValue("--v-ink").trim()||"#1f2933";return`color-mix(in srgb, ${e} 40%, ${t})`}var Aw=(n,e,t,i,r)=>Math.max(9,Math.min(24,r/4));function Rw(n,e){if(!(e>=n))return[0,1];let t=.06*(e-n||Math.abs(e)||1);return[n-t,e+t]}function Cw(n){let[e,t]=Ex(Math.max(...n.map(Math.abs)));return Rs(n.map(i=>i/e),t)}function Rs(n,e=""){let t=Math.max(...n.map(Math.abs)),i=n.length>1?Math.abs(n[1]-n[0]):t,r=Math.max(0,Math.min(12,-Math.floor(Math.log10(i||1)+1e-9)));return r<12&&Math.abs(i*10**r-Math.round(i*10**r))>1e-6&&r++,n.map((s,o)=>{let a=t>=1e6||t>0&&t<1e-4?s.toExponential(2):s.toFixed(r);return(o===n.length-1&&e?`${a} ${e}`:a).replace(/^-(0(\.0+)?)$/,"$1").replace("-","\u2212")})}var Pw=92;function av(n){let e=n.length;return[1.5*n[0]-.5*n[1],1.5*n[e-1]-.5*n[e-2]]}function dh(n,e){let t=0,i=n.length-1;for(;i-t>1;){let r=t+i>>1;n[r]<=e?t=r:i=r}return e-n[t]<n[i]-e?t:i}var Ru=(n,e)=>n.most*10**((e/255-1)*(n.decibels/20)),ph=n=>Math.max(...n)>1e4?[.001,"kHz"]:[1,"Hz"],mh=class{constructor(e,t,i){this.element=e,this.seek=t,this.say=i,this.drawn=[],this.time=0}destroy(){for(let{plot:e}of this.drawn)e.destroy();this.drawn=[],this.element.replaceChildren()}build(e,t,i){this.destroy(),this.shown=i;for(let o of e){let a=J("div",{className:"ppv-box"});this.element.append(a),this.drawn.push({...this.#e(o,a,t),box:a,map:o})}let[r]=e,s=[...new Set(e.map(({most:o})=>Ht(o*i.scale,3)))].join(" | ");this.element.append(J("div",{className:"ppv-map-scale",title:"Amplitudes below the largest one of the map"},J("i",{style:`background:${zc().replace("to right","to top")}`}),J("span",{},`0 dB = ${s} ${i.unit==="1"?"":i.unit}`),J("span",{},`\u2212${r.decibels} dB`))),this.resize()}#e(e,t,i){let r=Array.from(e.times.data),s=Array.from(e.lines.data),[o,a]=av(r),[l,c]=av(s),h=Lw(e.levels.data,r.length,s.length),f={stroke:i.soft,grid:{show:!1},ticks:{show:!1},font:"11px system-ui, sans-serif"},[u,d]=e.of?[1,"order"]:ph([s.at(-1)]),g=new ti({width:300,height:160,padding:[6,30,0,0],legend:{show:!1},cursor:{show:!1},series:[{},{show:!1}],scales:{x:{time:!1,range:()=>[o,a]},y:{range:()=>[Math.max(0,l),c]}},axes:[{...f,size:22,gap:3,values:(p,m)=>Rs(m,"s")},{...f,size:62,gap:4,space:28,values:(p,m)=>Rs(m.map(_=>_*u),d)}],hooks:{draw:[()=>this.cursor(this.time)],drawClear:[p=>{let{ctx:m,bbox:_}=p,w=p.valToPos(c,"y",!0),S=p.valToPos(l,"y",!0);m.save(),m.beginPath(),m.rect(_.left,_.top,_.width,_.height),m.clip(),m.imageSmoothingEnabled=!1,m.drawImage(h,_.left,w,_.width,S-w),m.restore()}]}},[r,r.map(()=>null)],t),M=J("div",{className:"ppv-cursor"});return g.over.append(M),this.#t(g,e,r,s),{plot:g,line:M}}#t(e,t,i,r){let{over:s}=e,o=(l,c)=>{let h=s.getBoundingClientRect();return e.posToVal(c==="x"?l.clientX-h.left:l.clientY-h.top,c)},a=!1;s.addEventListener("pointerdown",l=>{l.button||(a=!0,s.setPointerCapture?.(l.pointerId),this.seek(o(l,"x")))}),s.addEventListener("pointermove",l=>{a&&this.seek(o(l,"x"));let c=dh(r,o(l,"y")),h=dh(i,o(l,"x")),f=t.levels.data[h*r.length+c],[u,d]=ph([r.at(-1)]),g=t.of?`order ${Ht(r[c],4)}`:`${Ht(r[c]*u,4)} ${d}`;this.say(`${Ht(i[h],4)} s, ${g}: ${f?"":"< "}${Ht(Ru(t,f)*this.shown.scale,3)} ${this.shown.unit}`)}),s.addEventListener("pointerleave",()=>this.say(""));for(let l of["pointerup","pointercancel"])s.addEventListener(l,()=>a=!1)}cursor(e){this.time=e;for(let{plot:t,line:i}of this.drawn){let r=t.valToPos(e,"x");i.hidden=!(r>=-.5&&r<=t.over.clientWidth+.5),i.style.transform=`translateX(${r}px)`}}resize(){let e=(this.element.clientWidth-Pw)/Math.max(1,this.drawn.length);for(let{plot:t}of this.drawn)t.setSize({width:Math.max(120,Math.floor(e)),height:Math.max(110,this.element.clientHeight)})}};function Lw(n,e,t){let i=J("canvas",{width:e,height:t}),r=i.getContext("2d"),s=r.createImageData(e,t),o=Array.from({length:256},(a,l)=>sl(l/255).map(c=>Math.round(255*c)));for(let a=0;a<e;a++)for(let l=0;l<t;l++)s.data.set([...o[n[a*t+l]],255],4*((t-1-l)*e+a));return r.putImageData(s,0,0),i}var gh=" and time",lv="#d2484f",xh=class{constructor(e,t,i){this.spectra=e.map(s=>s.spectra),this.maps=e.map(s=>s.maps),this.names=[...new Set(this.spectra.flat().map(s=>s.channel))];let r=s=>t.flat().find(o=>o.name===s)?.label??s;this.channels=t,this.name=this.names[0],this.time=e[0]?.times.data[0]??0,this.box=J("div",{className:"ppv-box"}),this.maps_box=J("div",{className:"ppv-maps",hidden:!0}),this.read=J("output",{}),this.unit=J("small",{className:"ppv-soft"}),this.waterfall=new mh(this.maps_box,i,s=>this.read.textContent=s),this.choice=rn("spectrum of",this.names.map(s=>[s,r(s)]),s=>this.choose(s,this.over)),this.ways=rn("over",[],s=>this.choose(this.name,s)),this.near=J("span",{className:"ppv-curve",hidden:!0},J("i",{}),J("span",{},"around the cursor")),this.element=J("div",{className:"ppv-spectra"},J("div",{className:"ppv-caption"},this.choice.row,this.ways.row,this.unit,this.near,this.read),this.box,this.maps_box),this.element.hidden=!0}waysOf(e){let t=({of:r})=>r?`orders of ${r}`:"frequency",i=r=>r.flat().filter(s=>s.channel===e);return[...new Set([...i(this.spectra).map(t),...i(this.maps).map(r=>t(r)+gh)])]}choose(e,t=""){this.name=e;let i=this.waysOf(e),r=i.find(s=>s.split(" ")[0]===t.split(" ")[0]&&s.endsWith(gh)===t.endsWith(gh));this.over=i.includes(t)?t:r??i[0],this.ways.select.replaceChildren(...i.map(s=>J("option",{value:s},s))),this.ways.select.value=this.over,this.choice.select.value=e,this.build()}#e(e){let t=/^orders of (.*?)( and time)?$/.exec(this.over)?.[1]??"";return e.map(i=>i.find(r=>r.channel===this.name&&(r.of??"")===t))}#t(e){let t=e?.unit??"1",i=this.channels.flat().find(({name:r})=>r===this.name);return!i?.shown_unit||i.unit!==t?{unit:t,scale:1}:{unit:i.shown_unit,scale:i.scale??1}}build(){if(!this.over)return this.choose(this.name);this.plot?.destroy(),this.plot=null,this.waterfall.destroy(),this.read.textContent="";let e=getComputedStyle(this.element),t=(o,a)=>e.getPropertyValue(o).trim()||a,i={soft:t("--v-soft","#666"),grid:t("--v-grid","#ddd"),paper:t("--v-paper","#fff")},r=this.over.endsWith(gh);this.shown=this.#t(this.#e(this.spectra).concat(this.#e(this.maps)).find(Boolean));let{unit:s}=this.shown;this.unit.textContent=s==="1"?"peak amplitude":`peak amplitude in ${s}`,r&&(this.unit.textContent="colours: peak amplitude in dB below the largest"),this.box.hidden=r,this.maps_box.hidden=!r,this.near.hidden=!0,r?this.waterfall.build(this.#e(this.maps).filter(Boolean),i,this.shown):this.#i(i),this.resize(),this.cursor(this.time)}#i(e){let t=this.#e(this.spectra),{unit:i,scale:r}=this.shown,s=t.filter(Boolean).map(({lines:p,amplitude:m})=>[Array.from(p.data),Array.from(m.data,_=>_>0?_*r:null)]),o={stroke:e.soft,grid:{stroke:e.grid,width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},a=Bc(this.element,this.name,0),{of:l=""}=t.find(Boolean)??{},c={width:1.2,points:{show:!1},spanGaps:!0},h=t.flatMap((p,m)=>p?[{...c,stroke:m?Au(this.element,a):a,dash:m?[6,4]:void 0}]:[]),f=s.reduce((p,[,m])=>m.reduce((_,w)=>Math.max(_,w??0),p),1e-300),[u,d]=ph(s.map(([p])=>p.at(-1)));this.passing=this.#e(this.maps)[0],this.passing&&(s.push([Array.from(this.passing.lines.data),Array.from(this.passing.lines.data,()=>null)]),h.push({...c,stroke:lv,width:1}),this.near.hidden=!1,this.near.firstChild.style.background=lv);let g=l?p=>`order ${Ht(p,5)}`:p=>`${Ht(p*u,5)} ${d}`;this.plot=new ti({width:300,height:160,padding:[6,44,0,0],legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},series:[{},...h],scales:{x:{time:!1},y:{distr:3,range:(p,m)=>[Math.max(m??0,f*1e-5),f*1.6]}},axes:[{...o,size:22,gap:3,values:(p,m)=>Rs(l?m:m.map(_=>_*u),l?"order":d)},{...o,size:62,gap:4,space:28,values:(p,m)=>m.map(_=>_===null?"":Ht(_,2))}],hooks:{setCursor:[p=>{let m=p.cursor.idx,w=(m==null?[]:p.data.slice(1).map(S=>S[m])).filter(S=>S!=null).map(S=>Ht(S,3));this.read.textContent=w.length?`${g(p.data[0][m])}: ${w.join(" | ")} ${i}`:""}]}},s.length>1?ti.join(s):s[0],this.box);let M=new Map(this.plot.data[0].map((p,m)=>[p,m]));this.rows=this.passing?Array.from(this.passing.lines.data,p=>M.get(p)):[],this.piece=-1}cursor(e){if(this.time=e,this.element.hidden||(this.waterfall.cursor(e),!this.plot||!this.passing))return;let{times:t,lines:i,levels:r}=this.passing,s=dh(t.data,e);if(s===this.piece)return;this.piece=s;let o=this.plot.data.slice(),a=new Array(o[0].length).fill(void 0);this.rows.forEach((c,h)=>{let f=r.data[s*i.data.length+h];a[c]=f?Ru(this.passing,f)*this.shown.scale:null}),o[o.length-1]=a;let l=this.plot.scales.x.min!=null;this.plot.setData(o,!l),l&&this.plot.redraw()}state(){if(this.element.hidden)return null;let e=this.passing&&this.plot?this.rows.map(i=>this.plot.data.at(-1)[i]):[],t=this.waterfall.drawn.map(({plot:i,line:r})=>({cursor:i.posToVal(new DOMMatrix(getComputedStyle(r).transform).m41,"x")}));return{channel:this.name,over:this.over,ways:this.waysOf(this.name),near:e,maps:t}}resize(){if(this.element.hidden)return;let e=this.element.querySelector(".ppv-caption"),t=Math.max(90,this.element.parentElement.clientHeight-e.offsetHeight-8);this.maps_box.style.height=`${t}px`,this.maps_box.hidden||this.waterfall.resize(),this.plot?.setSize({width:Math.max(120,this.box.clientWidth),height:t}),this.cursor(this.time)}};var _h=class{constructor(e,t,i,r){let s=e.map(a=>a.channels),o=e.map(a=>a.times?.data.at(-1));this.plots=new uh(s,i,t,r,o),this.spectra=new xh(e,s,r),this.labels=new Map(s.flat().map(a=>[a.name,a.label??a.name])),this.search=J("input",{type:"search",placeholder:`add a curve (${this.labels.size})`,"aria-label":"Search channels",title:"Channels, by any words of their names"}),this.list=J("div",{className:"ppv-list",role:"listbox","aria-label":"Channels",hidden:!0}),this.search.addEventListener("focus",()=>this.fill()),this.search.addEventListener("input",()=>this.fill()),this.search.addEventListener("keydown",a=>{if(a.key==="Escape"&&this.close(),a.key==="Enter"||a.key==="ArrowDown"){let l=this.list.querySelector("button");a.key==="Enter"?l?.click():l?.focus(),a.preventDefault()}a.stopPropagation()}),this.list.addEventListener("keydown",a=>{let l={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[a.key];l&&(document.activeElement?.[l]??this.search).focus(),a.key==="Escape"&&this.close(),(l||a.key==="Escape")&&a.preventDefault(),a.stopPropagation()}),this.picker=J("div",{className:"ppv-picker"},this.search,this.list),this.picker.addEventListener("focusout",a=>{this.picker.contains(a.relatedTarget)||this.close()}),this.tab=Tt("Spectrum","Curves over time or spectrum",()=>this.turn()),this.tab.hidden=!this.spectra.names.length,this.plots.onRemove=()=>this.list.hidden||this.fill(),this.body=J("div",{className:"ppv-curves-body"},this.plots.element,this.spectra.element),this.element=J("div",{className:"ppv-curves"},J("div",{className:"ppv-bar"},this.picker,this.tab),this.body),this.element.hidden=!this.labels.size&&!this.spectra.names.length}matches(){let e=this.search.value.toLowerCase().split(/\s+/).filter(Boolean);return[...this.labels].filter(([t,i])=>{let r=`${t} ${i}`.toLowerCase();return e.every(s=>r.includes(s))})}fill(){let e=this.matches();this.list.replaceChildren(...e.slice(0,200).map(([t,i])=>{let r=this.plots.names.has(t);return J("button",{type:"button",role:"option","aria-selected":String(r),title:t,onclick:s=>{this.plots.show(t,!this.plots.names.has(t)),s.currentTarget.setAttribute("aria-selected",String(this.plots.names.has(t)))}},i)})),e.length||this.list.append(J("p",{},"No channel has these words.")),e.length>200&&this.list.append(J("p",{},`${e.length-200} more: search for words of their names.`)),this.list.hidden=!1}close(){this.list.hidden=!0}spectrum(e,t){this.spectra.element.hidden&&this.turn(),this.spectra.choose(e,t)}turn(){if(!this.spectra.names.length)return;let e=this.spectra.element.hidden;this.spectra.element.hidden=!e,this.plots.element.hidden=e,this.tab.textContent=e?"Curves":"Spectrum",this.picker.style.visibility=e?"hidden":"",e?this.spectra.build():this.resize()}cursor(e){this.plots.cursor(e),this.spectra.cursor(e)}build(){this.element.hidden||(this.plots.build(),this.spectra.element.hidden||this.spectra.build())}resize(){this.element.hidden||(this.plots.element.hidden||this.plots.resize(),this.spectra.resize())}};var Dw=8,vh=class{constructor(e,t,i){this.stage=e,this.label=J("div",{className:"ppv-label",hidden:!0}),this.at=null,this.waiting=!1;let{canvas:r}=e;r.addEventListener("pointermove",o=>{this.at=t.dragging||o.pointerType==="touch"?null:{x:o.clientX,y:o.clientY},this.waiting||setTimeout(()=>this.#e(),60),this.waiting=!0}),r.addEventListener("pointerleave",o=>{this.at=null,o.pointerType!=="touch"&&(this.label.hidden=!0)});let s={x:0,y:0};r.addEventListener("pointerdown",({clientX:o,clientY:a,pointerType:l})=>{s={x:o,y:a},l==="touch"&&(this.label.hidden=!0)}),r.addEventListener("pointerup",({clientX:o,clientY:a,pointerType:l})=>{l!=="touch"||Math.hypot(o-s.x,a-s.y)>Dw||(this.at={x:o,y:a},this.#e(),this.at=null)}),r.addEventListener("dblclick",o=>{let a=e.hit(o.clientX,o.clientY);a&&i(a.part.solid.body)})}#e(){this.waiting=!1;let e=this.at&&this.stage.hit(this.at.x,this.at.y);if(this.label.hidden=!e,!e)return;let{solid:t}=e.part;this.label.textContent=Nw(t);let i=this.stage.canvas.getBoundingClientRect(),r=Math.min(this.at.x-i.left+14,i.width-this.label.offsetWidth-4);this.label.style.transform=`translate(${r}px, ${Math.max(0,this.at.y-i.top-26)}px)`}};function Nw(n){let e=n.name.replaceAll("_"," ");return n.teeth?`${e}, ${n.kind} of ${n.teeth} teeth`:e===n.kind?e:`${e}, ${n.kind}`}var pl=1e-4;function ml(n){let e=10**Math.floor(Math.log10(n)),t=n/e;return e*(t<1.5?1:t<3.5?2:t<7.5?5:10)}var Mh=class{constructor(e,t){this.times=e,this.poses=t,this.first=e.length?e[0]:0,this.last=e.length?e[e.length-1]:0,this.time=this.first,this.playing=!1,this.atEnd=null,this.loop="record",this.window=[this.first,this.last],this.body=-1,this.speed=this.#e()}#e(){let e=this.last-this.first,t=0,i=[cr(this.times,this.first),cr(this.times,this.last)];this.poses?.bodies.forEach((s,o)=>{t=Math.max(t,Math.abs(this.poses.angle(o,i[1])-this.poses.angle(o,i[0])))});let r=e>0?t>1?2*Math.PI*e/t/3:e/10:1;return ml(Math.max(pl,Math.min(1,r)))}seek(e){this.time=Math.max(this.first,Math.min(this.last,e))}advance(e){if(!this.playing)return;let[t,i]=this.window,r=this.time+e*this.speed;r<t&&(r=t);let s=r>i&&this.atEnd;s&&(r=i),r>i&&(r=i>t?t+(r-t)%(i-t):t),this.time=r,s&&this.atEnd()}step(e){this.playing=!1;let{low:t,share:i}=cr(this.times,this.time),r=t+i,s=e>0?Math.floor(r+1e-9)+e:Math.ceil(r-1e-9)+e;this.time=this.times[Math.max(0,Math.min(this.times.length-1,s))]??0}get frame(){let{low:e,share:t}=cr(this.times,this.time);return e+t}reference(e,t){let i=s=>this.poses&&Math.abs(this.poses.angle(s,cr(this.times,this.last))-this.poses.angle(s,cr(this.times,this.first)))>0;if(e>=0&&i(e))return e;let r=t.find(s=>s.teeth&&i(s.body));return r?r.body:this.poses?.bodies.findIndex((s,o)=>i(o))??-1}repeat(e,t,i){if(this.loop="record",this.window=[this.first,this.last],e==="record")return"";let r=this.reference(t,i);if(r<0)return"No body of this scene turns.";let s=i.find(f=>f.body===r&&f.teeth)?.teeth;if(e==="cycle"&&!s)return"The followed body is not a gear.";let o=2*Math.PI/(e==="cycle"?s:1),a=f=>this.poses.angle(r,cr(this.times,f));if(Math.abs(a(this.last)-a(this.first))<o)return"The record is shorter than that.";let c=this.time;Math.abs(a(this.last)-a(c))<o&&(c=this.#t(f=>Math.abs(a(this.last)-a(f))<=o,this.first,this.last));let h=this.#t(f=>Math.abs(a(f)-a(c))>=o,c,this.last);return this.loop=e,this.body=r,this.window=[c,h],this.seek(c),""}#t(e,t,i){for(let r=0;r<60;r++){let s=(t+i)/2;e(s)?i=s:t=s}return i}};var cv=[["space","play, pause"],["\u2190 \u2192","one frame back, on"],["Home, End","start, end"],["+ \u2212","faster, slower"],["[ ]","mark before, next mark"],["f","show all"],["1 \u2026 9, 0","follow a body, none"],["s","section"],["m","vibrations \xD71, \xD710, \xD7100, \xD71000"],["drag","turn; right button or shift: move"],["wheel","zoom to the pointer"],["double click","follow the body of a part"]];function hv(n){let e={" ":()=>n.toggle(),ArrowLeft:()=>n.step(-1),ArrowRight:()=>n.step(1),Home:()=>n.seek(n.player.window[0]),End:()=>n.seek(n.player.window[1]),"+":()=>Cu(n,2.1),"=":()=>Cu(n,2.1),"-":()=>Cu(n,.47619047619047616),"[":()=>n.transport.toMark(-1),"]":()=>n.transport.toMark(1),f:()=>n.views?.fit(),s:()=>n.section?.turn(!n.section.on),m:()=>Iw(n),Escape:()=>n.panels.close()};n.root.tabIndex=-1,document.addEventListener("keydown",t=>{if(t.ctrlKey||t.metaKey||t.altKey||t.defaultPrevented)return;let{target:i}=t,r=n.root.contains(i),s=i===document.body&&n.fills;if(!(!r&&!s||i.matches?.("select, input[type=search], input[type=text]")||i.matches?.("input[type=range]")&&i!==n.transport.range&&/^(Arrow|Home|End)/.test(t.key))&&!(t.key===" "&&i.matches?.("button, input[type=checkbox]"))){if(/^[0-9]$/.test(t.key))n.follow(Number(t.key)-1);else if(e[t.key])e[t.key]();else return;t.preventDefault()}})}function Cu(n,e){let{player:t,transport:i}=n;t.speed=Math.max(pl,Math.min(1,ml(t.speed*e))),i.speed.set(t.speed)}function Iw(n){if(!n.magnification)return;let e=n.stage.pictures[0].poses.magnification,t=e>=1e3?1:e>=100?1e3:e>=10?100:10;n.magnification.set(t),n.magnify(t)}var Pu=.48,Uw=.32,Sh=class{constructor(e){this.sizes=Fw(e),this.columns=Cr.filter(i=>e.some(r=>(r.components??r.largest)?.[i])),this.rows=e.map(i=>{let r=i.state?J("span",{className:"ppv-state"}):null,s=this.columns.map(a=>J("td",{className:`ppv-${a}`})),o=i.name.replaceAll("_"," ");return{state:r,cells:s,said:null,row:J("tr",{},J("th",{scope:"row",title:`${i.kind} ${o}`},r,o),...s)}}),this.folder=Tt("forces","Fold or unfold the forces",()=>this.fold(!this.folded),{"aria-expanded":"true"}),this.folded=this.chosen=!1;let t=J("tr",{},J("td",{},this.folder),...this.columns.map(i=>J("th",{scope:"col",className:`ppv-${i}`},J("i"),i)));if(this.states=J("div",{className:"ppv-states"}),e.some(i=>i.state)){let i=new Set(e.flatMap(r=>[...r.state?.data??[]]).map(r=>r===255?-1:r));for(let{word:r,colour:s}of[1,-1,2,0].filter(o=>i.has(o)).map(o=>hr[o]))this.states.append(J("span",{},J("i",{style:`background:${s}`}),r))}this.element=J("div",{className:"ppv-legend",tabindex:"0",role:"region","aria-label":"Forces now"},J("table",{},J("thead",{},t),J("tbody",{},...this.rows.map(({row:i})=>i))),this.states),this.element.hidden=!e.length}fold(e,t=!0){this.chosen||=t,this.folded=e,this.element.classList.toggle("ppv-folded",e),this.folder.setAttribute("aria-expanded",String(!e))}settle(){if(this.chosen||this.element.hidden)return;this.fold(!1,!1);let{clientWidth:e,clientHeight:t}=this.element.parentElement,{offsetWidth:i,offsetHeight:r}=this.element;this.fold(i>Pu*e||i>Uw*e&&r>Pu*t,!1)}get share(){if(this.element.hidden||this.folded)return 0;let e=(this.element.offsetWidth+12)/Math.max(this.element.parentElement.clientWidth,1);return e>Pu?0:e}get drop(){return(this.element.offsetHeight+12)/Math.max(this.element.parentElement.clientHeight,1)}update(e,t,i){this.element.hidden=i||!e.some(r=>t.has(r.kind)),!this.element.hidden&&e.forEach((r,s)=>{let{row:o,cells:a,state:l}=this.rows[s];if(o.hidden=!t.has(r.kind)||r.kind==="pair"&&!r.total,!o.hidden&&(this.columns.forEach((c,h)=>{let f=c in r.values?this.#e(r.values[c],r.unit):"";a[h].textContent!==f&&(a[h].textContent=f)}),l&&this.rows[s].said!==r.state)){let{word:c,colour:h}=hr[r.state]??hr[0];this.rows[s].said=r.state,l.style.background=h,l.title=c,l.setAttribute("aria-label",c)}})}#e(e,t){let{most:i,least:r}=this.sizes[t]??{};return wx(e,t,i||e,r||e)}lines(e,t){return e.filter(i=>t.has(i.kind)&&(i.kind!=="pair"||i.total)).map(i=>({name:i.name.replaceAll("_"," "),values:this.columns.filter(r=>r in i.values).map(r=>({part:r,text:this.#e(i.values[r],i.unit)}))}))}};function Fw(n){let e={};for(let{unit:t="N",size:i}of n){if(!i)continue;let r=e[t]??={most:i,least:i};r.most=Math.max(r.most,i),r.least=Math.min(r.least,i)}return e}var Ow={contact_loss:"contact lost",impact:"impact",back_flank:"back flank touches",front_flank:"front flank touches",faulty_tooth:"faulty tooth in mesh"},Lu=400,gl=n=>Ow[n]??n.replaceAll("_"," ");function fv(n){let{marks:e,kinds:t,stepLength:i}=n.transport,r=new Set,s=J("div",{className:"ppv-marklist"}),o=()=>{let l=e.filter(c=>!r.has(c.kind));s.replaceChildren(...l.slice(0,Lu).map(c=>{let h=Ms(c.time,i/10),f=c.until>c.time?`, ${No(c.until-c.time)}`:"",u=Tt("",`Go to ${gl(c.kind)} at ${h}`,()=>n.seek(c.time));return u.append(J("i",{style:`background:${vs(t,c.kind)}`}),J("b",{},h),J("span",{},`${gl(c.kind)}${c.what?`, ${c.what}`:""}${f}`)),u}),l.length>Lu?J("p",{className:"ppv-soft"},`${l.length-Lu} more`):"")},a=t.map(l=>{let c=e.filter(f=>f.kind===l).length,h=J("input",{type:"checkbox",checked:!0,onchange:()=>{h.checked?r.delete(l):r.add(l),o()}});return J("label",{className:"ppv-tick"},h,J("i",{className:"ppv-dot",style:`background:${vs(t,l)}`}),J("span",{},`${gl(l)} (${c})`))});return o(),[...a,s]}function yh(n){if(n.length<2)return[""];for(let e of["title","label","subtitle"]){let[t,i]=n.map(r=>r[e]??"");if(t&&i&&t!==i)return Bw(t,i)}return["first","second"]}function Bw(n,e){if(Math.max(n.length,e.length)<=36)return[n,e];let t=[n,e].map(r=>r.split(/(?<=[\s,_/-])/)),i=0;for(;i<Math.min(t[0].length,t[1].length)-1&&t[0][i]===t[1][i];)i++;return t.map(r=>{let s=(i?"\u2026 ":"")+r.slice(i).join("");return s.length>36?`${s.slice(0,35).trimEnd()}\u2026`:s})}var kw=1.6,zw=.06,bh=class{constructor(e,t,i){this.modes=e,this.changed=i,this.stage=t,this.number=-1,this.phase=0,this.amplitude=1,this.unit=e.map(s=>this.#t(s)),this.buttons=e.map((s,o)=>Tt("",`Swing in ${s.name}`,()=>this.choose(this.number===o?-1:o),{"aria-pressed":"false"})),this.buttons.forEach((s,o)=>s.append(J("span",{},e[o].name),J("span",{},this.#e(e[o])))),this.stop=Tt("back to the record","End the mode shape",()=>this.choose(-1)),this.stop.hidden=!0;let r=_r({label:"amplitude",title:"Amplitude of the mode shape",least:.05,most:20,value:1,show:s=>`\xD7 ${Ht(s,2)}`,changed:s=>{this.amplitude=s,this.changed()}});this.rows=[J("div",{className:"ppv-modes"},...this.buttons),r.row,this.stop]}#e({frequency:e,damping:t}){return`${Ht(e,4)} Hz${t==null?"":`, ${Ht(100*t,2)} %`}`}#t(e){let{solids:t,bounds:i}=this.stage.pictures[0],r=0,s=(o,a)=>{let l=0;for(let c=0;c<6;c++)l+=o?o.data[6*a+c]**2:0;return Math.sqrt(l)};this.stage.pictures[0].data.bodies.forEach((o,a)=>{let l=t.reachOf(a);r=Math.max(r,s(e.position,a)+s(e.turn,a)*(l||.1*i.radius))});for(let{sway:o}of t.parts)r=Math.max(r,o?.largest(e)??0);return r>0?zw*i.radius/r:0}get active(){return this.number>=0}get words(){return this.active?`${this.modes[this.number].name}, ${this.#e(this.modes[this.number])}`:""}choose(e){this.number=e,this.phase=0,this.buttons.forEach((t,i)=>t.setAttribute("aria-pressed",String(i===e))),this.stop.hidden=e<0,this.changed()}advance(e){this.active&&(this.phase=(this.phase+2*Math.PI*e/kw)%(2*Math.PI))}pose({poses:e}){e.ofMode(this.modes[this.number],this.phase,this.amplitude*this.unit[this.number])}};var Gw=.07,wh=Math.PI/2-.001,Th=class{constructor(e,t,i,r){this.camera=e,this.element=t,this.changed=i,this.up=new I(...r).normalize(),this.basis=new Ft().setFromUnitVectors(new I(0,1,0),this.up),this.now={target:new I,azimuth:.6,elevation:.4,distance:1},this.goal={target:new I,azimuth:.6,elevation:.4,distance:1},this.nearest=1e-6,this.farthest=1e6,this.chosen=!1,this.takesWheel=()=>!0,this.shift=0,this.pointers=new Map,t.addEventListener("pointerdown",s=>this.#i(s)),t.addEventListener("pointermove",s=>this.#r(s));for(let s of["pointerup","pointercancel"])t.addEventListener(s,o=>this.#n(o));t.addEventListener("wheel",s=>this.#s(s),{passive:!1}),t.addEventListener("contextmenu",s=>s.preventDefault())}get pixel(){return 2*this.now.distance*Math.tan(this.camera.fov*Math.PI/360)/Math.max(this.element.clientHeight,1)}direction(e=this.now){let t=Math.cos(e.elevation);return new I(t*Math.sin(e.azimuth),Math.sin(e.elevation),t*Math.cos(e.azimuth)).applyQuaternion(this.basis)}look({target:e,direction:t,distance:i},r=!1){if(this.chosen=!0,e&&this.goal.target.copy(e),i&&(this.goal.distance=this.#t(i)),t){let s=t.clone().normalize().applyQuaternion(this.basis.clone().invert());if(this.goal.elevation=Math.max(-wh,Math.min(wh,Math.asin(Math.max(-1,Math.min(1,s.y))))),Math.hypot(s.x,s.z)>1e-6){let o=Math.atan2(s.x,s.z);this.goal.azimuth=o+2*Math.PI*Math.round((this.now.azimuth-o)/(2*Math.PI))}}r&&this.settle(),this.changed()}settle(){this.now.target.copy(this.goal.target);for(let e of["azimuth","elevation","distance"])this.now[e]=this.goal[e];this.#e()}step(e){let t=1-Math.exp(-e/Gw),{now:i,goal:r}=this,s=i.target.distanceTo(r.target)/i.distance+Math.abs(i.azimuth-r.azimuth)+Math.abs(i.elevation-r.elevation)+Math.abs(Math.log(i.distance/r.distance));return s<1e-4?(s&&this.settle(),!1):(i.target.lerp(r.target,t),i.azimuth+=t*(r.azimuth-i.azimuth),i.elevation+=t*(r.elevation-i.elevation),i.distance*=(r.distance/i.distance)**t,this.#e(),!0)}#e(){let{camera:e,now:t}=this;e.position.copy(t.target).addScaledVector(this.direction(),t.distance),uv.lookAt(this.direction(),Hw,this.up),e.quaternion.setFromRotationMatrix(uv),e.updateMatrixWorld(!0)}#t(e){return Math.max(this.nearest,Math.min(this.farthest,e))}#i(e){e.button>2||(this.element.setPointerCapture?.(e.pointerId),this.pointers.set(e.pointerId,{x:e.clientX,y:e.clientY,pan:e.button!==0||e.shiftKey||e.ctrlKey}))}#n(e){this.pointers.delete(e.pointerId)}get dragging(){return this.pointers.size>0}#r(e){let t=this.pointers.get(e.pointerId);if(!t)return;let i=[...this.pointers.entries()].filter(([o])=>o!==e.pointerId).map(([,o])=>o),r=e.clientX-t.x,s=e.clientY-t.y;if(i.length){let[o]=i,a=Math.hypot(t.x-o.x,t.y-o.y),l=Math.hypot(e.clientX-o.x,e.clientY-o.y);a>0&&l>0&&this.zoom(a/l,(e.clientX+o.x)/2,(e.clientY+o.y)/2),this.pan(r/2,s/2)}else t.pan?this.pan(r,s):this.turn(r,s);t.x=e.clientX,t.y=e.clientY}turn(e,t){this.chosen=!0;let i=1.1*Math.PI/Math.max(this.element.clientHeight,1);this.goal.azimuth-=i*e,this.goal.elevation=Math.max(-wh,Math.min(wh,this.goal.elevation+i*t)),this.changed()}pan(e,t){this.chosen=!0;let i=this.pixel;this.goal.target.addScaledVector(Eh.set(1,0,0).applyQuaternion(this.camera.quaternion),-e*i),this.goal.target.addScaledVector(Eh.set(0,1,0).applyQuaternion(this.camera.quaternion),t*i),this.changed()}zoom(e,t,i){this.chosen=!0;let r=this.goal.distance;if(this.goal.distance=this.#t(r*e),t!==void 0){let s=this.element.getBoundingClientRect(),o=this.pixel*r/this.now.distance*(1-this.goal.distance/r);this.goal.target.addScaledVector(Eh.set(1,0,0).applyQuaternion(this.camera.quaternion),(t-s.left-this.middle(t-s.left))*o),this.goal.target.addScaledVector(Eh.set(0,1,0).applyQuaternion(this.camera.quaternion),(s.height/2-(i-s.top))*o)}this.changed()}middle(e){let t=this.element.clientWidth/(this.pictures??1);return(Math.floor(e/t)+.5-this.shift)*t}#s(e){if(!this.takesWheel(e))return;e.preventDefault();let t=e.deltaMode===1?33:1;this.zoom(Math.exp(Math.max(-1,Math.min(1,e.deltaY*t*.0015))),e.clientX,e.clientY)}},uv=new Le,Hw=new I,Eh=new I;var[Vw,Ww]=[5126,5125],[dv,Xw]=[34962,34963],Du=class{constructor(){this.pieces=[],this.length=0,this.json={asset:{version:"2.0",generator:"pitchpoint"},scene:0,scenes:[{nodes:[]}],nodes:[],meshes:[],materials:[],accessors:[],bufferViews:[],buffers:[{byteLength:0}]}}put(e,t,i,r=!1){let s={SCALAR:1,VEC3:3,VEC4:4}[t];this.json.bufferViews.push({buffer:0,byteOffset:this.length,byteLength:e.byteLength,...i&&{target:i}});let o={bufferView:this.json.bufferViews.length-1,componentType:e instanceof Float32Array?Vw:Ww,count:e.length/s,type:t};return r&&(o.min=Array(s).fill(1/0),o.max=Array(s).fill(-1/0),e.forEach((a,l)=>{o.min[l%s]=Math.min(o.min[l%s],a),o.max[l%s]=Math.max(o.max[l%s],a)})),this.pieces.push(new Uint8Array(e.buffer,e.byteOffset,e.byteLength)),this.length+=e.byteLength,this.json.accessors.push(o)-1}bytes(){this.json.buffers[0].byteLength=this.length;let e=new TextEncoder().encode(JSON.stringify(this.json)),t=Math.ceil(e.length/4)*4,i=new Uint8Array(20+t+8+this.length),r=new DataView(i.buffer);[1179937895,2,i.length,t,1313821514].forEach((o,a)=>r.setUint32(4*a,o,!0)),i.fill(32,20,20+t),i.set(e,20),r.setUint32(20+t,this.length,!0),r.setUint32(24+t,5130562,!0);let s=28+t;for(let o of this.pieces)i.set(o,s),s+=o.length;return i}};function pv(n,e,t,i){let r=new Du,{json:s}=r,o=new I,a=new Ft,l=new I,c=new Ft,h=i.length>1,f=h?r.put(Float32Array.from(i,p=>p-i[0]),"SCALAR",void 0,!0):0,u={name:"record",samplers:[],channels:[]},d=new Set(n.map(({solid:p})=>p.skin?p.skin.bodies[0]:p.body)),g=new Map;for(let p of d){let m={name:p<0?"ground":e[p].name,children:[]};if(g.set(p,m),s.scenes[0].nodes.push(s.nodes.push(m)-1),p<0)continue;let _=new Float32Array(3*i.length),w=new Float32Array(4*i.length);if(t[p].forEach((S,R)=>{S.decompose(o,a,l),R&&a.dot(c)<0&&a.set(-a.x,-a.y,-a.z,-a.w),c.copy(a),o.toArray(_,3*R),a.toArray(w,4*R)}),m.translation=[..._.slice(0,3)],m.rotation=[...w.slice(0,4)],!!h)for(let[S,R,A,x]of[["translation",_,"VEC3",3],["rotation",w,"VEC4",4]]){if(R.every((F,L)=>F===R[L%x]))continue;let b=u.samplers.push({input:f,output:r.put(R,A),interpolation:"LINEAR"})-1;u.channels.push({sampler:b,target:{node:s.nodes.indexOf(m),path:S}})}}let M=new Map;for(let{solid:p,geometry:m,colour:_}of n){let w=_+!!p.see_through;if(!M.has(w)){let{r:L,g:D,b:k}=new Xe(_),G={baseColorFactor:[L,D,k,p.see_through?.22:1],metallicFactor:.1,roughnessFactor:.7};M.set(w,s.materials.push({pbrMetallicRoughness:G,...p.see_through&&{alphaMode:"BLEND"}})-1)}let{position:S,normal:R}=m.attributes,A={POSITION:r.put(S.array,"VEC3",dv,!0),NORMAL:r.put(R.array,"VEC3",dv)},x=r.put(Uint32Array.from(m.index.array),"SCALAR",Xw),b=s.meshes.push({name:p.name,primitives:[{attributes:A,indices:x,material:M.get(w)}]})-1,F=s.nodes.push({name:p.name,mesh:b})-1;g.get(p.skin?p.skin.bodies[0]:p.body).children.push(F)}for(let p of g.values())p.children.length||delete p.children;return u.channels.length&&(s.animations=[u]),r.bytes()}var qw=[.5377,.7071,.4591],Yw=1e-6;function mv(n,e){let t=n.length/3,i=new Float64Array(t),r=0;for(let l=0;l<t;l++)for(let c=0;c<3;c++)i[l]+=qw[c]*n[3*l+c],r=Math.max(r,Yw*Math.abs(n[3*l+c]));let s=Uint32Array.from(i.keys()).sort((l,c)=>i[l]-i[c]),o=new Uint32Array(t);s.forEach((l,c)=>{o[l]=l;for(let h=c-1;h>=0&&i[l]-i[s[h]]<=r;h--){let f=o[s[h]];if(!(Math.hypot(...[0,1,2].map(d=>n[3*l+d]-n[3*f+d]))>r)){o[l]=f;break}}});let a=[];for(let l=0;l<e.length;l+=3){let c=[o[e[l]],o[e[l+1]],o[e[l+2]]];new Set(c).size===3&&a.push(...c)}return a}function xl(n,e){let t=URL.createObjectURL(n),i=J("a",{href:t,download:e});document.body.append(i),i.click(),i.remove(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}function _l(n,e){return`${n.scenes[0].title.toLowerCase().replace(/[^a-z0-9]+/g,"-").replace(/^-|-$/g,"")||"scene"}.${e}`}function Ah(n,e=1){let{stage:t}=n,{renderer:i,canvas:r}=t;i.setPixelRatio(t.ratio*e),i.setSize(t.size.width,t.size.height),n.draw();let s=J("canvas",{width:r.width,height:r.height}),o=s.getContext("2d");o.drawImage(r,0,0),t.resize(),n.draw();let a=t.ratio*e;o.scale(a,a);let l=getComputedStyle(n.root),c=l.getPropertyValue("--v-ink").trim()||"#222",h=l.getPropertyValue("--v-soft").trim()||"#666",{width:f,height:u}=t.size;o.textBaseline="top",o.font=`600 14px ${l.fontFamily}`,o.fillStyle=c;let d=f/n.scenes.length;n.scenes.forEach((w,S)=>o.fillText([w.title,w.label].filter(Boolean).join(", "),12+S*d,10)),o.font=`12px ${l.fontFamily}`,o.fillStyle=h;let g=n.modes?.active?n.modes.words:`t = ${Ms(n.player.time,n.transport.stepLength/10)}`;n.scenes.forEach((w,S)=>o.fillText([w.subtitle,g].filter(Boolean).join(", "),12+S*d,28)),n.legends.forEach((w,S)=>{w.element.hidden||Kw(o,n,S,(S+1)*d,c,l)}),n.boxes.forEach((w,S)=>{w.element.hidden||$w(o,w,12+S*d,u-62,h)});let[M,p]=n.scale.children;o.fillStyle=o.strokeStyle=h,o.fillText(M.textContent,12,u-30);let m=parseFloat(p.style.width);o.beginPath(),o.moveTo(12,u-15),o.lineTo(12,u-10),o.lineTo(12+m,u-10),o.lineTo(12+m,u-15),o.stroke();let _=atob(s.toDataURL("image/png").split(",")[1]);return new Blob([Uint8Array.from(_,w=>w.charCodeAt(0))],{type:"image/png"})}function $w(n,e,t,i,r){if(n.fillStyle=r,n.font=n.font.replace(/^\d+px/,"11px"),!e.bar.hidden){for(let s=0;s<210;s++)n.fillStyle=`rgb(${sl(s/209).map(o=>Math.round(255*o)).join(" ")})`,n.fillRect(t+s,i,1.5,8);n.fillStyle=r,n.fillText(`0 \u2026 ${e.end.textContent} on flanks, ${e.now.textContent}`,t,i+11)}e.gap.hidden||n.fillText(e.gap.textContent,t,i-16)}function Kw(n,e,t,i,r,s){let{arrows:o}=e.stage.pictures[t],a=e.legends[t],{columns:l}=a,c=a.lines(o.now,o.shown).slice(0,20),h=92*l.length+24+Math.max(0,...c.map(({name:f})=>n.measureText(f).width));n.globalAlpha=.85,n.fillStyle=s.getPropertyValue("--v-paper").trim()||"#fff",n.fillRect(i-h,0,h,34+16*c.length),n.globalAlpha=1,n.textAlign="right",l.forEach((f,u)=>{n.fillStyle=nl(e.root,f),n.fillText(f,i-12-92*(l.length-1-u),10)}),c.forEach(({name:f,values:u},d)=>{let g=27+16*d;n.fillStyle=r,n.font=`12px ${s.fontFamily}`,n.fillText(f,i-12-92*l.length,g);for(let{part:M,text:p}of u)n.fillText(p,i-12-92*(l.length-1-l.indexOf(M)),g)}),n.textAlign="left"}function Rh(n){let e=n.stage.pictures[0].solids.exported(!1).map(({solid:h,geometry:f})=>{let u=f.attributes.position.array;return{solid:h,points:u,index:mv(u,f.index.array)}}),t=e.reduce((h,{index:f})=>h+f.length/3,0),i=new ArrayBuffer(84+50*t),r=new DataView(i);r.setUint32(80,t,!0);let s=84,o=[new I,new I,new I],a=new I,l=new I,c=h=>{for(let f of[h.x,h.y,h.z])r.setFloat32(s,f,!0),s+=4};for(let{solid:h,points:f,index:u}of e){let d=n.stage.pictures[0].poses.ofSolid(h);for(let g=0;g<u.length;g+=3)o.forEach((M,p)=>M.fromArray(f,3*u[g+p]).applyMatrix4(d)),a.subVectors(o[1],o[0]).cross(l.subVectors(o[2],o[0])).normalize(),c(a),o.forEach(c),s+=2}return new Blob([i],{type:"model/stl"})}var gv=1e3;function Ch(n){let{solids:e,poses:t,data:i}=n.stage.pictures[0],r=t.times.length,s=Math.max(1,Math.ceil((r-1)/(gv-1))),o=[];for(let h=0;h<r;h+=s)o.push(h);let a=Zw(o.map(h=>t.times[h]),t),l=e.exported(!0),c=t.world.map(()=>[]);for(let h of a)t.at(h),t.world.forEach((f,u)=>c[u].push(new Le().copy(f)));return t.at(n.player.time),n.changed(),new Blob([pv(l,i.bodies,c,a)],{type:"model/gltf-binary"})}function Zw(n,e){let t=s=>(e.at(s),e.bodies.map((o,a)=>e.angle(a))),i=[n[0]],r=t(n[0]);for(let s=1;s<n.length&&i.length<8*gv;s++){let o=t(n[s]),a=Math.max(0,...o.map((c,h)=>Math.abs(c-r[h]))),l=Math.min(64,Math.max(1,Math.ceil(a/(Math.PI/2))));for(let c=1;c<=l;c++)i.push(n[s-1]+(n[s]-n[s-1])*c/l);r=o}return i}function xv(n){if(typeof MediaRecorder>"u"||!n.captureStream)return null;let t=["video/mp4;codecs=avc1.42E01E","video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm"].find(i=>MediaRecorder.isTypeSupported(i));return t?{ending:t.slice(6,t.includes(";")?t.indexOf(";"):void 0),start(){let i=new MediaRecorder(n.captureStream(30),{mimeType:t,videoBitsPerSecond:6e6}),r=[];return i.ondataavailable=({data:s})=>s.size&&r.push(s),i.start(500),()=>new Promise(s=>{i.onstop=()=>s(new Blob(r,{type:t.split(";")[0]})),i.stop()})}}:null}var Ph=class{constructor(){this.bar=J("div",{className:"ppv-tools",role:"toolbar","aria-label":"Scene"}),this.panel=J("div",{className:"ppv-panel",hidden:!0}),this.open=null,this.panel.addEventListener("keydown",e=>{e.key==="Escape"&&this.close()})}action(e,t,i){let r=Tt(e,t,i);return this.bar.append(r),r}add(e,t,i){let r=Tt(e,t,()=>this.open===e?this.close():this.show(e,i,r),{"aria-expanded":"false"});return this.bar.append(r),r}show(e,t,i){this.close(),this.open=e,this.opener=i,i.setAttribute("aria-expanded","true"),this.panel.replaceChildren(J("div",{className:"ppv-panel-head"},J("b",{},e),Tt("\xD7","Close",()=>this.close())),...t),this.panel.hidden=!1}close(){if(!this.open)return;let e=this.panel.contains(document.activeElement);this.open=null,this.panel.hidden=!0,this.opener.setAttribute("aria-expanded","false"),e&&this.opener.focus()}};function _v(n){let{stage:e}=n,t=e.pictures[0].data,i=[["axis","Along the axis"],["front","From the side"],["top","From above"],["iso","Oblique"]];n.followed=rn("follow",[["-1","nothing"],...t.bodies.map((h,f)=>[String(f),h.name])],h=>n.follow(Number(h)),"Body that the camera follows (1 to 9, 0)");let r=tr("turn with it",!1,h=>{n.views.turning=h,n.views.follow(n.views.body,h)}),s=n.scenes.flatMap(h=>h.solids),o=s.some(h=>h.see_through)?rn("housing",[["see-through","see-through"],["solid","solid"],["hidden","hidden"]],h=>{for(let f of e.pictures)f.solids.cover(h);n.changed()}).row:null,a=s.some(h=>h.schematic)?tr("what only stands for parts",!0,h=>{for(let f of e.pictures)f.solids.schematics(h);n.changed()}).row:null,c=n.scenes.flatMap(h=>h.arrows.filter(f=>f.kind==="mesh")).filter((h,f,u)=>u.findIndex(({name:d})=>d===h.name)===f).map(h=>Tt(h.name.replaceAll("_"," "),`Look into the mesh ${h.name}, along its axis`,()=>n.intoMesh(h)));return[J("div",{className:"ppv-buttons"},...i.map(([h,f])=>Tt(h,f,()=>n.views.named(h)))),n.followed.row,r.row,o,a,c.length?J("div",{},J("span",{className:"ppv-soft"},"look into a mesh"),J("div",{className:"ppv-buttons"},...c)):null].filter(Boolean)}var Jw={mesh:"mesh forces",pair:"forces of tooth pairs",bearing:"bearing forces",load:"loads"};function vv(n){let e=n.stage.pictures.map(r=>r.arrows),t=[...new Set(e.flatMap(r=>[...r.kinds]))],i=_r({label:"length",title:"Length of the arrows",least:.05,most:20,value:1,show:r=>`\xD7 ${Ht(r,2)}`,changed:r=>{for(let s of e)s.scale=r;n.changed()}});return n.kinds=Object.fromEntries(t.map(r=>[r,tr(Jw[r]??r,e.some(s=>s.shown.has(r)),s=>n.arrows(r,s))])),[...Object.values(n.kinds).map(({row:r})=>r),i.row]}function Mv(n){let{stage:e}=n,t=l=>xl(Ah(n,l),_l(n,"png")),i=xv(e.canvas),r=null,s=(l,c)=>{a.textContent=l,a.title=a.ariaLabel=c,a.setAttribute("aria-pressed",String(!!r))},o=i&&`Film what is played, to the end of the record, ${i.ending}`,a=i?Tt("film",o,async()=>{if(!r){n.filming=!0,e.coarsen(!1),r=i.start(),s("stop and save","Stop the film and save it; it stops by itself at the end of what is played"),n.player.atEnd=()=>a.click(),n.toggle(!0);return}let l=r;r=null,n.player.atEnd=null,n.filming=!1,n.toggle(!1),s("film",o),xl(await l(),_l(n,i.ending))}):null;return[J("div",{className:"ppv-buttons"},Tt("picture","PNG of the scene with title, time and forces",()=>t(1)),Tt("picture \xD7 2","The same with twice as many pixels each way",()=>t(2)),a),J("div",{className:"ppv-buttons"},Tt("GLB, moving","Solids and their motion, binary glTF",()=>xl(Ch(n),_l(n,"glb"))),Tt("STL","Solids where they are now, metres",()=>xl(Rh(n),_l(n,"stl"))))]}function Sv(n){return n.magnification=_r({label:"\xD7 ",title:"How much vibrations are magnified; turning is not (m)",least:1,most:1e4,value:1,show:e=>String(e<10?Number(e.toPrecision(2)):Math.round(e)),changed:e=>n.magnify(e)}),[n.magnification.row,J("p",{className:"ppv-soft"},"Displacements, tilts and torsion about their means; the turning itself is not magnified.")]}var ZO=new I(1,0,0),Nh=new I(0,0,1);function yv(n,e,t,i){let r=Math.hypot(e,t,i);if(r<1e-300)return n.identity();let s=Math.sin(r/2)/r;return n.set(s*e,s*t,s*i,Math.cos(r/2))}var Xo=class{constructor(e){this.bodies=e.bodies,this.times=e.times?.data??new Float64Array([0]),this.where={low:0,share:0},this.magnification=1,this.world=this.bodies.map(()=>new Le),this.still=this.bodies.map(()=>new Le),this.rest=this.bodies.map(()=>new Le),this.means=this.bodies.map(t=>({position:t.position&&Do(t.position),turn:t.turn&&Do(t.turn),spin:t.spin&&Do(t.spin)})),this.bodies.forEach((t,i)=>{let[r,s,o]=t.place??[0,0,0],a=new Ft(...t.axes??[0,0,0,1]).normalize();t.frame=new Le().compose(new I(r,s,o),a,new I(1,1,1)),this.rest[i].multiplyMatrices(this.#e(this.rest,i),t.frame)}),this.at(this.times[0])}#e(e,t){let i=this.bodies[t].parent??-1;return i<0?Lh:e[i]}ofSolid(e){if(e.between)return this.#t(e);let t=e.skin?e.skin.bodies[0]:e.body,i=t<0?Lh:this.world[t];return!e.place&&!e.axes?i:(e.seat??=new Le().compose(new I(...e.place??[0,0,0]),new Ft(...e.axes??[0,0,0,1]).normalize(),bv),e.placed??=new Le,e.placed.multiplyMatrices(i,e.seat))}#t(e){let{bodies:t,ends:i}=e.between,[r,s]=t.map((d,g)=>new I(...i[g]).applyMatrix4(d<0?Lh:this.world[d])),o=s.clone().sub(r),a=o.length()||1e-12,l=o.clone().divideScalar(a),c=t[0]<0?Lh:this.world[t[0]],h=[0,1,2].map(d=>new I().setFromMatrixColumn(c,d)).reduce((d,g)=>Math.abs(g.dot(l))<Math.abs(d.dot(l))-.2?g:d),f=h.addScaledVector(l,-h.dot(l)).normalize(),u=new I().crossVectors(l,f);return e.placed??=new Le,e.placed.makeBasis(f,u,o.lengthSq()?o:l.multiplyScalar(a)).setPosition(r)}#i({gross:e,ratio:t=1},i){return e?t*Qt(e,i):0}angle(e,t=this.where){let{spin:i}=this.bodies[e];return this.#i(this.bodies[e],t)+(i?Qt(i,t):0)}at(e){this.mode=null,this.where=cr(this.times,e);let{where:t,magnification:i}=this,r=(s,o,a)=>{let l=Qt(s,t,a);return i===1?l:o[a]+i*(l-o[a])};return this.bodies.forEach((s,o)=>{this.still[o].multiplyMatrices(this.#e(this.world,o),s.frame),Cs.set(0,0,0);let a=this.means[o];s.position&&Cs.set(r(s.position,a.position,0),r(s.position,a.position,1),r(s.position,a.position,2)),s.travel&&Cs.set(Cs.x+Qt(s.travel,t,0),Cs.y+Qt(s.travel,t,1),Cs.z+Qt(s.travel,t,2)),s.quaternion?(Dr.set(...[0,1,2,3].map(c=>s.quaternion.data[c+(s.quaternion.count>1?4*t.low:0)])),s.quaternion.count>1&&t.share&&(Nu.set(...[4,5,6,7].map(c=>s.quaternion.data[c+4*t.low])),Dr.slerp(Nu,t.share)),Dr.normalize()):(Dr.identity(),s.turn&&yv(Dr,r(s.turn,a.turn,0),r(s.turn,a.turn,1),r(s.turn,a.turn,2)));let l=this.#i(s,t)+(s.spin?r(s.spin,a.spin,0):0);l&&Dr.multiply(Nu.setFromAxisAngle(Nh,l)),Dh.compose(Cs,Dr,bv),this.world[o].multiplyMatrices(this.still[o],Dh)}),this}ofMode(e,t,i){let r=i*Math.cos(t),s=-i*Math.sin(t);this.mode={shape:e,cosine:r,sine:s};let o=(a,l,c)=>a?r*a.data[6*l+c]+s*a.data[6*l+3+c]:0;return this.bodies.forEach((a,l)=>{yv(Dr,o(e.turn,l,0),o(e.turn,l,1),o(e.turn,l,2));let c=this.rest[l];Dh.makeRotationFromQuaternion(Dr),this.world[l].multiplyMatrices(Dh,c);let h=this.world[l].elements;for(let f=0;f<3;f++)h[12+f]=c.elements[12+f]+o(e.position,l,f);this.still[l].copy(this.world[l])}),this}axis(){let e=new I,t=this.bodies.some(i=>i.gross);return this.bodies.forEach((i,r)=>{if(!i.gross&&(t||!i.spin))return;let s=new I().setFromMatrixColumn(this.rest[r],2);e.addScaledVector(s,e.dot(s)<0?-1:1)}),e.length()>1e-9?e.normalize():Nh.clone()}},Lh=new Le,Dh=new Le,Cs=new I,bv=new I(1,1,1),Dr=new Ft,Nu=new Ft;var vl={x:new I(1,0,0),y:new I(0,1,0),z:new I(0,0,1)},Ih=class{constructor(e,t){this.stage=e,this.changed=t,this.on=!1,this.normal=new I(0,0,1),this.flipped=!1,this.at=0,this.plane=new Yi;let[i]=Object.entries(vl).reduce((r,s)=>Math.abs(s[1].dot(e.pictures[0].poses.axis()))>Math.abs(r[1].dot(e.pictures[0].poses.axis()))?s:r);this.enable=tr("cut the solids (s)",!1,r=>this.turn(r)),this.axis=rn("square to",[...Object.keys(vl).map(r=>[r,r]),["mesh","axis of the mesh"]],r=>this.along(r)),this.axis.select.lastChild.hidden=!0,this.place=J("input",{type:"range",min:"0",max:"1000",title:"Place of the cut","aria-label":"Place of the cut"}),this.place.addEventListener("input",()=>this.#t()),this.said=J("output",{}),this.flip=tr("other half",!1,r=>{this.flipped=r,this.update(),t()}),this.rows=[this.enable.row,this.axis.row,J("label",{className:"ppv-slider"},J("span",{},"place"),this.place,this.said),this.flip.row],this.along(i)}along(e){e in vl&&this.normal.copy(vl[e]),this.axis.select.value=e;let[t,i]=this.#e();this.#i((t+i)/2),this.#r()}through(e,t){let i=Object.entries(vl).find(([,r])=>Math.abs(r.dot(t))>.999999999);this.normal.copy(t).normalize(),i&&this.normal.copy(i[1]),this.axis.select.lastChild.hidden=!!i,this.axis.select.value=i?i[0]:"mesh",this.flipped=this.normal.dot(t)<0,this.flip.input.checked=this.flipped,this.#i(this.normal.dot(e)),this.#s(!0)}#e(){let{low:e,high:t}=this.stage.bounds(),i=1/0,r=-1/0;for(let s=0;s<8;s++){let o=new I(s&1?t.x:e.x,s&2?t.y:e.y,s&4?t.z:e.z).dot(this.normal);i=Math.min(i,o),r=Math.max(r,o)}return[i,r]}#t(){let[e,t]=this.#e();this.at=e+Number(this.place.value)/1e3*(t-e),this.#n(),this.update(),this.changed()}#i(e){let[t,i]=this.#e();this.at=e,this.place.value=String(1e3*(e-t)/(i-t||1)),this.#n(),this.update(),this.changed()}#n(){let e=qc(1e3*Math.max(...this.#e().map(Math.abs)))(this.at*1e3);this.said.textContent=`${Number(e)===0?"0":e} mm`}#r(){let e=this.stage.camera.position.clone().applyMatrix4(this.stage.seen.clone().invert());this.flipped=this.normal.dot(e)<this.at,this.flip.input.checked=this.flipped,this.update()}turn(e){e&&this.#r(),this.#s(e)}#s(e){this.on=e,this.enable.input.checked=e;for(let{solids:t,flanks:i}of this.stage.pictures)for(let r of[t,i])r.cut(e?[this.plane]:[]);this.update(),this.changed()}update(){let e=this.flipped?1:-1;this.plane.normal.copy(this.normal).multiplyScalar(e),this.plane.constant=-e*this.at,this.plane.applyMatrix4(this.stage.seen)}};var Qw=8;function jw(){let n=new bo(.19,.19,.72,12,1,!1).translate(0,.36,0),e=new _c(.5,.3,16,1,!1).translate(0,.85,0),t=[n.toNonIndexed(),e.toNonIndexed()],i=s=>t.flatMap(o=>[...o.attributes[s].array]),r=new Ot;return r.setAttribute("position",new Gt(i("position"),3)),r.setAttribute("normal",new Gt(i("normal"),3)),r.rotateX(Math.PI/2)}var Uh=class{constructor(e,t,i,r,s){this.arrows=e.arrows,this.poses=i,this.radius=s,this.scale=1,this.kinds=new Set(this.arrows.map(f=>f.kind)),this.shown=new Set(this.kinds),this.shown.delete("pair"),this.arrows.filter(f=>f.kind==="bearing").length>Qw&&this.shown.delete("bearing"),this.hidden=!1;let o=jw(),a=new Eo(.5,14,10),l=f=>new Rr({color:f,emissive:f,emissiveIntensity:.35}),c=Object.fromEntries(Cr.map(f=>[f,l(nl(r,f))]));this.states=Object.fromEntries(Object.entries(hr).map(([f,{colour:u}])=>[f,l(u)]));let h=(f,u)=>{let d=new St(f,u);return d.matrixAutoUpdate=!1,t.add(d),d};this.drawn=this.arrows.map(f=>({parts:Object.fromEntries(Cr.filter(u=>(f.components??f.largest)?.[u]).map(u=>[u,h(o,c[u])])),ball:f.state?h(a,this.states[0]):null})),this.largest=this.arrows.map(f=>f.largest??Object.fromEntries(Cr.filter(u=>f.components?.[u]).map(u=>[u,iE(f.components[u].data)]))),this.size=Math.max(0,...this.arrows.map(f=>f.size??0))}get longest(){return .55*this.radius*this.scale}forces(){let{where:e}=this.poses;return this.arrows.map(t=>{if(t.now)return{name:t.name,kind:t.kind,unit:t.unit,...t.now()};let i=t.body<0?null:this.poses.still[t.body],r=new I(Qt(t.at,e,0),Qt(t.at,e,1),Qt(t.at,e,2));i&&r.applyMatrix4(i);let s={},o={},a=new I;for(let f of Cr){let u=t.components?.[f];if(!u)continue;let d=new I(Qt(u,e,0),Qt(u,e,1),Qt(u,e,2));o[f]=d.length(),a.add(d),i&&(wv.extractRotation(i),d.applyMatrix4(wv)),s[f]=d}let l=t.state?e.share===1?e.low+1:e.low:0,c=t.state?t.state.data[t.state.count>1?l:0]:null,h=c===255?-1:c;return{name:t.name,kind:t.kind,unit:t.unit??"N",state:h,vectors:s,values:o,at:r,total:a.length()}})}ends(){return this.hidden||!(this.size>0)?[]:this.forces().flatMap((e,t)=>this.shown.has(e.kind)?Object.entries(e.vectors).map(([i,r])=>{let s=this.longest*(this.largest[t][i]??0)/this.size;return r.clone().setLength(r.length()?s:0).add(e.at)}):[])}update(e){this.now=this.forces(),this.now.forEach((t,i)=>{let r=!this.hidden&&this.shown.has(t.kind),{parts:s,ball:o}=this.drawn[i],a=Math.min(.055*this.radius*Math.sqrt(this.scale),22*e||1/0);for(let[l,c]of Object.entries(s)){let h=t.vectors[l],f=this.size>0?this.longest*h.length()/this.size:0;if(c.visible=r&&f>2*e&&f>0,!c.visible)continue;let u=Math.min(a,.5*f);Ev.copy(h).normalize(),c.matrix.compose(t.at,eE.setFromUnitVectors(Nh,Ev),tE.set(u,u,f))}o&&(o.visible=r,o.material=this.states[t.state]??this.states[0],o.matrix.makeScale(.6*a,.6*a,.6*a).setPosition(t.at))})}},wv=new Le,eE=new Ft,Ev=new I,tE=new I;function iE(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}var Ml=1024,Oh=class extends St{constructor(e,t){let i=p=>e.reduce((m,_)=>m+p(_.geometry),0),r=i(p=>p.attributes.position.count),s=new Float32Array(3*r),o=new Float32Array(3*r),a=new Uint8Array(3*r),l=new Float32Array(r),c=new Uint32Array(i(p=>p.index.count)),h=new Xe,f=0,u=0;e.forEach(({geometry:p,colour:m},_)=>{let{array:w}=p.attributes.position;s.set(w,3*f),o.set(p.attributes.normal.array,3*f),h.set(m);let S=[h.r,h.g,h.b].map(R=>Math.round(255*R));for(let R=f;R<f+w.length/3;R++)l[R]=_,a.set(S,3*R);for(let R of p.index.array)c[u++]=f+R;f+=w.length/3});let d=new Ot;d.setAttribute("position",new Rt(s,3)),d.setAttribute("normal",new Rt(o,3)),d.setAttribute("color",new Rt(a,3,!0)),d.setAttribute("member",new Rt(l,1)),d.setIndex(new Rt(c,1)),super(d,t),this.parts=e,this.first=[],e.reduce((p,{geometry:{attributes:m}})=>(this.first.push(p),p+m.position.array.length),0);let g=Math.ceil(4*e.length/Ml);this.places=new Tr(new Float32Array(4*Ml*g),Ml,g,Fi,fi),this.frustumCulled=!1,this.matrixAutoUpdate=!1,t.vertexColors=!0;let M=t.onBeforeCompile;t.onBeforeCompile=p=>{M(p),p.uniforms.places={value:this.places},p.vertexShader=`attribute float member;
        uniform highp sampler2D places;
        mat4 placeOf() {
          int at = 4 * int(member + 0.5);
          ivec2 t = ivec2(at % ${Ml}, at / ${Ml});
          return mat4(texelFetch(places, t, 0), texelFetch(places, t + ivec2(1, 0), 0),
            texelFetch(places, t + ivec2(2, 0), 0), texelFetch(places, t + ivec2(3, 0), 0));
        }
        ${p.vertexShader}`.replace("#include <beginnormal_vertex>",`#include <beginnormal_vertex>
mat4 place = placeOf();
objectNormal = mat3(place) * objectNormal;`).replace("#include <begin_vertex>","vec3 transformed = (place * vec4(position, 1.0)).xyz;")},t.customProgramCacheKey=()=>"crowd"}place(e,t){this.places.image.data.set(t.elements,16*e),this.places.needsUpdate=!0}bend(e){let{attributes:t}=this.parts[e].geometry;for(let i of["position","normal"]){let{array:r}=t[i],s=this.geometry.attributes[i];s.array.set(r,this.first[e]),s.addUpdateRange(this.first[e],r.length),s.needsUpdate=!0}}raycast(e,t){this.parts.forEach((i,r)=>{Fh.geometry=i.geometry,Fh.material=this.material,Fh.matrixWorld.fromArray(this.places.image.data,16*r).premultiply(this.matrixWorld);let s=[];Fh.raycast(e,s);for(let o of s)t.push({...o,object:this,member:r})})}},Fh=new St;function Bh(n,e,t=40){let i=n.length/3,r=e.length/3,s=new Float64Array(3*r),o=new Float64Array(r);for(let M=0;M<r;M++){let[p,m,_]=[3*e[3*M],3*e[3*M+1],3*e[3*M+2]],w=n[m]-n[p],S=n[m+1]-n[p+1],R=n[m+2]-n[p+2],A=n[_]-n[p],x=n[_+1]-n[p+1],b=n[_+2]-n[p+2],F=S*b-R*x,L=R*A-w*b,D=w*x-S*A,k=Math.hypot(F,L,D);o[M]=k,k&&s.set([F/k,L/k,D/k],3*M)}let a=new Uint32Array(i+1);for(let M=0;M<e.length;M++)a[e[M]+1]++;for(let M=0;M<i;M++)a[M+1]+=a[M];let l=a.slice(0,i),c=new Uint32Array(e.length);for(let M=0;M<e.length;M++)c[l[e[M]]++]=M;let h=Math.cos(t*Math.PI/180),f=[],u=[],d=[],g=new Uint32Array(e.length);for(let M=0;M<i;M++){let p=[];for(let m=a[M];m<a[M+1];m++){let _=3*(c[m]/3|0),w=0,S=0,R=0;for(let b=a[M];b<a[M+1];b++){let F=c[b]/3|0;s[_]*s[3*F]+s[_+1]*s[3*F+1]+s[_+2]*s[3*F+2]<h||(w+=o[F]*s[3*F],S+=o[F]*s[3*F+1],R+=o[F]*s[3*F+2])}let A=Math.hypot(w,S,R)||1;w/=A,S/=A,R/=A;let x=p.find(b=>Math.abs(u[3*b]-w)+Math.abs(u[3*b+1]-S)+Math.abs(u[3*b+2]-R)<1e-6);x===void 0&&(x=d.length,p.push(x),d.push(M),f.push(n[3*M],n[3*M+1],n[3*M+2]),u.push(w,S,R)),g[c[m]]=x}}return{points:Float32Array.from(f),normals:Float32Array.from(u),index:g,source:Uint32Array.from(d)}}var nE=.35;function Gh({points:n,normals:e,index:t}){let i=new Ot;return i.setAttribute("position",new Rt(n,3)),i.setAttribute("normal",new Rt(e,3)),i.setIndex(n.length/3<65536?new Rt(Uint16Array.from(t),1):new Rt(Uint32Array.from(t),1)),i.computeBoundingSphere(),i}function Fu(n,e){let t=Math.cos(e),i=Math.sin(e),r=new Float32Array(n.length);for(let s=0;s<n.length;s+=3)r[s]=t*n[s]-i*n[s+1],r[s+1]=i*n[s]+t*n[s+1],r[s+2]=n[s+2];return r}function rE(n,e,t){let i=n.points.data,r=n.triangles.data,s=i.length/3,o=0;for(let p of i)o=Math.max(o,Math.abs(p));let a=new Map,l=[],c=(p,m,_)=>{let w=[p,m,_].map(S=>Math.round(S/o*2e5)).join();return a.has(w)||(a.set(w,l.length/3),l.push(p,m,_)),a.get(w)},h=[];for(let p of[0,-1,1]){let m=p?Fu(i,p*e):i,_=Array.from({length:s},(w,S)=>c(m[3*S],m[3*S+1],m[3*S+2]));for(let w of r)h.push(_[w])}let f=Bh(Float32Array.from(l),Uint32Array.from(h),t),u=f.index.subarray(0,r.length),d=new Map,g=Uint32Array.from(u,p=>(d.has(p)||d.set(p,d.size),d.get(p))),M=p=>{let m=new Float32Array(3*d.size);for(let[_,w]of d)m.set(p.subarray(3*_,3*_+3),3*w);return m};return Gh({points:M(f.points),normals:M(f.normals),index:g})}var Tv=new Le,Iu=new Le,kh=new Le,Uu=new ln,Av=new cn,sE=new I,zh=class extends Mn{constructor(e,t){super();let{solid:i}=e;this.matrixAutoUpdate=!1;let r=2*Math.PI/Math.max(i.teeth||0,2);this.pieces=i.pieces.map(s=>{let o=Array.from(s.turns.data),a=s.levels.map(f=>{let u=rE(f,r,i.creases??40),d=new $a(u,t(s.fault),o.length);return d.instanceMatrix=new Zr(new Float32Array(16*o.length),16),d.frustumCulled=!1,d.matrixAutoUpdate=!1,d.count=0,d.visible=!1,Object.assign(d.userData,{part:e,fault:s.fault}),this.add(d),{error:f.error,geometry:u,mesh:d,shown:[]}}),{center:l,radius:c}=a[a.length-1].geometry.boundingSphere,h=o.map(f=>l.clone().applyMatrix4(Tv.makeRotationZ(f)));return{turns:o,levels:a,centres:h,radius:c}})}get meshes(){return this.pieces.flatMap(({levels:e})=>e.map(({mesh:t})=>t))}get drawn(){return this.meshes.reduce((e,t)=>e+(t.visible?t.count*t.geometry.index.count/3:0),0)}get finest(){return this.pieces.reduce((e,{turns:t,levels:i})=>e+t.length*i[i.length-1].geometry.index.count/3,0)}choose(e,t,i){Iu.multiplyMatrices(e,this.matrix),kh.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),Av.setFromProjectionMatrix(kh),kh.multiplyMatrices(t.matrixWorldInverse,Iu);for(let r of this.pieces){let s=r.levels.map(()=>[]);r.centres.forEach((o,a)=>{if(Uu.center.copy(o).applyMatrix4(Iu),Uu.radius=r.radius,!Av.intersectsSphere(Uu))return;let l=Math.max(-sE.copy(o).applyMatrix4(kh).z-r.radius,t.near),c=nE*i*l,h=r.levels.findIndex(({error:f})=>f<=c);h<0&&(h=r.levels.length-1),s[h].push(a)}),r.levels.forEach((o,a)=>this.#e(r,o,s[a]))}}#e(e,t,i){let{mesh:r}=t;i.length===t.shown.length&&i.every((s,o)=>s===t.shown[o])||(t.shown=i,i.forEach((s,o)=>Tv.makeRotationZ(e.turns[s]).toArray(r.instanceMatrix.array,16*o)),r.instanceMatrix.needsUpdate=!0,r.count=i.length,r.visible=i.length>0,r.boundingSphere=null)}whole(e){let t=this.pieces.flatMap(({turns:c,levels:h})=>{let f=h.length-(h.length>2?2:1),{geometry:u}=h[e==="fine"?f:0];return c.map(d=>({geometry:u,turn:d}))}),i=c=>t.reduce((h,{geometry:f})=>h+c(f),0),r=new Float32Array(i(({attributes:c})=>c.position.array.length)),s=new Float32Array(r.length),o=new Uint32Array(i(c=>c.index.count)),[a,l]=[0,0];for(let{geometry:c,turn:h}of t){r.set(Fu(c.attributes.position.array,h),a),s.set(Fu(c.attributes.normal.array,h),a);for(let f of c.index.array)o[l++]=a/3+f;a+=c.attributes.position.array.length}return Gh({points:r,normals:s,index:o})}};var oE=new Le,Hh=(n,e)=>e<0?oE:n[e],Vh=class{constructor(e,t,i,r){this.skin=e,this.geometry=t,this.source=i,this.poses=r,this.points=t.attributes.position.array.slice(),this.normals=t.attributes.normal.array.slice();let s=Hh(r.rest,e.bodies[0]);this.toBody=e.bodies.map(o=>Hh(r.rest,o).clone().invert().multiply(s)),this.moved=e.bodies.map(()=>new Le),this.drawn=e.bodies.map(()=>new Le)}update(e,t){let{skin:i,poses:r,moved:s,drawn:o}=this,a=Hh(r.world,i.bodies[0]).clone().invert(),l=0;if(s.forEach((g,M)=>{g.multiplyMatrices(a,Hh(r.world,i.bodies[M])).multiply(this.toBody[M]);for(let p=0;p<16;p++)l=Math.max(l,Math.abs(g.elements[p]-o[M].elements[p])*(p<12?t:1))}),l<=e)return!1;s.forEach((g,M)=>o[M].copy(g));let{position:c,normal:h}=this.geometry.attributes,{first:f,second:u,weight:d}=i;for(let g=0;g<this.source.length;g++){let M=this.source[g],p=u.data[M],m=d.data[M],_=o[f?f.data[M]:0].elements,w=o[p].elements,S=this.points[3*g],R=this.points[3*g+1],A=this.points[3*g+2],x=this.normals[3*g],b=this.normals[3*g+1],F=this.normals[3*g+2];for(let L=0;L<3;L++){let D=_[L]+m*(w[L]-_[L]),k=_[4+L]+m*(w[4+L]-_[4+L]),G=_[8+L]+m*(w[8+L]-_[8+L]);c.array[3*g+L]=D*S+k*R+G*A+_[12+L]+m*(w[12+L]-_[12+L]),h.array[3*g+L]=D*x+k*b+G*F}}return c.needsUpdate=h.needsUpdate=!0,this.geometry.computeBoundingSphere(),!0}};var Wh=class{constructor(e,t,i,r){this.name=e.name,this.geometry=t,this.poses=r;let{shapes:s,node:o,coordinates:a}=e.sway;this.shapes=s.data,this.count=s.shape[0],this.nodes=s.shape[1],this.node=Uint32Array.from(i,l=>o.data[l]),this.points=t.attributes.position.array.slice(),this.coordinates=a,this.mean=a&&Do(a),this.drawn=new Float64Array(this.count),this.moved=new Float64Array(3*this.nodes)}#e(){let{mode:e,magnification:t,where:i}=this.poses;return this.drawn.map((r,s)=>{if(e){let a=e.shape.sway?.[this.name];return a?e.cosine*a.data[2*s]+e.sine*a.data[2*s+1]:0}if(!this.coordinates)return 0;let o=Qt(this.coordinates,i,s);return t===1?o:this.mean[s]+t*(o-this.mean[s])})}largest(e){let t=e.sway?.[this.name],i=0;for(let r=0;t&&r<this.nodes;r++){let s=0;for(let o=0;o<6;o++){let a=0;for(let l=0;l<this.count;l++)a+=t.data[2*l+o%2]*this.shapes[3*(this.nodes*l+r)+(o>>1)];s+=a*a}i=Math.max(i,Math.sqrt(s))}return i}update(){let e=this.#e();if(e.every((i,r)=>i===this.drawn[r]))return!1;this.drawn=e,this.moved.fill(0);for(let i=0;i<this.count;i++){let r=3*this.nodes*i;for(let s=0;s<this.moved.length;s++)this.moved[s]+=e[i]*this.shapes[r+s]}let{position:t}=this.geometry.attributes;for(let i=0;i<this.node.length;i++)for(let r=0;r<3;r++)t.array[3*i+r]=this.points[3*i+r]+this.moved[3*this.node[i]+r];return t.needsUpdate=!0,this.geometry.computeBoundingSphere(),!0}};var Rv=300,aE=2.5,lE=.9996,cE=new Le().multiplyScalar(0);function hE(n){n.onBeforeCompile=e=>{e.fragmentShader=`#ifdef DOUBLE_SIDED
        uniform mat4 projectionMatrix;
      #endif
      ${e.fragmentShader}`.replace("#include <opaque_fragment>",`#ifdef DOUBLE_SIDED
        gl_FragDepth = gl_FragCoord.z;
        if (!gl_FrontFacing) {
          float nearer = ${lE} / gl_FragCoord.w;
          gl_FragDepth = clamp(0.5 + 0.5 * (projectionMatrix[3][2] / nearer - projectionMatrix[2][2]), 0.0, 1.0);
          float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0);
          outgoingLight = diffuseColor.rgb * (stripe < 1.1 ? 0.66 : 0.86);
        }
      #endif
      #include <opaque_fragment>`)}}function Cv(n,e){let t=new Rr({color:n});return e&&Object.assign(t,{transparent:!0,opacity:.22,depthWrite:!1}),hE(t),t}var Xh=class{constructor(e,t,i){this.solids=e.solids,this.root=t,this.poses=i,this.known=new Map;let r={};this.parts=e.solids.map(s=>{let o=r[s.kind]=(r[s.kind]??-1)+1,a={solid:s,colour:Mx(s.kind,o,s.schematic)};if(s.pieces)a.repeated=new zh(a,c=>this.#e(a,c,"repeated")),a.geometry=a.repeated.whole("coarse");else{let c=Bh(s.points.data,s.triangles.data,s.creases??40);a.geometry=Gh(c),a.skin=s.skin?new Vh(s.skin,a.geometry,c.source,i):null,a.sway=s.sway?new Wh(s,a.geometry,c.source,i):null}let l=a.geometry.attributes.position.array;return Object.assign(a,{radius:uE(l),rim:fE(l)})}),this.triangles=this.parts.reduce((s,o)=>s+(o.repeated?.finest??o.geometry.index.count/3),0),this.meshes=[],this.crowds=[],this.parts.length>Rv?this.#i():this.#t(),this.update(0)}#e({colour:e,solid:t},i="",r=""){let s=[e,!!t.see_through,!!i,r].join();if(!this.known.has(s)){let o=i?new Xe(e).lerp(new Xe(vx),.55):e;this.known.set(s,Cv(o,t.see_through))}return this.known.get(s)}get materials(){return[...this.known.values()]}#t(){for(let e of this.parts){let t=e.repeated??new St(e.geometry,this.#e(e));t.matrixAutoUpdate=!1,t.renderOrder=e.solid.see_through?1:0,t.userData.part=e,e.mesh=t,this.meshes.push(...e.repeated?.meshes??[t]),this.root.add(t)}}#i(){for(let e of[!1,!0]){let t=this.parts.filter(s=>!!s.solid.see_through===e);if(!t.length)continue;let i=Cv("#ffffff",e),r=new Oh(t,i);t.forEach((s,o)=>Object.assign(s,{crowd:r,member:o,repeated:null})),r.renderOrder=e?1:0,this.known.set(`crowd ${e}`,i),this.crowds.push(r),this.root.add(r)}}update(e){for(let t of this.parts){let i=this.poses.ofSolid(t.solid),r=[t.skin?.update(e,t.radius),t.sway?.update()].some(Boolean);t.crowd?(t.crowd.place(t.member,this.shows(t)?i:cE),r&&t.crowd.bend(t.member)):t.mesh.matrix.copy(i)}}choose(e,t,i){for(let{repeated:r}of this.parts)r?.choose(e,t,i)}exported(e){return this.parts.filter(t=>this.shows(t)).map(t=>{let i=t.repeated?t.repeated.whole("fine"):t.geometry,{solid:r}=t;if(!e||!(r.place||r.axes||r.between))return{...t,geometry:i};let s=this.poses.ofSolid(r).clone(),o=r.between?r.between.bodies[0]:r.body;return o>=0&&s.premultiply(this.poses.world[o].clone().invert()),{...t,solid:{...r,body:o},geometry:i.clone().applyMatrix4(s)}})}get drawn(){return this.parts.reduce((e,t)=>e+(t.repeated?.drawn??(this.shows(t)?t.geometry.index.count/3:0)),0)}cut(e){for(let t of this.materials)t.clippingPlanes=e.length?e:null,t.side=e.length?zi:sn,t.needsUpdate=!0}cover(e){let t=new Set;for(let i of this.parts){if(!i.solid.see_through)continue;i.hidden=e==="hidden",this.#n(i);let r=i.crowd?.material??i.mesh.material;t.has(r)||(t.add(r),Object.assign(r,e==="solid"?{transparent:!1,opacity:1,depthWrite:!0}:{transparent:!0,opacity:.22,depthWrite:!1}),r.needsUpdate=!0)}}schematics(e){this.plain=!e;for(let t of this.parts)t.solid.schematic&&this.#n(t)}shows(e){return!e.hidden&&!(this.plain&&e.solid.schematic)}#n(e){e.mesh&&(e.mesh.visible=this.shows(e))}hit(e){let i=e.intersectObjects([...this.meshes,...this.crowds].filter(r=>r.visible),!1).map(({object:r,member:s,point:o})=>({part:r.userData.part??r.parts[s],fault:r.userData.fault??"",point:o})).filter(({part:r})=>this.shows(r));return i.find(({part:r,point:s})=>!r.solid.see_through&&this.#r(s))??i.find(({point:r})=>this.#r(r))??null}#r(e){return!this.materials[0]?.clippingPlanes?.some(t=>t.distanceToPoint(e)<0)}bounds(){let e=this.parts.filter(({solid:s})=>!s.see_through||s.schematic),t=this.#s(this.parts),i=e.length&&e.length<this.parts.length?this.#s(e):t;return{...t.radius<aE*i.radius?t:i,size:i.radius,whole:t}}#s(e){let t=new I(1/0,1/0,1/0),i=t.clone().negate(),r=new I,s=[];for(let o of e){let a=this.poses.ofSolid(o.solid),{center:l,radius:c}=o.geometry.boundingSphere;o.geometry.computeBoundingBox();let{min:h,max:f}=o.geometry.boundingBox;if(!(c>=0))continue;let u=o.geometry.attributes.position,d=Math.max(1,Math.ceil(u.count/(this.parts.length>Rv?4:80)));for(let g=0;g<u.count;g+=d)s.push(new I().fromBufferAttribute(u,g).applyMatrix4(a));for(let g=0;g<8;g++)r.set(g&1?f.x:h.x,g&2?f.y:h.y,g&4?f.z:h.z),r.sub(l).clampLength(0,c).add(l).applyMatrix4(a),t.min(r),i.max(r)}return i.x>=t.x?{centre:t.clone().add(i).multiplyScalar(.5),radius:Math.max(t.distanceTo(i)/2,1e-9),low:t,high:i,outline:s}:{centre:r.set(0,0,0),radius:1,low:r.clone().set(-1,-1,-1),high:r.clone().set(1,1,1),outline:s}}reachOf(e){return Math.max(0,...this.parts.filter(t=>t.solid.body===e).map(t=>t.radius))}};function fE(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1]));return e}function uE(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}var dE=/swiftshader|llvmpipe|softpipe|software|basic render/i;function Pv(){try{let n=document.createElement("canvas").getContext("webgl2");if(!n)return null;let e=n.getExtension("WEBGL_debug_renderer_info"),t=String(n.getParameter(e?e.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),{software:dE.test(t)}}catch{return null}}var Ou=class{constructor(e,t){this.data=e,this.scene=new lo,this.over=new lo,this.root=new Mn,this.overRoot=new Mn,this.root.matrixAutoUpdate=this.overRoot.matrixAutoUpdate=!1,this.scene.add(this.root),this.over.add(this.overRoot),this.lights=[this.scene,this.over].map(i=>{let r=new Za("#ffffff",2.1),s=new Ka("#ffffff","#8f98a3",1.25);return i.add(r,r.target,s),{light:r,sky:s}}),this.poses=new Xo(e),this.solids=new Xh(e,this.root,this.poses),this.bounds=this.solids.bounds(),this.flanks=new $c(e,this.root,this.overRoot,this.poses),this.arrows=new Uh({arrows:[...e.arrows,...this.flanks.pairs()]},this.overRoot,this.poses,t,this.bounds.size)}},qh=class{constructor(e,t,i){this.host=e,this.software=i,this.renderer=new il({antialias:!i,powerPreference:"high-performance"}),this.renderer.autoClear=!1,this.renderer.localClippingEnabled=!0,this.canvas=this.renderer.domElement,this.canvas.className="ppv-canvas",e.append(this.canvas),this.camera=new Bi(28,1,.01,100),this.pictures=t.map(a=>new Ou(a,e));let r=Math.max(...this.pictures.map(a=>a.arrows.size)),s=Math.max(...this.pictures.map(a=>a.bounds.size)),o=Math.max(...this.pictures.map(a=>a.flanks.greatest));for(let{arrows:a,flanks:l}of this.pictures)Object.assign(a,{size:r,radius:s}),l.greatest=o;this.background=new Xe("#ffffff"),this.size={width:1,height:1},this.drawn=0,this.coarse=!1,this.shift=0,this.seen=new Le}coarsen(e){return e===this.coarse?!1:(this.coarse=e,this.resize(),!0)}get ratio(){return this.coarse?.6:this.software?1:Math.min(window.devicePixelRatio||1,2)}resize(){let{clientWidth:e,clientHeight:t}=this.host;!e||!t||(this.size={width:e,height:t},this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(e,t),this.camera.aspect=e/this.pictures.length/t,this.camera.updateProjectionMatrix())}bounds(e="fit"){let t=this.pictures.map(({bounds:a})=>e==="fit"?a:a.whole),i=t.reduce((a,l)=>a.min(l.low),t[0].low.clone()),r=t.reduce((a,l)=>a.max(l.high),t[0].high.clone()),s=i.clone().add(r).multiplyScalar(.5),o=Math.max(...t.map(a=>a.centre.distanceTo(s)+a.radius));return{centre:s.applyMatrix4(this.seen),radius:o,low:i,high:r}}render(e){let{renderer:t,camera:i}=this,{centre:r,radius:s}=this.bounds("whole"),{distance:o,target:a}=e.now,l=a.distanceTo(r);i.near=Math.max(.01*o,o-l-1.3*s),i.far=o+l+2.5*s;let c=this.size.width/this.pictures.length;i.setViewOffset(c,this.size.height,this.shift*c,0,c,this.size.height),this.setLights(),t.setScissorTest(!0);let h=this.size.width/this.pictures.length;i.updateMatrixWorld();let f=this.size.height*Math.min(1,this.ratio),u=(this.software?2.5:1)*2*Math.tan(i.fov*Math.PI/360)/f;this.pictures.forEach((d,g)=>{t.setViewport(g*h,0,h,this.size.height),t.setScissor(g*h,0,h,this.size.height),t.setClearColor(this.background,1),t.clear(),d.root.matrix.copy(this.seen),d.overRoot.matrix.copy(this.seen),d.solids.choose(this.seen,i,u),t.render(d.scene,i),!((d.arrows.hidden||!d.arrows.shown.size)&&!d.flanks.over)&&(t.clearDepth(),t.render(d.over,i))}),this.drawn++}setLights(){let e=new I(-.45,.7,.9).applyQuaternion(this.camera.quaternion),t=new I(0,1,0).applyQuaternion(this.camera.quaternion);for(let i of this.pictures)for(let r of i.lights)r.light.position.copy(e),r.sky.position.copy(t)}hit(e,t){let i=this.canvas.getBoundingClientRect(),r=i.width/this.pictures.length,s=Math.floor((e-i.left)/r),o=this.pictures[s];if(!o)return null;let a=new Ke((e-i.left-s*r)/r*2-1,1-(t-i.top)/i.height*2),l=new Ja;l.setFromCamera(a,this.camera);let c=o.solids.hit(l);return c&&{...c,picture:s}}onScreen(e,t=0){let i=e.clone().applyMatrix4(this.seen).project(this.camera),r=this.size.width/this.pictures.length;return{x:(t+(i.x+1)/2)*r,y:(1-i.y)/2*this.size.height,front:i.z<1}}};function Lv(n){let{canvas:e}=n.stage,t=()=>{e.style.touchAction=n.fills||document.activeElement===e?"none":"pan-y"};for(let i of["focus","blur","pointerenter"])e.addEventListener(i,t);window.addEventListener("resize",t),t()}var Bu=1e6,Yh=class{constructor(e,t,i){this.player=e,this.marks=[...t].sort((r,s)=>r.time-s.time),this.kinds=[...new Set(this.marks.map(r=>r.kind))],this.does=i,this.stepLength=1/0;for(let r=1;r<e.times.length;r++)this.stepLength=Math.min(this.stepLength,e.times[r]-e.times[r-1]||1/0);Number.isFinite(this.stepLength)||(this.stepLength=1),this.play=Tt("","Play (space)",i.toggle,{className:"ppv-play"}),this.range=J("input",{type:"range",min:"0",max:String(Bu),step:"1",className:"ppv-range",title:"Time","aria-label":"Time"}),this.range.addEventListener("input",()=>i.seek(this.#e(Number(this.range.value)/Bu))),this.strip=J("canvas",{className:"ppv-marks",role:"img","aria-label":`${this.marks.length} marks`}),this.tip=J("div",{className:"ppv-tip",hidden:!0}),this.strip.addEventListener("pointermove",r=>this.#n(r)),this.strip.addEventListener("pointerleave",()=>this.tip.hidden=!0),this.strip.addEventListener("click",r=>{let s=this.#i(r);i.seek(s?s.time:this.#e(this.#t(r)))}),this.read=J("output",{className:"ppv-now",title:"Time of the record"}),this.speed=_r({label:"",title:"Speed, part of real time (+ and \u2212)",least:pl,most:1,value:e.speed,show:Rx,changed:i.speed}),this.loop=rn("repeat",[["record","whole record"],["turn","one turn"],["cycle","one mesh cycle"]],r=>{let s=i.loop(r);this.loop.select.value=e.loop,this.say(s)}),this.said=J("span",{className:"ppv-said",role:"status"}),this.jump=this.marks.length?[Tt("\u27E8","Mark before ([)",()=>this.toMark(-1)),Tt("\u27E9","Next mark (])",()=>this.toMark(1))]:[],this.element=J("div",{className:"ppv-time"},J("div",{className:"ppv-track"},this.strip,this.range,this.tip),J("div",{className:"ppv-transport"},this.play,Tt("|\u25C2","To the start (Home)",()=>i.seek(e.window[0])),Tt("\u25C2","One frame back (left arrow)",()=>i.step(-1)),Tt("\u25B8","One frame on (right arrow)",()=>i.step(1)),...this.jump,this.read,this.speed.row,this.loop.row,this.said)),e.times.length<2&&this.element.classList.add("ppv-still")}#e(e){return this.player.first+e*(this.player.last-this.player.first)}#t(e){let t=this.strip.getBoundingClientRect();return Math.max(0,Math.min(1,(e.clientX-t.left)/t.width))}#i(e){let t=this.strip.getBoundingClientRect(),i=this.#e(this.#t(e)),r=6*(this.player.last-this.player.first)/Math.max(t.width,1),s=null;for(let o of this.marks)Math.abs(o.time-i)<=r&&(!s||Math.abs(o.time-i)<Math.abs(s.time-i))&&(s=o);return s}#n(e){let t=this.#i(e);if(this.tip.hidden=!t,this.strip.style.cursor="pointer",!t)return;this.tip.textContent=`${gl(t.kind)}${t.what?`, ${t.what}`:""}, ${Ms(t.time,this.stepLength/10)}`;let i=this.strip.getBoundingClientRect(),r=e.clientX-i.left;this.tip.style.left=`${Math.max(0,Math.min(i.width-180,r))}px`}say(e){this.said.textContent=e}toMark(e){let t=this.player.time,i=1e-9*(this.player.last-this.player.first),r=e>0?this.marks.find(s=>s.time>t+i):this.marks.findLast(s=>s.time<t-i);r&&this.does.seek(r.time)}draw(){let{strip:e,player:t}=this,i=e.clientWidth,r=e.clientHeight;if(!i)return;let s=window.devicePixelRatio||1;e.width=i*s,e.height=r*s;let o=e.getContext("2d");o.scale(s,s);let a=t.last-t.first||1,l=h=>(h-t.first)/a*i,c=getComputedStyle(this.element);t.loop!=="record"&&(o.fillStyle=c.getPropertyValue("--v-accent"),o.globalAlpha=.35,o.fillRect(l(t.window[0]),r-4,Math.max(2,l(t.window[1])-l(t.window[0])),4),o.globalAlpha=1);for(let h of this.marks)o.fillStyle=vs(this.kinds,h.kind),o.globalAlpha=.3,h.until>h.time&&o.fillRect(l(h.time),3,l(h.until)-l(h.time),r-9),o.globalAlpha=1,o.fillRect(l(h.time)-.75,1,1.5,r-5)}update(){let{player:e}=this,t=e.last-e.first,i=t>0?(e.time-e.first)/t:0;this.range.value=String(Math.round(i*Bu));let r=Ms(e.time,e.playing?this.stepLength:this.stepLength/10);this.range.ariaValueText=r,this.read.textContent=r,this.read.title=`Time of the record; it lasts ${No(t)}`;let s=e.playing?"pause":"play";this.play.dataset.state!==s&&(this.play.dataset.state=s,this.play.textContent=e.playing?"\u275A\u275A":"\u25B6\uFE0E",this.play.title=e.playing?"Pause (space)":"Play (space)",this.play.setAttribute("aria-label",this.play.title))}};var $h=class{constructor(e,t,i=()=>[]){this.stage=e,this.orbit=t,this.legends=i,this.body=-1,this.turning=!1,this.anchor=new Le}get poses(){return this.stage.pictures[0].poses}directions(){let e=this.poses.axis().transformDirection(this.stage.seen),t=this.orbit.up,i=new I().crossVectors(t,e);i.length()<.001&&i.crossVectors(new I(1,0,0),e),i.length()<.001&&i.crossVectors(new I(0,0,1),e),i.normalize();let r=new I().crossVectors(e,i),s=Math.abs(e.dot(t))>.9,[o,a,l]=s?[.55*Math.sign(e.dot(t)),1,.7]:[1,.75,.55];return{axis:e,front:i,top:s?e:r,iso:e.clone().multiplyScalar(o).addScaledVector(i,a).addScaledVector(r,l)}}distanceFor(e){let{camera:t}=this.stage,i=Math.atan(Math.tan(t.fov*Math.PI/360)*Math.min(1,t.aspect));return e/Math.sin(i)}#e(e){this.stage.shift=this.orbit.shift=e/2}fit(e=!1){let{seen:t,pictures:i}=this.stage,r=i.flatMap(h=>[...h.bounds.outline,...h.arrows.ends()].map(f=>f.clone().applyMatrix4(t))),s=this.legends()??[],[o,a]=["share","drop"].map(h=>Math.max(0,...s.map(f=>f[h]))),l=0,c=this.#t(r,l);o&&r.some(h=>c.under(h,o,a))&&(c=this.#t(r,l=o)),this.#e(l),this.orbit.look({target:c.target,distance:c.distance},e),this.orbit.chosen=!1}#t(e,t){let{centre:i,radius:r}=this.stage.bounds(),{camera:s}=this.stage,o=this.orbit.direction(this.orbit.goal),a=new I().crossVectors(this.orbit.up,o).normalize(),l=new I().crossVectors(o,a),c=.9*Math.tan(s.fov*Math.PI/360),h=c*s.aspect*(1-t),f=i.clone(),u=this.distanceFor(r);for(let g=0;e.length&&g<3;g++){let M=[1/0,-1/0,1/0,-1/0],p=0;for(let m of e){let _=m.clone().sub(f),[w,S,R]=[_.dot(a),_.dot(l),_.dot(o)],A=Math.max(u-R,.001*r);M[0]=Math.min(M[0],w/A),M[1]=Math.max(M[1],w/A),M[2]=Math.min(M[2],S/A),M[3]=Math.max(M[3],S/A),p=Math.max(p,R+Math.abs(w)/h,R+Math.abs(S)/c)}if(g===2){u=p;break}f.addScaledVector(a,u*(M[0]+M[1])/2),f.addScaledVector(l,u*(M[2]+M[3])/2)}return u=Math.max(u,.1*r),{target:f,distance:u,under:(g,M,p)=>{let m=g.clone().sub(f),_=c/.9*(u-m.dot(o));return m.dot(a)>_*s.aspect*(1-2*M)&&m.dot(l)>_*(1-2*p)}}}named(e,t=!1){let i=this.directions();e==="top"&&this.orbit.look({direction:i.front}),this.orbit.look({direction:i[e]},t),this.fit(t)}follow(e,t=this.turning){if(this.body=e,this.turning=t,e<0){let i=this.orbit.goal.target.clone().applyMatrix4(this.stage.seen.clone().invert());this.stage.seen.identity(),this.anchor.identity(),this.orbit.look({target:i},!0);return}this.anchor.multiplyMatrices(this.stage.seen,this.#i()),this.orbit.changed()}#i(){let e=this.poses.world[this.body];return this.turning?e.clone():new Le().setPosition(new I().setFromMatrixPosition(e))}update(){this.body>=0&&this.stage.seen.multiplyMatrices(this.anchor,this.#i().invert())}look(e,t,i){let r=i/(2*Math.tan(this.stage.camera.fov*Math.PI/360));this.#e(0),this.orbit.look({target:new I(...e),direction:t&&new I(...t),distance:r},!0)}closeUp(){if(this.body<0)return;let{solids:e}=this.stage.pictures[0],t=new I().setFromMatrixPosition(this.poses.world[this.body]).applyMatrix4(this.stage.seen),i=e.reachOf(this.body);this.orbit.look({target:t,distance:i>0?this.distanceFor(1.15*i):void 0})}#n(e,{solids:t,poses:i}){let r=null;for(let s of t.parts){if(!s.solid.teeth)continue;let o=i.ofSolid(s.solid),a=new I().setFromMatrixColumn(o,2),l=e.clone().sub(new I().setFromMatrixPosition(o)),c=l.addScaledVector(a,-l.dot(a)).length(),h=Math.abs(s.rim-c)/s.rim;(!r||h<r.off)&&(r={off:h,axis:a,pitch:2*Math.PI*c/s.solid.teeth})}return r}intoMesh(e){let t=this.stage.pictures.find(({data:h})=>h.arrows.includes(e)),{poses:i,arrows:r,data:s}=t,o=r.forces()[s.arrows.indexOf(e)],a=this.#n(o.at,t),l=a?a.axis:i.axis(),c=a?a.pitch:.1*this.stage.bounds().radius;return this.orbit.look({target:o.at.clone().applyMatrix4(this.stage.seen),direction:l.clone().transformDirection(this.stage.seen),distance:1.6*c/(2*Math.tan(this.stage.camera.fov*Math.PI/360))}),{point:o.at,axis:l}}};var pE="This browser or machine offers no WebGL 2, so the solids cannot be drawn; curves and time work.",Kh=class{constructor(e,t){this.root=e,this.scenes=t,this.last=0,this.waiting=0,this.stage=null;let i=gE(t);this.poses=new Xo(t[0]),this.player=new Mh(i,this.poses);let r=mE(t),s=[this.player.first,this.player.last];this.curves=new _h(t,s,r,c=>this.seek(c)),this.transport=new Yh(this.player,r,{seek:c=>this.seek(c),toggle:()=>this.toggle(),step:c=>this.step(c),speed:c=>this.player.speed=c,loop:c=>this.loop(c)}),this.panels=new Ph,this.host=J("div",{className:"ppv-view"}),this.area=J("div",{className:"ppv-scene"},this.host,this.panels.panel);let o=[...new Set(t.map(c=>c.title))].join(" and "),a=t.length>1?"":t[0].subtitle,l=J("div",{className:"ppv-head"},J("div",{className:"ppv-title",title:`${o} ${a}`},J("b",{},o),J("span",{},a)),this.panels.bar);e.replaceChildren(l,this.area,this.transport.element,this.curves.element),this.#t(),this.#i(),hv(this),this.watch=new ResizeObserver(()=>this.resize()),this.watch.observe(e),this.watch.observe(this.curves.body),window.addEventListener("beforeprint",()=>this.draw()),this.dark=window.matchMedia("(prefers-color-scheme: dark)"),this.dark.addEventListener("change",()=>this.colours()),this.resize(),this.curves.build(),this.colours()}#e(e){this.area.append(J("div",{className:"ppv-message",role:"alert"},J("p",{},e)))}#t(){if(!this.scenes.some(o=>o.solids.length)){this.#e("This scene holds no solids: the model gives no shapes, or the result none that moves.");return}let e=Pv();if(!e){this.#e(pE);return}this.stage=new qh(this.host,this.scenes,e.software);let{stage:t}=this;t.canvas.tabIndex=0,t.canvas.setAttribute("aria-label","3-D scene: drag to turn, right button to shift, wheel to zoom"),t.canvas.addEventListener("webglcontextlost",()=>this.#e("The graphics card gave the scene up. Load the page again.")),this.orbit=new Th(t.camera,t.canvas,()=>this.changed(),this.scenes[0].up),this.orbit.takesWheel=o=>{let a=this.fills||o.ctrlKey||document.activeElement===t.canvas;return a||this.#l("click the scene first, then the wheel zooms"),a},Lv(this),this.orbit.pictures=t.pictures.length;let{radius:i}=t.bounds();this.orbit.nearest=2e-5*i,this.orbit.farthest=40*i,this.views=new $h(t,this.orbit,()=>this.legends),this.hover=new vh(t,this.orbit,o=>this.follow(o)),this.legends=t.pictures.map(({arrows:o})=>new Sh(o.arrows)),this.boxes=t.pictures.map(({flanks:o})=>new Kc(o)),this.scale=J("div",{className:"ppv-scale","aria-hidden":"true"},J("span"),J("i")),this.status=J("div",{className:"ppv-status",role:"status"});let r=yh(this.scenes);this.names=r.map((o,a)=>o&&J("span",{className:"ppv-name",title:this.scenes[a].label},o));let s=this.legends.map((o,a)=>J("div",{className:"ppv-half"},o.element,this.boxes[a].element,this.names[a]));this.host.append(J("div",{className:"ppv-halves"},...s),this.hover.label,this.scale,this.status)}#i(){let{panels:e,stage:t}=this;if(t){e.action("Fit","Show all of it (f)",()=>this.views.fit()),e.add("View","Views, following a body, housing, meshes",_v(this)),this.scenes.some(o=>o.arrows.length)&&e.add("Forces","Arrows of forces",vv(this)),this.scenes.some(o=>o.contacts.length)&&e.add("Flanks","Contact lines, pattern and gap of the teeth",Dx(this)),this.player.times.length>1&&e.add("Vibration","Magnify vibrations",Sv(this)),this.section=new Ih(t,()=>this.changed()),e.add("Section","Cut the solids by a plane",this.section.rows);let{modes:s}=this.scenes[0];s.length&&!this.scenes[1]&&(this.modes=new bh(s,t,()=>this.changed()),e.add("Modes","Mode shapes",this.modes.rows)),e.add("Save","Picture, solids, film",Mv(this))}this.transport.marks.length&&e.add("Marks","Instants worth looking at",fv(this));let i=[...new Set(this.scenes.flatMap(s=>s.notes))],r=[J("dl",{},...cv.flatMap(([s,o])=>[J("dt",{},s),J("dd",{},o)]))];i.length&&r.unshift(J("ul",{className:"ppv-notes"},...i.map(s=>J("li",{},s)))),e.add(i.length?`Notes (${i.length})`:"?","Notes and keys",r)}colours(){this.stage?.background.set(getComputedStyle(this.area).backgroundColor),this.curves.build(),this.transport.draw(),this.changed()}resize(){if(!(!this.root.clientWidth||!this.root.clientHeight)){if(this.stage){let e=this.stage.size.width===1;this.stage.resize(),e&&this.draw();for(let t of this.legends)t.settle();e&&this.views.named("iso",!0),this.orbit.chosen||this.views.fit(!0),this.draw()}this.curves.resize(),this.transport.draw(),this.update()}}changed(){this.waiting||(this.waiting=requestAnimationFrame(e=>this.#n(e)))}#n(e){this.waiting=0;let t=this.player.playing||this.easing||this.modes?.active,i=t&&this.last?Math.min(.25,Math.max(0,(e-this.last)/1e3)):1/60;this.last=e,this.player.advance(i),this.modes?.advance(i),this.easing=this.orbit?.step(i)??!1,this.#r(i,t),this.update(),this.draw(),this.frames=(this.frames??0)+1,this.player.playing||this.easing||this.modes?.active?this.changed():this.last=0}#r(e,t){let i=this.player.playing||this.easing||this.modes?.active;t&&i&&(this.pace=.7*(this.pace??e)+.3*e),!this.filming&&this.stage?.coarsen(!!i&&this.pace>(this.stage.coarse?.03:.085))}update(){this.transport.update(),this.curves.cursor(this.player.time),this.#s()}#s(){this.player.time!==this.told&&(this.told=this.player.time,this.#o(),this.root.dispatchEvent(new CustomEvent("pp-time",{bubbles:!0,detail:this.told})))}#o(){if(this.scenes.length<2||!this.names)return;let e=yh(this.scenes);this.names.forEach((t,i)=>{let r=this.scenes[i].times?.data.at(-1),s=Tu(r,this.told)?`ended at ${No(r)}: ${e[i]}`:e[i];t&&t.textContent!==s&&(t.textContent=s)})}draw(){let{stage:e,orbit:t}=this;if(!(!e||e.size.width===1)){for(let i of e.pictures)this.modes?.active?this.modes.pose(i):i.poses.at(this.player.time);this.modes?.active||this.views.update(),this.section?.update();for(let i of e.pictures)i.solids.update(.25*t.pixel),i.arrows.hidden=i.flanks.hidden=!!this.modes?.active,i.flanks.look(),i.flanks.update(t.pixel),i.arrows.update(t.pixel);e.render(t),e.pictures.forEach(({arrows:i},r)=>this.legends[r].update(i.now,i.shown,i.hidden));for(let i of this.boxes)i.update();this.#a()}}#a(){let e=ml(90*this.orbit.pixel),[t,i]=this.scale.children;t.textContent=Ax(e),i.style.width=`${e/this.orbit.pixel}px`;let r=this.views.body,s=r>=0?`following ${this.scenes[0].bodies[r].name}`:"",o=this.stage.pictures[0].poses.magnification>1?`vibrations \xD7 ${this.magnification.row.lastChild.textContent}`:"";this.status.textContent=[s,o,this.modes?.words].filter(Boolean).join(" \xB7 ")}get fills(){return this.root.clientHeight>.8*window.innerHeight}#l(e){this.status.textContent=e,clearTimeout(this.hinted),this.hinted=setTimeout(()=>this.changed(),2500)}advance(e){this.player.advance(e),this.modes?.advance(e),this.update(),this.draw()}seek(e){this.player.seek(e),this.update(),this.changed()}toggle(e=!this.player.playing){this.player.playing=e&&this.player.last>this.player.first,this.transport.update(),this.changed()}step(e){this.player.step(e),this.update(),this.changed()}loop(e){let t=this.player.repeat(e,this.views?.body??-1,this.scenes[0].solids);return this.transport.loop.select.value=this.player.loop,this.transport.draw(),this.changed(),t}follow(e){e>=this.scenes[0].bodies.length||!this.stage||(this.views.follow(e),e>=0&&this.views.closeUp(),this.followed.select.value=String(e),this.changed())}magnify(e){for(let t of this.stage.pictures)t.poses.magnification=e;this.changed()}arrows(e,t){for(let{arrows:i}of this.stage.pictures)t?i.shown.add(e):i.shown.delete(e);this.kinds?.[e]&&(this.kinds[e].input.checked=t),this.changed()}intoMesh(e){let{point:t,axis:i}=this.views.intoMesh(e);this.section.through(t,i)}};function mE(n){let e=yh(n);return n.flatMap((t,i)=>t.marks.map(r=>({...r,what:[r.what,e[i]].filter(Boolean).join(", ")})))}function gE(n){let e=n.map(t=>t.times?.data??[]);return e.length===1?e[0]:Float64Array.from(new Set(e.flatMap(t=>[...t]))).sort()}function Dv(n,e,{shape:t,differences:i,across:r}){let s=new Float64Array(e);for(let c=0,h=1;c<n.length;c+=e,h*=256)for(let f=0;f<e;f++)s[f]+=h*n[c+f];for(let c=0;c<e;c++)s[c]=s[c]%2?-(s[c]+1)/2:s[c]/2;let o=r?t[t.length-1]:t[0];for(let c=0;o&&c<e;c+=o)xE(s,c,c+o,i);if(r)return s;let a=o?e/o:0,l=new Float64Array(e);for(let c=0;c<a;c++)for(let h=0;h<o;h++)l[h*a+c]=s[c*o+h];return l}function xE(n,e,t,i){if(i===0)for(let r=e+1;r<t;r++)n[r]+=n[e];if(i===2)for(let r=e+2;r<t;r++)n[r]+=n[r-1];if(i>0)for(let r=e+1;r<t;r++)n[r]+=n[r-1]}function Nv(n,e,t,i){let r=i.length,s=new Float64Array(e*r);for(let o=0;o<e;o++)for(let a=0;a<r;a++){let l=i[a];for(let c=0;c<t.length;c++)l+=t[c][a]*n[o*t.length+c];s[o*r+a]=l}return s}function Iv(n){for(let e of n.channels){if(!e.curve)continue;let[t,i]=e.curve,[r,s]=e.from,{times:o,least:a,span:l}=n.curves[t],c=u=>({data:Float64Array.from({length:a.count},(g,M)=>r+s*u(M)),shape:[a.count],width:1,count:a.count}),h=(u,d)=>u.data[d*u.width+i];e.times=o,e.least=c(u=>h(a,u)),l&&e.least.data.some((u,d)=>h(l,d)!==0)&&(e.most=c(u=>h(a,u)+h(l,u)))}}var Uv="pitchpoint-scene-1",_E={f8:Float64Array,f4:Float32Array,i4:Int32Array,u4:Uint32Array,i2:Int16Array,u2:Uint16Array,u1:Uint8Array},hn=class extends Error{};function vE(n){let e;try{e=atob(n.trim())}catch{throw new hn("The numbers of this scene cannot be read: they are not base64. The file may be damaged.")}let t=new Uint8Array(e.length);for(let i=0;i<t.length;i++)t[i]=e.charCodeAt(i);return t}async function ME(n){if(typeof DecompressionStream>"u")throw new hn("This browser cannot unpack the numbers of the scene (no DecompressionStream); a newer one can.");try{let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip"));return await new Response(e).arrayBuffer()}catch{throw new hn("The numbers of this scene cannot be unpacked: the file is truncated or damaged.")}}function SE(n,e,t){let i=e?.type==="planes",r=i?Uint8Array:_E[e?.type],s=e?.shape;if(!r||!Array.isArray(s)||!s.length||s.some(w=>!Number.isInteger(w)||w<0))throw new hn(`This scene cannot be read: ${t} has no type or shape that this viewer knows.`);let o=s.reduce((w,S)=>w*S,1),a=e.at,l=i?o*e.bytes:o;if(!Number.isInteger(a)||a<0||a%8||!(a+l*r.BYTES_PER_ELEMENT<=n.byteLength))throw new hn(`This scene is truncated: ${t} lies beyond the end of the numbers.`);let c=new r(n,a,l),h=i?Dv(c,o,e):c,f=s[s.length-1],u=s.length>1?o/Math.max(s[0],1):1,d=s[0];if(!e.scale&&!e.offset)return{data:h,shape:s,width:u,count:d};let g=s.length>1?f:1,M=e.scale??Array(g).fill(1),p=!e.mix&&e.offset||Array(g).fill(0),m=new Float64Array(o);for(let w=0;w<o;w++)m[w]=p[w%g]+M[w%g]*h[w];if(e.exponent&&m.forEach((w,S)=>m[S]=Math.exp(w)),!e.mix)return{data:m,shape:s,width:u,count:d};let _=e.offset.length;return{data:Nv(m,d,e.mix,e.offset),shape:[d,_],width:_,count:d}}function ku(n,e,t,i=new Map){if(Array.isArray(n))return n.map((s,o)=>ku(s,e,s?.name?`${t} ${s.name}`:`${t} ${o+1}`,i));if(n===null||typeof n!="object")return n;if("at"in n&&"type"in n&&"shape"in n){let s=JSON.stringify(n);return i.has(s)||i.set(s,SE(e,n,t)),i.get(s)}let r={};for(let[s,o]of Object.entries(n))r[s]=ku(o,e,`${s} of ${t}`,i);return r}function di(n,e){if(!n)throw new hn(`This scene cannot be read: ${e}.`)}function yE(n){let e=n.times?.count??0,t=(i,r)=>di(!i||i.count===e||i.count===1,`${r} has ${i?.count} rows for ${e} times`);for(let{channel:i,lines:r,times:s,levels:o}of n.maps)di(r?.count>1&&s?.count>1&&o?.data.length===r.count*s.count,`the map of ${i} has ${o?.data.length} levels for ${r?.count} lines at ${s?.count} times`);n.bodies.forEach((i,r)=>{di(Number.isInteger(i.parent??-1)&&(i.parent??-1)<r,`body ${i.name} comes before its parent`);for(let s of["position","travel","turn","spin","gross","quaternion"])t(i[s],`${s} of body ${i.name}`)});for(let i of n.solids){di(i.body>=-1&&i.body<n.bodies.length,`solid ${i.name} belongs to no body`);let r=i.pieces?i.pieces.flatMap(s=>s.levels??[]):[i];di(r.length,`solid ${i.name} has no surface`);for(let{points:s,triangles:o}of r){di(s?.width===3&&o?.width===3,`solid ${i.name} has no surface`);for(let a of o.data)di(a<s.count,`solid ${i.name} has a triangle without a point`)}for(let s of i.pieces??[])di(s.turns?.count,`solid ${i.name} stands nowhere`);if(i.sway){let{shapes:s,node:o,coordinates:a}=i.sway;di(s?.shape.length===3&&o?.count===i.points?.count,`solid ${i.name} does not say how it bends`);for(let l of o.data)di(l<s.shape[1],`solid ${i.name} has a point without a node`);t(a,`the modal coordinates of ${i.name}`)}for(let s of i.between?.bodies??[])di(s>=-1&&s<n.bodies.length,`solid ${i.name} ends on a body that is not there`);for(let s of i.skin?.bodies??[])di(s>=-1&&s<n.bodies.length,`the skin of ${i.name} names a body that is not there`)}for(let i of n.arrows){di(i.body>=-1&&i.body<n.bodies.length,`arrow ${i.name} belongs to no body`);for(let r of["circumferential","radial","axial"])t(i.components?.[r],`the ${r} force ${i.name}`);t(i.at,`the place of arrow ${i.name}`),t(i.state,`the state of arrow ${i.name}`)}for(let i of n.contacts)bE(n,i,t);for(let i of n.channels){let r=i.least?.count;di(i.times&&r&&i.times.count===r&&(i.most?.count??r)===r,`channel ${i.name} has times and values of different length`)}}function bE(n,e,t){let{name:i}=e;for(let r of["at","axes","pressure_angle","penetration"])di(e[r],`contact ${i} has no ${r}`),t(e[r],`${r} of contact ${i}`);di(e.width?.length===2&&e.path?.length===2,`contact ${i} has no place`),di(!e.unit_pressure||e.unit_pressure.count>1,`contact ${i} has no pressures`),di(e.base_pitch>0&&e.flanks?.length,`contact ${i} has no flanks`);for(let r of e.flanks){di(r.travel?.count===n.times.count,`contact ${i} has no travel for each time`);for(let s of["forces","loads"])t(r[s],`${s} of contact ${i}`);di(!!r.forces==!!r.loads,`contact ${i} has forces or loads alone`);for(let s of r.surfaces??[])di(s.body in n.bodies&&s.points?.shape.length===3&&s.teeth>0,`a flank of contact ${i} is on no body`)}}async function zu(n=""){let e=document.getElementById(`pp-scene${n}`),t=document.getElementById(`pp-scene-numbers${n}`);if(!e||!t)throw new hn("This page holds no scene.");let i;try{i=JSON.parse(e.textContent??"")}catch{throw new hn("The header of this scene cannot be read: the file is truncated or damaged.")}if(i?.format!==Uv)throw new hn(`This scene is of the format "${i?.format}"; this viewer reads "${Uv}".`);let r=await ME(vE(t.textContent??"")),o={title:"",subtitle:"",up:[0,1,0],...{bodies:[],solids:[],arrows:[],contacts:[],channels:[],spectra:[],maps:[],marks:[],modes:[],notes:[]},...ku(i,r,"this scene")};return Iv(o),yE(o),o}function Fv(n){let{player:e,stage:t,curves:i}=n,r=s=>[s.x,s.y,s.z];return{time:e.time,playing:e.playing,frame:e.frame,speed:e.speed,loop:e.loop,window:[...e.window],channels:[...i.plots.names],cursor:i.plots.drawn.map(({plot:s,line:o})=>({at:o.hidden?null:s.posToVal(new DOMMatrix(getComputedStyle(o).transform).m41,"x"),readings:[...o.closest(".ppv-plot").querySelectorAll("output")].map(a=>a.textContent)})),spectrum:i.spectra.state(),marks:n.transport.marks.length,message:n.area.querySelector(".ppv-message")?.textContent??null,drawn:t?.drawn??0,ratio:t?.ratio??0,section:n.section?{on:n.section.on,normal:r(n.section.normal),at:n.section.at}:null,mode:n.modes?.number??-1,following:n.views?.body??-1,camera:n.orbit?{position:r(t.camera.position),target:r(n.orbit.now.target),distance:n.orbit.now.distance,near:t.camera.near,far:t.camera.far}:null,pictures:(t?.pictures??[]).map(s=>({bodies:s.poses.world.map(o=>[...o.elements]),seen:[...t.seen.elements],magnification:s.poses.magnification,triangles:s.solids.triangles,drawnTriangles:s.solids.drawn,crowds:s.solids.crowds.length,contacts:s.flanks.state(),arrows:(s.arrows.now??[]).map((o,a)=>({name:o.name,kind:o.kind,state:o.state,at:r(o.at),vectors:Object.fromEntries(Object.entries(o.vectors).map(([l,c])=>[l,r(c)])),lengths:Object.fromEntries(Object.entries(s.arrows.drawn[a].parts).map(([l,c])=>[l,c.visible?new I().setFromMatrixColumn(c.matrix,2).length():0]))}))}))}}var ur=null;async function wE(n,{compare:e=!1}={}){document.getElementById("ppv-style")||document.head.append(J("style",{id:"ppv-style"},od+ad));let t=J("div",{className:"ppv"}),i=J("p",{},"Reading the scene \u2026");t.append(J("div",{className:"ppv-message",role:"status"},i)),n.replaceChildren(t);try{let r=[await zu()];return e&&r.push(await zu("-2")),ur=new Kh(t,r),t.dataset.ready="scene",!0}catch(r){return i.textContent=r instanceof hn?r.message:`The viewer failed: ${r instanceof Error?r.message:r}.`,t.replaceChildren(J("div",{className:"ppv-message",role:"alert"},i)),t.dataset.ready="failed",r instanceof hn||console.error(r),!1}}var ii=()=>{if(!ur)throw new Error("no scene is shown");return ur};function Ov(n){ur?.stage&&ur.stage.background.set(n?"#ffffff":getComputedStyle(ur.area).backgroundColor),ur&&!n&&ur.draw()}window.addEventListener("beforeprint",()=>Ov(!0));window.addEventListener("afterprint",()=>Ov(!1));window.pitchpointViewer={mount:wE,state:()=>ur?Fv(ur):null,seek:n=>ii().seek(n),play:()=>ii().toggle(!0),pause:()=>ii().toggle(!1),step:n=>ii().step(n),repeat:n=>ii().loop(n),advance:n=>ii().advance(n),follow:n=>ii().follow(n),look:(n,e,t)=>ii().views?.look(n,e,t),view:n=>ii().views?.named(n,!0),show:(n,e=!0)=>ii().curves.plots.show(n,e),spectrum:(n,e)=>ii().curves.spectrum(n,e),magnify:n=>ii().magnify(n),arrows:(n,e=!0)=>ii().arrows(n,e),lines:(n=!0)=>Io(ii(),e=>e.showsLines=n),pattern:n=>Io(ii(),e=>e.mode=n),shade:n=>Io(ii(),e=>e.shade=e.pressures?n:"load"),gauge:(n,e)=>Zc(ii(),n,e),mode:n=>ii().modes.choose(n),file:(n,e=1)=>n==="png"?Ah(ii(),e):n==="glb"?Ch(ii()):Rh(ii()),draw:()=>{ii().orbit?.settle(),ii().draw()}};})();
