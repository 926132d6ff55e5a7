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
(()=>{var cd='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var hd=`.ppv { --v-paper: var(--pp-paper, #fff); --v-ink: var(--pp-ink, #1f2933); --v-soft: var(--pp-soft, #5b6672); --v-grid: var(--pp-grid, #e3e7ec);
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
@container (max-width: 300px) { .ppv-flanks { bottom: 54px; font-size: 10px; } .ppv-half .ppv-name { left: 8px; right: 8px; bottom: 3px; max-width: none; font-size: 11px; justify-content: flex-end; } .ppv-half:has(.ppv-name) .ppv-scale { bottom: 22px; } }
/* of two results, the names are at the lower edges */
.ppv-view:has(.ppv-half + .ppv-half) .ppv-status { bottom: 28px; }
.ppv-half + .ppv-half { border-left: 1px solid var(--v-grid); }
.ppv-name { position: absolute; right: 12px; bottom: 8px; max-width: 60%; font-weight: 600; display: flex; white-space: pre; }
.ppv-name span:first-child { overflow: hidden; text-overflow: ellipsis; }
.ppv-name span:last-child { flex: none; }
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
.ppv-status { color: var(--v-soft); font-size: 12px; }
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
.ppv-modes button { text-align: left; display: flex; flex-direction: column; flex: none; white-space: normal; padding: 4px 8px; }
.ppv-modes button + button { border-top-color: var(--v-grid); border-radius: 0 0 5px 5px; }
.ppv-modes span:first-child { font-weight: 600; font-variant-numeric: tabular-nums; }
.ppv-modes span:last-child { font-size: 12px; overflow-wrap: anywhere; opacity: .8; }
@media (max-width: 640px) {
  .ppv-caption { padding-right: 8px; }
  .ppv-curve { white-space: normal; }
  .ppv-curve :is(output, small, button) { flex: none; white-space: nowrap; }
  .ppv-bar { position: static; }
  .ppv-now { min-width: 6em; }
  .ppv-legend { font-size: 11px; max-height: 45%; }
  .ppv-head { padding: 3px 6px 3px 8px; }
  .ppv-title { flex-basis: 100%; }
  .ppv-tools button { padding: 4px 6px; }
  .ppv-panel { max-height: 78%; }
  .ppv-panel:has(.ppv-modes) { max-height: max(230px, 56%); }
  .ppv-transport .ppv-slider input { width: 84px; }
  .ppv-transport .ppv-slider output { min-width: 0; }
  .ppv-transport .ppv-choice span { display: none; }
  .ppv-status { max-width: 50%; overflow: hidden; text-overflow: ellipsis; }
}
@media print { .ppv-tools, .ppv-time, .ppv-bar { display: none; } }
`;function J(n,e={},...t){let i=document.createElement(n);for(let[r,s]of Object.entries(e))s==null||s===!1||(r.startsWith("on")?i.addEventListener(r.slice(2),s):r in i&&r!=="list"&&typeof s!="string"?i[r]=s:i.setAttribute(r==="className"?"class":r,s===!0?"":String(s)));return i.append(...t.filter(r=>r!=null)),i}function Tt(n,e,t,i={}){return J("button",{type:"button",title:e,"aria-label":e,onclick:t,...i},n)}function _r({label:n,title:e,least:t,most:i,value:r,show:s,changed:o}){let a=Math.log(i/t),c=J("output",{},s(r)),l=J("input",{type:"range",min:"0",max:"1",step:"0.001",title:e,"aria-label":e}),h=()=>t*Math.exp(a*Number(l.value)),f=u=>{l.value=String(Math.log(u/t)/a),c.textContent=l.ariaValueText=s(u)};return l.addEventListener("input",()=>{let u=h();c.textContent=l.ariaValueText=s(u),o(u)}),f(r),{row:J("label",{className:"ppv-slider"},J("span",{},n),l,c),set:f,input:l}}function rn(n,e,t,i=n){let r=J("select",{title:i,"aria-label":i,onchange:()=>t(r.value)},...e.map(([s,o])=>J("option",{value:s},o)));return{row:J("label",{className:"ppv-choice"},J("span",{},n),r),select:r}}function tr(n,e,t,i=null){let r=J("input",{type:"checkbox",checked:e,onchange:()=>t(r.checked)});return{row:J("label",{className:"ppv-tick"},r,i,J("span",{},n)),input:r}}var fd=0,cf=1,ud=2;var Gs=1,dd=2,os=3,sn=0,jt=1,zi=2,ir=0,kr=1,hf=2,ff=3,uf=4,pd=5;var zr=100,md=101,gd=102,xd=103,_d=104,vd=200,Md=201,Sd=202,yd=203,Al=204,Rl=205,bd=206,wd=207,Ed=208,Td=209,Ad=210,Rd=211,Cd=212,Pd=213,Ld=214,ta=0,ia=1,na=2,Gr=3,ra=4,sa=5,oa=6,aa=7,Hs=0,Dd=1,Nd=2,mn=0,Cl=1,Pl=2,Ll=3,Dl=4,Nl=5,Il=6,Ul=7;var df=300,nr=301,Hr=302,Fl=303,Ol=304,la=1e3,on=1001,ca=1002,Kt=1003,Id=1004;var ha=1005;var Mi=1006,Bl=1007;var gn=1008;var fi=1009,kl=1010,zl=1011,vr=1012,Vs=1013,Ii=1014,ui=1015,Ui=1016,Ws=1017,Xs=1018,zn=1020,Gl=35902,Hl=35899,Vl=1021,Wl=1022,Fi=1023,an=1026,xn=1027,qs=1028,Ys=1029,_n=1030,$s=1031;var Ks=1033,Zs=33776,Js=33777,Qs=33778,js=33779,fa=35840,ua=35841,da=35842,pa=35843,ma=36196,ga=37492,xa=37496,_a=37488,va=37489,as=37490,Ma=37491,Sa=37808,ya=37809,ba=37810,wa=37811,Ea=37812,Ta=37813,Aa=37814,Ra=37815,Ca=37816,Pa=37817,La=37818,Da=37819,Na=37820,Ia=37821,Ua=36492,Fa=36494,Oa=36495,Ba=36283,ka=36284,ls=36285,za=36286;var Ud=3200;var Ga=0,Fd=1,Rn="",en="srgb",cs="srgb-linear",hs="linear",_t="srgb";var Xl=7680;var Od=519,Bd=512,kd=513,zd=514,ql=515,Gd=516,Hd=517,Yl=518,$l=519,Vd=35044,Wd=35048;var pf="300 es",Gi=2e3,Mr=2001;function qd(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function to(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Yd(){let n=to("canvas");return n.style.display="block",n}var Xd={},eo=null;function mf(...n){let e="THREE."+n.shift();eo?eo("log",e,...n):console.log(e,...n)}function $d(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ge(...n){n=$d(n);let e="THREE."+n.shift();if(eo)eo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function ut(...n){n=$d(n);let e="THREE."+n.shift();if(eo)eo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function fs(...n){let e=n.join(" ");e in Xd||(Xd[e]=!0,Ge(...n))}function Kd(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var Zd={[ta]:ta,[na]:oa,[ra]:ra,[Gr]:sa,[ia]:ia,[oa]:na,[aa]:aa,[sa]:Gr};var Wi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}};var Xi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Kl=Math.PI/180,Ha=180/Math.PI;function rr(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Xi[n&255]+Xi[n>>8&255]+Xi[n>>16&255]+Xi[n>>24&255]+"-"+Xi[e&255]+Xi[e>>8&255]+"-"+Xi[e>>16&15|64]+Xi[e>>24&255]+"-"+Xi[t&63|128]+Xi[t>>8&255]+"-"+Xi[t>>16&255]+Xi[t>>24&255]+Xi[i&255]+Xi[i>>8&255]+Xi[i>>16&255]+Xi[i>>24&255]).toLowerCase()}function ct(n,e,t){return Math.max(e,Math.min(t,n))}function Jd(n,e){return(n%e+e)%e}function Zl(n,e,t){return(1-t)*n+t*e}function Qd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Jl(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function jd(n,e){if(e.constructor===Float32Array)return n;let t=Jl(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function ep(n,e){if(e.constructor===Float32Array)return n;let t=Jl(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Ke=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};var Ft=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let c=i[r+0],l=i[r+1],h=i[r+2],f=i[r+3],u=s[o+0],p=s[o+1],g=s[o+2],M=s[o+3];if(f!==M||c!==u||l!==p||h!==g){let m=c*u+l*p+h*g+f*M;m<0&&(u=-u,p=-p,g=-g,M=-M,m=-m);let d=1-a;if(m<.9995){let x=Math.acos(m),w=Math.sin(x);d=Math.sin(d*x)/w,a=Math.sin(a*x)/w,c=c*d+u*a,l=l*d+p*a,h=h*d+g*a,f=f*d+M*a}else{c=c*d+u*a,l=l*d+p*a,h=h*d+g*a,f=f*d+M*a;let x=1/Math.sqrt(c*c+l*l+h*h+f*f);c*=x,l*=x,h*=x,f*=x}}e[t]=c,e[t+1]=l,e[t+2]=h,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],c=i[r+1],l=i[r+2],h=i[r+3],f=s[o],u=s[o+1],p=s[o+2],g=s[o+3];return e[t]=a*g+h*f+c*p-l*u,e[t+1]=c*g+h*u+l*f-a*p,e[t+2]=l*g+h*p+a*u-c*f,e[t+3]=h*g-a*f-c*u-l*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,c=Math.sin,l=a(i/2),h=a(r/2),f=a(s/2),u=c(i/2),p=c(r/2),g=c(s/2);switch(o){case"XYZ":this._x=u*h*f+l*p*g,this._y=l*p*f-u*h*g,this._z=l*h*g+u*p*f,this._w=l*h*f-u*p*g;break;case"YXZ":this._x=u*h*f+l*p*g,this._y=l*p*f-u*h*g,this._z=l*h*g-u*p*f,this._w=l*h*f+u*p*g;break;case"ZXY":this._x=u*h*f-l*p*g,this._y=l*p*f+u*h*g,this._z=l*h*g+u*p*f,this._w=l*h*f-u*p*g;break;case"ZYX":this._x=u*h*f-l*p*g,this._y=l*p*f+u*h*g,this._z=l*h*g-u*p*f,this._w=l*h*f+u*p*g;break;case"YZX":this._x=u*h*f+l*p*g,this._y=l*p*f+u*h*g,this._z=l*h*g-u*p*f,this._w=l*h*f-u*p*g;break;case"XZY":this._x=u*h*f-l*p*g,this._y=l*p*f-u*h*g,this._z=l*h*g+u*p*f,this._w=l*h*f+u*p*g;break;default:Ge("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],c=t[9],l=t[2],h=t[6],f=t[10],u=i+a+f;if(u>0){let p=.5/Math.sqrt(u+1);this._w=.25/p,this._x=(h-c)*p,this._y=(s-l)*p,this._z=(o-r)*p}else if(i>a&&i>f){let p=2*Math.sqrt(1+i-a-f);this._w=(h-c)/p,this._x=.25*p,this._y=(r+o)/p,this._z=(s+l)/p}else if(a>f){let p=2*Math.sqrt(1+a-i-f);this._w=(s-l)/p,this._x=(r+o)/p,this._y=.25*p,this._z=(c+h)/p}else{let p=2*Math.sqrt(1+f-i-a);this._w=(o-r)/p,this._x=(s+l)/p,this._y=(c+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,c=t._y,l=t._z,h=t._w;return this._x=i*h+o*a+r*l-s*c,this._y=r*h+o*c+s*a-i*l,this._z=s*h+o*l+i*c-r*a,this._w=o*h-i*a-r*c-s*l,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let c=1-t;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,t=Math.sin(t*l)/h,this._x=this._x*c+i*t,this._y=this._y*c+r*t,this._z=this._z*c+s*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+i*t,this._y=this._y*c+r*t,this._z=this._z*c+s*t,this._w=this._w*c+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}};var N=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(tp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(tp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,c=e.w,l=2*(o*r-a*i),h=2*(a*t-s*r),f=2*(s*i-o*t);return this.x=t+c*l+o*f-a*h,this.y=i+c*h+a*l-s*f,this.z=r+c*f+s*h-o*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,c=t.z;return this.x=r*c-s*a,this.y=s*o-i*c,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return gf.copy(this).projectOnVector(e),this.sub(gf)}reflect(e){return this.sub(gf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},gf=new N,tp=new Ft;var $e=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,c,l)}set(e,t,i,r,s,o,a,c,l){let h=this.elements;return h[0]=e,h[1]=r,h[2]=a,h[3]=t,h[4]=s,h[5]=c,h[6]=i,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],h=i[4],f=i[7],u=i[2],p=i[5],g=i[8],M=r[0],m=r[3],d=r[6],x=r[1],w=r[4],S=r[7],R=r[2],A=r[5],_=r[8];return s[0]=o*M+a*x+c*R,s[3]=o*m+a*w+c*A,s[6]=o*d+a*S+c*_,s[1]=l*M+h*x+f*R,s[4]=l*m+h*w+f*A,s[7]=l*d+h*S+f*_,s[2]=u*M+p*x+g*R,s[5]=u*m+p*w+g*A,s[8]=u*d+p*S+g*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8];return t*o*h-t*a*l-i*s*h+i*a*c+r*s*l-r*o*c}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],f=h*o-a*l,u=a*c-h*s,p=l*s-o*c,g=t*f+i*u+r*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/g;return e[0]=f*M,e[1]=(r*l-h*i)*M,e[2]=(a*i-r*o)*M,e[3]=u*M,e[4]=(h*t-r*c)*M,e[5]=(r*s-a*t)*M,e[6]=p*M,e[7]=(i*c-l*t)*M,e[8]=(o*t-i*s)*M,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let c=Math.cos(s),l=Math.sin(s);return this.set(i*c,i*l,-i*(c*o+l*a)+o+e,-r*l,r*c,-r*(-l*o+c*a)+a+t,0,0,1),this}scale(e,t){return fs("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(xf.makeScale(e,t)),this}rotate(e){return fs("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(xf.makeRotation(-e)),this}translate(e,t){return fs("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(xf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},xf=new $e;var ip=new $e().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),np=new $e().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function sM(){let n={enabled:!0,workingColorSpace:cs,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===_t&&(r.r=Gn(r.r),r.g=Gn(r.g),r.b=Gn(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===_t&&(r.r=us(r.r),r.g=us(r.g),r.b=us(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Rn?hs:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[cs]:{primaries:e,whitePoint:i,transfer:hs,toXYZ:ip,fromXYZ:np,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:en},outputColorSpaceConfig:{drawingBufferColorSpace:en}},[en]:{primaries:e,whitePoint:i,transfer:_t,toXYZ:ip,fromXYZ:np,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:en}}}),n}var ot=sM();function Gn(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function us(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var io,Ql=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{io===void 0&&(io=to("canvas")),io.width=e.width,io.height=e.height;let r=io.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=io}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=to("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Gn(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Gn(t[i]/255)*255):t[i]=Gn(t[i]);return{data:t,width:e.width,height:e.height}}else return Ge("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}};var oM=0,Vr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:oM++}),this.uuid=rr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(_f(r[o].image)):s.push(_f(r[o]))}else s=_f(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function _f(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ql.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ge("Texture: Unable to serialize Texture."),{})}var aM=0,vf=new N,di=class n extends Wi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=on,r=on,s=Mi,o=gn,a=Fi,c=fi,l=n.DEFAULT_ANISOTROPY,h=Rn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:aM++}),this.uuid=rr(),this.name="",this.source=new Vr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new $e,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(vf).x}get height(){return this.source.getSize(vf).y}get depth(){return this.source.getSize(vf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ge(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ge(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==df)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case la:e.x=e.x-Math.floor(e.x);break;case on:e.x=e.x<0?0:1;break;case ca:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case la:e.y=e.y-Math.floor(e.y);break;case on:e.y=e.y<0?0:1;break;case ca:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};di.DEFAULT_IMAGE=null;di.DEFAULT_MAPPING=df;di.DEFAULT_ANISOTROPY=1;var bt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,c=e.elements,l=c[0],h=c[4],f=c[8],u=c[1],p=c[5],g=c[9],M=c[2],m=c[6],d=c[10];if(Math.abs(h-u)<.01&&Math.abs(f-M)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(f+M)<.1&&Math.abs(g+m)<.1&&Math.abs(l+p+d-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let w=(l+1)/2,S=(p+1)/2,R=(d+1)/2,A=(h+u)/4,_=(f+M)/4,b=(g+m)/4;return w>S&&w>R?w<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(w),r=A/i,s=_/i):S>R?S<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(S),i=A/r,s=b/r):R<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(R),i=_/s,r=b/s),this.set(i,r,s,t),this}let x=Math.sqrt((m-g)*(m-g)+(f-M)*(f-M)+(u-h)*(u-h));return Math.abs(x)<.001&&(x=1),this.x=(m-g)/x,this.y=(f-M)/x,this.z=(u-h)/x,this.w=Math.acos((l+p+d-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};var jl=class extends Wi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Mi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new bt(0,0,e,t),this.scissorTest=!1,this.viewport=new bt(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new di({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Mi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Vr(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Hi=class extends jl{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}};var no=class extends di{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Kt,this.minFilter=Kt,this.wrapR=on,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ec=class extends di{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Kt,this.minFilter=Kt,this.wrapR=on,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Le=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,c,l,h,f,u,p,g,M,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,c,l,h,f,u,p,g,M,m)}set(e,t,i,r,s,o,a,c,l,h,f,u,p,g,M,m){let d=this.elements;return d[0]=e,d[4]=t,d[8]=i,d[12]=r,d[1]=s,d[5]=o,d[9]=a,d[13]=c,d[2]=l,d[6]=h,d[10]=f,d[14]=u,d[3]=p,d[7]=g,d[11]=M,d[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/ro.setFromMatrixColumn(e,0).length(),s=1/ro.setFromMatrixColumn(e,1).length(),o=1/ro.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(r),l=Math.sin(r),h=Math.cos(s),f=Math.sin(s);if(e.order==="XYZ"){let u=o*h,p=o*f,g=a*h,M=a*f;t[0]=c*h,t[4]=-c*f,t[8]=l,t[1]=p+g*l,t[5]=u-M*l,t[9]=-a*c,t[2]=M-u*l,t[6]=g+p*l,t[10]=o*c}else if(e.order==="YXZ"){let u=c*h,p=c*f,g=l*h,M=l*f;t[0]=u+M*a,t[4]=g*a-p,t[8]=o*l,t[1]=o*f,t[5]=o*h,t[9]=-a,t[2]=p*a-g,t[6]=M+u*a,t[10]=o*c}else if(e.order==="ZXY"){let u=c*h,p=c*f,g=l*h,M=l*f;t[0]=u-M*a,t[4]=-o*f,t[8]=g+p*a,t[1]=p+g*a,t[5]=o*h,t[9]=M-u*a,t[2]=-o*l,t[6]=a,t[10]=o*c}else if(e.order==="ZYX"){let u=o*h,p=o*f,g=a*h,M=a*f;t[0]=c*h,t[4]=g*l-p,t[8]=u*l+M,t[1]=c*f,t[5]=M*l+u,t[9]=p*l-g,t[2]=-l,t[6]=a*c,t[10]=o*c}else if(e.order==="YZX"){let u=o*c,p=o*l,g=a*c,M=a*l;t[0]=c*h,t[4]=M-u*f,t[8]=g*f+p,t[1]=f,t[5]=o*h,t[9]=-a*h,t[2]=-l*h,t[6]=p*f+g,t[10]=u-M*f}else if(e.order==="XZY"){let u=o*c,p=o*l,g=a*c,M=a*l;t[0]=c*h,t[4]=-f,t[8]=l*h,t[1]=u*f+M,t[5]=o*h,t[9]=p*f-g,t[2]=g*f-p,t[6]=a*h,t[10]=M*f+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(lM,e,cM)}lookAt(e,t,i){let r=this.elements;return vn.subVectors(e,t),vn.lengthSq()===0&&(vn.z=1),vn.normalize(),Wr.crossVectors(i,vn),Wr.lengthSq()===0&&(Math.abs(i.z)===1?vn.x+=1e-4:vn.z+=1e-4,vn.normalize(),Wr.crossVectors(i,vn)),Wr.normalize(),tc.crossVectors(vn,Wr),r[0]=Wr.x,r[4]=tc.x,r[8]=vn.x,r[1]=Wr.y,r[5]=tc.y,r[9]=vn.y,r[2]=Wr.z,r[6]=tc.z,r[10]=vn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],h=i[1],f=i[5],u=i[9],p=i[13],g=i[2],M=i[6],m=i[10],d=i[14],x=i[3],w=i[7],S=i[11],R=i[15],A=r[0],_=r[4],b=r[8],F=r[12],L=r[1],D=r[5],k=r[9],G=r[13],U=r[2],W=r[6],Y=r[10],V=r[14],ce=r[3],Z=r[7],j=r[11],re=r[15];return s[0]=o*A+a*L+c*U+l*ce,s[4]=o*_+a*D+c*W+l*Z,s[8]=o*b+a*k+c*Y+l*j,s[12]=o*F+a*G+c*V+l*re,s[1]=h*A+f*L+u*U+p*ce,s[5]=h*_+f*D+u*W+p*Z,s[9]=h*b+f*k+u*Y+p*j,s[13]=h*F+f*G+u*V+p*re,s[2]=g*A+M*L+m*U+d*ce,s[6]=g*_+M*D+m*W+d*Z,s[10]=g*b+M*k+m*Y+d*j,s[14]=g*F+M*G+m*V+d*re,s[3]=x*A+w*L+S*U+R*ce,s[7]=x*_+w*D+S*W+R*Z,s[11]=x*b+w*k+S*Y+R*j,s[15]=x*F+w*G+S*V+R*re,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],c=e[9],l=e[13],h=e[2],f=e[6],u=e[10],p=e[14],g=e[3],M=e[7],m=e[11],d=e[15],x=c*p-l*u,w=a*p-l*f,S=a*u-c*f,R=o*p-l*h,A=o*u-c*h,_=o*f-a*h;return t*(M*x-m*w+d*S)-i*(g*x-m*R+d*A)+r*(g*w-M*R+d*_)-s*(g*S-M*A+m*_)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],c=e[2],l=e[6],h=e[10];return t*(o*h-a*l)-i*(s*h-a*c)+r*(s*l-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],f=e[9],u=e[10],p=e[11],g=e[12],M=e[13],m=e[14],d=e[15],x=t*a-i*o,w=t*c-r*o,S=t*l-s*o,R=i*c-r*a,A=i*l-s*a,_=r*l-s*c,b=h*M-f*g,F=h*m-u*g,L=h*d-p*g,D=f*m-u*M,k=f*d-p*M,G=u*d-p*m,U=x*G-w*k+S*D+R*L-A*F+_*b;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/U;return e[0]=(a*G-c*k+l*D)*W,e[1]=(r*k-i*G-s*D)*W,e[2]=(M*_-m*A+d*R)*W,e[3]=(u*A-f*_-p*R)*W,e[4]=(c*L-o*G-l*F)*W,e[5]=(t*G-r*L+s*F)*W,e[6]=(m*S-g*_-d*w)*W,e[7]=(h*_-u*S+p*w)*W,e[8]=(o*k-a*L+l*b)*W,e[9]=(i*L-t*k-s*b)*W,e[10]=(g*A-M*S+d*x)*W,e[11]=(f*S-h*A-p*x)*W,e[12]=(a*F-o*D-c*b)*W,e[13]=(t*D-i*F+r*b)*W,e[14]=(M*w-g*R-m*x)*W,e[15]=(h*R-f*w+u*x)*W,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,c=e.z,l=s*o,h=s*a;return this.set(l*o+i,l*a-r*c,l*c+r*a,0,l*a+r*c,h*a+i,h*c-r*o,0,l*c-r*a,h*c+r*o,s*c*c+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,c=t._w,l=s+s,h=o+o,f=a+a,u=s*l,p=s*h,g=s*f,M=o*h,m=o*f,d=a*f,x=c*l,w=c*h,S=c*f,R=i.x,A=i.y,_=i.z;return r[0]=(1-(M+d))*R,r[1]=(p+S)*R,r[2]=(g-w)*R,r[3]=0,r[4]=(p-S)*A,r[5]=(1-(u+d))*A,r[6]=(m+x)*A,r[7]=0,r[8]=(g+w)*_,r[9]=(m-x)*_,r[10]=(1-(u+M))*_,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=ro.set(r[0],r[1],r[2]).length(),a=ro.set(r[4],r[5],r[6]).length(),c=ro.set(r[8],r[9],r[10]).length();s<0&&(o=-o),Hn.copy(this);let l=1/o,h=1/a,f=1/c;return Hn.elements[0]*=l,Hn.elements[1]*=l,Hn.elements[2]*=l,Hn.elements[4]*=h,Hn.elements[5]*=h,Hn.elements[6]*=h,Hn.elements[8]*=f,Hn.elements[9]*=f,Hn.elements[10]*=f,t.setFromRotationMatrix(Hn),i.x=o,i.y=a,i.z=c,this}makePerspective(e,t,i,r,s,o,a=Gi,c=!1){let l=this.elements,h=2*s/(t-e),f=2*s/(i-r),u=(t+e)/(t-e),p=(i+r)/(i-r),g,M;if(c)g=s/(o-s),M=o*s/(o-s);else if(a===Gi)g=-(o+s)/(o-s),M=-2*o*s/(o-s);else if(a===Mr)g=-o/(o-s),M=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=f,l[9]=p,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=M,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=Gi,c=!1){let l=this.elements,h=2/(t-e),f=2/(i-r),u=-(t+e)/(t-e),p=-(i+r)/(i-r),g,M;if(c)g=1/(o-s),M=o/(o-s);else if(a===Gi)g=-2/(o-s),M=-(o+s)/(o-s);else if(a===Mr)g=-1/(o-s),M=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=u,l[1]=0,l[5]=f,l[9]=0,l[13]=p,l[2]=0,l[6]=0,l[10]=g,l[14]=M,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},ro=new N,Hn=new Le,lM=new N(0,0,0),cM=new N(1,1,1),Wr=new N,tc=new N,vn=new N;var rp=new Le,sp=new Ft,Cn=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],c=r[1],l=r[5],h=r[9],f=r[2],u=r[6],p=r[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(u,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,s),this._z=0);break;case"ZXY":this._x=Math.asin(ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-f,p),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,s));break;case"ZYX":this._y=Math.asin(-ct(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(u,p),this._z=Math.atan2(c,s)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ct(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-f,s)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,l),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-h,p),this._y=0);break;default:Ge("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return rp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(rp,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return sp.setFromEuler(this),this.setFromQuaternion(sp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Cn.DEFAULT_ORDER="XYZ";var Xr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}};var hM=0,op=new N,so=new Ft,Sr=new Le,ic=new N,Va=new N,fM=new N,uM=new Ft,ap=new N(1,0,0),lp=new N(0,1,0),cp=new N(0,0,1),hp={type:"added"},dM={type:"removed"},oo={type:"childadded",child:null},Mf={type:"childremoved",child:null},Zt=class n extends Wi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:hM++}),this.uuid=rr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new N,t=new Cn,i=new Ft,r=new N(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new Le},normalMatrix:{value:new $e}}),this.matrix=new Le,this.matrixWorld=new Le,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Xr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return so.setFromAxisAngle(e,t),this.quaternion.multiply(so),this}rotateOnWorldAxis(e,t){return so.setFromAxisAngle(e,t),this.quaternion.premultiply(so),this}rotateX(e){return this.rotateOnAxis(ap,e)}rotateY(e){return this.rotateOnAxis(lp,e)}rotateZ(e){return this.rotateOnAxis(cp,e)}translateOnAxis(e,t){return op.copy(e).applyQuaternion(this.quaternion),this.position.add(op.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(ap,e)}translateY(e){return this.translateOnAxis(lp,e)}translateZ(e){return this.translateOnAxis(cp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Sr.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?ic.copy(e):ic.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),Va.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Sr.lookAt(Va,ic,this.up):Sr.lookAt(ic,Va,this.up),this.quaternion.setFromRotationMatrix(Sr),r&&(Sr.extractRotation(r.matrixWorld),so.setFromRotationMatrix(Sr),this.quaternion.premultiply(so.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ut("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(hp),oo.child=e,this.dispatchEvent(oo),oo.child=null):ut("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(dM),Mf.child=e,this.dispatchEvent(Mf),Mf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Sr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Sr.multiply(e.parent.matrixWorld)),e.applyMatrix4(Sr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(hp),oo.child=e,this.dispatchEvent(oo),oo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Va,e,fM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Va,uM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let f=c[l];s(e.shapes,f)}else s(e.shapes,c)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(s(e.materials,this.material[c]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];r.animations.push(s(e.animations,c))}}if(t){let a=o(e.geometries),c=o(e.materials),l=o(e.textures),h=o(e.images),f=o(e.shapes),u=o(e.skeletons),p=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),h.length>0&&(i.images=h),f.length>0&&(i.shapes=f),u.length>0&&(i.skeletons=u),p.length>0&&(i.animations=p),g.length>0&&(i.nodes=g)}return i.object=r,i;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Zt.DEFAULT_UP=new N(0,1,0);Zt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Zt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Mn=class extends Zt{constructor(){super(),this.isGroup=!0,this.type="Group"}};var pM={type:"move"},ao=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Mn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Mn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new N,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new N),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Mn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new N,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new N,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){o=!0;for(let M of e.hand.values()){let m=t.getJointPose(M,i),d=this._getHandJoint(l,M);m!==null&&(d.matrix.fromArray(m.transform.matrix),d.matrix.decompose(d.position,d.quaternion,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=m.radius),d.visible=m!==null}let h=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],u=h.position.distanceTo(f.position),p=.02,g=.005;l.inputState.pinching&&u>p+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&u<=p-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(c.matrix.fromArray(s.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,s.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(s.linearVelocity)):c.hasLinearVelocity=!1,s.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(s.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(pM)))}return a!==null&&(a.visible=r!==null),c!==null&&(c.visible=s!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Mn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}};var fp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},qr={h:0,s:0,l:0},nc={h:0,s:0,l:0};function Sf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Xe=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=en){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,ot.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=ot.workingColorSpace){return this.r=e,this.g=t,this.b=i,ot.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=ot.workingColorSpace){if(e=Jd(e,1),t=ct(t,0,1),i=ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=Sf(o,s,e+1/3),this.g=Sf(o,s,e),this.b=Sf(o,s,e-1/3)}return ot.colorSpaceToWorking(this,r),this}setStyle(e,t=en){function i(s){s!==void 0&&parseFloat(s)<1&&Ge("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Ge("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);Ge("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=en){let i=fp[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ge("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Gn(e.r),this.g=Gn(e.g),this.b=Gn(e.b),this}copyLinearToSRGB(e){return this.r=us(e.r),this.g=us(e.g),this.b=us(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=en){return ot.workingToColorSpace(qi.copy(this),e),Math.round(ct(qi.r*255,0,255))*65536+Math.round(ct(qi.g*255,0,255))*256+Math.round(ct(qi.b*255,0,255))}getHexString(e=en){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=ot.workingColorSpace){ot.workingToColorSpace(qi.copy(this),t);let i=qi.r,r=qi.g,s=qi.b,o=Math.max(i,r,s),a=Math.min(i,r,s),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let f=o-a;switch(l=h<=.5?f/(o+a):f/(2-o-a),o){case i:c=(r-s)/f+(r<s?6:0);break;case r:c=(s-i)/f+2;break;case s:c=(i-r)/f+4;break}c/=6}return e.h=c,e.s=l,e.l=h,e}getRGB(e,t=ot.workingColorSpace){return ot.workingToColorSpace(qi.copy(this),t),e.r=qi.r,e.g=qi.g,e.b=qi.b,e}getStyle(e=en){ot.workingToColorSpace(qi.copy(this),e);let t=qi.r,i=qi.g,r=qi.b;return e!==en?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(qr),this.setHSL(qr.h+e,qr.s+t,qr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(qr),e.getHSL(nc);let i=Zl(qr.h,nc.h,t),r=Zl(qr.s,nc.s,t),s=Zl(qr.l,nc.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},qi=new Xe;Xe.NAMES=fp;var lo=class extends Zt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Cn,this.environmentIntensity=1,this.environmentRotation=new Cn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}};var Vn=new N,yr=new N,yf=new N,br=new N,co=new N,ho=new N,up=new N,bf=new N,wf=new N,Ef=new N,Tf=new bt,Af=new bt,Rf=new bt,Yr=class n{constructor(e=new N,t=new N,i=new N){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),Vn.subVectors(e,t),r.cross(Vn);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){Vn.subVectors(r,t),yr.subVectors(i,t),yf.subVectors(e,t);let o=Vn.dot(Vn),a=Vn.dot(yr),c=Vn.dot(yf),l=yr.dot(yr),h=yr.dot(yf),f=o*l-a*a;if(f===0)return s.set(0,0,0),null;let u=1/f,p=(l*c-a*h)*u,g=(o*h-a*c)*u;return s.set(1-p-g,g,p)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,br)===null?!1:br.x>=0&&br.y>=0&&br.x+br.y<=1}static getInterpolation(e,t,i,r,s,o,a,c){return this.getBarycoord(e,t,i,r,br)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(s,br.x),c.addScaledVector(o,br.y),c.addScaledVector(a,br.z),c)}static getInterpolatedAttribute(e,t,i,r,s,o){return Tf.setScalar(0),Af.setScalar(0),Rf.setScalar(0),Tf.fromBufferAttribute(e,t),Af.fromBufferAttribute(e,i),Rf.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(Tf,s.x),o.addScaledVector(Af,s.y),o.addScaledVector(Rf,s.z),o}static isFrontFacing(e,t,i,r){return Vn.subVectors(i,t),yr.subVectors(e,t),Vn.cross(yr).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Vn.subVectors(this.c,this.b),yr.subVectors(this.a,this.b),Vn.cross(yr).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;co.subVectors(r,i),ho.subVectors(s,i),bf.subVectors(e,i);let c=co.dot(bf),l=ho.dot(bf);if(c<=0&&l<=0)return t.copy(i);wf.subVectors(e,r);let h=co.dot(wf),f=ho.dot(wf);if(h>=0&&f<=h)return t.copy(r);let u=c*f-h*l;if(u<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),t.copy(i).addScaledVector(co,o);Ef.subVectors(e,s);let p=co.dot(Ef),g=ho.dot(Ef);if(g>=0&&p<=g)return t.copy(s);let M=p*l-c*g;if(M<=0&&l>=0&&g<=0)return a=l/(l-g),t.copy(i).addScaledVector(ho,a);let m=h*g-p*f;if(m<=0&&f-h>=0&&p-g>=0)return up.subVectors(s,r),a=(f-h)/(f-h+(p-g)),t.copy(r).addScaledVector(up,a);let d=1/(m+M+u);return o=M*d,a=u*d,t.copy(i).addScaledVector(co,o).addScaledVector(ho,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}};var Pn=class{constructor(e=new N(1/0,1/0,1/0),t=new N(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Wn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Wn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Wn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Wn):Wn.fromBufferAttribute(s,o),Wn.applyMatrix4(e.matrixWorld),this.expandByPoint(Wn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),rc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),rc.copy(i.boundingBox)),rc.applyMatrix4(e.matrixWorld),this.union(rc)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Wn),Wn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Wa),sc.subVectors(this.max,Wa),fo.subVectors(e.a,Wa),uo.subVectors(e.b,Wa),po.subVectors(e.c,Wa),$r.subVectors(uo,fo),Kr.subVectors(po,uo),ds.subVectors(fo,po);let t=[0,-$r.z,$r.y,0,-Kr.z,Kr.y,0,-ds.z,ds.y,$r.z,0,-$r.x,Kr.z,0,-Kr.x,ds.z,0,-ds.x,-$r.y,$r.x,0,-Kr.y,Kr.x,0,-ds.y,ds.x,0];return!Cf(t,fo,uo,po,sc)||(t=[1,0,0,0,1,0,0,0,1],!Cf(t,fo,uo,po,sc))?!1:(oc.crossVectors($r,Kr),t=[oc.x,oc.y,oc.z],Cf(t,fo,uo,po,sc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Wn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Wn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(wr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),wr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),wr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),wr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),wr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),wr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),wr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),wr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(wr),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},wr=[new N,new N,new N,new N,new N,new N,new N,new N],Wn=new N,rc=new Pn,fo=new N,uo=new N,po=new N,$r=new N,Kr=new N,ds=new N,Wa=new N,sc=new N,oc=new N,ps=new N;function Cf(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){ps.fromArray(n,s);let a=r.x*Math.abs(ps.x)+r.y*Math.abs(ps.y)+r.z*Math.abs(ps.z),c=e.dot(ps),l=t.dot(ps),h=i.dot(ps);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var Si=new N,ac=new Ke,mM=0,Rt=class extends Wi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:mM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Vd,this.updateRanges=[],this.gpuType=ui,this.version=0,this._normalizationScale=e!==void 0?Jl(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)ac.fromBufferAttribute(this,t),ac.applyMatrix3(e),this.setXY(t,ac.x,ac.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.applyMatrix3(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.applyMatrix4(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.applyNormalMatrix(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.transformDirection(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):jd(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):ep(e,this.array)}};var mo=class extends Rt{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var go=class extends Rt{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Gt=class extends Rt{constructor(e,t,i){super(new Float32Array(e),t,i)}};var gM=new Pn,Xa=new N,Pf=new N,ln=class{constructor(e=new N,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):gM.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Xa.subVectors(e,this.center);let t=Xa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(Xa,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Pf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Xa.copy(e.center).add(Pf)),this.expandByPoint(Xa.copy(e.center).sub(Pf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}};var xM=0,Ln=new Le,Lf=new Zt,xo=new N,Sn=new Pn,qa=new Pn,Oi=new N,Ot=class n extends Wi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:xM++}),this.uuid=rr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(qd(e)?go:mo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new $e().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ln.makeRotationFromQuaternion(e),this.applyMatrix4(Ln),this}rotateX(e){return Ln.makeRotationX(e),this.applyMatrix4(Ln),this}rotateY(e){return Ln.makeRotationY(e),this.applyMatrix4(Ln),this}rotateZ(e){return Ln.makeRotationZ(e),this.applyMatrix4(Ln),this}translate(e,t,i){return Ln.makeTranslation(e,t,i),this.applyMatrix4(Ln),this}scale(e,t,i){return Ln.makeScale(e,t,i),this.applyMatrix4(Ln),this}lookAt(e){return Lf.lookAt(e),Lf.updateMatrix(),this.applyMatrix4(Lf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(xo).negate(),this.translate(xo.x,xo.y,xo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Gt(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Ge("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Pn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ut("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new N(-1/0,-1/0,-1/0),new N(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];Sn.setFromBufferAttribute(s),this.morphTargetsRelative?(Oi.addVectors(this.boundingBox.min,Sn.min),this.boundingBox.expandByPoint(Oi),Oi.addVectors(this.boundingBox.max,Sn.max),this.boundingBox.expandByPoint(Oi)):(this.boundingBox.expandByPoint(Sn.min),this.boundingBox.expandByPoint(Sn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ut('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ln);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ut("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new N,1/0);return}if(e){let i=this.boundingSphere.center;if(Sn.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];qa.setFromBufferAttribute(a),this.morphTargetsRelative?(Oi.addVectors(Sn.min,qa.min),Sn.expandByPoint(Oi),Oi.addVectors(Sn.max,qa.max),Sn.expandByPoint(Oi)):(Sn.expandByPoint(qa.min),Sn.expandByPoint(qa.max))}Sn.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)Oi.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(Oi));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)Oi.fromBufferAttribute(a,l),c&&(xo.fromBufferAttribute(e,l),Oi.add(xo)),r=Math.max(r,i.distanceToSquared(Oi))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&ut('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ut("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Rt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let F=0;F<i.count;F++)a[F]=new N,c[F]=new N;let h=new N,f=new N,u=new N,p=new Ke,g=new Ke,M=new Ke,m=new N,d=new N;function x(F,L,D){l[F]=l[L]=l[D]=1,h.fromBufferAttribute(i,F),f.fromBufferAttribute(i,L),u.fromBufferAttribute(i,D),p.fromBufferAttribute(s,F),g.fromBufferAttribute(s,L),M.fromBufferAttribute(s,D),f.sub(h),u.sub(h),g.sub(p),M.sub(p);let k=1/(g.x*M.y-M.x*g.y);isFinite(k)&&(m.copy(f).multiplyScalar(M.y).addScaledVector(u,-g.y).multiplyScalar(k),d.copy(u).multiplyScalar(g.x).addScaledVector(f,-M.x).multiplyScalar(k),a[F].add(m),a[L].add(m),a[D].add(m),c[F].add(d),c[L].add(d),c[D].add(d))}let w=this.groups;w.length===0&&(w=[{start:0,count:e.count}]);for(let F=0,L=w.length;F<L;++F){let D=w[F],k=D.start,G=D.count;for(let U=k,W=k+G;U<W;U+=3)x(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let S=new N,R=new N,A=new N,_=new N;function b(F){A.fromBufferAttribute(r,F),_.copy(A);let L=a[F];S.copy(L),S.sub(A.multiplyScalar(A.dot(L))).normalize(),R.crossVectors(_,L);let k=R.dot(c[F])<0?-1:1;o.setXYZW(F,S.x,S.y,S.z,k)}for(let F=0,L=i.count;F<L;++F)l[F]&&b(F);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Rt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let u=0,p=i.count;u<p;u++)i.setXYZ(u,0,0,0);let r=new N,s=new N,o=new N,a=new N,c=new N,l=new N,h=new N,f=new N;if(e)for(let u=0,p=e.count;u<p;u+=3){let g=e.getX(u+0),M=e.getX(u+1),m=e.getX(u+2);r.fromBufferAttribute(t,g),s.fromBufferAttribute(t,M),o.fromBufferAttribute(t,m),h.subVectors(o,s),f.subVectors(r,s),h.cross(f),a.fromBufferAttribute(i,g),c.fromBufferAttribute(i,M),l.fromBufferAttribute(i,m),a.add(h),c.add(h),l.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(M,c.x,c.y,c.z),i.setXYZ(m,l.x,l.y,l.z)}else for(let u=0,p=t.count;u<p;u+=3)r.fromBufferAttribute(t,u+0),s.fromBufferAttribute(t,u+1),o.fromBufferAttribute(t,u+2),h.subVectors(o,s),f.subVectors(r,s),h.cross(f),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Oi.fromBufferAttribute(e,t),Oi.normalize(),e.setXYZ(t,Oi.x,Oi.y,Oi.z)}toNonIndexed(){function e(a,c){let l=a.array,h=a.itemSize,f=a.normalized,u=new l.constructor(c.length*h),p=0,g=0;for(let M=0,m=c.length;M<m;M++){a.isInterleavedBufferAttribute?p=c[M]*a.data.stride+a.offset:p=c[M]*h;for(let d=0;d<h;d++)u[g++]=l[p++]}return new Rt(u,h,f)}if(this.index===null)return Ge("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let c=r[a],l=e(c,i);t.setAttribute(a,l)}let s=this.morphAttributes;for(let a in s){let c=[],l=s[a];for(let h=0,f=l.length;h<f;h++){let u=l[h],p=e(u,i);c.push(p)}t.morphAttributes[a]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let c in i){let l=i[c];e.data.attributes[c]=l.toJSON(e.data)}let r={},s=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let f=0,u=l.length;f<u;f++){let p=l[f];h.push(p.toJSON(e.data))}h.length>0&&(r[c]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let l in r){let h=r[l];this.setAttribute(l,h.clone(t))}let s=e.morphAttributes;for(let l in s){let h=[],f=s[l];for(let u=0,p=f.length;u<p;u++)h.push(f[u].clone(t));this.morphAttributes[l]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let l=0,h=o.length;l<h;l++){let f=o[l];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Df=new N,_M=new N,vM=new $e,Yi=class{constructor(e=new N(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=Df.subVectors(i,t).cross(_M.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(Df),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||vM.getNormalMatrix(e),r=this.coplanarPoint(Df).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}};var MM=0,Dn=class extends Wi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:MM++}),this.uuid=rr(),this.name="",this.type="Material",this.blending=kr,this.side=sn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Al,this.blendDst=Rl,this.blendEquation=zr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Xe(0,0,0),this.blendAlpha=0,this.depthFunc=Gr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Od,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Xl,this.stencilZFail=Xl,this.stencilZPass=Xl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ge(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ge(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let c=s[a];delete c.metadata,o.push(c)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Xe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Yi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ke().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Er=new N,Nf=new N,lc=new N,cc=new N,_o=class{constructor(e=new N,t=new N(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Er)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Er.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Er.copy(this.origin).addScaledVector(this.direction,t),Er.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){Nf.copy(e).add(t).multiplyScalar(.5),lc.copy(t).sub(e).normalize(),cc.copy(this.origin).sub(Nf);let s=e.distanceTo(t)*.5,o=-this.direction.dot(lc),a=cc.dot(this.direction),c=-cc.dot(lc),l=cc.lengthSq(),h=Math.abs(1-o*o),f,u,p,g;if(h>0)if(f=o*c-a,u=o*a-c,g=s*h,f>=0)if(u>=-g)if(u<=g){let M=1/h;f*=M,u*=M,p=f*(f+o*u+2*a)+u*(o*f+u+2*c)+l}else u=s,f=Math.max(0,-(o*u+a)),p=-f*f+u*(u+2*c)+l;else u=-s,f=Math.max(0,-(o*u+a)),p=-f*f+u*(u+2*c)+l;else u<=-g?(f=Math.max(0,-(-o*s+a)),u=f>0?-s:Math.min(Math.max(-s,-c),s),p=-f*f+u*(u+2*c)+l):u<=g?(f=0,u=Math.min(Math.max(-s,-c),s),p=u*(u+2*c)+l):(f=Math.max(0,-(o*s+a)),u=f>0?s:Math.min(Math.max(-s,-c),s),p=-f*f+u*(u+2*c)+l);else u=o>0?-s:s,f=Math.max(0,-(o*u+a)),p=-f*f+u*(u+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,f),r&&r.copy(Nf).addScaledVector(lc,u),p}intersectSphere(e,t){if(e.radius<0)return null;Er.subVectors(e.center,this.origin);let i=Er.dot(this.direction),r=Er.dot(Er)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,c,l=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,u=this.origin;return l>=0?(i=(e.min.x-u.x)*l,r=(e.max.x-u.x)*l):(i=(e.max.x-u.x)*l,r=(e.min.x-u.x)*l),h>=0?(s=(e.min.y-u.y)*h,o=(e.max.y-u.y)*h):(s=(e.max.y-u.y)*h,o=(e.min.y-u.y)*h),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),f>=0?(a=(e.min.z-u.z)*f,c=(e.max.z-u.z)*f):(a=(e.max.z-u.z)*f,c=(e.min.z-u.z)*f),i>c||a>r)||((a>i||i!==i)&&(i=a),(c<r||r!==r)&&(r=c),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,Er)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,f=e.x-o.x,u=e.y-o.y,p=e.z-o.z,g=t.x-o.x,M=t.y-o.y,m=t.z-o.z,d=i.x-o.x,x=i.y-o.y,w=i.z-o.z,S=Math.abs(c),R=Math.abs(l),A=Math.abs(h),_,b,F,L,D,k,G,U,W,Y,V,ce;if(S>=R&&S>=A?(F=c,k=f,W=g,ce=d,c>=0?(_=l,b=h,L=u,D=p,G=M,U=m,Y=x,V=w):(_=h,b=l,L=p,D=u,G=m,U=M,Y=w,V=x)):R>=A?(F=l,k=u,W=M,ce=x,l>=0?(_=h,b=c,L=p,D=f,G=m,U=g,Y=w,V=d):(_=c,b=h,L=f,D=p,G=g,U=m,Y=d,V=w)):(F=h,k=p,W=m,ce=w,h>=0?(_=c,b=l,L=f,D=u,G=g,U=M,Y=d,V=x):(_=l,b=c,L=u,D=f,G=M,U=g,Y=x,V=d)),F===0)return null;let Z=_/F,j=b/F,re=1/F,ue=L-Z*k,fe=D-j*k,ee=G-Z*W,me=U-j*W,_e=Y-Z*ce,Ae=V-j*ce,ye=_e*me-Ae*ee,qe=ue*Ae-fe*_e,rt=ee*fe-me*ue;if(r){if(ye<0||qe<0||rt<0)return null}else if((ye<0||qe<0||rt<0)&&(ye>0||qe>0||rt>0))return null;let Ve=ye+qe+rt;if(Ve===0)return null;let dt=re*(ye*k+qe*W+rt*ce);return(Ve>0?dt<0:dt>0)?null:this.at(dt/Ve,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}};var sr=class extends Dn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cn,this.combine=Hs,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var dp=new Le,ms=new _o,hc=new ln,pp=new N,fc=new N,uc=new N,dc=new N,If=new N,pc=new N,mp=new N,mc=new N,St=class extends Zt{constructor(e=new Ot,t=new sr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){pc.set(0,0,0);for(let c=0,l=s.length;c<l;c++){let h=a[c],f=s[c];h!==0&&(If.fromBufferAttribute(f,e),o?pc.addScaledVector(If,h):pc.addScaledVector(If.sub(t),h))}t.add(pc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),hc.copy(i.boundingSphere),hc.applyMatrix4(s),ms.copy(e.ray).recast(e.near),!(hc.containsPoint(ms.origin)===!1&&(ms.intersectSphere(hc,pp)===null||ms.origin.distanceToSquared(pp)>(e.far-e.near)**2))&&(dp.copy(s).invert(),ms.copy(e.ray).applyMatrix4(dp),!(i.boundingBox!==null&&ms.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,ms)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,c=s.attributes.position,l=s.attributes.uv,h=s.attributes.uv1,f=s.attributes.normal,u=s.groups,p=s.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,M=u.length;g<M;g++){let m=u[g],d=o[m.materialIndex],x=Math.max(m.start,p.start),w=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let S=x,R=w;S<R;S+=3){let A=a.getX(S),_=a.getX(S+1),b=a.getX(S+2);r=gc(this,d,e,i,l,h,f,A,_,b),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let g=Math.max(0,p.start),M=Math.min(a.count,p.start+p.count);for(let m=g,d=M;m<d;m+=3){let x=a.getX(m),w=a.getX(m+1),S=a.getX(m+2);r=gc(this,o,e,i,l,h,f,x,w,S),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}else if(c!==void 0)if(Array.isArray(o))for(let g=0,M=u.length;g<M;g++){let m=u[g],d=o[m.materialIndex],x=Math.max(m.start,p.start),w=Math.min(c.count,Math.min(m.start+m.count,p.start+p.count));for(let S=x,R=w;S<R;S+=3){let A=S,_=S+1,b=S+2;r=gc(this,d,e,i,l,h,f,A,_,b),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let g=Math.max(0,p.start),M=Math.min(c.count,p.start+p.count);for(let m=g,d=M;m<d;m+=3){let x=m,w=m+1,S=m+2;r=gc(this,o,e,i,l,h,f,x,w,S),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}}};function SM(n,e,t,i,r,s,o,a){let c;if(e.side===jt?c=i.intersectTriangle(o,s,r,!0,a):c=i.intersectTriangle(r,s,o,e.side===sn,a),c===null)return null;mc.copy(a),mc.applyMatrix4(n.matrixWorld);let l=t.ray.origin.distanceTo(mc);return l<t.near||l>t.far?null:{distance:l,point:mc.clone(),object:n}}function gc(n,e,t,i,r,s,o,a,c,l){n.getVertexPosition(a,fc),n.getVertexPosition(c,uc),n.getVertexPosition(l,dc);let h=SM(n,e,t,i,fc,uc,dc,mp);if(h){let f=new N;Yr.getBarycoord(mp,fc,uc,dc,f),r&&(h.uv=Yr.getInterpolatedAttribute(r,a,c,l,f,new Ke)),s&&(h.uv1=Yr.getInterpolatedAttribute(s,a,c,l,f,new Ke)),o&&(h.normal=Yr.getInterpolatedAttribute(o,a,c,l,f,new N),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:c,c:l,normal:new N,materialIndex:0};Yr.getNormal(fc,uc,dc,u.normal),h.face=u,h.barycoord=f}return h}var Tr=class extends di{constructor(e=null,t=1,i=1,r,s,o,a,c,l=Kt,h=Kt,f,u){super(null,o,a,c,l,h,r,s,f,u),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Zr=class extends Rt{constructor(e,t,i,r=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var vo=new Le,gp=new Le,xc=[],xp=new Pn,yM=new Le,Ya=new St,$a=new ln,Ka=class extends St{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Zr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<i;r++)this.setMatrixAt(r,yM)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Pn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,vo),xp.copy(e.boundingBox).applyMatrix4(vo),this.boundingBox.union(xp)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new ln),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,vo),$a.copy(e.boundingSphere).applyMatrix4(vo),this.boundingSphere.union($a)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,r=this.morphTexture.source.data.data,s=i.length+1,o=e*s+1;for(let a=0;a<i.length;a++)i[a]=r[o+a]}raycast(e,t){let i=this.matrixWorld,r=this.count;if(Ya.geometry=this.geometry,Ya.material=this.material,Ya.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),$a.copy(this.boundingSphere),$a.applyMatrix4(i),e.ray.intersectsSphere($a)!==!1))for(let s=0;s<r;s++){this.getMatrixAt(s,vo),gp.multiplyMatrices(i,vo),Ya.matrixWorld=gp,Ya.raycast(e,xc);for(let o=0,a=xc.length;o<a;o++){let c=xc[o];c.instanceId=s,c.object=this,t.push(c)}xc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Zr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,r=i.length+1;this.morphTexture===null&&(this.morphTexture=new Tr(new Float32Array(r*this.count),r,this.count,qs,ui));let s=this.morphTexture.source.data.data,o=0;for(let l=0;l<i.length;l++)o+=i[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=r*e;return s[c]=a,s.set(i,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}};var gs=new ln,bM=new Ke(.5,.5),_c=new N,cn=class{constructor(e=new Yi,t=new Yi,i=new Yi,r=new Yi,s=new Yi,o=new Yi){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Gi,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],c=s[2],l=s[3],h=s[4],f=s[5],u=s[6],p=s[7],g=s[8],M=s[9],m=s[10],d=s[11],x=s[12],w=s[13],S=s[14],R=s[15];if(r[0].setComponents(l-o,p-h,d-g,R-x).normalize(),r[1].setComponents(l+o,p+h,d+g,R+x).normalize(),r[2].setComponents(l+a,p+f,d+M,R+w).normalize(),r[3].setComponents(l-a,p-f,d-M,R-w).normalize(),i)r[4].setComponents(c,u,m,S).normalize(),r[5].setComponents(l-c,p-u,d-m,R-S).normalize();else if(r[4].setComponents(l-c,p-u,d-m,R-S).normalize(),t===Gi)r[5].setComponents(l+c,p+u,d+m,R+S).normalize();else if(t===Mr)r[5].setComponents(c,u,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),gs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),gs.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(gs)}intersectsSprite(e){gs.center.set(0,0,0);let t=bM.distanceTo(e.center);return gs.radius=.7071067811865476+t,gs.applyMatrix4(e.matrixWorld),this.intersectsSphere(gs)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(_c.x=r.normal.x>0?e.max.x:e.min.x,_c.y=r.normal.y>0?e.max.y:e.min.y,_c.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(_c)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var _p=new Le,vc=class n{constructor(){this.coordinateSystem=Gi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];_p.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new cn),i[r].setFromProjectionMatrix(_p,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new cn),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Mo=class extends di{constructor(e=[],t=nr,i,r,s,o,a,c,l,h){super(e,t,i,r,s,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var yn=class extends di{constructor(e,t,i=Ii,r,s,o,a=Kt,c=Kt,l,h=an,f=1){if(h!==an&&h!==xn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:f};super(u,r,s,o,a,c,h,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Vr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}};var So=class extends yn{constructor(e,t=Ii,i=nr,r,s,o=Kt,a=Kt,c,l=an){let h={width:e,height:e,depth:1},f=[h,h,h,h,h,h];super(e,e,t,i,r,s,o,a,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}};var yo=class extends di{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var or=class n extends Ot{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let c=[],l=[],h=[],f=[],u=0,p=0;g("z","y","x",-1,-1,i,t,e,o,s,0),g("z","y","x",1,-1,i,t,-e,o,s,1),g("x","z","y",1,1,e,i,t,r,o,2),g("x","z","y",1,-1,e,i,-t,r,o,3),g("x","y","z",1,-1,e,t,i,r,s,4),g("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(c),this.setAttribute("position",new Gt(l,3)),this.setAttribute("normal",new Gt(h,3)),this.setAttribute("uv",new Gt(f,2));function g(M,m,d,x,w,S,R,A,_,b,F){let L=S/_,D=R/b,k=S/2,G=R/2,U=A/2,W=_+1,Y=b+1,V=0,ce=0,Z=new N;for(let j=0;j<Y;j++){let re=j*D-G;for(let ue=0;ue<W;ue++){let fe=ue*L-k;Z[M]=fe*x,Z[m]=re*w,Z[d]=U,l.push(Z.x,Z.y,Z.z),Z[M]=0,Z[m]=0,Z[d]=A>0?1:-1,h.push(Z.x,Z.y,Z.z),f.push(ue/_),f.push(1-j/b),V+=1}}for(let j=0;j<b;j++)for(let re=0;re<_;re++){let ue=u+re+W*j,fe=u+re+W*(j+1),ee=u+(re+1)+W*(j+1),me=u+(re+1)+W*j;c.push(ue,fe,me),c.push(fe,ee,me),ce+=6}a.addGroup(p,ce,F),p+=ce,u+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var bo=class n extends Ot{constructor(e=1,t=1,i=1,r=32,s=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:c};let l=this;r=Math.floor(r),s=Math.floor(s);let h=[],f=[],u=[],p=[],g=0,M=[],m=i/2,d=0;x(),o===!1&&(e>0&&w(!0),t>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new Gt(f,3)),this.setAttribute("normal",new Gt(u,3)),this.setAttribute("uv",new Gt(p,2));function x(){let S=new N,R=new N,A=0,_=(t-e)/i;for(let b=0;b<=s;b++){let F=[],L=b/s,D=L*(t-e)+e;for(let k=0;k<=r;k++){let G=k/r,U=G*c+a,W=Math.sin(U),Y=Math.cos(U);R.x=D*W,R.y=-L*i+m,R.z=D*Y,f.push(R.x,R.y,R.z),S.set(W,_,Y).normalize(),u.push(S.x,S.y,S.z),p.push(G,1-L),F.push(g++)}M.push(F)}for(let b=0;b<r;b++)for(let F=0;F<s;F++){let L=M[F][b],D=M[F+1][b],k=M[F+1][b+1],G=M[F][b+1];(e>0||F!==0)&&(h.push(L,D,G),A+=3),(t>0||F!==s-1)&&(h.push(D,k,G),A+=3)}l.addGroup(d,A,0),d+=A}function w(S){let R=g,A=new Ke,_=new N,b=0,F=S===!0?e:t,L=S===!0?1:-1;for(let k=1;k<=r;k++)f.push(0,m*L,0),u.push(0,L,0),p.push(.5,.5),g++;let D=g;for(let k=0;k<=r;k++){let U=k/r*c+a,W=Math.cos(U),Y=Math.sin(U);_.x=F*Y,_.y=m*L,_.z=F*W,f.push(_.x,_.y,_.z),u.push(0,L,0),A.x=W*.5+.5,A.y=Y*.5*L+.5,p.push(A.x,A.y),g++}for(let k=0;k<r;k++){let G=R+k,U=D+k;S===!0?h.push(U,U+1,G):h.push(U+1,U,G),b+=3}l.addGroup(d,b,S===!0?1:2),d+=b}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Mc=class n extends bo{constructor(e=1,t=1,i=32,r=1,s=!1,o=0,a=Math.PI*2){super(0,e,t,i,r,s,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:r,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var wo=class n extends Ot{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),c=Math.floor(r),l=a+1,h=c+1,f=e/a,u=t/c,p=[],g=[],M=[],m=[];for(let d=0;d<h;d++){let x=d*u-o;for(let w=0;w<l;w++){let S=w*f-s;g.push(S,-x,0),M.push(0,0,1),m.push(w/a),m.push(1-d/c)}}for(let d=0;d<c;d++)for(let x=0;x<a;x++){let w=x+l*d,S=x+l*(d+1),R=x+1+l*(d+1),A=x+1+l*d;p.push(w,S,A),p.push(S,R,A)}this.setIndex(p),this.setAttribute("position",new Gt(g,3)),this.setAttribute("normal",new Gt(M,3)),this.setAttribute("uv",new Gt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Eo=class n extends Ot{constructor(e=1,t=32,i=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let c=Math.min(o+a,Math.PI),l=0,h=[],f=new N,u=new N,p=[],g=[],M=[],m=[];for(let d=0;d<=i;d++){let x=[],w=d/i,S=o+w*a,R=e*Math.cos(S),A=Math.sqrt(e*e-R*R),_=0;d===0&&o===0?_=.5/t:d===i&&c===Math.PI&&(_=-.5/t);for(let b=0;b<=t;b++){let F=b/t,L=r+F*s;f.x=-A*Math.cos(L),f.y=R,f.z=A*Math.sin(L),g.push(f.x,f.y,f.z),u.copy(f).normalize(),M.push(u.x,u.y,u.z),m.push(F+_,1-w),x.push(l++)}h.push(x)}for(let d=0;d<i;d++)for(let x=0;x<t;x++){let w=h[d][x+1],S=h[d][x],R=h[d+1][x],A=h[d+1][x+1];(d!==0||o>0)&&p.push(w,S,A),(d!==i-1||c<Math.PI)&&p.push(S,R,A)}this.setIndex(p),this.setAttribute("position",new Gt(g,3)),this.setAttribute("normal",new Gt(M,3)),this.setAttribute("uv",new Gt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Ar(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(vp(r))r.isRenderTargetTexture?(Ge("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(vp(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function $i(n){let e={};for(let t=0;t<n.length;t++){let i=Ar(n[t]);for(let r in i)e[r]=i[r]}return e}function vp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Mp(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Sc(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:ot.workingColorSpace}var Sp={clone:Ar,merge:$i};var yp=`
void main() {
gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}
`;var bp=`
void main() {
gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}
`;var tn=class extends Dn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=yp,this.fragmentShader=bp,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ar(e.uniforms),this.uniformsGroups=Mp(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new Xe().setHex(r.value);break;case"v2":this.uniforms[i].value=new Ke().fromArray(r.value);break;case"v3":this.uniforms[i].value=new N().fromArray(r.value);break;case"v4":this.uniforms[i].value=new bt().fromArray(r.value);break;case"m3":this.uniforms[i].value=new $e().fromArray(r.value);break;case"m4":this.uniforms[i].value=new Le().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}};var yc=class extends tn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Rr=class extends Dn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Xe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ga,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cn,this.combine=Hs,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var bc=class extends Dn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Ud,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}};var wc=class extends Dn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var To=class extends Zt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Xe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Za=class extends To{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Zt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Xe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}};var Uf=new Le,wp=new N,Ep=new N,Ec=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=fi,this.map=null,this.mapPass=null,this.matrix=new Le,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new cn,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new bt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;wp.setFromMatrixPosition(e.matrixWorld),t.position.copy(wp),Ep.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Ep),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,r){Uf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Uf,e.coordinateSystem,e.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,c=r?r.x/s.x:0,l=r?r.y/s.y:0;e.coordinateSystem===Mr||e.reversedDepth?t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),t.multiply(Uf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var Tc=new N,Ac=new Ft,ar=new N,Ao=class extends Zt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Le,this.projectionMatrix=new Le,this.projectionMatrixInverse=new Le,this.coordinateSystem=Gi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Tc,Ac,ar),ar.x===1&&ar.y===1&&ar.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Tc,Ac,ar.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Tc,Ac,ar),ar.x===1&&ar.y===1&&ar.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Tc,Ac,ar.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}};var Jr=new N,Tp=new Ke,Ap=new Ke,Bi=class extends Ao{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ha*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Kl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ha*2*Math.atan(Math.tan(Kl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Jr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Jr.x,Jr.y).multiplyScalar(-e/Jr.z),Jr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Jr.x,Jr.y).multiplyScalar(-e/Jr.z)}getViewSize(e,t){return this.getViewBounds(e,Tp,Ap),t.subVectors(Ap,Tp)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Kl*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;s+=o.offsetX*r/c,t-=o.offsetY*i/l,r*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ro=class extends Ao{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,c=r-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=l*this.view.offsetX,o=s+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Rc=class extends Ec{constructor(){super(new Ro(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}};var Ja=class extends To{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Zt.DEFAULT_UP),this.updateMatrix(),this.target=new Zt,this.shadow=new Rc}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Co=-90,Po=1,xs=class extends Zt{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Bi(Co,Po,e,t);r.layers=this.layers,this.add(r);let s=new Bi(Co,Po,e,t);s.layers=this.layers,this.add(s);let o=new Bi(Co,Po,e,t);o.layers=this.layers,this.add(o);let a=new Bi(Co,Po,e,t);a.layers=this.layers,this.add(a);let c=new Bi(Co,Po,e,t);c.layers=this.layers,this.add(c);let l=new Bi(Co,Po,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,c]=t;for(let l of t)this.remove(l);if(e===Gi)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===Mr)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,c,l,h]=this.children,f=e.getRenderTarget(),u=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let M=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(i,4,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),i.texture.mipmapsAutoUpdate=M,e.setRenderTarget(i,5,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(f,u,p),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}};var Cc=class extends Bi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Rp=new Le,Qa=class{constructor(e,t,i=0,r=1/0){this.ray=new _o(e,t),this.near=i,this.far=r,this.camera=null,this.layers=new Xr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):ut("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Rp.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Rp),this}intersectObject(e,t=!0,i=[]){return Ff(e,this,i,t),i.sort(Cp),i}intersectObjects(e,t=!0,i=[]){for(let r=0,s=e.length;r<s;r++)Ff(e[r],this,i,t);return i.sort(Cp),i}};function Cp(n,e){return n.distance-e.distance}function Ff(n,e,t,i){let r=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(r=!1),r===!0&&i===!0){let s=n.children;for(let o=0,a=s.length;o<a;o++)Ff(s[o],e,t,!0)}}function Of(n,e,t,i){let r=wM(i);switch(t){case Vl:return n*e;case qs:return n*e/r.components*r.byteLength;case Ys:return n*e/r.components*r.byteLength;case _n:return n*e*2/r.components*r.byteLength;case $s:return n*e*2/r.components*r.byteLength;case Wl:return n*e*3/r.components*r.byteLength;case Fi:return n*e*4/r.components*r.byteLength;case Ks:return n*e*4/r.components*r.byteLength;case Zs:case Js:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Qs:case js:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ua:case pa:return Math.max(n,16)*Math.max(e,8)/4;case fa:case da:return Math.max(n,8)*Math.max(e,8)/2;case ma:case ga:case _a:case va:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case xa:case as:case Ma:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Sa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ya:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case ba:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case wa:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Ea:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Ta:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Aa:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Ra:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Ca:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Pa:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case La:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Da:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Na:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Ia:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Ua:case Fa:case Oa:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Ba:case ka:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ls:case za:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function wM(n){switch(n){case fi:case kl:return{byteLength:1,components:1};case vr:case zl:case Ui:return{byteLength:2,components:1};case Ws:case Xs:return{byteLength:2,components:4};case Ii:case Vs:case ui:return{byteLength:4,components:1};case Gl:case Hl:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ge("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Pc(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function Pp(n){let e=new WeakMap;function t(a,c){let l=a.array,h=a.usage,f=l.byteLength,u=n.createBuffer();n.bindBuffer(c,u),n.bufferData(c,l,h),a.onUploadCallback();let p;if(l instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)p=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)p=n.SHORT;else if(l instanceof Uint32Array)p=n.UNSIGNED_INT;else if(l instanceof Int32Array)p=n.INT;else if(l instanceof Int8Array)p=n.BYTE;else if(l instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:u,type:p,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,c,l){let h=c.array,f=c.updateRanges;if(n.bindBuffer(l,a),f.length===0)n.bufferSubData(l,0,h);else{f.sort((p,g)=>p.start-g.start);let u=0;for(let p=1;p<f.length;p++){let g=f[u],M=f[p];M.start<=g.start+g.count+1?g.count=Math.max(g.count,M.start+M.count-g.start):(++u,f[u]=M)}f.length=u+1;for(let p=0,g=f.length;p<g;p++){let M=f[p];n.bufferSubData(l,M.start*h.BYTES_PER_ELEMENT,h,M.start,M.count)}c.clearUpdateRanges()}c.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=e.get(a);c&&(n.deleteBuffer(c.buffer),e.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=e.get(a);if(l===void 0)e.set(a,t(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:r,remove:s,update:o}}var Lp=`
#ifdef USE_ALPHAHASH
if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif
`;var Dp=`
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
`;var Np=`
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif
`;var Ip=`
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif
`;var Up=`
#ifdef USE_ALPHATEST
#ifdef ALPHA_TO_COVERAGE
diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
if ( diffuseColor.a == 0.0 ) discard;
#else
if ( diffuseColor.a < alphaTest ) discard;
#endif
#endif
`;var Fp=`
#ifdef USE_ALPHATEST
uniform float alphaTest;
#endif
`;var Op=`
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
`;var Bp=`
#ifdef USE_AOMAP
uniform sampler2D aoMap;
uniform float aoMapIntensity;
#endif
`;var kp=`
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
`;var zp=`
#ifdef USE_BATCHING
mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif
`;var Gp=`
vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
vPosition = vec3( position );
#endif
`;var Hp=`
vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
vec3 objectTangent = vec3( tangent.xyz );
#endif
`;var Vp=`
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
`;var Wp=`
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
`;var Xp=`
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
`;var qp=`
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
`;var Yp=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif
`;var $p=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
#endif
`;var Kp=`
#if NUM_CLIPPING_PLANES > 0
vClipPosition = - mvPosition.xyz;
#endif
`;var Zp=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
diffuseColor *= vColor;
#endif
`;var Jp=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
varying vec4 vColor;
#endif
`;var Qp=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
varying vec4 vColor;
#endif
`;var jp=`
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
`;var em=`
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
`;var tm=`
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
`;var im=`
#ifdef USE_DISPLACEMENTMAP
uniform sampler2D displacementMap;
uniform float displacementScale;
uniform float displacementBias;
#endif
`;var nm=`
#ifdef USE_DISPLACEMENTMAP
transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif
`;var rm=`
#ifdef USE_EMISSIVEMAP
vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
emissiveColor = sRGBTransferEOTF( emissiveColor );
#endif
totalEmissiveRadiance *= emissiveColor.rgb;
#endif
`;var sm=`
#ifdef USE_EMISSIVEMAP
uniform sampler2D emissiveMap;
#endif
`;var om=`
gl_FragColor = linearToOutputTexel( gl_FragColor );
`;var am=`
vec4 LinearTransferOETF( in vec4 value ) {
return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}
`;var lm=`
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
`;var cm=`
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
`;var hm=`
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
`;var fm=`
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
`;var um=`
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
`;var dm=`
#ifdef USE_FOG
vFogDepth = - mvPosition.z;
#endif
`;var pm=`
#ifdef USE_FOG
varying float vFogDepth;
#endif
`;var mm=`
#ifdef USE_FOG
#ifdef FOG_EXP2
float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
#else
float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
#endif
gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif
`;var gm=`
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
`;var xm=`
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
`;var _m=`
#ifdef USE_LIGHTMAP
uniform sampler2D lightMap;
uniform float lightMapIntensity;
#endif
`;var vm=`
LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;
`;var Mm=`
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
`;var Sm=`
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
`;var ym=`
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
`;var bm=`
ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;
`;var wm=`
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
`;var Em=`
BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;
`;var Tm=`
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
`;var Am=`
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
`;var Rm=`
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
`;var Cm=`
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
`;var Pm=`
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
`;var Lm=`
#if defined( RE_IndirectDiffuse )
#if defined( LAMBERT ) || defined( PHONG )
irradiance += iblIrradiance;
#endif
RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
`;var Dm=`
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
`;var Nm=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif
`;var Im=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
uniform float logDepthBufFC;
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var Um=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var Fm=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
vFragDepth = 1.0 + gl_Position.w;
vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif
`;var Om=`
#ifdef USE_MAP
vec4 sampledDiffuseColor = texture2D( map, vMapUv );
#ifdef DECODE_VIDEO_TEXTURE
sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
#endif
diffuseColor *= sampledDiffuseColor;
#endif
`;var Bm=`
#ifdef USE_MAP
uniform sampler2D map;
#endif
`;var km=`
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
`;var zm=`
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
`;var Gm=`
float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
metalnessFactor *= texelMetalness.b;
#endif
`;var Hm=`
#ifdef USE_METALNESSMAP
uniform sampler2D metalnessMap;
#endif
`;var Vm=`
#ifdef USE_INSTANCING_MORPH
float morphTargetInfluences[ MORPHTARGETS_COUNT ];
float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
}
#endif
`;var Wm=`
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
`;var Xm=`
#ifdef USE_MORPHNORMALS
objectNormal *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var qm=`
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
`;var Ym=`
#ifdef USE_MORPHTARGETS
transformed *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var $m=`
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
`;var Km=`
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
`;var Zm=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var Jm=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var Qm=`
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
`;var jm=`
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
`;var eg=`
#ifdef USE_CLEARCOAT
vec3 clearcoatNormal = nonPerturbedNormal;
#endif
`;var tg=`
#ifdef USE_CLEARCOAT_NORMALMAP
vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
clearcoatMapN.xy *= clearcoatNormalScale;
clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif
`;var ig=`
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
`;var ng=`
#ifdef USE_IRIDESCENCEMAP
uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform sampler2D iridescenceThicknessMap;
#endif
`;var rg=`
#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );
`;var sg=`
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
`;var og=`
#ifdef PREMULTIPLIED_ALPHA
gl_FragColor.rgb *= gl_FragColor.a;
#endif
`;var ag=`
vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;
`;var lg=`
#ifdef DITHERING
gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif
`;var cg=`
#ifdef DITHERING
vec3 dithering( vec3 color ) {
float grid_position = rand( gl_FragCoord.xy );
vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
return color + dither_shift_RGB;
}
#endif
`;var hg=`
float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
roughnessFactor *= texelRoughness.g;
#endif
`;var fg=`
#ifdef USE_ROUGHNESSMAP
uniform sampler2D roughnessMap;
#endif
`;var ug=`
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
`;var dg=`
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
`;var pg=`
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
`;var mg=`
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
`;var gg=`
#ifdef USE_SKINNING
mat4 boneMatX = getBoneMatrix( skinIndex.x );
mat4 boneMatY = getBoneMatrix( skinIndex.y );
mat4 boneMatZ = getBoneMatrix( skinIndex.z );
mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif
`;var xg=`
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
`;var _g=`
#ifdef USE_SKINNING
vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
vec4 skinned = vec4( 0.0 );
skinned += boneMatX * skinVertex * skinWeight.x;
skinned += boneMatY * skinVertex * skinWeight.y;
skinned += boneMatZ * skinVertex * skinWeight.z;
skinned += boneMatW * skinVertex * skinWeight.w;
transformed = ( bindMatrixInverse * skinned ).xyz;
#endif
`;var vg=`
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
`;var Mg=`
float specularStrength;
#ifdef USE_SPECULARMAP
vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
specularStrength = texelSpecular.r;
#else
specularStrength = 1.0;
#endif
`;var Sg=`
#ifdef USE_SPECULARMAP
uniform sampler2D specularMap;
#endif
`;var yg=`
#if defined( TONE_MAPPING )
gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif
`;var bg=`
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
`;var wg=`
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
`;var Eg=`
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
`;var Tg=`
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
`;var Ag=`
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
`;var Rg=`
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
`;var Cg=`
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
`;var Pg=`
varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
gl_Position = vec4( position.xy, 1.0, 1.0 );
}
`,Lg=`
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
`;var Dg=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,Ng=`
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
`;var Ig=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,Ug=`
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
`;var Fg=`
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
`,Og=`
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
`;var Bg=`
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
`,kg=`
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
`;var zg=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
}
`,Gg=`
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
`;var Hg=`
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
`,Vg=`
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
`;var Wg=`
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
`,Xg=`
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
`;var qg=`
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
`,Yg=`
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
`;var $g=`
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
`,Kg=`
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
`;var Zg=`
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
`,Jg=`
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
`;var Qg=`
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
`,jg=`
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
`;var e0=`
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
`,t0=`
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
`;var i0=`
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
`,n0=`
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
`;var r0=`
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
`,s0=`
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
`;var o0=`
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
`,a0=`
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
`;var l0=`
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
`,c0=`
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
`;var at={alphahash_fragment:Lp,alphahash_pars_fragment:Dp,alphamap_fragment:Np,alphamap_pars_fragment:Ip,alphatest_fragment:Up,alphatest_pars_fragment:Fp,aomap_fragment:Op,aomap_pars_fragment:Bp,batching_pars_vertex:kp,batching_vertex:zp,begin_vertex:Gp,beginnormal_vertex:Hp,bsdfs:Vp,iridescence_fragment:Wp,bumpmap_pars_fragment:Xp,clipping_planes_fragment:qp,clipping_planes_pars_fragment:Yp,clipping_planes_pars_vertex:$p,clipping_planes_vertex:Kp,color_fragment:Zp,color_pars_fragment:Jp,color_pars_vertex:Qp,color_vertex:jp,common:em,defaultnormal_vertex:tm,displacementmap_pars_vertex:im,displacementmap_vertex:nm,emissivemap_fragment:rm,emissivemap_pars_fragment:sm,colorspace_fragment:om,colorspace_pars_fragment:am,envmap_fragment:lm,envmap_common_pars_fragment:cm,envmap_pars_fragment:hm,envmap_pars_vertex:fm,envmap_physical_pars_fragment:ym,envmap_vertex:um,fog_vertex:dm,fog_pars_vertex:pm,fog_fragment:mm,fog_pars_fragment:gm,gradientmap_pars_fragment:xm,lightmap_pars_fragment:_m,lights_lambert_fragment:vm,lights_lambert_pars_fragment:Mm,lights_pars_begin:Sm,lights_toon_fragment:bm,lights_toon_pars_fragment:wm,lights_phong_fragment:Em,lights_phong_pars_fragment:Tm,lights_physical_fragment:Am,lights_physical_pars_fragment:Rm,lights_fragment_begin:Cm,lights_fragment_maps:Pm,lights_fragment_end:Lm,lightprobes_pars_fragment:Dm,logdepthbuf_fragment:Nm,logdepthbuf_pars_fragment:Im,logdepthbuf_pars_vertex:Um,logdepthbuf_vertex:Fm,map_fragment:Om,map_pars_fragment:Bm,map_particle_fragment:km,map_particle_pars_fragment:zm,metalnessmap_fragment:Gm,metalnessmap_pars_fragment:Hm,morphinstance_vertex:Vm,morphcolor_vertex:Wm,morphnormal_vertex:Xm,morphtarget_pars_vertex:qm,morphtarget_vertex:Ym,normal_fragment_begin:$m,normal_fragment_maps:Km,normal_pars_fragment:Zm,normal_pars_vertex:Jm,normal_vertex:Qm,normalmap_pars_fragment:jm,clearcoat_normal_fragment_begin:eg,clearcoat_normal_fragment_maps:tg,clearcoat_pars_fragment:ig,iridescence_pars_fragment:ng,opaque_fragment:rg,packing:sg,premultiplied_alpha_fragment:og,project_vertex:ag,dithering_fragment:lg,dithering_pars_fragment:cg,roughnessmap_fragment:hg,roughnessmap_pars_fragment:fg,shadowmap_pars_fragment:ug,shadowmap_pars_vertex:dg,shadowmap_vertex:pg,shadowmask_pars_fragment:mg,skinbase_vertex:gg,skinning_pars_vertex:xg,skinning_vertex:_g,skinnormal_vertex:vg,specularmap_fragment:Mg,specularmap_pars_fragment:Sg,tonemapping_fragment:yg,tonemapping_pars_fragment:bg,transmission_fragment:wg,transmission_pars_fragment:Eg,uv_pars_fragment:Tg,uv_pars_vertex:Ag,uv_vertex:Rg,worldpos_vertex:Cg,background_vert:Pg,background_frag:Lg,backgroundCube_vert:Dg,backgroundCube_frag:Ng,cube_vert:Ig,cube_frag:Ug,depth_vert:Fg,depth_frag:Og,distance_vert:Bg,distance_frag:kg,equirect_vert:zg,equirect_frag:Gg,linedashed_vert:Hg,linedashed_frag:Vg,meshbasic_vert:Wg,meshbasic_frag:Xg,meshlambert_vert:qg,meshlambert_frag:Yg,meshmatcap_vert:$g,meshmatcap_frag:Kg,meshnormal_vert:Zg,meshnormal_frag:Jg,meshphong_vert:Qg,meshphong_frag:jg,meshphysical_vert:e0,meshphysical_frag:t0,meshtoon_vert:i0,meshtoon_frag:n0,points_vert:r0,points_frag:s0,shadow_vert:o0,shadow_frag:a0,sprite_vert:l0,sprite_frag:c0};var De={common:{diffuse:{value:new Xe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new $e},alphaMap:{value:null},alphaMapTransform:{value:new $e},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new $e}},envmap:{envMap:{value:null},envMapRotation:{value:new $e},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new $e}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new $e}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new $e},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new $e},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new $e},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new $e}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new $e}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new $e}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Xe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Xe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new $e},alphaTest:{value:0},uvTransform:{value:new $e}},sprite:{diffuse:{value:new Xe(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new $e},alphaMap:{value:null},alphaMapTransform:{value:new $e},alphaTest:{value:0}}};var Nn={basic:{uniforms:$i([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:at.meshbasic_vert,fragmentShader:at.meshbasic_frag},lambert:{uniforms:$i([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new Xe(0)},envMapIntensity:{value:1}}]),vertexShader:at.meshlambert_vert,fragmentShader:at.meshlambert_frag},phong:{uniforms:$i([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new Xe(0)},specular:{value:new Xe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:at.meshphong_vert,fragmentShader:at.meshphong_frag},standard:{uniforms:$i([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new Xe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag},toon:{uniforms:$i([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new Xe(0)}}]),vertexShader:at.meshtoon_vert,fragmentShader:at.meshtoon_frag},matcap:{uniforms:$i([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:at.meshmatcap_vert,fragmentShader:at.meshmatcap_frag},points:{uniforms:$i([De.points,De.fog]),vertexShader:at.points_vert,fragmentShader:at.points_frag},dashed:{uniforms:$i([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:at.linedashed_vert,fragmentShader:at.linedashed_frag},depth:{uniforms:$i([De.common,De.displacementmap]),vertexShader:at.depth_vert,fragmentShader:at.depth_frag},normal:{uniforms:$i([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:at.meshnormal_vert,fragmentShader:at.meshnormal_frag},sprite:{uniforms:$i([De.sprite,De.fog]),vertexShader:at.sprite_vert,fragmentShader:at.sprite_frag},background:{uniforms:{uvTransform:{value:new $e},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:at.background_vert,fragmentShader:at.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new $e}},vertexShader:at.backgroundCube_vert,fragmentShader:at.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:at.cube_vert,fragmentShader:at.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:at.equirect_vert,fragmentShader:at.equirect_frag},distance:{uniforms:$i([De.common,De.displacementmap,{referencePosition:{value:new N},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:at.distance_vert,fragmentShader:at.distance_frag},shadow:{uniforms:$i([De.lights,De.fog,{color:{value:new Xe(0)},opacity:{value:1}}]),vertexShader:at.shadow_vert,fragmentShader:at.shadow_frag}};Nn.physical={uniforms:$i([Nn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new $e},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new $e},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new $e},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new $e},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new $e},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new $e},sheen:{value:0},sheenColor:{value:new Xe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new $e},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new $e},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new $e},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new $e},attenuationDistance:{value:0},attenuationColor:{value:new Xe(0)},specularColor:{value:new Xe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new $e},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new $e},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new $e}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag};var Lc={r:0,b:0,g:0},HM=new Le,h0=new $e;h0.set(-1,0,0,0,1,0,0,0,1);function f0(n,e,t,i,r,s){let o=new Xe(0),a=r===!0?0:1,c,l,h=null,f=0,u=null;function p(x){let w=x.isScene===!0?x.background:null;if(w&&w.isTexture){let S=x.backgroundBlurriness>0;w=e.get(w,S)}return w}function g(x){let w=!1,S=p(x);S===null?m(o,a):S&&S.isColor&&(m(S,1),w=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,s):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||w)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function M(x,w){let S=p(w);S&&S.isCubeTexture?(l===void 0&&(l=new St(new or(1,1,1),new tn({name:"BackgroundCubeMaterial",uniforms:Ar(Nn.backgroundCube.uniforms),vertexShader:Nn.backgroundCube.vertexShader,fragmentShader:Nn.backgroundCube.fragmentShader,side:jt,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(R,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=S,l.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(HM.makeRotationFromEuler(w.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(h0),l.material.toneMapped=ot.getTransfer(S.colorSpace)!==_t,(h!==S||f!==S.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=S,f=S.version,u=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null)):S&&S.isTexture&&(c===void 0&&(c=new St(new wo(2,2),new tn({name:"BackgroundMaterial",uniforms:Ar(Nn.background.uniforms),vertexShader:Nn.background.vertexShader,fragmentShader:Nn.background.fragmentShader,side:sn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=S,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.toneMapped=ot.getTransfer(S.colorSpace)!==_t,S.matrixAutoUpdate===!0&&S.updateMatrix(),c.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||f!==S.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=S,f=S.version,u=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null))}function m(x,w){x.getRGB(Lc,Sc(n)),t.buffers.color.setClear(Lc.r,Lc.g,Lc.b,w,s)}function d(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,w=1){o.set(x),a=w,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:g,addToRenderList:M,dispose:d}}function u0(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=u(null),s=r,o=!1;function a(D,k,G,U,W){let Y=!1,V=f(D,U,G,k);s!==V&&(s=V,l(s.object)),Y=p(D,U,G,W),Y&&g(D,U,G,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(D,k,G,U),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function c(){return n.createVertexArray()}function l(D){return n.bindVertexArray(D)}function h(D){return n.deleteVertexArray(D)}function f(D,k,G,U){let W=U.wireframe===!0,Y=i[k.id];Y===void 0&&(Y={},i[k.id]=Y);let V=D.isInstancedMesh===!0?D.id:0,ce=Y[V];ce===void 0&&(ce={},Y[V]=ce);let Z=ce[G.id];Z===void 0&&(Z={},ce[G.id]=Z);let j=Z[W];return j===void 0&&(j=u(c()),Z[W]=j),j}function u(D){let k=[],G=[],U=[];for(let W=0;W<t;W++)k[W]=0,G[W]=0,U[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:G,attributeDivisors:U,object:D,attributes:{},index:null}}function p(D,k,G,U){let W=s.attributes,Y=k.attributes,V=0,ce=G.getAttributes();for(let Z in ce)if(ce[Z].location>=0){let re=W[Z],ue=Y[Z];if(ue===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(ue=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(ue=D.instanceColor)),re===void 0||re.attribute!==ue||ue&&re.data!==ue.data)return!0;V++}return s.attributesNum!==V||s.index!==U}function g(D,k,G,U){let W={},Y=k.attributes,V=0,ce=G.getAttributes();for(let Z in ce)if(ce[Z].location>=0){let re=Y[Z];re===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(re=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(re=D.instanceColor));let ue={};ue.attribute=re,re&&re.data&&(ue.data=re.data),W[Z]=ue,V++}s.attributes=W,s.attributesNum=V,s.index=U}function M(){let D=s.newAttributes;for(let k=0,G=D.length;k<G;k++)D[k]=0}function m(D){d(D,0)}function d(D,k){let G=s.newAttributes,U=s.enabledAttributes,W=s.attributeDivisors;G[D]=1,U[D]===0&&(n.enableVertexAttribArray(D),U[D]=1),W[D]!==k&&(n.vertexAttribDivisor(D,k),W[D]=k)}function x(){let D=s.newAttributes,k=s.enabledAttributes;for(let G=0,U=k.length;G<U;G++)k[G]!==D[G]&&(n.disableVertexAttribArray(G),k[G]=0)}function w(D,k,G,U,W,Y,V){V===!0?n.vertexAttribIPointer(D,k,G,W,Y):n.vertexAttribPointer(D,k,G,U,W,Y)}function S(D,k,G,U){M();let W=U.attributes,Y=G.getAttributes(),V=k.defaultAttributeValues;for(let ce in Y){let Z=Y[ce];if(Z.location>=0){let j=W[ce];if(j===void 0&&(ce==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),ce==="instanceColor"&&D.instanceColor&&(j=D.instanceColor)),j!==void 0){let re=j.normalized,ue=j.itemSize,fe=e.get(j);if(fe===void 0)continue;let ee=fe.buffer,me=fe.type,_e=fe.bytesPerElement,Ae=me===n.INT||me===n.UNSIGNED_INT||j.gpuType===Vs;if(j.isInterleavedBufferAttribute){let ye=j.data,qe=ye.isInterleavedBuffer===!0?ye.stride:ye.itemSize,rt=j.offset;if(ye.isInstancedInterleavedBuffer||ye.isInstancedBufferAttribute){for(let Ve=0;Ve<Z.locationSize;Ve++)d(Z.location+Ve,ye.meshPerAttribute);D.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=ye.meshPerAttribute*ye.count)}else for(let Ve=0;Ve<Z.locationSize;Ve++)m(Z.location+Ve);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ve=0;Ve<Z.locationSize;Ve++)w(Z.location+Ve,ue/Z.locationSize,me,re,qe*_e,(rt+ue/Z.locationSize*Ve)*_e,Ae)}else{if(j.isInstancedBufferAttribute){for(let ye=0;ye<Z.locationSize;ye++)d(Z.location+ye,j.meshPerAttribute);D.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let ye=0;ye<Z.locationSize;ye++)m(Z.location+ye);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let ye=0;ye<Z.locationSize;ye++)w(Z.location+ye,ue/Z.locationSize,me,re,ue*_e,ue/Z.locationSize*ye*_e,Ae)}}else if(V!==void 0){let re=V[ce];if(re!==void 0)switch(re.length){case 2:n.vertexAttrib2fv(Z.location,re);break;case 3:n.vertexAttrib3fv(Z.location,re);break;case 4:n.vertexAttrib4fv(Z.location,re);break;default:n.vertexAttrib1fv(Z.location,re)}}}}x()}function R(){F();for(let D in i){let k=i[D];for(let G in k){let U=k[G];for(let W in U){let Y=U[W];for(let V in Y)h(Y[V].object),delete Y[V];delete U[W]}}delete i[D]}}function A(D){if(i[D.id]===void 0)return;let k=i[D.id];for(let G in k){let U=k[G];for(let W in U){let Y=U[W];for(let V in Y)h(Y[V].object),delete Y[V];delete U[W]}}delete i[D.id]}function _(D){for(let k in i){let G=i[k];for(let U in G){let W=G[U];if(W[D.id]===void 0)continue;let Y=W[D.id];for(let V in Y)h(Y[V].object),delete Y[V];delete W[D.id]}}}function b(D){for(let k in i){let G=i[k],U=D.isInstancedMesh===!0?D.id:0,W=G[U];if(W!==void 0){for(let Y in W){let V=W[Y];for(let ce in V)h(V[ce].object),delete V[ce];delete W[Y]}delete G[U],Object.keys(G).length===0&&delete i[k]}}}function F(){L(),o=!0,s!==r&&(s=r,l(s.object))}function L(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:F,resetDefaultState:L,dispose:R,releaseStatesOfGeometry:A,releaseStatesOfObject:b,releaseStatesOfProgram:_,initAttributes:M,enableAttribute:m,disableUnusedAttributes:x}}function d0(n,e,t){let i;function r(c){i=c}function s(c,l){n.drawArrays(i,c,l),t.update(l,i,1)}function o(c,l,h){h!==0&&(n.drawArraysInstanced(i,c,l,h),t.update(l,i,h))}function a(c,l,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,h);let u=0;for(let p=0;p<h;p++)u+=l[p];t.update(u,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function p0(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(_){return!(_!==Fi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let b=_===Ui&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==fi&&_!==ui&&!b&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp",h=c(l);h!==l&&(Ge("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Ge("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Ge("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),d=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:u,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:g,maxTextureSize:M,maxCubemapSize:m,maxAttributes:d,maxVertexUniforms:x,maxVaryings:w,maxFragmentUniforms:S,maxSamples:R,samples:A}}function m0(n){let e=this,t=null,i=0,r=!1,s=!1,o=new Yi,a=new $e,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,u){let p=f.length!==0||u||i!==0||r;return r=u,i=f.length,p},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(f,u){t=h(f,u,0)},this.setState=function(f,u,p){let g=f.clippingPlanes,M=f.clipIntersection,m=f.clipShadows,d=n.get(f);if(!r||g===null||g.length===0||s&&!m)s?h(null):l();else{let x=s?0:i,w=x*4,S=d.clippingState||null;c.value=S,S=h(g,u,w,p);for(let R=0;R!==w;++R)S[R]=t[R];d.clippingState=S,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=x}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(f,u,p,g){let M=f!==null?f.length:0,m=null;if(M!==0){if(m=c.value,g!==!0||m===null){let d=p+M*4,x=u.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<d)&&(m=new Float32Array(d));for(let w=0,S=p;w!==M;++w,S+=4)o.copy(f[w]).applyMatrix4(x,a),o.normal.toArray(m,S),m[S+3]=o.constant}c.value=m,c.needsUpdate=!0}return e.numPlanes=M,e.numIntersection=0,m}}var Qr=class extends Hi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new Mo(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new or(5,5,5),s=new tn({name:"CubemapFromEquirect",uniforms:Ar(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:jt,blending:ir});s.uniforms.tEquirect.value=t;let o=new St(r,s),a=t.minFilter;return t.minFilter===gn&&(t.minFilter=Mi),new xs(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}};var g0=256,VM=3,WM=20,M0=256,S0=16,XM=3,qM=new N,YM=new Xe,ja=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new xs(1,10,null),this._boxMesh=new St(new or(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=qM}=s,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let f=c.autoClear,u=c.autoClearColor,p=c.autoClearDepth,g=c.autoClearStencil,M=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,M===null&&(e.background=c.getClearColor(YM));let m=new xs(i,r,h);return m.position.copy(a),m.update(c,e),c.autoClear=f,c.autoClearColor=u,c.autoClearDepth=p,c.autoClearStencil=g,e.background=M,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,t)),this._applyPMREM(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=v0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=_0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(g0,Qd(e))}_fromTexture(e,t){e.mapping===nr||e.mapping===Hr?this._setSize(e.image.length===0?g0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=x0(e,!1,!1),i=Math.log2(e)-VM;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=x0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===nr||e.mapping===Hr?(this._cubemapMaterial===null&&(this._cubemapMaterial=v0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=_0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=$M(),this._integrationMaterial=KM());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/S0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-XM)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let c=a>0?Math.log2(t)+.5*Math.log2(6/(M0*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=ZM());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function x0(n,e,t){return new Qr(n,{minFilter:gn,generateMipmaps:e,type:Ui,colorSpace:cs,depthBuffer:t})}function el(n,e,t){return new tn({name:n,uniforms:e,vertexShader:at.cube_vert,fragmentShader:t,side:jt,blending:ir,depthTest:!1,depthWrite:!1})}function $M(){return el("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${M0}u

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
	`)}function KM(){return el("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:S0}},`

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
	`)}function ZM(){return el("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${WM}
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
	`)}function _0(){return el("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function v0(){return el("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function y0(n){let e=new WeakMap,t=new WeakMap,i=null;function r(u,p=!1){return u==null?null:p?o(u):s(u)}function s(u){if(u&&u.isTexture){let p=u.mapping;if(p===Fl||p===Ol)if(e.has(u)){let g=e.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let M=new Qr(g.height);return M.fromEquirectangularTexture(n,u),e.set(u,M),u.addEventListener("dispose",l),a(M.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let p=u.mapping,g=p===Fl||p===Ol,M=p===nr||p===Hr;if(g||M){let m=t.get(u),d=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==d)return i===null&&(i=new ja(n)),m=g?i.fromEquirectangular(u,m):i.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),m.texture;if(m!==void 0)return m.texture;{let x=u.image;return g&&x&&x.height>0||M&&x&&c(x)?(i===null&&(i=new ja(n)),m=g?i.fromEquirectangular(u):i.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function a(u,p){return p===Fl?u.mapping=nr:p===Ol&&(u.mapping=Hr),u}function c(u){let p=0,g=6;for(let M=0;M<g;M++)u[M]!==void 0&&p++;return p===g}function l(u){let p=u.target;p.removeEventListener("dispose",l);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function h(u){let p=u.target;p.removeEventListener("dispose",h);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:f}}function b0(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&fs("WebGLRenderer: "+i+" extension not supported."),r}}}function w0(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(g=>delete r[g]);function a(g){c(g.target)}function c(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete r[g.id],o.unregister(g);let M=s.get(g);M&&(e.remove(M),s.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function l(g,M){return r[M.id]!==void 0||(M.addEventListener("dispose",a),r[M.id]=new WeakRef(M),o.register(M,M.id,M),t.memory.geometries++),M}function h(g){let M=g.attributes;for(let m in M)e.update(M[m],n.ARRAY_BUFFER)}function f(g){let M=g.index,m=g.attributes.position,d=0;if(m===void 0)return;let x=M!==null?M.array.length:m.array.length/3-1,w=m.count>=65535?go:mo,S=new w(Math.ceil(x/3)*6,1),R=S.array;if(M!==null){let _=M.array;d=M.version;for(let b=0,F=0;b<x;b+=3){let L=_[b+0],D=_[b+1],k=_[b+2];R[F++]=L,R[F++]=D,R[F++]=D,R[F++]=k,R[F++]=k,R[F++]=L}}else{d=m.version;for(let _=0,b=0;_<x;_+=3){let F=_+0,L=_+1,D=_+2;R[b++]=F,R[b++]=L,R[b++]=L,R[b++]=D,R[b++]=D,R[b++]=F}}S.version=d;let A=s.get(g);A&&e.remove(A),s.set(g,S)}function u(g){let M=s.get(g);if(M){let m=g.index;m!==null&&M.version<m.version&&f(g)}else f(g);return s.get(g)}function p(){for(let g in r){let M=r[g].deref();M!==void 0&&c(M)}}return{get:l,update:h,getWireframeAttribute:u,dispose:p}}function E0(n,e,t){let i;function r(f){i=f}let s,o;function a(f){s=f.type,o=f.bytesPerElement}function c(f,u){n.drawElements(i,u,s,f*o),t.update(u,i,1)}function l(f,u,p){p!==0&&(n.drawElementsInstanced(i,u,s,f*o,p),t.update(u,i,p))}function h(f,u,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,s,f,0,p);let M=0;for(let m=0;m<p;m++)M+=u[m];t.update(M,i,1)}this.setMode=r,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function T0(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:ut("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function A0(n,e,t){let i=new WeakMap,r=new bt;function s(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=h!==void 0?h.length:0,u=i.get(a);if(u===void 0||u.count!==f){let F=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",F)};u!==void 0&&u.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,M=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],w=0;p===!0&&(w=1),g===!0&&(w=2),M===!0&&(w=3);let S=a.attributes.position.count*w,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let A=new Float32Array(S*R*4*f),_=new no(A,S,R,f);_.type=ui,_.needsUpdate=!0;let b=w*4;for(let L=0;L<f;L++){let D=m[L],k=d[L],G=x[L],U=S*R*4*L;for(let W=0;W<D.count;W++){let Y=W*b;p===!0&&(r.fromBufferAttribute(D,W),A[U+Y+0]=r.x,A[U+Y+1]=r.y,A[U+Y+2]=r.z,A[U+Y+3]=0),g===!0&&(r.fromBufferAttribute(k,W),A[U+Y+4]=r.x,A[U+Y+5]=r.y,A[U+Y+6]=r.z,A[U+Y+7]=0),M===!0&&(r.fromBufferAttribute(G,W),A[U+Y+8]=r.x,A[U+Y+9]=r.y,A[U+Y+10]=r.z,A[U+Y+11]=G.itemSize===4?r.w:1)}}u={count:f,texture:_,size:new Ke(S,R)},i.set(a,u),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let M=0;M<l.length;M++)p+=l[M];let g=a.morphTargetsRelative?1:1-p;c.getUniforms().setValue(n,"morphTargetBaseInfluence",g),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",u.texture,t),c.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:s}}function R0(n,e,t,i,r){let s=new WeakMap;function o(l){let h=r.render.frame,f=l.geometry,u=e.get(l,f);if(s.get(u)!==h&&(e.update(u),s.set(u,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),s.get(l)!==h&&(t.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,h))),l.isSkinnedMesh){let p=l.skeleton;s.get(p)!==h&&(p.update(),s.set(p,h))}return u}function a(){s=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var JM={[Cl]:"LINEAR_TONE_MAPPING",[Pl]:"REINHARD_TONE_MAPPING",[Ll]:"CINEON_TONE_MAPPING",[Dl]:"ACES_FILMIC_TONE_MAPPING",[Il]:"AGX_TONE_MAPPING",[Ul]:"NEUTRAL_TONE_MAPPING",[Nl]:"CUSTOM_TONE_MAPPING"};function C0(n,e,t,i,r,s){let o=new Hi(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new Ot;h.setAttribute("position",new Gt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Gt([0,2,0,0,2,0],2));let f=new yc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new St(h,f),p=new Ro(-1,1,1,-1,0,1),g=null,M=null,m=!1,d,x=null,w=[],S=!1;this.setSize=function(R,A){o.setSize(R,A),a!==null&&a.setSize(R,A),c!==null&&c.setSize(R,A);for(let _=0;_<w.length;_++){let b=w[_];b.setSize&&b.setSize(R,A)}},this.setEffects=function(R){w=R,S=w.length>0&&w[0].isRenderPass===!0;let A=o.width,_=o.height;w.length>0&&a===null&&(a=new Hi(A,_,{type:Ui,depthBuffer:!1,stencilBuffer:!1}),c=new Hi(A,_,{type:Ui,depthBuffer:!1,stencilBuffer:!1}));let b=r===!0&&w.some(F=>F.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&l===null&&(l=new yn(A,_),s===!0&&(l.format=xn,l.type=zn)),o.dispose(),o.depthTexture=b?l:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let F=0;F<w.length;F++){let L=w[F];L.setSize&&L.setSize(A,_),b&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(l)}},this.begin=function(R,A){if(m||R.toneMapping===mn&&w.length===0)return!1;if(x=A,A!==null){let _=A.width,b=A.height;(o.width!==_||o.height!==b)&&this.setSize(_,b)}return S===!1&&R.setRenderTarget(o),d=R.toneMapping,R.toneMapping=mn,!0},this.hasRenderPass=function(){return S},this.end=function(R,A){R.toneMapping=d,m=!0;let _=o,b=a;for(let F=0;F<w.length;F++){let L=w[F];L.enabled!==!1&&(L.render(R,b,_,A),L.needsSwap!==!1&&(_=b,b=b===a?c:a))}if(g!==R.outputColorSpace||M!==R.toneMapping){g=R.outputColorSpace,M=R.toneMapping,f.defines={},ot.getTransfer(g)===_t&&(f.defines.SRGB_TRANSFER="");let F=JM[M];F&&(f.defines[F]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(x),R.render(u,p),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),f.dispose()}}var F0=new di,O0=new yn(1,1),B0=new So(1),k0=new no,z0=new ec,G0=new Mo,P0=[],L0=[],D0=new Float32Array(16),N0=new Float32Array(9),I0=new Float32Array(4);function Lo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=P0[r];if(s===void 0&&(s=new Float32Array(r),P0[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function Ei(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Ti(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Dc(n,e){let t=L0[e];t===void 0&&(t=new Int32Array(e),L0[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function QM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function jM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ei(t,e))return;n.uniform2fv(this.addr,e),Ti(t,e)}}function eS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ei(t,e))return;n.uniform3fv(this.addr,e),Ti(t,e)}}function tS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ei(t,e))return;n.uniform4fv(this.addr,e),Ti(t,e)}}function iS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ei(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Ti(t,e)}else{if(Ei(t,i))return;I0.set(i),n.uniformMatrix2fv(this.addr,!1,I0),Ti(t,i)}}function nS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ei(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Ti(t,e)}else{if(Ei(t,i))return;N0.set(i),n.uniformMatrix3fv(this.addr,!1,N0),Ti(t,i)}}function rS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ei(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Ti(t,e)}else{if(Ei(t,i))return;D0.set(i),n.uniformMatrix4fv(this.addr,!1,D0),Ti(t,i)}}function sS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function oS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ei(t,e))return;n.uniform2iv(this.addr,e),Ti(t,e)}}function aS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ei(t,e))return;n.uniform3iv(this.addr,e),Ti(t,e)}}function lS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ei(t,e))return;n.uniform4iv(this.addr,e),Ti(t,e)}}function cS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function hS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ei(t,e))return;n.uniform2uiv(this.addr,e),Ti(t,e)}}function fS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ei(t,e))return;n.uniform3uiv(this.addr,e),Ti(t,e)}}function uS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ei(t,e))return;n.uniform4uiv(this.addr,e),Ti(t,e)}}function Nc(n){return n.version===0&&(n.compareFunction=$l,n.needsUpdate=!0),n}function dS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=Nc(O0):s=F0,t.setTexture2D(e||s,r)}function pS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||z0,r)}function mS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=Nc(B0):s=G0,t.setTextureCube(e||s,r)}function gS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||k0,r)}function xS(n){switch(n){case 5126:return QM;case 35664:return jM;case 35665:return eS;case 35666:return tS;case 35674:return iS;case 35675:return nS;case 35676:return rS;case 5124:case 35670:return sS;case 35667:case 35671:return oS;case 35668:case 35672:return aS;case 35669:case 35673:return lS;case 5125:return cS;case 36294:return hS;case 36295:return fS;case 36296:return uS;case 35678:case 36198:case 36298:case 36306:case 35682:return dS;case 35679:case 36299:case 36307:return pS;case 35680:case 36300:case 36308:case 36293:return mS;case 36289:case 36303:case 36311:case 36292:return gS}}function _S(n,e){n.uniform1fv(this.addr,e)}function vS(n,e){let t=Lo(e,this.size,2);n.uniform2fv(this.addr,t)}function MS(n,e){let t=Lo(e,this.size,3);n.uniform3fv(this.addr,t)}function SS(n,e){let t=Lo(e,this.size,4);n.uniform4fv(this.addr,t)}function yS(n,e){let t=Lo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function bS(n,e){let t=Lo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function wS(n,e){let t=Lo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function ES(n,e){n.uniform1iv(this.addr,e)}function TS(n,e){n.uniform2iv(this.addr,e)}function AS(n,e){n.uniform3iv(this.addr,e)}function RS(n,e){n.uniform4iv(this.addr,e)}function CS(n,e){n.uniform1uiv(this.addr,e)}function PS(n,e){n.uniform2uiv(this.addr,e)}function LS(n,e){n.uniform3uiv(this.addr,e)}function DS(n,e){n.uniform4uiv(this.addr,e)}function NS(n,e,t){let i=this.cache,r=e.length,s=Dc(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=Nc(O0):o=F0;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function IS(n,e,t){let i=this.cache,r=e.length,s=Dc(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||z0,s[o])}function US(n,e,t){let i=this.cache,r=e.length,s=Dc(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Nc(B0):o=G0;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function FS(n,e,t){let i=this.cache,r=e.length,s=Dc(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||k0,s[o])}function OS(n){switch(n){case 5126:return _S;case 35664:return vS;case 35665:return MS;case 35666:return SS;case 35674:return yS;case 35675:return bS;case 35676:return wS;case 5124:case 35670:return ES;case 35667:case 35671:return TS;case 35668:case 35672:return AS;case 35669:case 35673:return RS;case 5125:return CS;case 36294:return PS;case 36295:return LS;case 36296:return DS;case 35678:case 36198:case 36298:case 36306:case 35682:return NS;case 35679:case 36299:case 36307:return IS;case 35680:case 36300:case 36308:case 36293:return US;case 36289:case 36303:case 36311:case 36292:return FS}}var zf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=xS(t.type)}},Gf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=OS(t.type)}},Hf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},kf=/(\w+)(\])?(\[|\.)?/g;function U0(n,e){n.seq.push(e),n.map[e.id]=e}function BS(n,e,t){let i=n.name,r=i.length;for(kf.lastIndex=0;;){let s=kf.exec(i),o=kf.lastIndex,a=s[1],c=s[2]==="]",l=s[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===r){U0(t,l===void 0?new zf(a,n,e):new Gf(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new Hf(a),U0(t,f)),t=f}}}var jr=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),c=e.getUniformLocation(t,a.name);BS(a,c,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],c=i[a.id];c.needsUpdate!==!1&&a.setValue(e,c.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function Vf(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var kS=37297,zS=0;function GS(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var H0=new $e;function HS(n){ot._getMatrix(H0,ot.workingColorSpace,n);let e=`mat3( ${H0.elements.map(t=>t.toFixed(4))} )`;switch(ot.getTransfer(n)){case hs:return[e,"LinearTransferOETF"];case _t:return[e,"sRGBTransferOETF"];default:return Ge("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function V0(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+GS(n.getShaderSource(e),a)}else return s}function VS(n,e){let t=HS(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var WS={[Cl]:"Linear",[Pl]:"Reinhard",[Ll]:"Cineon",[Dl]:"ACESFilmic",[Il]:"AgX",[Ul]:"Neutral",[Nl]:"Custom"};function XS(n,e){let t=WS[e];return t===void 0?(Ge("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ic=new N;function qS(){ot.getLuminanceCoefficients(Ic);let n=Ic.x.toFixed(4),e=Ic.y.toFixed(4),t=Ic.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function YS(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(tl).join(`
`)}function $S(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function KS(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function tl(n){return n!==""}function W0(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function X0(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var ZS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Wf(n){return n.replace(ZS,JS)}function JS(n,e){let t=at[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Wf(t)}var QS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function q0(n){return n.replace(QS,jS)}function jS(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function Y0(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var ey={[Gs]:"SHADOWMAP_TYPE_PCF",[os]:"SHADOWMAP_TYPE_VSM"};function ty(n){return ey[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var iy={[Hr]:"ENVMAP_MODE_REFRACTION"};function ny(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":iy[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var ry={[Hs]:"ENVMAP_BLENDING_MULTIPLY",[Dd]:"ENVMAP_BLENDING_MIX",[Nd]:"ENVMAP_BLENDING_ADD"};function sy(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":ry[n.combine]||"ENVMAP_BLENDING_NONE"}function $0(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,c=ty(t),l=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=ny(t),f=sy(t),u=YS(t),p=$S(s),g=r.createProgram(),M,m,d=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(M=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(tl).join(`
`),M.length>0&&(M+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(tl).join(`
`),m.length>0&&(m+=`
`)):(M=[Y0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(tl).join(`
`),m=[Y0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+h:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==mn?"#define TONE_MAPPING":"",t.toneMapping!==mn?at.tonemapping_pars_fragment:"",t.toneMapping!==mn?XS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",at.colorspace_pars_fragment,VS("linearToOutputTexel",t.outputColorSpace),qS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(tl).join(`
`)),o=Wf(o),o=W0(o,t),o=X0(o,t),a=Wf(a),a=W0(a,t),a=X0(a,t),o=q0(o),a=q0(a),t.isRawShaderMaterial!==!0&&(d=`#version 300 es
`,M=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+M,m=["#define varying in",t.glslVersion===pf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===pf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=d+M+o,w=d+m+a,S=Vf(r,r.VERTEX_SHADER,x),R=Vf(r,r.FRAGMENT_SHADER,w);r.attachShader(g,S),r.attachShader(g,R),t.index0AttributeName!==void 0?r.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(g,0,"position"),r.linkProgram(g);function A(L){if(n.debug.checkShaderErrors){let D=r.getProgramInfoLog(g)||"",k=r.getShaderInfoLog(S)||"",G=r.getShaderInfoLog(R)||"",U=D.trim(),W=k.trim(),Y=G.trim(),V=!0,ce=!0;if(r.getProgramParameter(g,r.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,g,S,R);else{let Z=V0(r,S,"vertex"),j=V0(r,R,"fragment");ut("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(g,r.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+U+`
`+Z+`
`+j)}else U!==""?Ge("WebGLProgram: Program Info Log:",U):(W===""||Y==="")&&(ce=!1);ce&&(L.diagnostics={runnable:V,programLog:U,vertexShader:{log:W,prefix:M},fragmentShader:{log:Y,prefix:m}})}r.deleteShader(S),r.deleteShader(R),_=new jr(r,g),b=KS(r,g)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let b;this.getAttributes=function(){return b===void 0&&A(this),b};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=r.getProgramParameter(g,kS)),F},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=zS++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=R,this}var oy=0,Uc=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Xf(e),t.set(e,i)),i}},Xf=class{constructor(e){this.id=oy++,this.code=e,this.usedTimes=0}};function ay(n){return n===_n||n===as||n===ls}function K0(n,e,t,i,r,s){let o=new Xr,a=new Uc,c=new Set,l=[],h=new Map,f=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(_){return c.add(_),_===0?"uv":`uv${_}`}function g(_,b,F,L,D,k){let G=L.fog,U=D.geometry,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?L.environment:null,Y=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=e.get(_.envMap||W,Y),ce=u[_.type],Z=i.precision;_.precision!==null&&(Z=i.getMaxPrecision(_.precision),Z!==_.precision&&Ge("WebGLProgram.getParameters:",_.precision,"not supported, using",Z,"instead."));let j=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,re=j!==void 0?j.length:0,ue=0;U.morphAttributes.position!==void 0&&(ue=1),U.morphAttributes.normal!==void 0&&(ue=2),U.morphAttributes.color!==void 0&&(ue=3);let fe,ee,me,_e;if(ce){let Re=Nn[ce];fe=Re.vertexShader,ee=Re.fragmentShader}else{fe=_.vertexShader,ee=_.fragmentShader;let Re=a.getVertexShaderStage(_),lt=a.getFragmentShaderStage(_);a.update(_,Re,lt),me=Re.id,_e=lt.id}let Ae=n.getRenderTarget(),ye=n.state.buffers.depth.getReversed(),qe=D.isInstancedMesh===!0,rt=D.isBatchedMesh===!0,Ve=!!_.map,dt=!!_.matcap,ht=!!V,it=ht&&V.isPMREMTexture===!0,Yt=!!_.aoMap,zt=!!_.lightMap,pi=!!_.bumpMap&&_.wireframe===!1,Nt=!!_.normalMap,Ci=!!_.displacementMap,Mt=!!_.emissiveMap,bi=!!_.metalnessMap,ii=!!_.roughnessMap,mi=_.anisotropy>0,B=_.clearcoat>0,Ce=_.diffuseRoughness>0,Je=_.dispersion>0,st=_.retroreflectivity>0,be=_.iridescence>0,Ut=_.sheen>0,He=_.transmission>0,Ze=mi&&!!_.anisotropyMap,C=B&&!!_.clearcoatMap,y=B&&!!_.clearcoatNormalMap,X=B&&!!_.clearcoatRoughnessMap,he=Ce&&!!_.diffuseRoughnessMap,oe=be&&!!_.iridescenceMap,xe=be&&!!_.iridescenceThicknessMap,ve=Ut&&!!_.sheenColorMap,te=Ut&&!!_.sheenRoughnessMap,ne=!!_.specularMap,pe=!!_.specularColorMap,O=!!_.specularIntensityMap,se=He&&!!_.transmissionMap,ie=He&&!!_.thicknessMap,we=!!_.gradientMap,ge=!!_.alphaMap,Se=_.alphaTest>0,We=!!_.alphaHash,je=!!_.extensions,le=mn;_.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(le=n.toneMapping);let Be=it?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,et={shaderID:ce,shaderType:_.type,shaderName:_.name,vertexShader:fe,fragmentShader:ee,defines:_.defines,customVertexShaderID:me,customFragmentShaderID:_e,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:Z,batching:rt,batchingColor:rt&&D._colorsTexture!==null,instancing:qe,instancingColor:qe&&D.instanceColor!==null,instancingMorph:qe&&D.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:ot.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Ve,matcap:dt,envMap:ht,envMapMode:ht&&V.mapping,envMapPMREM:it,envMapMaxLod:it?Be.length-1:null,envMapSize:it?Be[0].width:null,aoMap:Yt,lightMap:zt,bumpMap:pi,normalMap:Nt,displacementMap:Ci,emissiveMap:Mt,normalMapObjectSpace:Nt&&_.normalMapType===Fd,normalMapTangentSpace:Nt&&_.normalMapType===Ga,packedNormalMap:Nt&&_.normalMapType===Ga&&ay(_.normalMap.format),metalnessMap:bi,roughnessMap:ii,anisotropy:mi,anisotropyMap:Ze,clearcoat:B,clearcoatMap:C,clearcoatNormalMap:y,clearcoatRoughnessMap:X,diffuseRoughness:Ce,diffuseRoughnessMap:he,dispersion:Je,retroreflection:st,iridescence:be,iridescenceMap:oe,iridescenceThicknessMap:xe,sheen:Ut,sheenColorMap:ve,sheenRoughnessMap:te,specularMap:ne,specularColorMap:pe,specularIntensityMap:O,transmission:He,transmissionMap:se,thicknessMap:ie,gradientMap:we,opaque:_.transparent===!1&&_.blending===kr&&_.alphaToCoverage===!1,alphaMap:ge,alphaTest:Se,alphaHash:We,combine:_.combine,mapUv:Ve&&p(_.map.channel),aoMapUv:Yt&&p(_.aoMap.channel),lightMapUv:zt&&p(_.lightMap.channel),bumpMapUv:pi&&p(_.bumpMap.channel),normalMapUv:Nt&&p(_.normalMap.channel),displacementMapUv:Ci&&p(_.displacementMap.channel),emissiveMapUv:Mt&&p(_.emissiveMap.channel),metalnessMapUv:bi&&p(_.metalnessMap.channel),roughnessMapUv:ii&&p(_.roughnessMap.channel),anisotropyMapUv:Ze&&p(_.anisotropyMap.channel),clearcoatMapUv:C&&p(_.clearcoatMap.channel),clearcoatNormalMapUv:y&&p(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&p(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&p(_.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&p(_.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&p(_.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&p(_.sheenColorMap.channel),sheenRoughnessMapUv:te&&p(_.sheenRoughnessMap.channel),specularMapUv:ne&&p(_.specularMap.channel),specularColorMapUv:pe&&p(_.specularColorMap.channel),specularIntensityMapUv:O&&p(_.specularIntensityMap.channel),transmissionMapUv:se&&p(_.transmissionMap.channel),thicknessMapUv:ie&&p(_.thicknessMap.channel),alphaMapUv:ge&&p(_.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Nt||mi),vertexNormals:!!U.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!U.attributes.uv&&(Ve||ge),fog:!!G,useFog:_.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||U.attributes.normal===void 0&&Nt===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:ye,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:re,morphTextureStride:ue,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:k.filter(Re=>Re.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&F.length>0,shadowMapType:n.shadowMap.type,toneMapping:le,decodeVideoTexture:Ve&&_.map.isVideoTexture===!0&&ot.getTransfer(_.map.colorSpace)===_t,decodeVideoTextureEmissive:Mt&&_.emissiveMap.isVideoTexture===!0&&ot.getTransfer(_.emissiveMap.colorSpace)===_t,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===zi,flipSided:_.side===jt,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:je&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&_.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return et.vertexUv1s=c.has(1),et.vertexUv2s=c.has(2),et.vertexUv3s=c.has(3),c.clear(),et}function M(_){let b=[];if(_.shaderID?b.push(_.shaderID):(b.push(_.customVertexShaderID),b.push(_.customFragmentShaderID)),_.defines!==void 0)for(let F in _.defines)b.push(F),b.push(_.defines[F]);return _.isRawShaderMaterial===!1&&(m(b,_),d(b,_),b.push(n.outputColorSpace)),b.push(_.customProgramCacheKey),b.join()}function m(_,b){_.push(b.precision),_.push(b.outputColorSpace),_.push(b.envMapMode),_.push(b.envMapPMREM),_.push(b.envMapMaxLod),_.push(b.envMapSize),_.push(b.mapUv),_.push(b.alphaMapUv),_.push(b.lightMapUv),_.push(b.aoMapUv),_.push(b.bumpMapUv),_.push(b.normalMapUv),_.push(b.displacementMapUv),_.push(b.emissiveMapUv),_.push(b.metalnessMapUv),_.push(b.roughnessMapUv),_.push(b.anisotropyMapUv),_.push(b.clearcoatMapUv),_.push(b.clearcoatNormalMapUv),_.push(b.clearcoatRoughnessMapUv),_.push(b.diffuseRoughnessMapUv),_.push(b.iridescenceMapUv),_.push(b.iridescenceThicknessMapUv),_.push(b.sheenColorMapUv),_.push(b.sheenRoughnessMapUv),_.push(b.specularMapUv),_.push(b.specularColorMapUv),_.push(b.specularIntensityMapUv),_.push(b.transmissionMapUv),_.push(b.thicknessMapUv),_.push(b.combine),_.push(b.fogExp2),_.push(b.sizeAttenuation),_.push(b.morphTargetsCount),_.push(b.numSunLights),_.push(b.numDirLights),_.push(b.numPointLights),_.push(b.numSpotLights),_.push(b.numSpotLightMaps),_.push(b.numHemiLights),_.push(b.numRectAreaLights),_.push(b.numSunLightShadows),_.push(b.numDirLightShadows),_.push(b.numPointLightShadows),_.push(b.numSpotLightShadows),_.push(b.numSpotLightShadowsWithMaps),_.push(b.numLightProbes),_.push(b.numLightProbeGrids),_.push(b.shadowMapType),_.push(b.toneMapping),_.push(b.numClippingPlanes),_.push(b.numClipIntersection),_.push(b.depthPacking)}function d(_,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function x(_){let b=u[_.type],F;if(b){let L=Nn[b];F=Sp.clone(L.uniforms)}else F=_.uniforms;return F}function w(_,b){let F=h.get(b);return F!==void 0?++F.usedTimes:(F=new $0(n,b,_,r),l.push(F),h.set(b,F)),F}function S(_){if(--_.usedTimes===0){let b=l.indexOf(_);l[b]=l[l.length-1],l.pop(),h.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:M,getUniforms:x,acquireProgram:w,releaseProgram:S,releaseShaderCache:R,programs:l,dispose:A}}function Z0(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,c){n.get(o)[a]=c}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function ly(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function J0(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Q0(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(u){let p=0;return u.isInstancedMesh&&(p+=2),u.isSkinnedMesh&&(p+=1),p}function a(u,p,g,M,m,d){let x=n[e];return x===void 0?(x={id:u.id,object:u,geometry:p,material:g,materialVariant:o(u),groupOrder:M,renderOrder:u.renderOrder,z:m,group:d},n[e]=x):(x.id=u.id,x.object=u,x.geometry=p,x.material=g,x.materialVariant=o(u),x.groupOrder=M,x.renderOrder=u.renderOrder,x.z=m,x.group=d),e++,x}function c(u,p,g,M,m,d,x){x.reversedDepth===!0&&(m=-m);let w=a(u,p,g,M,m,d);g.transmission>0?i.push(w):g.transparent===!0?r.push(w):t.push(w)}function l(u,p,g,M,m,d){let x=a(u,p,g,M,m,d);g.transmission>0?i.unshift(x):g.transparent===!0?r.unshift(x):t.unshift(x)}function h(u,p){t.length>1&&t.sort(u||ly),i.length>1&&i.sort(p||J0),r.length>1&&r.sort(p||J0)}function f(){for(let u=e,p=n.length;u<p;u++){let g=n[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:c,unshift:l,finish:f,sort:h}}function j0(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new Q0,n.set(i,[o])):r>=s.length?(o=new Q0,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function cy(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new N,color:new Xe};break;case"SpotLight":t={position:new N,direction:new N,color:new Xe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new N,color:new Xe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new N,skyColor:new Xe,groundColor:new Xe};break;case"RectAreaLight":t={color:new Xe,position:new N,halfWidth:new N,halfHeight:new N};break}return n[e.id]=t,t}}}function hy(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var fy=0;function uy(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function ex(n){let e=new cy,t=hy(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new N);let r=new N,s=new Le,o=new Le;function a(l){let h=0,f=0,u=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let p=0,g=0,M=0,m=0,d=0,x=0,w=0,S=0,R=0,A=0,_=0,b=0,F=0,L=0;l.sort(uy);for(let k=0,G=l.length;k<G;k++){let U=l[k],W=U.color,Y=U.intensity,V=U.distance,ce=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===_n?ce=U.shadow.map.texture:ce=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)h+=W.r*Y,f+=W.g*Y,u+=W.b*Y;else if(U.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(U.sh.coefficients[Z],Y);L++}else if(U.isSunLight){let Z=e.get(U);if(Z.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let j=U.shadow,re=t.get(U);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[g]=re,i.sunShadowMap[g]=ce;let ue=j.getViewportCount();for(let fe=0;fe<ue;fe++)i.sunShadowMatrix[M+fe]=j.getMatrix(fe),i.sunShadowCascade[M+fe]=j._cascadeData[fe];M+=ue,g++}i.sun[p]=Z,p++}else if(U.isDirectionalLight){let Z=e.get(U);if(Z.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let j=U.shadow,re=t.get(U);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize=j.mapSize,i.directionalShadow[m]=re,i.directionalShadowMap[m]=ce,i.directionalShadowMatrix[m]=U.shadow.matrix,R++}i.directional[m]=Z,m++}else if(U.isSpotLight){let Z=e.get(U);Z.position.setFromMatrixPosition(U.matrixWorld),Z.color.copy(W).multiplyScalar(Y),Z.distance=V,Z.coneCos=Math.cos(U.angle),Z.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),Z.decay=U.decay,i.spot[x]=Z;let j=U.shadow;if(U.map&&(i.spotLightMap[b]=U.map,b++,j.updateMatrices(U),U.castShadow&&F++),i.spotLightMatrix[x]=j.matrix,U.castShadow){let re=t.get(U);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize=j.mapSize,i.spotShadow[x]=re,i.spotShadowMap[x]=ce,_++}x++}else if(U.isRectAreaLight){let Z=e.get(U);Z.color.copy(W).multiplyScalar(Y),Z.halfWidth.set(U.width*.5,0,0),Z.halfHeight.set(0,U.height*.5,0),i.rectArea[w]=Z,w++}else if(U.isPointLight){let Z=e.get(U);if(Z.color.copy(U.color).multiplyScalar(U.intensity),Z.distance=U.distance,Z.decay=U.decay,U.castShadow){let j=U.shadow,re=t.get(U);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize=j.mapSize,re.shadowCameraNear=j.camera.near,re.shadowCameraFar=j.camera.far,i.pointShadow[d]=re,i.pointShadowMap[d]=ce,i.pointShadowMatrix[d]=U.shadow.matrix,A++}i.point[d]=Z,d++}else if(U.isHemisphereLight){let Z=e.get(U);Z.skyColor.copy(U.color).multiplyScalar(Y),Z.groundColor.copy(U.groundColor).multiplyScalar(Y),i.hemi[S]=Z,S++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=De.LTC_FLOAT_1,i.rectAreaLTC2=De.LTC_FLOAT_2):(i.rectAreaLTC1=De.LTC_HALF_1,i.rectAreaLTC2=De.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=f,i.ambient[2]=u;let D=i.hash;(D.sunLength!==p||D.directionalLength!==m||D.pointLength!==d||D.spotLength!==x||D.rectAreaLength!==w||D.hemiLength!==S||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==A||D.numSpotShadows!==_||D.numSpotMaps!==b||D.numLightProbes!==L)&&(i.sun.length=p,i.directional.length=m,i.spot.length=x,i.rectArea.length=w,i.point.length=d,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=M,i.sunShadowCascade.length=M,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+b-F,i.spotLightMap.length=b,i.numSpotLightShadowsWithMaps=F,i.numLightProbes=L,D.sunLength=p,D.directionalLength=m,D.pointLength=d,D.spotLength=x,D.rectAreaLength=w,D.hemiLength=S,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=A,D.numSpotShadows=_,D.numSpotMaps=b,D.numLightProbes=L,i.version=fy++)}function c(l,h){let f=0,u=0,p=0,g=0,M=0,m=0,d=h.matrixWorldInverse;for(let x=0,w=l.length;x<w;x++){let S=l[x];if(S.isSunLight){let R=i.sun[f];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(d),f++}else if(S.isDirectionalLight){let R=i.directional[u];R.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(r),R.direction.transformDirection(d),u++}else if(S.isSpotLight){let R=i.spot[g];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(d),R.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(r),R.direction.transformDirection(d),g++}else if(S.isRectAreaLight){let R=i.rectArea[M];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(d),o.identity(),s.copy(S.matrixWorld),s.premultiply(d),o.extractRotation(s),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),M++}else if(S.isPointLight){let R=i.point[p];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(d),p++}else if(S.isHemisphereLight){let R=i.hemi[m];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(d),m++}}}return{setup:a,setupView:c,state:i}}function tx(n){let e=new ex(n),t=[],i=[],r=[];function s(f){h.camera=f,t.length=0,i.length=0,r.length=0}function o(f){f.isLightProbeGrid?r.push(f):t.push(f)}function a(f){i.push(f)}function c(){e.setup(t),r.sort((f,u)=>f.priority-u.priority||f.id-u.id)}function l(f){e.setupView(t,f)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function ix(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new tx(n),e.set(r,[a])):s>=o.length?(a=new tx(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var nx=`
void main() {
gl_Position = vec4( position, 1.0 );
}
`,rx=`
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
`;var py=[new N(1,0,0),new N(-1,0,0),new N(0,1,0),new N(0,-1,0),new N(0,0,1),new N(0,0,-1)],my=[new N(0,-1,0),new N(0,-1,0),new N(0,0,1),new N(0,0,-1),new N(0,-1,0),new N(0,-1,0)],sx=new Le,il=new N,qf=new N;function ox(n,e,t){let i=new cn,r=new Ke,s=new Ke,o=new bt,a=new bc,c=new wc,l={},h=t.maxTextureSize,f={[sn]:jt,[jt]:sn,[zi]:zi},u=new tn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:nx,fragmentShader:rx}),p=u.clone();p.defines.HORIZONTAL_PASS=1;let g=new Ot;g.setAttribute("position",new Rt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new St(g,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Gs;let d=this.type;this.render=function(A,_,b){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;this.type===dd&&(Ge("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Gs);let F=n.getRenderTarget(),L=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),k=n.state;k.setBlending(ir),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let G=d!==this.type;G&&_.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(W=>W.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,W=A.length;U<W;U++){let Y=A[U],V=Y.shadow;if(V===void 0){Ge("WebGLShadowMap:",Y,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;r.copy(V.mapSize);let ce=V.getFrameExtents();r.multiply(ce),s.copy(V.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/ce.x),r.x=s.x*ce.x,V.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/ce.y),r.y=s.y*ce.y,V.mapSize.y=s.y));let Z=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=Z,V.map===null||G===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===os){if(Y.isPointLight){Ge("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new Hi(r.x,r.y,{format:_n,type:Ui,minFilter:Mi,magFilter:Mi,generateMipmaps:!1}),V.map.texture.name=Y.name+".shadowMap",V.map.depthTexture=new yn(r.x,r.y,ui),V.map.depthTexture.name=Y.name+".shadowMapDepth",V.map.depthTexture.format=an,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Kt,V.map.depthTexture.magFilter=Kt}else Y.isPointLight?(V.map=new Qr(r.x),V.map.depthTexture=new So(r.x,Ii)):(V.map=new Hi(r.x,r.y),V.map.depthTexture=new yn(r.x,r.y,Ii)),V.map.depthTexture.name=Y.name+".shadowMap",V.map.depthTexture.format=an,this.type===Gs?(V.map.depthTexture.compareFunction=Z?Yl:ql,V.map.depthTexture.minFilter=Mi,V.map.depthTexture.magFilter=Mi):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Kt,V.map.depthTexture.magFilter=Kt);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==r.x||V.map.height!==r.y)&&V.map.setSize(r.x,r.y);let j=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();Y.isPointLight!==!0&&V.updateMatrices(Y,b);let re=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:b.layers;for(let ue=0;ue<j;ue++){let fe=V.getCamera(ue);if(Y.isPointLight){let ee=V.camera,me=V.matrix,_e=Y.distance||ee.far;_e!==ee.far&&(ee.far=_e,ee.updateProjectionMatrix()),il.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(il),qf.copy(ee.position),qf.add(py[ue]),ee.up.copy(my[ue]),ee.lookAt(qf),ee.updateMatrixWorld(),me.makeTranslation(-il.x,-il.y,-il.z),sx.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),V._frustum.setFromProjectionMatrix(sx,ee.coordinateSystem,ee.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,ue),n.clear();else{ue===0&&(n.setRenderTarget(V.map),n.clear());let ee=V.getViewport(ue);o.set(s.x*ee.x,s.y*ee.y,s.x*ee.z,s.y*ee.w),k.viewport(o)}i=V.getFrustum(ue),S(_,b,fe,Y,re,this.type)}V.isPointLightShadow!==!0&&this.type===os&&x(V,b),V.needsUpdate=!1}d=this.type,m.needsUpdate=!1,n.setRenderTarget(F,L,D)};function x(A,_){let b=e.update(M);u.defines.VSM_SAMPLES!==A.blurSamples&&(u.defines.VSM_SAMPLES=A.blurSamples,p.defines.VSM_SAMPLES=A.blurSamples,u.needsUpdate=!0,p.needsUpdate=!0),A.mapPass===null?A.mapPass=new Hi(r.x,r.y,{format:_n,type:Ui}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),u.uniforms.shadow_pass.value=A.map.depthTexture,u.uniforms.resolution.value.set(A.map.width,A.map.height),u.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(_,null,b,u,M,null),p.uniforms.shadow_pass.value=A.mapPass.texture,p.uniforms.resolution.value.set(A.map.width,A.map.height),p.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(_,null,b,p,M,null)}function w(A,_,b,F){let L=null,D=b.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(D!==void 0)L=D;else if(L=b.isPointLight===!0?c:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let k=L.uuid,G=_.uuid,U=l[k];U===void 0&&(U={},l[k]=U);let W=U[G];W===void 0&&(W=L.clone(),U[G]=W,_.addEventListener("dispose",R)),L=W}if(L.visible=_.visible,L.wireframe=_.wireframe,F===os?L.side=_.shadowSide!==null?_.shadowSide:_.side:L.side=_.shadowSide!==null?_.shadowSide:f[_.side],L.alphaMap=_.alphaMap,L.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,L.map=_.map,L.clipShadows=_.clipShadows,L.clippingPlanes=_.clippingPlanes,L.clipIntersection=_.clipIntersection,L.displacementMap=_.displacementMap,L.displacementScale=_.displacementScale,L.displacementBias=_.displacementBias,L.wireframeLinewidth=_.wireframeLinewidth,L.linewidth=_.linewidth,b.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let k=n.properties.get(L);k.light=b}return L}function S(A,_,b,F,L,D){if(A.visible===!1)return;if(A.layers.test(L)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&D===os)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,A.matrixWorld);let U=e.update(A),W=A.material;if(Array.isArray(W)){let Y=U.groups;for(let V=0,ce=Y.length;V<ce;V++){let Z=Y[V],j=W[Z.materialIndex];if(j&&j.visible){let re=w(A,j,F,D);A.onBeforeShadow(n,A,_,b,U,re,Z),n.renderBufferDirect(b,null,U,re,A,Z),A.onAfterShadow(n,A,_,b,U,re,Z)}}}else if(W.visible){let Y=w(A,W,F,D);A.onBeforeShadow(n,A,_,b,U,Y,null),n.renderBufferDirect(b,null,U,Y,A,null),A.onAfterShadow(n,A,_,b,U,Y,null)}}let G=A.children;for(let U=0,W=G.length;U<W;U++)S(G[U],_,b,F,L,D)}function R(A){A.target.removeEventListener("dispose",R);for(let b in l){let F=l[b],L=A.target.uuid;L in F&&(F[L].dispose(),delete F[L])}}}function ax(n,e){function t(){let O=!1,se=new bt,ie=null,we=new bt(0,0,0,0);return{setMask:function(ge){ie!==ge&&!O&&(n.colorMask(ge,ge,ge,ge),ie=ge)},setLocked:function(ge){O=ge},setClear:function(ge,Se,We,je,le){le===!0&&(ge*=je,Se*=je,We*=je),se.set(ge,Se,We,je),we.equals(se)===!1&&(n.clearColor(ge,Se,We,je),we.copy(se))},reset:function(){O=!1,ie=null,we.set(-1,0,0,0)}}}function i(){let O=!1,se=!1,ie=null,we=null,ge=null;return{setReversed:function(Se){if(se!==Se){let We=e.get("EXT_clip_control");Se?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),se=Se;let je=ge;ge=null,this.setClear(je)}},getReversed:function(){return se},setTest:function(Se){Se?ye(n.DEPTH_TEST):qe(n.DEPTH_TEST)},setMask:function(Se){ie!==Se&&!O&&(n.depthMask(Se),ie=Se)},setFunc:function(Se){if(se&&(Se=Zd[Se]),we!==Se){switch(Se){case ta:n.depthFunc(n.NEVER);break;case ia:n.depthFunc(n.ALWAYS);break;case na:n.depthFunc(n.LESS);break;case Gr:n.depthFunc(n.LEQUAL);break;case ra:n.depthFunc(n.EQUAL);break;case sa:n.depthFunc(n.GEQUAL);break;case oa:n.depthFunc(n.GREATER);break;case aa:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=Se}},setLocked:function(Se){O=Se},setClear:function(Se){ge!==Se&&(ge=Se,se&&(Se=1-Se),n.clearDepth(Se))},reset:function(){O=!1,ie=null,we=null,ge=null,se=!1}}}function r(){let O=!1,se=null,ie=null,we=null,ge=null,Se=null,We=null,je=null,le=null;return{setTest:function(Be){O||(Be?ye(n.STENCIL_TEST):qe(n.STENCIL_TEST))},setMask:function(Be){se!==Be&&!O&&(n.stencilMask(Be),se=Be)},setFunc:function(Be,et,Re){(ie!==Be||we!==et||ge!==Re)&&(n.stencilFunc(Be,et,Re),ie=Be,we=et,ge=Re)},setOp:function(Be,et,Re){(Se!==Be||We!==et||je!==Re)&&(n.stencilOp(Be,et,Re),Se=Be,We=et,je=Re)},setLocked:function(Be){O=Be},setClear:function(Be){le!==Be&&(n.clearStencil(Be),le=Be)},reset:function(){O=!1,se=null,ie=null,we=null,ge=null,Se=null,We=null,je=null,le=null}}}let s=new t,o=new i,a=new r,c={},l=new WeakMap,h={},f={},u={},p=new WeakMap,g=[],M=null,m=!1,d=null,x=null,w=null,S=null,R=null,A=null,_=null,b=new Xe(0,0,0),F=0,L=!1,D=null,k=null,G=null,U=null,W=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ce=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(Z)[1]),V=ce>=1):Z.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),V=ce>=2);let j=null,re={},ue=n.getParameter(n.SCISSOR_BOX),fe=n.getParameter(n.VIEWPORT),ee=new bt().fromArray(ue),me=new bt().fromArray(fe);function _e(O,se,ie,we){let ge=new Uint8Array(4),Se=n.createTexture();n.bindTexture(O,Se),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<ie;We++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(se,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(se+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return Se}let Ae={};Ae[n.TEXTURE_2D]=_e(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=_e(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=_e(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=_e(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ye(n.DEPTH_TEST),o.setFunc(Gr),pi(!1),Nt(cf),ye(n.CULL_FACE),Yt(ir);function ye(O){h[O]!==!0&&(n.enable(O),h[O]=!0)}function qe(O){h[O]!==!1&&(n.disable(O),h[O]=!1)}function rt(O,se){return u[O]!==se?(n.bindFramebuffer(O,se),u[O]=se,O===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=se),O===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=se),!0):!1}function Ve(O,se){let ie=g,we=!1;if(O){ie=p.get(se),ie===void 0&&(ie=[],p.set(se,ie));let ge=O.textures;if(ie.length!==ge.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,We=ge.length;Se<We;Se++)ie[Se]=n.COLOR_ATTACHMENT0+Se;ie.length=ge.length,we=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,we=!0);we&&n.drawBuffers(ie)}function dt(O){return M!==O?(n.useProgram(O),M=O,!0):!1}let ht={[zr]:n.FUNC_ADD,[md]:n.FUNC_SUBTRACT,[gd]:n.FUNC_REVERSE_SUBTRACT};ht[xd]=n.MIN,ht[_d]=n.MAX;let it={[vd]:n.ZERO,[Md]:n.ONE,[Sd]:n.SRC_COLOR,[Al]:n.SRC_ALPHA,[Ad]:n.SRC_ALPHA_SATURATE,[Ed]:n.DST_COLOR,[bd]:n.DST_ALPHA,[yd]:n.ONE_MINUS_SRC_COLOR,[Rl]:n.ONE_MINUS_SRC_ALPHA,[Td]:n.ONE_MINUS_DST_COLOR,[wd]:n.ONE_MINUS_DST_ALPHA,[Rd]:n.CONSTANT_COLOR,[Cd]:n.ONE_MINUS_CONSTANT_COLOR,[Pd]:n.CONSTANT_ALPHA,[Ld]:n.ONE_MINUS_CONSTANT_ALPHA};function Yt(O,se,ie,we,ge,Se,We,je,le,Be){if(O===ir){m===!0&&(qe(n.BLEND),m=!1);return}if(m===!1&&(ye(n.BLEND),m=!0),O!==pd){if(O!==d||Be!==L){if((x!==zr||R!==zr)&&(n.blendEquation(n.FUNC_ADD),x=zr,R=zr),Be)switch(O){case kr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case hf:n.blendFunc(n.ONE,n.ONE);break;case ff:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case uf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ut("WebGLState: Invalid blending: ",O);break}else switch(O){case kr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case hf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case ff:ut("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case uf:ut("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ut("WebGLState: Invalid blending: ",O);break}w=null,S=null,A=null,_=null,b.set(0,0,0),F=0,d=O,L=Be}return}ge=ge||se,Se=Se||ie,We=We||we,(se!==x||ge!==R)&&(n.blendEquationSeparate(ht[se],ht[ge]),x=se,R=ge),(ie!==w||we!==S||Se!==A||We!==_)&&(n.blendFuncSeparate(it[ie],it[we],it[Se],it[We]),w=ie,S=we,A=Se,_=We),(je.equals(b)===!1||le!==F)&&(n.blendColor(je.r,je.g,je.b,le),b.copy(je),F=le),d=O,L=!1}function zt(O,se){O.side===zi?qe(n.CULL_FACE):ye(n.CULL_FACE);let ie=O.side===jt;se&&(ie=!ie),pi(ie),O.blending===kr&&O.transparent===!1?Yt(ir):Yt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),s.setMask(O.colorWrite);let we=O.stencilWrite;a.setTest(we),we&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),Mt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?ye(n.SAMPLE_ALPHA_TO_COVERAGE):qe(n.SAMPLE_ALPHA_TO_COVERAGE)}function pi(O){D!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),D=O)}function Nt(O){O!==fd?(ye(n.CULL_FACE),O!==k&&(O===cf?n.cullFace(n.BACK):O===ud?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):qe(n.CULL_FACE),k=O}function Ci(O){O!==G&&(V&&n.lineWidth(O),G=O)}function Mt(O,se,ie){O?(ye(n.POLYGON_OFFSET_FILL),(U!==se||W!==ie)&&(U=se,W=ie,o.getReversed()&&(se=-se,ie=-ie),n.polygonOffset(se,ie))):qe(n.POLYGON_OFFSET_FILL)}function bi(O){O?ye(n.SCISSOR_TEST):qe(n.SCISSOR_TEST)}function ii(O){O===void 0&&(O=n.TEXTURE0+Y-1),j!==O&&(n.activeTexture(O),j=O)}function mi(O,se,ie){ie===void 0&&(j===null?ie=n.TEXTURE0+Y-1:ie=j);let we=re[ie];we===void 0&&(we={type:void 0,texture:void 0},re[ie]=we),(we.type!==O||we.texture!==se)&&(j!==ie&&(n.activeTexture(ie),j=ie),n.bindTexture(O,se||Ae[O]),we.type=O,we.texture=se)}function B(){let O=re[j];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Ce(){try{n.compressedTexImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function st(){try{n.texSubImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function be(){try{n.texSubImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function Ut(){try{n.compressedTexSubImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function He(){try{n.compressedTexSubImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function Ze(){try{n.texStorage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function C(){try{n.texStorage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function y(){try{n.texImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function X(){try{n.texImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function he(O){return f[O]!==void 0?f[O]:n.getParameter(O)}function oe(O,se){f[O]!==se&&(n.pixelStorei(O,se),f[O]=se)}function xe(O){ee.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function ve(O){me.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function te(O,se){let ie=l.get(se);ie===void 0&&(ie=new WeakMap,l.set(se,ie));let we=ie.get(O);we===void 0&&(we=n.getUniformBlockIndex(se,O.name),n.uniformBlockBinding(se,we,we),ie.set(O,we))}function ne(O,se,ie){let ge=l.get(se).get(O);c[ge]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,ie),c[ge]=ie)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},f={},j=null,re={},u={},c={},p=new WeakMap,g=[],M=null,m=!1,d=null,x=null,w=null,S=null,R=null,A=null,_=null,b=new Xe(0,0,0),F=0,L=!1,D=null,k=null,G=null,U=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:ye,disable:qe,bindFramebuffer:rt,drawBuffers:Ve,useProgram:dt,setBlending:Yt,setMaterial:zt,setFlipSided:pi,setCullFace:Nt,setLineWidth:Ci,setPolygonOffset:Mt,setScissorTest:bi,activeTexture:ii,bindTexture:mi,unbindTexture:B,compressedTexImage2D:Ce,compressedTexImage3D:Je,texImage2D:y,texImage3D:X,pixelStorei:oe,getParameter:he,updateUBOMapping:te,uniformBlockBinding:ne,texStorage2D:Ze,texStorage3D:C,texSubImage2D:st,texSubImage3D:be,compressedTexSubImage2D:Ut,compressedTexSubImage3D:He,scissor:xe,viewport:ve,reset:pe}}function lx(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Ke,h=new WeakMap,f=new Set,u,p=new WeakMap,g=new Set,M=new FinalizationRegistry(C=>g.delete(C)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function d(C,y){return m?new OffscreenCanvas(C,y):to("canvas")}function x(C,y,X){let he=1,oe=Ze(C);if((oe.width>X||oe.height>X)&&(he=X/Math.max(oe.width,oe.height)),he<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let xe=Math.floor(he*oe.width),ve=Math.floor(he*oe.height);u===void 0&&(u=d(xe,ve));let te=y?d(xe,ve):u;return te.width=xe,te.height=ve,te.getContext("2d").drawImage(C,0,0,xe,ve),Ge("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+xe+"x"+ve+")."),te}else return"data"in C&&Ge("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),C;return C}function w(C){return C.generateMipmaps}function S(C){n.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?n.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(C,y,X,he,oe,xe=!1){if(C!==null){if(n[C]!==void 0)return n[C];Ge("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ve;he&&(ve=e.get("EXT_texture_norm16"),ve||Ge("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=y;if(y===n.RED&&(X===n.FLOAT&&(te=n.R32F),X===n.HALF_FLOAT&&(te=n.R16F),X===n.UNSIGNED_BYTE&&(te=n.R8),X===n.UNSIGNED_SHORT&&ve&&(te=ve.R16_EXT),X===n.SHORT&&ve&&(te=ve.R16_SNORM_EXT)),y===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.R8UI),X===n.UNSIGNED_SHORT&&(te=n.R16UI),X===n.UNSIGNED_INT&&(te=n.R32UI),X===n.BYTE&&(te=n.R8I),X===n.SHORT&&(te=n.R16I),X===n.INT&&(te=n.R32I)),y===n.RG&&(X===n.FLOAT&&(te=n.RG32F),X===n.HALF_FLOAT&&(te=n.RG16F),X===n.UNSIGNED_BYTE&&(te=n.RG8),X===n.UNSIGNED_SHORT&&ve&&(te=ve.RG16_EXT),X===n.SHORT&&ve&&(te=ve.RG16_SNORM_EXT)),y===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RG8UI),X===n.UNSIGNED_SHORT&&(te=n.RG16UI),X===n.UNSIGNED_INT&&(te=n.RG32UI),X===n.BYTE&&(te=n.RG8I),X===n.SHORT&&(te=n.RG16I),X===n.INT&&(te=n.RG32I)),y===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGB8UI),X===n.UNSIGNED_SHORT&&(te=n.RGB16UI),X===n.UNSIGNED_INT&&(te=n.RGB32UI),X===n.BYTE&&(te=n.RGB8I),X===n.SHORT&&(te=n.RGB16I),X===n.INT&&(te=n.RGB32I)),y===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),X===n.UNSIGNED_INT&&(te=n.RGBA32UI),X===n.BYTE&&(te=n.RGBA8I),X===n.SHORT&&(te=n.RGBA16I),X===n.INT&&(te=n.RGBA32I)),y===n.RGB&&(X===n.UNSIGNED_SHORT&&ve&&(te=ve.RGB16_EXT),X===n.SHORT&&ve&&(te=ve.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),y===n.RGBA){let ne=xe?hs:ot.getTransfer(oe);X===n.FLOAT&&(te=n.RGBA32F),X===n.HALF_FLOAT&&(te=n.RGBA16F),X===n.UNSIGNED_BYTE&&(te=ne===_t?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&ve&&(te=ve.RGBA16_EXT),X===n.SHORT&&ve&&(te=ve.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function _(C,y){let X;return C?y===null||y===Ii||y===zn?X=n.DEPTH24_STENCIL8:y===ui?X=n.DEPTH32F_STENCIL8:y===vr&&(X=n.DEPTH24_STENCIL8,Ge("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Ii||y===zn?X=n.DEPTH_COMPONENT24:y===ui?X=n.DEPTH_COMPONENT32F:y===vr&&(X=n.DEPTH_COMPONENT16),X}function b(C,y){return w(C)===!0||C.isFramebufferTexture&&C.minFilter!==Kt&&C.minFilter!==Mi?Math.log2(Math.max(y.width,y.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?y.mipmaps.length:1}function F(C){let y=new WeakRef(C);i.get(C).__ref=y,g.add(y),M.register(C,y,y)}function L(C){let y=i.get(C).__ref;y!==void 0&&(g.delete(y),M.unregister(y))}function D(C){G(C.target)}function k(C){U(C.target)}function G(C){C.removeEventListener("dispose",D),L(C),Y(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&f.delete(C)}function U(C){C.removeEventListener("dispose",k),L(C),ce(C)}function W(){for(let C of g){let y=C.deref();y!==void 0&&(y.isRenderTarget===!0?U(y):G(y))}g.clear(),f.clear()}function Y(C){let y=i.get(C);if(y.__webglInit===void 0)return;let X=C.source,he=p.get(X);if(he){let oe=he[y.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&V(C),Object.keys(he).length===0&&p.delete(X)}i.remove(C)}function V(C){let y=i.get(C);n.deleteTexture(y.__webglTexture);let X=C.source,he=p.get(X);delete he[y.__cacheKey],o.memory.textures--}function ce(C){let y=i.get(C);y.__depthDisposeCallback&&y.__depthDisposeCallback();let X=C.depthTexture;if(X&&X.renderTarget===C&&G(X),C.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(y.__webglFramebuffer[oe]))for(let xe=0;xe<y.__webglFramebuffer[oe].length;xe++)n.deleteFramebuffer(y.__webglFramebuffer[oe][xe]);else n.deleteFramebuffer(y.__webglFramebuffer[oe]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[oe])}else{if(Array.isArray(y.__webglFramebuffer))for(let oe=0;oe<y.__webglFramebuffer.length;oe++)n.deleteFramebuffer(y.__webglFramebuffer[oe]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let oe=0;oe<y.__webglColorRenderbuffer.length;oe++)y.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[oe]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let he=C.textures;for(let oe=0,xe=he.length;oe<xe;oe++){let ve=i.get(he[oe]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(he[oe])}i.remove(C)}let Z=0;function j(){Z=0}function re(){return Z}function ue(C){Z=C}function fe(){let C=Z;return C>=r.maxTextures&&Ge("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+r.maxTextures),Z+=1,C}function ee(C){let y=[];return y.push(C.wrapS),y.push(C.wrapT),y.push(C.wrapR||0),y.push(C.magFilter),y.push(C.minFilter),y.push(C.anisotropy),y.push(C.internalFormat),y.push(C.format),y.push(C.type),y.push(C.generateMipmaps),y.push(C.mipmapsAutoUpdate),y.push(C.premultiplyAlpha),y.push(C.flipY),y.push(C.unpackAlignment),y.push(C.colorSpace),y.join()}function me(C,y){let X=i.get(C);if(C.isVideoTexture&&Ut(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&X.__version!==C.version){let he=C.image;if(he===null)Ge("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Ge("WebGLRenderer: Texture marked for update but image is incomplete");else{zt(X,C,y);return}}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+y)}function _e(C,y){let X=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){zt(X,C,y);return}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+y)}function Ae(C,y){let X=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){zt(X,C,y);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+y)}function ye(C,y){let X=i.get(C);if(C.version>0&&X.__version!==C.version){pi(X,C,y);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+y)}let qe={[la]:n.REPEAT,[on]:n.CLAMP_TO_EDGE,[ca]:n.MIRRORED_REPEAT},rt={[Kt]:n.NEAREST,[Id]:n.NEAREST_MIPMAP_NEAREST,[ha]:n.NEAREST_MIPMAP_LINEAR,[Mi]:n.LINEAR,[Bl]:n.LINEAR_MIPMAP_NEAREST,[gn]:n.LINEAR_MIPMAP_LINEAR},Ve={[Bd]:n.NEVER,[$l]:n.ALWAYS,[kd]:n.LESS,[ql]:n.LEQUAL,[zd]:n.EQUAL,[Yl]:n.GEQUAL,[Gd]:n.GREATER,[Hd]:n.NOTEQUAL};function dt(C,y){if(y.type===ui&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===Mi||y.magFilter===Bl||y.magFilter===ha||y.magFilter===gn||y.minFilter===Mi||y.minFilter===Bl||y.minFilter===ha||y.minFilter===gn)&&Ge("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(C,n.TEXTURE_WRAP_S,qe[y.wrapS]),n.texParameteri(C,n.TEXTURE_WRAP_T,qe[y.wrapT]),(C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY)&&n.texParameteri(C,n.TEXTURE_WRAP_R,qe[y.wrapR]),n.texParameteri(C,n.TEXTURE_MAG_FILTER,rt[y.magFilter]),n.texParameteri(C,n.TEXTURE_MIN_FILTER,rt[y.minFilter]),y.compareFunction&&(n.texParameteri(C,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(C,n.TEXTURE_COMPARE_FUNC,Ve[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===Kt||y.minFilter!==ha&&y.minFilter!==gn||y.type===ui&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(C,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,r.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function ht(C,y){let X=!1;C.__webglInit===void 0&&(C.__webglInit=!0,y.addEventListener("dispose",D),F(y));let he=y.source,oe=p.get(he);oe===void 0&&(oe={},p.set(he,oe));let xe=ee(y);if(xe!==C.__cacheKey){oe[xe]===void 0&&(oe[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[xe].usedTimes++;let ve=oe[C.__cacheKey];ve!==void 0&&(oe[C.__cacheKey].usedTimes--,ve.usedTimes===0&&V(y)),C.__cacheKey=xe,C.__webglTexture=oe[xe].texture}return X}function it(C,y,X){return Math.floor(Math.floor(C/X)/y)}function Yt(C,y,X,he){let xe=C.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,y.width,y.height,X,he,y.data);else{xe.sort((O,se)=>O.start-se.start);let ve=0;for(let O=1;O<xe.length;O++){let se=xe[ve],ie=xe[O],we=se.start+se.count,ge=it(ie.start,y.width,4),Se=it(se.start,y.width,4);ie.start<=we+1&&ge===Se&&it(ie.start+ie.count-1,y.width,4)===ge?se.count=Math.max(se.count,ie.start+ie.count-se.start):(++ve,xe[ve]=ie)}xe.length=ve+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ne=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,y.width);for(let O=0,se=xe.length;O<se;O++){let ie=xe[O],we=Math.floor(ie.start/4),ge=Math.ceil(ie.count/4),Se=we%y.width,We=Math.floor(we/y.width),je=ge,le=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,Se,We,je,le,X,he,y.data)}C.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function zt(C,y,X){let he=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(he=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(he=n.TEXTURE_3D);let oe=ht(C,y),xe=y.source;t.bindTexture(he,C.__webglTexture,n.TEXTURE0+X);let ve=i.get(xe);if(xe.version!==ve.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let le=ot.getPrimaries(ot.workingColorSpace),Be=y.colorSpace===Rn?null:ot.getPrimaries(y.colorSpace),et=y.colorSpace===Rn||le===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment);let ne=x(y.image,!1,r.maxTextureSize);ne=He(y,ne);let pe=s.convert(y.format,y.colorSpace),O=s.convert(y.type),se=A(y.internalFormat,pe,O,y.normalized,y.colorSpace,y.isVideoTexture);dt(he,y);let ie,we=y.mipmaps,ge=y.isVideoTexture!==!0,Se=ve.__version===void 0||oe===!0,We=xe.dataReady,je=b(y,ne);if(y.isDepthTexture)se=_(y.format===xn,y.type),Se&&(ge?t.texStorage2D(n.TEXTURE_2D,1,se,ne.width,ne.height):t.texImage2D(n.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,O,null));else if(y.isDataTexture)if(we.length>0){ge&&Se&&t.texStorage2D(n.TEXTURE_2D,je,se,we[0].width,we[0].height);for(let le=0,Be=we.length;le<Be;le++)ie=we[le],ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,ie.width,ie.height,pe,O,ie.data):t.texImage2D(n.TEXTURE_2D,le,se,ie.width,ie.height,0,pe,O,ie.data);y.generateMipmaps=!1}else ge?(Se&&t.texStorage2D(n.TEXTURE_2D,je,se,ne.width,ne.height),We&&Yt(y,ne,pe,O)):t.texImage2D(n.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,O,ne.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){ge&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,se,we[0].width,we[0].height,ne.depth);for(let le=0,Be=we.length;le<Be;le++)if(ie=we[le],y.format!==Fi)if(pe!==null)if(ge){if(We)if(y.layerUpdates.size>0){let et=Of(ie.width,ie.height,y.format,y.type);for(let Re of y.layerUpdates){let lt=ie.data.subarray(Re*et/ie.data.BYTES_PER_ELEMENT,(Re+1)*et/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,Re,ie.width,ie.height,1,pe,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,ie.width,ie.height,ne.depth,pe,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,le,se,ie.width,ie.height,ne.depth,0,ie.data,0,0);else Ge("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,ie.width,ie.height,ne.depth,pe,O,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,le,se,ie.width,ie.height,ne.depth,0,pe,O,ie.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{ge&&Se&&t.texStorage2D(n.TEXTURE_2D,je,se,we[0].width,we[0].height);for(let le=0,Be=we.length;le<Be;le++)ie=we[le],y.format!==Fi?pe!==null?ge?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,le,0,0,ie.width,ie.height,pe,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,le,se,ie.width,ie.height,0,ie.data):Ge("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,ie.width,ie.height,pe,O,ie.data):t.texImage2D(n.TEXTURE_2D,le,se,ie.width,ie.height,0,pe,O,ie.data)}else if(y.isDataArrayTexture)if(ge){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,se,ne.width,ne.height,ne.depth),We)if(y.layerUpdates.size>0){let le=Of(ne.width,ne.height,y.format,y.type);for(let Be of y.layerUpdates){let et=ne.data.subarray(Be*le/ne.data.BYTES_PER_ELEMENT,(Be+1)*le/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,ne.width,ne.height,1,pe,O,et)}y.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,pe,O,ne.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,se,ne.width,ne.height,ne.depth,0,pe,O,ne.data);else if(y.isData3DTexture)ge?(Se&&t.texStorage3D(n.TEXTURE_3D,je,se,ne.width,ne.height,ne.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,pe,O,ne.data)):t.texImage3D(n.TEXTURE_3D,0,se,ne.width,ne.height,ne.depth,0,pe,O,ne.data);else if(y.isFramebufferTexture){if(Se)if(ge)t.texStorage2D(n.TEXTURE_2D,je,se,ne.width,ne.height);else{let le=ne.width,Be=ne.height;for(let et=0;et<je;et++)t.texImage2D(n.TEXTURE_2D,et,se,le,Be,0,pe,O,null),le>>=1,Be>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in n){let le=n.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),ne.parentNode!==le){le.appendChild(ne),f.add(y),le.onpaint=Be=>{let et=Be.changedElements;for(let Re of f)et.includes(Re.image)&&(Re.needsUpdate=!0)},le.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ne);else{let et=n.RGBA,Re=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Re,lt,ne)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&Se){let le=Ze(we[0]);t.texStorage2D(n.TEXTURE_2D,je,se,le.width,le.height)}for(let le=0,Be=we.length;le<Be;le++)ie=we[le],ge?We&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,pe,O,ie):t.texImage2D(n.TEXTURE_2D,le,se,pe,O,ie);y.generateMipmaps=!1}else if(ge){if(Se){let le=Ze(ne);t.texStorage2D(n.TEXTURE_2D,je,se,le.width,le.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,O,ne)}else t.texImage2D(n.TEXTURE_2D,0,se,pe,O,ne);w(y)&&y.mipmapsAutoUpdate===!0&&S(he),ve.__version=xe.version,y.onUpdate&&y.onUpdate(y)}C.__version=y.version}function pi(C,y,X){if(y.image.length!==6)return;let he=ht(C,y),oe=y.source;t.bindTexture(n.TEXTURE_CUBE_MAP,C.__webglTexture,n.TEXTURE0+X);let xe=i.get(oe);if(oe.version!==xe.__version||he===!0){t.activeTexture(n.TEXTURE0+X);let ve=ot.getPrimaries(ot.workingColorSpace),te=y.colorSpace===Rn?null:ot.getPrimaries(y.colorSpace),ne=y.colorSpace===Rn||ve===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let pe=y.isCompressedTexture||y.image[0].isCompressedTexture,O=y.image[0]&&y.image[0].isDataTexture,se=[];for(let Re=0;Re<6;Re++)!pe&&!O?se[Re]=x(y.image[Re],!0,r.maxCubemapSize):se[Re]=O?y.image[Re].image:y.image[Re],se[Re]=He(y,se[Re]);let ie=se[0],we=s.convert(y.format,y.colorSpace),ge=s.convert(y.type),Se=A(y.internalFormat,we,ge,y.normalized,y.colorSpace),We=y.isVideoTexture!==!0,je=xe.__version===void 0||he===!0,le=oe.dataReady,Be=b(y,ie);dt(n.TEXTURE_CUBE_MAP,y);let et;if(y.isDepthTexture){if(Se=_(y.format===xn,y.type),je)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ie.width,ie.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,ie.width,ie.height,0,we,ge,null)}else if(pe){We&&je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,ie.width,ie.height);for(let Re=0;Re<6;Re++){et=se[Re].mipmaps;for(let lt=0;lt<et.length;lt++){let Ht=et[lt];y.format!==Fi?we!==null?We?le&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Ht.width,Ht.height,we,Ht.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Se,Ht.width,Ht.height,0,Ht.data):Ge("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,0,0,Ht.width,Ht.height,we,ge,Ht.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt,Se,Ht.width,Ht.height,0,we,ge,Ht.data)}}}else{if(et=y.mipmaps,We&&je){et.length>0&&Be++;let Re=Ze(se[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(O){We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,se[Re].width,se[Re].height,we,ge,se[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,se[Re].width,se[Re].height,0,we,ge,se[Re].data);for(let lt=0;lt<et.length;lt++){let Ki=et[lt].image[Re].image;We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,Ki.width,Ki.height,we,ge,Ki.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Se,Ki.width,Ki.height,0,we,ge,Ki.data)}}else{We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,we,ge,se[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,we,ge,se[Re]);for(let lt=0;lt<et.length;lt++){let Ht=et[lt];We?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,0,0,we,ge,Ht.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,lt+1,Se,we,ge,Ht.image[Re])}}}w(y)&&y.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),xe.__version=oe.version,y.onUpdate&&y.onUpdate(y)}C.__version=y.version}function Nt(C,y,X,he,oe,xe){let ve=s.convert(X.format,X.colorSpace),te=s.convert(X.type),ne=A(X.internalFormat,ve,te,X.normalized,X.colorSpace),pe=i.get(y),O=i.get(X);if(O.__renderTarget=y,!pe.__hasExternalTextures){let se=Math.max(1,y.width>>xe),ie=Math.max(1,y.height>>xe);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,xe,ne,se,ie,y.depth,0,ve,te,null):t.texImage2D(oe,xe,ne,se,ie,0,ve,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,C),be(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,he,oe,O.__webglTexture,0,st(y)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,he,oe,O.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Ci(C,y,X){if(n.bindRenderbuffer(n.RENDERBUFFER,C),y.depthBuffer){let he=y.depthTexture,oe=he&&he.isDepthTexture?he.type:null,xe=_(y.stencilBuffer,oe),ve=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;be(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(y),xe,y.width,y.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(y),xe,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,xe,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,C)}else{let he=y.textures;for(let oe=0;oe<he.length;oe++){let xe=he[oe],ve=s.convert(xe.format,xe.colorSpace),te=s.convert(xe.type),ne=A(xe.internalFormat,ve,te,xe.normalized,xe.colorSpace);be(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(y),ne,y.width,y.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(y),ne,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,ne,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Mt(C,y,X){let he=y.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,C),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(y.depthTexture);oe.__renderTarget=y;let xe=he?y.depthTexture.image[0]:y.depthTexture.image;(!oe.__webglTexture||xe.width!==y.width||xe.height!==y.height)&&(xe.width=y.width,xe.height=y.height,y.depthTexture.needsUpdate=!0),he?ye(y.depthTexture,0):me(y.depthTexture,0);let ve=oe.__webglTexture,te=st(y),ne=he?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,pe=y.depthTexture.format===xn?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(y.depthTexture.format===an)be(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ne,ve,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ne,ve,0);else if(y.depthTexture.format===xn)be(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ne,ve,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ne,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function bi(C){let y=i.get(C),X=C.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==C.depthTexture){let he=C.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),he){let oe=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,he.removeEventListener("dispose",oe)};he.addEventListener("dispose",oe),y.__depthDisposeCallback=oe}y.__boundDepthTexture=he}if(C.depthTexture&&!y.__autoAllocateDepthBuffer)if(X)for(let he=0;he<6;he++)Mt(y.__webglFramebuffer[he],C,he);else C.texture.mipmaps.length>0?Mt(y.__webglFramebuffer[0],C,0):Mt(y.__webglFramebuffer,C,0);else if(X){y.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[he]),y.__webglDepthbuffer[he]===void 0)y.__webglDepthbuffer[he]=n.createRenderbuffer(),Ci(y.__webglDepthbuffer[he],C,!1);else{let oe=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=y.__webglDepthbuffer[he];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),Ci(y.__webglDepthbuffer,C,!1);else{let oe=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function ii(C,y,X){let he=i.get(C);y!==void 0&&Nt(he.__webglFramebuffer,C,C.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&bi(C)}function mi(C){let y=C.texture,X=i.get(C),he=i.get(y);C.addEventListener("dispose",k),F(C);let oe=C.textures,xe=C.isWebGLCubeRenderTarget===!0,ve=oe.length>1;if(ve||(he.__webglTexture===void 0&&(he.__webglTexture=n.createTexture()),he.__version=y.version,o.memory.textures++),xe){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(y.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let ne=0;ne<y.mipmaps.length;ne++)X.__webglFramebuffer[te][ne]=n.createFramebuffer()}else X.__webglFramebuffer[te]=n.createFramebuffer()}else{if(y.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<y.mipmaps.length;te++)X.__webglFramebuffer[te]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(ve)for(let te=0,ne=oe.length;te<ne;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(C.samples>0&&be(C)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ne=oe[te];X.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let pe=s.convert(ne.format,ne.colorSpace),O=s.convert(ne.type),se=A(ne.internalFormat,pe,O,ne.normalized,ne.colorSpace,C.isXRRenderTarget===!0),ie=st(C);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,se,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,X.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),C.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),Ci(X.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,he.__webglTexture),dt(n.TEXTURE_CUBE_MAP,y);for(let te=0;te<6;te++)if(y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)Nt(X.__webglFramebuffer[te][ne],C,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ne);else Nt(X.__webglFramebuffer[te],C,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);w(y)?S(n.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let te=0,ne=oe.length;te<ne;te++){let pe=oe[te],O=i.get(pe),se=n.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(se=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(se,O.__webglTexture),dt(se,pe),Nt(X.__webglFramebuffer,C,pe,n.COLOR_ATTACHMENT0+te,se,0),w(pe)&&S(se)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(te=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,he.__webglTexture),dt(te,y),y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)Nt(X.__webglFramebuffer[ne],C,y,n.COLOR_ATTACHMENT0,te,ne);else Nt(X.__webglFramebuffer,C,y,n.COLOR_ATTACHMENT0,te,0);w(y)?S(te):y.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&bi(C)}function B(C){let y=C.textures;for(let X=0,he=y.length;X<he;X++){let oe=y[X];if(w(oe)&&oe.mipmapsAutoUpdate===!0){let xe=R(C),ve=i.get(oe).__webglTexture;t.bindTexture(xe,ve),S(xe),t.unbindTexture()}}}let Ce=[];function Je(C){if(C.samples>0){if(be(C)===!1){let y=C.textures,X=C.width,he=C.height,oe=n.COLOR_BUFFER_BIT,xe=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(C),te=y.length>1;if(te)for(let pe=0;pe<y.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let pe=0;pe<y.length;pe++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=i.get(y[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,X,he,0,0,X,he,oe,n.NEAREST),c===!0&&(Ce.length=0,Ce.push(n.COLOR_ATTACHMENT0+pe),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ce.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<y.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=i.get(y[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&c){let y=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function st(C){return Math.min(r.maxSamples,C.samples)}function be(C){let y=i.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Ut(C){let y=o.render.frame;h.get(C)!==y&&(h.set(C,y),C.update())}function He(C,y){let X=C.colorSpace,he=C.format,oe=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||X!==cs&&X!==Rn&&(ot.getTransfer(X)===_t?(he!==Fi||oe!==fi)&&Ge("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ut("WebGLTextures: Unsupported texture color space:",X)),y}function Ze(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(l.width=C.naturalWidth||C.width,l.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(l.width=C.displayWidth,l.height=C.displayHeight):(l.width=C.width,l.height=C.height),l}this.allocateTextureUnit=fe,this.resetTextureUnits=j,this.getTextureUnits=re,this.setTextureUnits=ue,this.setTexture2D=me,this.setTexture2DArray=_e,this.setTexture3D=Ae,this.setTextureCube=ye,this.rebindTextures=ii,this.setupRenderTarget=mi,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=bi,this.setupFrameBufferTexture=Nt,this.useMultisampledRTT=be,this.dispose=W}function cx(n,e){function t(i,r=Rn){let s,o=ot.getTransfer(r);if(i===fi)return n.UNSIGNED_BYTE;if(i===Ws)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Xs)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Gl)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Hl)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===kl)return n.BYTE;if(i===zl)return n.SHORT;if(i===vr)return n.UNSIGNED_SHORT;if(i===Vs)return n.INT;if(i===Ii)return n.UNSIGNED_INT;if(i===ui)return n.FLOAT;if(i===Ui)return n.HALF_FLOAT;if(i===Vl)return n.ALPHA;if(i===Wl)return n.RGB;if(i===Fi)return n.RGBA;if(i===an)return n.DEPTH_COMPONENT;if(i===xn)return n.DEPTH_STENCIL;if(i===qs)return n.RED;if(i===Ys)return n.RED_INTEGER;if(i===_n)return n.RG;if(i===$s)return n.RG_INTEGER;if(i===Ks)return n.RGBA_INTEGER;if(i===Zs||i===Js||i===Qs||i===js)if(o===_t)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===Zs)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Js)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Qs)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===js)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===Zs)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Js)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Qs)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===js)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===fa||i===ua||i===da||i===pa)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===fa)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===ua)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===da)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===pa)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===ma||i===ga||i===xa||i===_a||i===va||i===as||i===Ma)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===ma||i===ga)return o===_t?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===xa)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===_a)return s.COMPRESSED_R11_EAC;if(i===va)return s.COMPRESSED_SIGNED_R11_EAC;if(i===as)return s.COMPRESSED_RG11_EAC;if(i===Ma)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Sa||i===ya||i===ba||i===wa||i===Ea||i===Ta||i===Aa||i===Ra||i===Ca||i===Pa||i===La||i===Da||i===Na||i===Ia)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===Sa)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===ya)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ba)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===wa)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ea)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ta)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Aa)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ra)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Ca)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Pa)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===La)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Da)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Na)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Ia)return o===_t?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ua||i===Fa||i===Oa)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===Ua)return o===_t?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Fa)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Oa)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Ba||i===ka||i===ls||i===za)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===Ba)return s.COMPRESSED_RED_RGTC1_EXT;if(i===ka)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ls)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===za)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===zn?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var gy=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,xy=`
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

}`,Fc=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new yo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new tn({vertexShader:gy,fragmentShader:xy,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new St(new wo(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}};var Oc=class extends Wi{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",c=1,l=null,h=null,f=null,u=null,p=null,g=null,M=typeof XRWebGLBinding<"u",m=new Fc,d={},x=t.getContextAttributes(),w=null,S=null,R=[],A=[],_=new Ke,b=null,F=null,L=new Bi;L.viewport=new bt;let D=new Bi;D.viewport=new bt;let k=[L,D],G=new Cc,U=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=R[ee];return me===void 0&&(me=new ao,R[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=R[ee];return me===void 0&&(me=new ao,R[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=R[ee];return me===void 0&&(me=new ao,R[ee]=me),me.getHandSpace()};function Y(ee){let me=A.indexOf(ee.inputSource);if(me===-1)return;let _e=R[me];_e!==void 0&&(_e.update(ee.inputSource,ee.frame,l||o),_e.dispatchEvent({type:ee.type,data:ee.inputSource}))}function V(){r.removeEventListener("select",Y),r.removeEventListener("selectstart",Y),r.removeEventListener("selectend",Y),r.removeEventListener("squeeze",Y),r.removeEventListener("squeezestart",Y),r.removeEventListener("squeezeend",Y),r.removeEventListener("end",V),r.removeEventListener("inputsourceschange",ce);for(let ee=0;ee<R.length;ee++){let me=A[ee];me!==null&&(A[ee]=null,R[ee].disconnect(me))}U=null,W=null,m.reset();for(let ee in d)delete d[ee];if(e.setRenderTarget(w),p=null,u=null,f=null,r=null,S=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(b),e.setSize(_.width,_.height,!1),F!==null){let ee=F.camera;ee.fov=F.fov,ee.zoom=F.zoom,ee.updateProjectionMatrix(),F=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){s=ee,i.isPresenting===!0&&Ge("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ge("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(ee){l=ee},this.getBaseLayer=function(){return u!==null?u:p},this.getBinding=function(){return f===null&&M&&(f=new XRWebGLBinding(r,t)),f},this.getFrame=function(){return g},this.getSession=function(){return r},this.setSession=async function(ee){if(r=ee,r!==null){if(w=e.getRenderTarget(),r.addEventListener("select",Y),r.addEventListener("selectstart",Y),r.addEventListener("selectend",Y),r.addEventListener("squeeze",Y),r.addEventListener("squeezestart",Y),r.addEventListener("squeezeend",Y),r.addEventListener("end",V),r.addEventListener("inputsourceschange",ce),x.xrCompatible!==!0&&await t.makeXRCompatible(),b=e.getPixelRatio(),e.getSize(_),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,Ae=null,ye=null;x.depth&&(ye=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=x.stencil?xn:an,Ae=x.stencil?zn:Ii);let qe={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:s};f=this.getBinding(),u=f.createProjectionLayer(qe),r.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),S=new Hi(u.textureWidth,u.textureHeight,{format:Fi,type:fi,depthTexture:new yn(u.textureWidth,u.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let _e={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:s};p=new XRWebGLLayer(r,t,_e),r.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new Hi(p.framebufferWidth,p.framebufferHeight,{format:Fi,type:fi,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await r.requestReferenceSpace(a),fe.setContext(r),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ce(ee){for(let me=0;me<ee.removed.length;me++){let _e=ee.removed[me],Ae=A.indexOf(_e);Ae>=0&&(A[Ae]=null,R[Ae].disconnect(_e))}for(let me=0;me<ee.added.length;me++){let _e=ee.added[me],Ae=A.indexOf(_e);if(Ae===-1){for(let qe=0;qe<R.length;qe++)if(qe>=A.length){A.push(_e),Ae=qe;break}else if(A[qe]===null){A[qe]=_e,Ae=qe;break}if(Ae===-1)break}let ye=R[Ae];ye&&ye.connect(_e)}}function Z(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(r===null)return;let me=ee.near,_e=ee.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(_e=m.depthFar)),G.near=D.near=L.near=me,G.far=D.far=L.far=_e,(U!==G.near||W!==G.far)&&(r.updateRenderState({depthNear:G.near,depthFar:G.far}),U=G.near,W=G.far),G.layers.mask=ee.layers.mask|6,L.layers.mask=G.layers.mask&-5,D.layers.mask=G.layers.mask&-3;let Ae=ee.parent,ye=G.cameras;Z(G,Ae);for(let qe=0;qe<ye.length;qe++)Z(ye[qe],Ae);G.projectionMatrix.copy(L.projectionMatrix),G.projectionMatrixInverse.copy(L.projectionMatrixInverse),F===null&&ee.isPerspectiveCamera&&(F={camera:ee,fov:ee.fov,zoom:ee.zoom}),j(ee,G,Ae)};function j(ee,me,_e){_e===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(_e.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Ha*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(u===null&&p===null))return c},this.setFoveation=function(ee){c=ee,u!==null&&(u.fixedFoveation=ee),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(G)},this.getCameraTexture=function(ee){return d[ee]};let re=null;function ue(ee,me){if(h=me.getViewerPose(l||o),g=me,h!==null){let _e=h.views;p!==null&&(e.setRenderTargetFramebuffer(S,p.framebuffer),e.setRenderTarget(S));let Ae=!1;_e.length!==G.cameras.length&&(G.cameras.length=0,Ae=!0);for(let Ve=0;Ve<_e.length;Ve++){let dt=_e[Ve],ht=null;if(p!==null)ht=p.getViewport(dt);else{let Yt=f.getViewSubImage(u,dt);ht=Yt.viewport,Ve===0&&(e.setRenderTargetTextures(S,Yt.colorTexture,Yt.depthStencilTexture),e.setRenderTarget(S))}let it=k[Ve];it===void 0&&(it=new Bi,it.layers.enable(Ve),it.viewport=new bt,k[Ve]=it),it.matrix.fromArray(dt.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(dt.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ht.x,ht.y,ht.width,ht.height),Ve===0&&(G.matrix.copy(it.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Ae===!0&&G.cameras.push(it)}let ye=r.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&M){f=i.getBinding();let Ve=f.getDepthInformation(_e[0]);Ve&&Ve.isValid&&Ve.texture&&m.init(Ve,r.renderState)}if(ye&&ye.includes("camera-access")&&M){e.state.unbindTexture(),f=i.getBinding();for(let Ve=0;Ve<_e.length;Ve++){let dt=_e[Ve].camera;if(dt){let ht=d[dt];ht||(ht=new yo,d[dt]=ht);let it=f.getCameraImage(dt);ht.sourceTexture=it}}}}for(let _e=0;_e<R.length;_e++){let Ae=A[_e],ye=R[_e];Ae!==null&&ye!==void 0&&ye.update(Ae,me,l||o)}re&&re(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let fe=new Pc;fe.setAnimationLoop(ue),this.setAnimationLoop=function(ee){re=ee},this.dispose=function(){}}};var _y=new Le,hx=new $e;hx.set(-1,0,0,0,1,0,0,0,1);function fx(n,e){function t(m,d){m.matrixAutoUpdate===!0&&m.updateMatrix(),d.value.copy(m.matrix)}function i(m,d){d.color.getRGB(m.fogColor.value,Sc(n)),d.isFog?(m.fogNear.value=d.near,m.fogFar.value=d.far):d.isFogExp2&&(m.fogDensity.value=d.density)}function r(m,d,x,w,S){d.isNodeMaterial?d.uniformsNeedUpdate=!1:d.isMeshBasicMaterial?s(m,d):d.isMeshLambertMaterial?(s(m,d),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)):d.isMeshToonMaterial?(s(m,d),f(m,d)):d.isMeshPhongMaterial?(s(m,d),h(m,d),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)):d.isMeshStandardMaterial?(s(m,d),u(m,d),d.isMeshPhysicalMaterial&&p(m,d,S)):d.isMeshMatcapMaterial?(s(m,d),g(m,d)):d.isMeshDepthMaterial?s(m,d):d.isMeshDistanceMaterial?(s(m,d),M(m,d)):d.isMeshNormalMaterial?s(m,d):d.isLineBasicMaterial?(o(m,d),d.isLineDashedMaterial&&a(m,d)):d.isPointsMaterial?c(m,d,x,w):d.isSpriteMaterial?l(m,d):d.isShadowMaterial?(m.color.value.copy(d.color),m.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function s(m,d){m.opacity.value=d.opacity,d.color&&m.diffuse.value.copy(d.color),d.emissive&&m.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(m.map.value=d.map,t(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,t(d.alphaMap,m.alphaMapTransform)),d.bumpMap&&(m.bumpMap.value=d.bumpMap,t(d.bumpMap,m.bumpMapTransform),m.bumpScale.value=d.bumpScale,d.side===jt&&(m.bumpScale.value*=-1)),d.normalMap&&(m.normalMap.value=d.normalMap,t(d.normalMap,m.normalMapTransform),m.normalScale.value.copy(d.normalScale),d.side===jt&&m.normalScale.value.negate()),d.displacementMap&&(m.displacementMap.value=d.displacementMap,t(d.displacementMap,m.displacementMapTransform),m.displacementScale.value=d.displacementScale,m.displacementBias.value=d.displacementBias),d.emissiveMap&&(m.emissiveMap.value=d.emissiveMap,t(d.emissiveMap,m.emissiveMapTransform)),d.specularMap&&(m.specularMap.value=d.specularMap,t(d.specularMap,m.specularMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest);let x=e.get(d),w=x.envMap,S=x.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(_y.makeRotationFromEuler(S)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(hx),m.reflectivity.value=d.reflectivity,m.ior.value=d.ior,m.refractionRatio.value=d.refractionRatio),d.lightMap&&(m.lightMap.value=d.lightMap,m.lightMapIntensity.value=d.lightMapIntensity,t(d.lightMap,m.lightMapTransform)),d.aoMap&&(m.aoMap.value=d.aoMap,m.aoMapIntensity.value=d.aoMapIntensity,t(d.aoMap,m.aoMapTransform))}function o(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,d.map&&(m.map.value=d.map,t(d.map,m.mapTransform))}function a(m,d){m.dashSize.value=d.dashSize,m.totalSize.value=d.dashSize+d.gapSize,m.scale.value=d.scale}function c(m,d,x,w){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.size.value=d.size*x,m.scale.value=w*.5,d.map&&(m.map.value=d.map,t(d.map,m.uvTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,t(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function l(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.rotation.value=d.rotation,d.map&&(m.map.value=d.map,t(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,t(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function h(m,d){m.specular.value.copy(d.specular),m.shininess.value=Math.max(d.shininess,1e-4)}function f(m,d){d.gradientMap&&(m.gradientMap.value=d.gradientMap)}function u(m,d){m.metalness.value=d.metalness,d.metalnessMap&&(m.metalnessMap.value=d.metalnessMap,t(d.metalnessMap,m.metalnessMapTransform)),m.roughness.value=d.roughness,d.roughnessMap&&(m.roughnessMap.value=d.roughnessMap,t(d.roughnessMap,m.roughnessMapTransform)),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)}function p(m,d,x){m.ior.value=d.ior,d.diffuseRoughness>0&&(m.diffuseRoughness.value=d.diffuseRoughness,d.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=d.diffuseRoughnessMap,t(d.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),d.sheen>0&&(m.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),m.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(m.sheenColorMap.value=d.sheenColorMap,t(d.sheenColorMap,m.sheenColorMapTransform)),d.sheenRoughnessMap&&(m.sheenRoughnessMap.value=d.sheenRoughnessMap,t(d.sheenRoughnessMap,m.sheenRoughnessMapTransform))),d.clearcoat>0&&(m.clearcoat.value=d.clearcoat,m.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(m.clearcoatMap.value=d.clearcoatMap,t(d.clearcoatMap,m.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,t(d.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(m.clearcoatNormalMap.value=d.clearcoatNormalMap,t(d.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===jt&&m.clearcoatNormalScale.value.negate())),d.dispersion>0&&(m.dispersion.value=d.dispersion),d.retroreflectivity>0&&(m.retroreflectivity.value=d.retroreflectivity),d.iridescence>0&&(m.iridescence.value=d.iridescence,m.iridescenceIOR.value=d.iridescenceIOR,m.iridescenceThicknessMinimum.value=d.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=d.iridescenceThicknessMaximum,d.iridescenceMap&&(m.iridescenceMap.value=d.iridescenceMap,t(d.iridescenceMap,m.iridescenceMapTransform)),d.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=d.iridescenceThicknessMap,t(d.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),d.transmission>0&&(m.transmission.value=d.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),d.transmissionMap&&(m.transmissionMap.value=d.transmissionMap,t(d.transmissionMap,m.transmissionMapTransform)),m.thickness.value=d.thickness,d.thicknessMap&&(m.thicknessMap.value=d.thicknessMap,t(d.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=d.attenuationDistance,m.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(m.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(m.anisotropyMap.value=d.anisotropyMap,t(d.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=d.specularIntensity,m.specularColor.value.copy(d.specularColor),d.specularColorMap&&(m.specularColorMap.value=d.specularColorMap,t(d.specularColorMap,m.specularColorMapTransform)),d.specularIntensityMap&&(m.specularIntensityMap.value=d.specularIntensityMap,t(d.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,d){d.matcap&&(m.matcap.value=d.matcap)}function M(m,d){let x=e.get(d).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function ux(n,e,t,i){let r={},s={};function o(x,w){let S=w.program;i.uniformBlockBinding(x,S,r[x.id])}function a(x,w){let S=r[x.id];S===void 0&&(g(x),S=c(x),r[x.id]=S,x.addEventListener("dispose",m));let R=w.program;i.updateUBOMapping(x,R);let A=e.render.frame;s[x.id]!==A&&(l(x),s[x.id]=A)}function c(x){let w=n.createBuffer(),S=x.__size,R=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,S,R),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function l(x){let w=r[x.id],S=x.uniforms,R=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let A=0,_=S.length;A<_;A++){let b=S[A];if(Array.isArray(b))for(let F=0,L=b.length;F<L;F++)h(b[F],A,F,R);else h(b,A,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(x,w,S,R){if(u(x,w,S,R)===!0){let A=x.__offset,_=x.value;if(Array.isArray(_)){let b=0;for(let F=0;F<_.length;F++){let L=_[F],D=M(L,!0);f(L,x.__data,b),b+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else f(_,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,x.__data)}}function f(x,w,S){typeof x=="number"||typeof x=="boolean"?w[S]=x:x.isMatrix3?(w[S]=x.elements[0],w[S+1]=x.elements[1],w[S+2]=x.elements[2],w[S+3]=0,w[S+4]=x.elements[3],w[S+5]=x.elements[4],w[S+6]=x.elements[5],w[S+7]=0,w[S+8]=x.elements[6],w[S+9]=x.elements[7],w[S+10]=x.elements[8],w[S+11]=0):ArrayBuffer.isView(x)?w.set(x.subarray(0,w.length-S),S):x.toArray(w,S)}function u(x,w,S,R){let A=x.value,_=w+"_"+S;if(Array.isArray(A)){R[_]===void 0&&(R[_]=[]);let b=R[_],F=!1;for(let L=0;L<A.length;L++)p(A[L],b,L)===!0&&(F=!0);return F}return p(A,R,_)}function p(x,w,S){if(w[S]===void 0)return typeof x=="number"||typeof x=="boolean"?w[S]=x:ArrayBuffer.isView(x)?w[S]=x.slice():w[S]=x.clone(),!0;{let R=w[S];if(typeof x=="number"||typeof x=="boolean"){if(R!==x)return w[S]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(R.equals(x)===!1)return R.copy(x),!0}}return!1}function g(x){let w=x.uniforms,S=0,R=16;for(let _=0,b=w.length;_<b;_++){let F=Array.isArray(w[_])?w[_]:[w[_]];for(let L=0,D=F.length;L<D;L++){let k=F[L],G=Array.isArray(k.value)?k.value:[k.value],U=Array.isArray(w[_])||Array.isArray(k.value),W=S;for(let V=0,ce=G.length;V<ce;V++){let Z=G[V],j=M(Z,U),re=S%R,ue=re%j.boundary,fe=re+ue;S+=ue,fe!==0&&R-fe<j.storage&&(S+=R-fe),V===0&&(W=S),S+=j.storage}let Y=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new Y((S-W)/Float32Array.BYTES_PER_ELEMENT),k.__offset=W}}let A=S%R;return A>0&&(S+=R-A),x.__size=S,x.__cache={},this}function M(x,w){let S={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(S.boundary=4,S.storage=4):x.isVector2?(S.boundary=8,S.storage=8):x.isVector3||x.isColor?(S.boundary=16,S.storage=12):x.isVector4?(S.boundary=16,S.storage=16):x.isMatrix3?(S.boundary=16,S.storage=48):x.isMatrix4?(S.boundary=16,S.storage=64):x.isTexture?Ge("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(S.boundary=16,S.storage=x.byteLength):Ge("WebGLRenderer: Unsupported uniform value type.",x),w===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(x){let w=x.target;w.removeEventListener("dispose",m),n.deleteBuffer(r[w.id]),delete r[w.id],delete s[w.id]}function d(){for(let x in r)n.deleteBuffer(r[x]);r={},s={}}return{bind:o,update:a,dispose:d}}var vy=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),lr=null;function dx(){return lr===null&&(lr=new Tr(vy,16,16,_n,Ui),lr.name="DFG_LUT",lr.minFilter=Mi,lr.magFilter=Mi,lr.wrapS=on,lr.wrapT=on,lr.generateMipmaps=!1,lr.needsUpdate=!0),lr}var nl=class{constructor(e={}){let{canvas:t=Yd(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:u=!1,outputBufferType:p=fi}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let M=p,m=new Set([Ks,$s,Ys]),d=new Set([fi,Ii,vr,zn,Ws,Xs]),x=new Uint32Array(4),w=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,A=null,_=[],b=[],F=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=mn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,D=!1,k=null,G=null,U=null,W=null;this._outputColorSpace=en;let Y=0,V=0,ce=null,Z=-1,j=null,re=new bt,ue=new bt,fe=null,ee=new Xe(0),me=0,_e=t.width,Ae=t.height,ye=1,qe=null,rt=null,Ve=new bt(0,0,_e,Ae),dt=new bt(0,0,_e,Ae),ht=!1,it=new cn,Yt=new vc,zt=!1,pi=!1,Nt=new Le,Ci=new N,Mt=new bt,bi={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ii=!1;function mi(){return ce===null?ye:1}let B=i;function Ce(T,z){return t.getContext(T,z)}let Je,st,be,Ut,He,Ze,C,y,X,he,oe,xe,ve,te,ne,pe,O,se,ie,we,ge,Se,We;try{let T={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Re,!1),B===null){let z="webgl2";if(B=Ce(z,T),B===null)throw Ce(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(T){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),ut("WebGLRenderer: "+T.message),T}function je(){Je=new b0(B),Je.init(),ge=new cx(B,Je),st=new p0(B,Je,e,ge),be=new ax(B,Je),st.reversedDepthBuffer&&u&&be.buffers.depth.setReversed(!0),G=B.createFramebuffer(),U=B.createFramebuffer(),W=B.createFramebuffer(),Ut=new T0(B),He=new Z0,Ze=new lx(B,Je,be,He,st,ge,Ut),C=new y0(L),y=new Pp(B),Se=new u0(B,y),X=new w0(B,y,Ut,Se),he=new R0(B,X,y,Se,Ut),se=new A0(B,st,Ze),ne=new m0(He),oe=new K0(L,C,Je,st,Se,ne),xe=new fx(L,He),ve=new j0,te=new ix(Je),O=new f0(L,C,be,he,g,c),pe=new ox(L,he,st),We=new ux(B,Ut,st,be),ie=new d0(B,Je,Ut),we=new E0(B,Je,Ut),Ut.programs=oe.programs,L.capabilities=st,L.extensions=Je,L.properties=He,L.renderLists=ve,L.shadowMap=pe,L.state=be,L.info=Ut}M!==fi&&(F=new C0(M,t.width,t.height,a,r,s));let le=new Oc(L,B);this.xr=le,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let T=Je.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Je.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return ye},this.setPixelRatio=function(T){T!==void 0&&(ye=T,this.setSize(_e,Ae,!1))},this.getSize=function(T){return T.set(_e,Ae)},this.setSize=function(T,z,Q=!0){if(le.isPresenting){Ge("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=T,Ae=z,t.width=Math.floor(T*ye),t.height=Math.floor(z*ye),Q===!0&&(t.style.width=T+"px",t.style.height=z+"px"),F!==null&&F.setSize(t.width,t.height),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(_e*ye,Ae*ye).floor()},this.setDrawingBufferSize=function(T,z,Q){_e=T,Ae=z,ye=Q,t.width=Math.floor(T*Q),t.height=Math.floor(z*Q),this.setViewport(0,0,T,z)},this.setEffects=function(T){if(M===fi){ut("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let z=0;z<T.length;z++)if(T[z].isOutputPass===!0){Ge("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(re)},this.getViewport=function(T){return T.copy(Ve)},this.setViewport=function(T,z,Q,q){T.isVector4?Ve.set(T.x,T.y,T.z,T.w):Ve.set(T,z,Q,q),be.viewport(re.copy(Ve).multiplyScalar(mi()).round())},this.getScissor=function(T){return T.copy(dt)},this.setScissor=function(T,z,Q,q){T.isVector4?dt.set(T.x,T.y,T.z,T.w):dt.set(T,z,Q,q),be.scissor(ue.copy(dt).multiplyScalar(mi()).round())},this.getScissorTest=function(){return ht},this.setScissorTest=function(T){be.setScissorTest(ht=T)},this.setOpaqueSort=function(T){qe=T},this.setTransparentSort=function(T){rt=T},this.getClearColor=function(T){return T.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(T=!0,z=!0,Q=!0){let q=0;if(T){let $=!1;if(ce!==null){let Ee=ce.texture.format;$=m.has(Ee)}if($){let Ee=ce.texture.type,Pe=d.has(Ee),Te=O.getClearColor(),Ne=O.getClearAlpha(),ze=Te.r,tt=Te.g,pt=Te.b;Pe?(x[0]=ze,x[1]=tt,x[2]=pt,x[3]=Ne,B.clearBufferuiv(B.COLOR,0,x)):(w[0]=ze,w[1]=tt,w[2]=pt,w[3]=Ne,B.clearBufferiv(B.COLOR,0,w))}else q|=B.COLOR_BUFFER_BIT}z&&(q|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(q|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&B.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),k=T},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),O.dispose(),ve.dispose(),te.dispose(),Ze.dispose(),He.dispose(),C.dispose(),he.dispose(),X.dispose(),Se.dispose(),We.dispose(),oe.dispose(),le.dispose(),le.removeEventListener("sessionstart",bl),le.removeEventListener("sessionend",$n),dr.stop()};function Be(T){T.preventDefault(),mf("WebGLRenderer: Context Lost."),D=!0}function et(){mf("WebGLRenderer: Context Restored."),D=!1;let T=Ut.autoReset,z=pe.enabled,Q=pe.autoUpdate,q=pe.needsUpdate,$=pe.type;je(),Ut.autoReset=T,pe.enabled=z,pe.autoUpdate=Q,pe.needsUpdate=q,pe.type=$}function Re(T){ut("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function lt(T){let z=T.target;z.removeEventListener("dispose",lt),Ht(z)}function Ht(T){Ki(T),He.remove(T)}function Ki(T){let z=He.get(T).programs;z!==void 0&&(z.forEach(function(Q){oe.releaseProgram(Q)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,Q,q,$,Ee){z===null&&(z=bi);let Pe=$.isMesh&&$.matrixWorld.determinantAffine()<0,Te=Zo(T,z,Q,q,$);be.setMaterial(q,Pe);let Ne=Q.index,ze=1;if(q.wireframe===!0){if(Ne=X.getWireframeAttribute(Q),Ne===void 0)return;ze=2}let tt=Q.drawRange,pt=Q.attributes.position,ke=tt.start*ze,mt=(tt.start+tt.count)*ze;Ee!==null&&(ke=Math.max(ke,Ee.start*ze),mt=Math.min(mt,(Ee.start+Ee.count)*ze)),Ne!==null?(ke=Math.max(ke,0),mt=Math.min(mt,Ne.count)):pt!=null&&(ke=Math.max(ke,0),mt=Math.min(mt,pt.count));let Qt=mt-ke;if(Qt<0||Qt===1/0)return;Se.setup($,q,Te,Q,Ne);let Pt,Lt=ie;if(Ne!==null&&(Pt=y.get(Ne),Lt=we,Lt.setIndex(Pt)),$.isMesh)q.wireframe===!0?(be.setLineWidth(q.wireframeLinewidth*mi()),Lt.setMode(B.LINES)):Lt.setMode(B.TRIANGLES);else if($.isLine){let wi=q.linewidth;wi===void 0&&(wi=1),be.setLineWidth(wi*mi()),$.isLineSegments?Lt.setMode(B.LINES):$.isLineLoop?Lt.setMode(B.LINE_LOOP):Lt.setMode(B.LINE_STRIP)}else $.isPoints?Lt.setMode(B.POINTS):$.isSprite&&Lt.setMode(B.TRIANGLES);if($.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Lt.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let wi=$._multiDrawStarts,Fe=$._multiDrawCounts,gi=$._multiDrawCount,xt=Ne?y.get(Ne).bytesPerElement:1,mr=He.get(q).currentProgram.getUniforms();for(let xi=0;xi<gi;xi++)mr.setValue(B,"_gl_DrawID",xi),Lt.render(wi[xi]/xt,Fe[xi])}else if($.isInstancedMesh)Lt.renderInstances(ke,Qt,$.count);else if(Q.isInstancedBufferGeometry){let wi=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Fe=Math.min(Q.instanceCount,wi);Lt.renderInstances(ke,Qt,Fe)}else Lt.render(ke,Qt)};function Yo(T,z,Q,q){k!==null&&T.isNodeMaterial&&k.setObject(q,T),zt===!0&&ne.setState(T,Q,!1),T.transparent===!0&&T.side===zi&&T.forceSinglePass===!1?(T.side=jt,T.needsUpdate=!0,Kn(T,z,q),T.side=sn,T.needsUpdate=!0,Kn(T,z,q),T.side=zi):Kn(T,z,q)}this.compile=function(T,z,Q=null){Q===null&&(Q=T),k!==null&&k.renderStart(T,z,Q),A=te.get(Q),A.init(z),b.push(A),Q.traverseVisible(function($){$.isLight&&$.layers.test(z.layers)&&(A.pushLight($),$.castShadow&&A.pushShadow($))}),T!==Q&&T.traverseVisible(function($){$.isLight&&$.layers.test(z.layers)&&(A.pushLight($),$.castShadow&&A.pushShadow($))}),A.setupLights(),k!==null&&k.updateLights(A.state.lightsArray),pi=this.localClippingEnabled,zt=ne.init(this.clippingPlanes,pi),zt===!0&&ne.setGlobalState(this.clippingPlanes,z),k!==null&&pe.render(A.state.shadowsArray,Q,z);let q=new Set;return T.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Ee=$.material;if(Ee)if(Array.isArray(Ee))for(let Pe=0;Pe<Ee.length;Pe++){let Te=Ee[Pe];Yo(Te,Q,z,$),q.add(Te)}else Yo(Ee,Q,z,$),q.add(Ee)}),A=b.pop(),k!==null&&k.renderEnd(),q},this.compileAsync=function(T,z,Q=null){let q=this.compile(T,z,Q);return new Promise($=>{function Ee(){if(q.forEach(function(Pe){let Ne=He.get(Pe).currentProgram;(Ne===void 0||Ne.isReady())&&q.delete(Pe)}),q.size===0){$(T);return}setTimeout(Ee,10)}Je.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let Ps=null;function Qh(T){Ps&&Ps(T)}function bl(){dr.stop()}function $n(){dr.start()}let dr=new Pc;dr.setAnimationLoop(Qh),typeof self<"u"&&dr.setContext(self),this.setAnimationLoop=function(T){Ps=T,le.setAnimationLoop(T),T===null?dr.stop():dr.start()},le.addEventListener("sessionstart",bl),le.addEventListener("sessionend",$n),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){ut("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;k!==null&&k.renderStart(T,z);let Q=le.enabled===!0&&le.isPresenting===!0,q=F!==null&&(ce===null||Q)&&F.begin(L,ce);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(z),z=le.getCamera()),T.isScene===!0&&T.onBeforeRender(L,T,z,ce),A=te.get(T,b.length),A.init(z),A.state.textureUnits=Ze.getTextureUnits(),b.push(A),Nt.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Yt.setFromArrayCamera(z):it.setFromProjectionMatrix(Nt,Gi,z.reversedDepth),pi=this.localClippingEnabled,zt=ne.init(this.clippingPlanes,pi),R=ve.get(T,_.length),R.init(),_.push(R),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Pe=L.xr.getDepthSensingMesh();Pe!==null&&pr(Pe,z,-1/0,L.sortObjects)}pr(T,z,0,L.sortObjects),R.finish(),k!==null&&k.updateLights(A.state.lightsArray),L.sortObjects===!0&&R.sort(qe,rt),ii=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,ii&&O.addToRenderList(R,T),this.info.autoReset===!0&&this.info.reset(),zt===!0&&ne.beginShadows();let $=A.state.shadowsArray;if(pe.render($,T,z),zt===!0&&ne.endShadows(),(q&&F.hasRenderPass())===!1){let Pe=R.opaque,Te=R.transmissive;if(A.setupLights(),z.isArrayCamera){let Ne=z.cameras;if(Te.length>0)for(let ze=0,tt=Ne.length;ze<tt;ze++){let pt=Ne[ze];On(Pe,Te,T,pt)}ii&&O.render(T);for(let ze=0,tt=Ne.length;ze<tt;ze++){let pt=Ne[ze];$o(R,T,pt,pt.viewport)}}else Te.length>0&&On(Pe,Te,T,z),ii&&O.render(T),$o(R,T,z)}ce!==null&&V===0&&(Ze.updateMultisampleRenderTarget(ce),Ze.updateRenderTargetMipmap(ce)),q&&F.end(L),T.isScene===!0&&T.onAfterRender(L,T,z),Se.resetDefaultState(),Z=-1,j=null,b.pop(),b.length>0?(A=b[b.length-1],Ze.setTextureUnits(A.state.textureUnits),zt===!0&&ne.setGlobalState(L.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,k!==null&&k.renderEnd()};function pr(T,z,Q,q){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)Q=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)A.pushLight(T),T.castShadow&&A.pushShadow(T);else if(T.isSprite){let Pe=z.isArrayCamera?Yt:it;if(!T.frustumCulled||T.intersectsFrustum(Pe)){q&&Mt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Nt);let Te=he.update(T),Ne=T.material;Ne.visible&&R.push(T,Te,Ne,Q,Mt.z,null,z)}}else if(T.isMesh||T.isLine||T.isPoints){let Pe=z.isArrayCamera?Yt:it;if(!T.frustumCulled||T.intersectsFrustum(Pe)){let Te=he.update(T),Ne=T.material;if(q&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),Mt.copy(T.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),Mt.copy(Te.boundingSphere.center)),Mt.applyMatrix4(T.matrixWorld).applyMatrix4(Nt)),Array.isArray(Ne)){let ze=Te.groups;for(let tt=0,pt=ze.length;tt<pt;tt++){let ke=ze[tt],mt=Ne[ke.materialIndex];mt&&mt.visible&&R.push(T,Te,mt,Q,Mt.z,ke,z)}}else Ne.visible&&R.push(T,Te,Ne,Q,Mt.z,null,z)}}}let Ee=T.children;for(let Pe=0,Te=Ee.length;Pe<Te;Pe++)pr(Ee[Pe],z,Q,q)}function $o(T,z,Q,q){let{opaque:$,transmissive:Ee,transparent:Pe}=T;A.setupLightsView(Q),zt===!0&&ne.setGlobalState(L.clippingPlanes,Q),q&&be.viewport(re.copy(q)),$.length>0&&ni($,z,Q),Ee.length>0&&ni(Ee,z,Q),Pe.length>0&&ni(Pe,z,Q),be.buffers.depth.setTest(!0),be.buffers.depth.setMask(!0),be.buffers.color.setMask(!0),be.setPolygonOffset(!1)}function On(T,z,Q,q){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[q.id]===void 0){let ke=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[q.id]=new Hi(1,1,{generateMipmaps:!0,type:ke?Ui:fi,minFilter:gn,samples:Math.max(4,st.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ot.workingColorSpace})}let Ee=A.state.transmissionRenderTarget[q.id],Pe=q.viewport||re;Ee.setSize(Pe.z*L.transmissionResolutionScale,Pe.w*L.transmissionResolutionScale);let Te=L.getRenderTarget(),Ne=L.getActiveCubeFace(),ze=L.getActiveMipmapLevel();L.setRenderTarget(Ee),L.getClearColor(ee),me=L.getClearAlpha(),me<1&&L.setClearColor(16777215,.5),L.clear(),ii&&O.render(Q);let tt=L.toneMapping;L.toneMapping=mn;let pt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),A.setupLightsView(q),zt===!0&&ne.setGlobalState(L.clippingPlanes,q),ni(T,Q,q),Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee),Je.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let mt=0,Qt=z.length;mt<Qt;mt++){let Pt=z[mt],{object:Lt,geometry:wi,material:Fe,group:gi}=Pt;if(Fe.side===zi&&Lt.layers.test(q.layers)){let xt=Fe.side;Fe.side=jt,Fe.needsUpdate=!0,ci(Lt,Q,q,wi,Fe,gi),Fe.side=xt,Fe.needsUpdate=!0,ke=!0}}ke===!0&&(Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee))}L.setRenderTarget(Te,Ne,ze),L.setClearColor(ee,me),pt!==void 0&&(q.viewport=pt),L.toneMapping=tt}function ni(T,z,Q){let q=z.isScene===!0?z.overrideMaterial:null;for(let $=0,Ee=T.length;$<Ee;$++){let Pe=T[$],{object:Te,geometry:Ne,group:ze}=Pe,tt=Pe.material;tt.allowOverride===!0&&q!==null&&(tt=q),Te.layers.test(Q.layers)&&ci(Te,z,Q,Ne,tt,ze)}}function ci(T,z,Q,q,$,Ee){k!==null&&$.isNodeMaterial&&k.setObject(T,$),T.onBeforeRender(L,z,Q,q,$,Ee),T.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),$.onBeforeRender(L,z,Q,q,T,Ee),$.transparent===!0&&$.side===zi&&$.forceSinglePass===!1?($.side=jt,$.needsUpdate=!0,L.renderBufferDirect(Q,z,q,$,T,Ee),$.side=sn,$.needsUpdate=!0,L.renderBufferDirect(Q,z,q,$,T,Ee),$.side=zi):L.renderBufferDirect(Q,z,q,$,T,Ee),T.onAfterRender(L,z,Q,q,$,Ee)}function hi(T){let z=0;for(let Q of T)Q.texture!==null&&z++;return z}function Kn(T,z,Q){z.isScene!==!0&&(z=bi);let q=He.get(T),$=A.state.lights,Ee=A.state.shadowsArray,Pe=$.state.version,Te=oe.getParameters(T,$.state,Ee,z,Q,A.state.lightProbeGridArray),Ne=oe.getProgramCacheKey(Te),ze=q.programs;q.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?z.environment:null,q.fog=z.fog;let tt=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;q.envMap=C.get(T.envMap||q.environment,tt),q.envMapRotation=q.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,ze===void 0&&(T.addEventListener("dispose",lt),ze=new Map,q.programs=ze,q.programVariants=new Map);let pt=ze.get(Ne);if(pt!==void 0){if(q.currentProgram===pt&&q.lightsStateVersion===Pe)return Ko(T,Te),pt}else Te.uniforms=oe.getUniforms(T),k!==null&&T.isNodeMaterial&&k.build(T,Q,Te),T.onBeforeCompile(Te,L),pt=oe.acquireProgram(Te,Ne),ze.set(Ne,pt),q.uniforms=Te.uniforms;let ke=q.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(ke.clippingPlanes=ne.uniform),Ko(T,Te),q.needsLights=Ir(T),q.lightsStateVersion=Pe,q.needsLights&&(ke.ambientLightColor.value=$.state.ambient,ke.lightProbe.value=$.state.probe,ke.sunLights.value=$.state.sun,ke.sunLightShadows.value=$.state.sunShadow,ke.directionalLights.value=$.state.directional,ke.directionalLightShadows.value=$.state.directionalShadow,ke.spotLights.value=$.state.spot,ke.spotLightShadows.value=$.state.spotShadow,ke.rectAreaLights.value=$.state.rectArea,ke.ltc_1.value=$.state.rectAreaLTC1,ke.ltc_2.value=$.state.rectAreaLTC2,ke.pointLights.value=$.state.point,ke.pointLightShadows.value=$.state.pointShadow,ke.hemisphereLights.value=$.state.hemi,ke.sunShadowMatrix.value=$.state.sunShadowMatrix,ke.sunShadowCascade.value=$.state.sunShadowCascade,ke.directionalShadowMatrix.value=$.state.directionalShadowMatrix,ke.spotLightMatrix.value=$.state.spotLightMatrix,ke.spotLightMap.value=$.state.spotLightMap,ke.pointShadowMatrix.value=$.state.pointShadowMatrix),q.numLightProbeGrids=hi(A.state.lightProbeGridArray),q.currentProgram=pt,q.uniformsList=null,pt}function fn(T,z,Q,q,$){let Ee=He.get(T),Pe=Ee.currentProgram.id+","+q+","+$,Te=Ee.programVariants.get(Pe);return Te===void 0?(Te=Kn(T,z,Q),Ee.programVariants.set(Pe,Te)):(Ee.currentProgram=Te,Ee.uniformsList=null,Ee.outputColorSpace=q,Ee.toneMapping=$),Te}function Nr(T){if(T.uniformsList===null){let z=T.currentProgram.getUniforms();T.uniformsList=jr.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function Ko(T,z){let Q=He.get(T);Q.outputColorSpace=z.outputColorSpace,Q.batching=z.batching,Q.batchingColor=z.batchingColor,Q.instancing=z.instancing,Q.instancingColor=z.instancingColor,Q.instancingMorph=z.instancingMorph,Q.skinning=z.skinning,Q.morphTargets=z.morphTargets,Q.morphNormals=z.morphNormals,Q.morphColors=z.morphColors,Q.morphTargetsCount=z.morphTargetsCount,Q.numClippingPlanes=z.numClippingPlanes,Q.numIntersection=z.numClipIntersection,Q.vertexAlphas=z.vertexAlphas,Q.vertexTangents=z.vertexTangents,Q.toneMapping=z.toneMapping}function Zo(T,z,Q,q,$){z.isScene!==!0&&(z=bi),Ze.resetTextureUnits();let Ee=z.fog,Pe=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?z.environment:null,Te=ce===null?L.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:ot.workingColorSpace,Ne=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,ze=C.get(q.envMap||Pe,Ne),tt=q.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,pt=!!Q.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),ke=!!Q.morphAttributes.position,mt=!!Q.morphAttributes.normal,Qt=!!Q.morphAttributes.color,Pt=mn;q.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Pt=L.toneMapping);let Lt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,wi=Lt!==void 0?Lt.length:0,Fe=He.get(q),gi=A.state.lights;if(zt===!0&&(pi===!0||T!==j)){let Dt=T===j&&q.id===Z;ne.setState(q,T,Dt)}let xt=!1,mr=!1;q.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==gi.state.version||$.isBatchedMesh&&Fe.batching===!1||!$.isBatchedMesh&&Fe.batching===!0||$.isBatchedMesh&&Fe.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&Fe.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&Fe.instancing===!1||!$.isInstancedMesh&&Fe.instancing===!0||$.isSkinnedMesh&&Fe.skinning===!1||!$.isSkinnedMesh&&Fe.skinning===!0||$.isInstancedMesh&&Fe.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&Fe.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&Fe.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&Fe.instancingMorph===!1&&$.morphTexture!==null||Fe.envMap!==ze||q.fog===!0&&Fe.fog!==Ee||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ne.numPlanes||Fe.numIntersection!==ne.numIntersection)||Fe.vertexAlphas!==tt||Fe.vertexTangents!==pt||Fe.morphTargets!==ke||Fe.morphNormals!==mt||Fe.morphColors!==Qt||Fe.morphTargetsCount!==wi||Fe.numLightProbeGrids!==hi(A.state.lightProbeGridArray)?xt=!0:(Fe.outputColorSpace!==Te||Fe.toneMapping!==Pt)&&(mr=!0):(xt=!0,Fe.__version=q.version);let xi=Fe.currentProgram;(xt===!0||mr===!0)&&(xi=mr===!0?fn(q,z,$,Te,Pt):Kn(q,z,$),k&&q.isNodeMaterial&&k.onUpdateProgram(q,xi,Fe));let Ns=!1,Zn=!1,gr=!1,ft=xi.getUniforms(),ri=Fe.uniforms;if(be.useProgram(xi.program)&&(Ns=!0,Zn=!0,gr=!0),q.id!==Z&&(Z=q.id,Zn=!0),Ns||j!==T){be.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),ft.setValue(B,"projectionMatrix",T.projectionMatrix),ft.setValue(B,"viewMatrix",T.matrixWorldInverse);let _i=ft.map.cameraPosition;_i!==void 0&&_i.setValue(B,Ci.setFromMatrixPosition(T.matrixWorld)),st.logarithmicDepthBuffer&&ft.setValue(B,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&ft.setValue(B,"isOrthographic",T.isOrthographicCamera===!0),j!==T&&(j=T,Zn=!0,gr=!0)}if(Fe.needsLights&&(gi.state.sunShadowMap.length>0&&ft.setValue(B,"sunShadowMap",gi.state.sunShadowMap,Ze),gi.state.directionalShadowMap.length>0&&ft.setValue(B,"directionalShadowMap",gi.state.directionalShadowMap,Ze),gi.state.spotShadowMap.length>0&&ft.setValue(B,"spotShadowMap",gi.state.spotShadowMap,Ze),gi.state.pointShadowMap.length>0&&ft.setValue(B,"pointShadowMap",gi.state.pointShadowMap,Ze)),$.isSkinnedMesh){ft.setOptional(B,$,"bindMatrix"),ft.setOptional(B,$,"bindMatrixInverse");let Dt=$.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),ft.setValue(B,"boneTexture",Dt.boneTexture,Ze))}$.isBatchedMesh&&(ft.setOptional(B,$,"batchingTexture"),ft.setValue(B,"batchingTexture",$._matricesTexture,Ze),ft.setOptional(B,$,"batchingIdTexture"),ft.setValue(B,"batchingIdTexture",$._indirectTexture,Ze),ft.setOptional(B,$,"batchingColorTexture"),$._colorsTexture!==null&&ft.setValue(B,"batchingColorTexture",$._colorsTexture,Ze));let Zi=Q.morphAttributes;if((Zi.position!==void 0||Zi.normal!==void 0||Zi.color!==void 0)&&se.update($,Q,xi),(Zn||Fe.receiveShadow!==$.receiveShadow)&&(Fe.receiveShadow=$.receiveShadow,ft.setValue(B,"receiveShadow",$.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&z.environment!==null&&(ri.envMapIntensity.value=z.environmentIntensity),ri.dfgLUT!==void 0&&(ri.dfgLUT.value=dx()),Zn){if(ft.setValue(B,"toneMappingExposure",L.toneMappingExposure),Fe.needsLights&&Ls(ri,gr),Ee&&q.fog===!0&&xe.refreshFogUniforms(ri,Ee),xe.refreshMaterialUniforms(ri,q,ye,Ae,A.state.transmissionRenderTarget[T.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Dt=S,_i=0;for(let Vi of A.state.lightProbeGridArray)Vi.texture!==null&&(Dt.textures[_i]=Vi.texture,Dt.min[_i]=Vi.boundingBox.min,Dt.max[_i]=Vi.boundingBox.max,Dt.resolution[_i]=Vi.resolution,_i++);for(let Vi in Dt)Dt[Vi].length=_i;ri.probesSH.value=Dt.textures,ri.probesMin.value=Dt.min,ri.probesMax.value=Dt.max,ri.probesResolution.value=Dt.resolution}jr.upload(B,Nr(Fe),ri,Ze)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(jr.upload(B,Nr(Fe),ri,Ze),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&ft.setValue(B,"center",$.center),ft.setValue(B,"modelViewMatrix",$.modelViewMatrix),ft.setValue(B,"normalMatrix",$.normalMatrix),ft.setValue(B,"modelMatrix",$.matrixWorld),q.uniformsGroups!==void 0){let Dt=q.uniformsGroups;for(let _i=0,Vi=Dt.length;_i<Vi;_i++){let wl=Dt[_i];We.update(wl,xi),We.bind(wl,xi)}}return xi}function Ls(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.sunLights.needsUpdate=z,T.sunLightShadows.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function Ir(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(T,z,Q){let q=He.get(T);q.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),He.get(T.texture).__webglTexture=z,He.get(T.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:Q,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,z){let Q=He.get(T);Q.__webglFramebuffer=z,Q.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,Q=0){ce=T,Y=z,V=Q;let q=null,$=!1,Ee=!1;if(T){let Te=He.get(T);if(Te.__useDefaultFramebuffer!==void 0){be.bindFramebuffer(B.FRAMEBUFFER,Te.__webglFramebuffer),re.copy(T.viewport),ue.copy(T.scissor),fe=T.scissorTest,be.viewport(re),be.scissor(ue),be.setScissorTest(fe),Z=-1;return}else if(Te.__webglFramebuffer===void 0)Ze.setupRenderTarget(T);else if(Te.__hasExternalTextures)Ze.rebindTextures(T,He.get(T.texture).__webglTexture,He.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let tt=T.depthTexture;if(Te.__boundDepthTexture!==tt){if(tt!==null&&He.has(tt)&&(T.width!==tt.image.width||T.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(T)}}let Ne=T.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ee=!0);let ze=He.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(ze[z])?q=ze[z][Q]:q=ze[z],$=!0):T.samples>0&&Ze.useMultisampledRTT(T)===!1?q=He.get(T).__webglMultisampledFramebuffer:Array.isArray(ze)?q=ze[Q]:q=ze,re.copy(T.viewport),ue.copy(T.scissor),fe=T.scissorTest}else re.copy(Ve).multiplyScalar(ye).floor(),ue.copy(dt).multiplyScalar(ye).floor(),fe=ht;if(Q!==0&&(q=G),be.bindFramebuffer(B.FRAMEBUFFER,q)&&be.drawBuffers(T,q),be.viewport(re),be.scissor(ue),be.setScissorTest(fe),$){let Te=He.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+z,Te.__webglTexture,Q)}else if(Ee){let Te=z;for(let Ne=0;Ne<T.textures.length;Ne++){let ze=He.get(T.textures[Ne]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ne,ze.__webglTexture,Q,Te)}}else if(T!==null&&Q!==0){let Te=He.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Te.__webglTexture,Q)}Z=-1};function Ds(T){let z=He.get(T);return(z.__readFormat!==T.format||z.__readType!==T.type)&&(z.__readFormat=T.format,z.__readType=T.type,z.__formatReadable=st.textureFormatReadable(T.format),z.__typeReadable=st.textureTypeReadable(T.type)),z}this.readRenderTargetPixels=function(T,z,Q,q,$,Ee,Pe,Te=0){if(!(T&&T.isWebGLRenderTarget)){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=He.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ne=Ne[Pe],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){be.bindFramebuffer(B.FRAMEBUFFER,Ne);try{let ze=T.textures[Te],tt=ze.format,pt=ze.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let ke=Ds(ze);if(ke.__formatReadable===!1){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-q&&Q>=0&&Q<=T.height-$&&B.readPixels(z,Q,q,$,ge.convert(tt),ge.convert(pt),Ee)}finally{let ze=ce!==null?He.get(ce).__webglFramebuffer:null;be.bindFramebuffer(B.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(T,z,Q,q,$,Ee,Pe,Te=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=He.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ne=Ne[Pe],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(z>=0&&z<=T.width-q&&Q>=0&&Q<=T.height-$){be.bindFramebuffer(B.FRAMEBUFFER,Ne);let ze=T.textures[Te],tt=ze.format,pt=ze.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let ke=Ds(ze);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.bufferData(B.PIXEL_PACK_BUFFER,Ee.byteLength,B.STREAM_READ),B.readPixels(z,Q,q,$,ge.convert(tt),ge.convert(pt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Qt=ce!==null?He.get(ce).__webglFramebuffer:null;be.bindFramebuffer(B.FRAMEBUFFER,Qt);let Pt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await Kd(B,Pt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Ee),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(mt),B.deleteSync(Pt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,z=null,Q=0){let q=Math.pow(2,-Q),$=Math.floor(T.image.width*q),Ee=Math.floor(T.image.height*q),Pe=z!==null?z.x:0,Te=z!==null?z.y:0;Ze.setTexture2D(T,0),B.copyTexSubImage2D(B.TEXTURE_2D,Q,0,0,Pe,Te,$,Ee),be.unbindTexture()},this.copyTextureToTexture=function(T,z,Q=null,q=null,$=0,Ee=0){let Pe,Te,Ne,ze,tt,pt,ke,mt,Qt,Pt=T.isCompressedTexture?T.mipmaps[Ee]:T.image;if(Q!==null)Pe=Q.max.x-Q.min.x,Te=Q.max.y-Q.min.y,Ne=Q.isBox3?Q.max.z-Q.min.z:1,ze=Q.min.x,tt=Q.min.y,pt=Q.isBox3?Q.min.z:0;else{let ft=Math.pow(2,-$);Pe=Math.floor(Pt.width*ft),Te=Math.floor(Pt.height*ft),T.isDataArrayTexture?Ne=Pt.depth:T.isData3DTexture?Ne=Math.floor(Pt.depth*ft):Ne=1,ze=0,tt=0,pt=0}q!==null?(ke=q.x,mt=q.y,Qt=q.z):(ke=0,mt=0,Qt=0);let Lt=ge.convert(z.format),wi=ge.convert(z.type),Fe;z.isData3DTexture?(Ze.setTexture3D(z,0),Fe=B.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Ze.setTexture2DArray(z,0),Fe=B.TEXTURE_2D_ARRAY):(Ze.setTexture2D(z,0),Fe=B.TEXTURE_2D),be.activeTexture(B.TEXTURE0),be.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,z.flipY),be.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),be.pixelStorei(B.UNPACK_ALIGNMENT,z.unpackAlignment);let gi=be.getParameter(B.UNPACK_ROW_LENGTH),xt=be.getParameter(B.UNPACK_IMAGE_HEIGHT),mr=be.getParameter(B.UNPACK_SKIP_PIXELS),xi=be.getParameter(B.UNPACK_SKIP_ROWS),Ns=be.getParameter(B.UNPACK_SKIP_IMAGES);be.pixelStorei(B.UNPACK_ROW_LENGTH,Pt.width),be.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Pt.height),be.pixelStorei(B.UNPACK_SKIP_PIXELS,ze),be.pixelStorei(B.UNPACK_SKIP_ROWS,tt),be.pixelStorei(B.UNPACK_SKIP_IMAGES,pt);let Zn=T.isDataArrayTexture||T.isData3DTexture,gr=z.isDataArrayTexture||z.isData3DTexture;if(T.isDepthTexture){let ft=He.get(T),ri=He.get(z),Zi=He.get(ft.__renderTarget),Dt=He.get(ri.__renderTarget);be.bindFramebuffer(B.READ_FRAMEBUFFER,Zi.__webglFramebuffer),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let _i=0;_i<Ne;_i++)Zn&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(T).__webglTexture,$,pt+_i),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(z).__webglTexture,Ee,Qt+_i)),B.blitFramebuffer(ze,tt,ze+Pe,tt+Te,ke,mt,ke+Pe,mt+Te,B.DEPTH_BUFFER_BIT,B.NEAREST);be.bindFramebuffer(B.READ_FRAMEBUFFER,null),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if($!==0||T.isRenderTargetTexture||He.has(T)){let ft=He.get(T),ri=He.get(z);be.bindFramebuffer(B.READ_FRAMEBUFFER,U),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,W);for(let Zi=0;Zi<Ne;Zi++)Zn?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ft.__webglTexture,$,pt+Zi):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ft.__webglTexture,$),gr?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ri.__webglTexture,Ee,Qt+Zi):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ri.__webglTexture,Ee),$!==0?B.blitFramebuffer(ze,tt,ze+Pe,tt+Te,ke,mt,ke+Pe,mt+Te,B.COLOR_BUFFER_BIT,B.NEAREST):gr?B.copyTexSubImage3D(Fe,Ee,ke,mt,Qt+Zi,ze,tt,Pe,Te):B.copyTexSubImage2D(Fe,Ee,ke,mt,ze,tt,Pe,Te);be.bindFramebuffer(B.READ_FRAMEBUFFER,null),be.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else gr?T.isDataTexture||T.isData3DTexture?B.texSubImage3D(Fe,Ee,ke,mt,Qt,Pe,Te,Ne,Lt,wi,Pt.data):z.isCompressedArrayTexture?B.compressedTexSubImage3D(Fe,Ee,ke,mt,Qt,Pe,Te,Ne,Lt,Pt.data):B.texSubImage3D(Fe,Ee,ke,mt,Qt,Pe,Te,Ne,Lt,wi,Pt):T.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Ee,ke,mt,Pe,Te,Lt,wi,Pt.data):T.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Ee,ke,mt,Pt.width,Pt.height,Lt,Pt.data):B.texSubImage2D(B.TEXTURE_2D,Ee,ke,mt,Pe,Te,Lt,wi,Pt);be.pixelStorei(B.UNPACK_ROW_LENGTH,gi),be.pixelStorei(B.UNPACK_IMAGE_HEIGHT,xt),be.pixelStorei(B.UNPACK_SKIP_PIXELS,mr),be.pixelStorei(B.UNPACK_SKIP_ROWS,xi),be.pixelStorei(B.UNPACK_SKIP_IMAGES,Ns),Ee===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&B.generateMipmap(Fe),be.unbindTexture()},this.initRenderTarget=function(T){He.get(T).__webglFramebuffer===void 0&&Ze.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Ze.setTextureCube(T,0):T.isData3DTexture?Ze.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Ze.setTexture2DArray(T,0):Ze.setTexture2D(T,0),be.unbindTexture()},this.resetState=function(){Y=0,V=0,ce=null,be.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Gi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=ot._getDrawingBufferColorSpace(e),t.unpackColorSpace=ot._getUnpackColorSpace()}};function px(n,e,t,i){if(!n)return e.clone().multiplyScalar(t).setZ(i);let[r]=n,s=r*Math.exp(i/r),o=t/r;return e.clone().multiplyScalar(s*Math.sin(o)).setZ(s*Math.cos(o)-r)}function Bc(n,e,t,i,r){let[s,o]=n,a=Math.abs(i),c=i<0?-1:1,l=Math.cos(r/s),h=Math.sin(r/s),f=a*(l-c*t*h),u=a*(-h-c*t*l),p=f*Math.sin(e),g=p*Math.cos(o)-u*Math.sin(o),M=p*Math.sin(o)+u*Math.cos(o);return{circumferential:new N(0,c*f*Math.cos(e),0),radial:new N(Math.cos(o),0,-Math.sin(o)).multiplyScalar(g),axial:new N(Math.sin(o),0,Math.cos(o)).multiplyScalar(M)}}function Do(n,e){let t=n.length;if(t<2||e<=n[0])return{low:0,share:0};if(e>=n[t-1])return{low:t-2,share:1};let i=0,r=t-1;for(;r-i>1;){let o=i+r>>1;n[o]<=e?i=o:r=o}let s=n[i+1]-n[i];return{low:i,share:s>0?(e-n[i])/s:0}}function Jt(n,e,t=0){let{data:i,width:r,count:s}=n;if(s===1)return i[t];let o=e.low*r+t;return e.share?i[o]+e.share*(i[o+r]-i[o]):i[o]}function No(n){let e=new Float64Array(n.width);for(let t=0;t<n.data.length;t++)e[t%n.width]+=n.data[t];return e.map(t=>t/Math.max(n.count,1))}var mx=(n,e)=>(n%e+e)%e;function _s(n,e,t){let i=e.side*Math.tan(n.base_helix),[r,s]=n.width,[o,a]=n.path,c=n.base_pitch,l=[i*r,i*s],h=[],f=Math.ceil((t+Math.min(...l)-a)/c),u=Math.floor((t+Math.max(...l)-o)/c);for(let p=f;p<=u;p++){let g=t-p*c,M=i?[(o-g)/i,(a-g)/i]:[r,s];if(!i&&(g<o||g>a))continue;let m=Math.max(r,Math.min(...M)),d=Math.min(s,Math.max(...M));d>=m&&h.push({pair:p,place:g,slope:i,from:m,to:d})}return h}var kc=class{constructor(e,t){this.contact=e,this.poses=t,this.name=e.name,this.greatest=Math.max(0,...e.flanks.map(i=>My(i.loads))),this.pairs=Math.max(0,...e.flanks.map(i=>i.forces?.width??0)),this.matrix=new Le}frame(){let{contact:e,poses:t}=this,{where:i}=t;return gx.set(...[0,1,2,3].map(r=>Jt(e.axes,i,r))).normalize(),xx.set(...[0,1,2].map(r=>Jt(e.at,i,r))),this.matrix.compose(xx,gx,Sy)}normal(e){let t=Jt(this.contact.pressure_angle,this.poses.where);return new N(Math.sin(t),e*Math.cos(t),0)}lines(){let e=this.frame();return this.contact.flanks.flatMap(t=>{let i=Jt(t.travel,this.poses.where),r=this.normal(t.side),s=(o,a)=>px(this.contact.cone,r,o,a).applyMatrix4(e);return _s(this.contact,t,i).map(({pair:o,place:a,slope:c,from:l,to:h})=>{let{force:f,loads:u}=this.#e(t,o),p=u.reduce((m,d)=>m+d,0),g=p?u.reduce((m,d,x)=>m+d*x/(u.length-1),0)/p:.5,M=m=>{let d=l+m*(h-l);return s(a+c*d,d)};return{pair:o,side:t.side,slot:mx(o,Math.max(1,this.pairs)),from:M(0),to:M(1),at:M,centre:M(g),ray:a+c*(l+g*(h-l)),force:f,loads:u,ends:[l,h].map(m=>[a+c*m,m])}})})}#e(e,t){let i=new Float64Array(e.loads?e.loads.shape[2]:2),r=0;if(!e.loads)return{force:r,loads:i};let s=mx(t,e.forces.width),{low:o,share:a}=this.poses.where;return(a?[o,o+1]:[o]).forEach((l,h)=>{let f=h?a:1-a,u=e.travel.data[l];if(!_s(this.contact,e,u).some(g=>g.pair===t))return;r+=f*e.forces.data[l*e.forces.width+s];let p=l*e.loads.width+s*i.length;for(let g=0;g<i.length;g++)i[g]+=f*e.loads.data[p+g]}),{force:r,loads:i}}penetration(){let{penetration:e}=this.contact;return{1:Jt(e,this.poses.where,0),"-1":Jt(e,this.poses.where,1)}}pairForces(e){let t=this.matrix,i=Jt(this.contact.pressure_angle,this.poses.where),r=Math.tan(this.contact.base_helix),{cone:s}=this.contact,o=(a,c)=>s?Bc(s,i,r,a,c):{circumferential:new N(0,a*Math.cos(i),0),radial:new N(Math.abs(a)*Math.sin(i),0,0),axial:new N(0,0,-a*r)};return Array.from({length:this.pairs},(a,c)=>{let l=e.find(g=>g.slot===c&&g.force),h=o(l?.force??0,l?.ray??0),f={};for(let[g,M]of Object.entries(h))f[g]=M.length(),M.transformDirection(t).setLength(f[g]);let u=Math.hypot(...Object.values(f)),p=l?l.centre:new N().setFromMatrixPosition(t);return{state:l?l.side:0,vectors:h,values:f,at:p,total:u}})}};function My(n){let e=0;for(let t of n?.data??[])t>e&&(e=t);return e}var gx=new Ft,xx=new N,Sy=new N(1,1,1);var Cr=["circumferential","radial","axial"],yy={circumferential:"#d55e00",radial:"#0072b2",axial:"#009e73"},cr={1:{word:"front flank",colour:"#e8b400"},"-1":{word:"back flank",colour:"#b0489a"},2:{word:"both flanks",colour:"#7a5a2a"},0:{word:"no contact",colour:"#8a8f98"}},_x=["#93a9c1","#c1ab8b","#93b5a0","#ad9fc2","#c4a0a0","#8cb0bb"],vx={shaft:"#b3b9bf",bearing:"#6b7885",housing:"#9fb3c6",carrier:"#b9b39c",spring:"#8d97a1",body:"#a9b6c0"},yx="#c2452d";function bx(n,e,t=!1){return n==="gear"||n==="body"&&t?_x[e%_x.length]:vx[n]??vx.body}function rl(n,e){return getComputedStyle(n).getPropertyValue(`--pp-force-${e}`).trim()||yy[e]}var Mx=["#2296a0","#c2509a","#a88a1e","#d2484f","#6b8e23","#8f6b52","#8a8f98"],wx=n=>Cr.some(e=>n.startsWith(`${e}_force`));function zc(n,e,t){let i=Cr.find(r=>e.startsWith(`${r}_force`));return i?rl(n,i):Mx[t%Mx.length]}var Sx=["#d2484f","#a88a1e","#8a68c4","#2296a0","#2f9e62"],by={contact_loss:"#8a8f98",impact:"#d2484f",back_flank:"#b0489a",front_flank:"#e8b400",faulty_tooth:"#2296a0"};function vs(n,e){return by[e]??Sx[Math.max(n.indexOf(e),0)%Sx.length]}var sl=["#440154","#3b528b","#21918c","#5ec962","#fde725"].map(n=>[1,3,5].map(e=>parseInt(n.slice(e,e+2),16)/255));function ol(n){let e=Math.max(0,Math.min(1,n))*(sl.length-1),t=Math.min(Math.floor(e),sl.length-2);return sl[t].map((i,r)=>i+(e-t)*(sl[t+1][r]-i))}var Gc=n=>ol(n).map(e=>e<=.04045?e/12.92:((e+.055)/1.055)**2.4),Hc=()=>`linear-gradient(to right, ${sl.map(n=>`rgb(${n.map(e=>Math.round(255*e)).join(" ")})`).join(", ")})`;var In=6,Vc=24,qc=class{constructor(e,t){this.contact=e,this.stations=e.contact.flanks[0].loads?.shape[2]??2;let i=Vc*this.stations*In,r=new Ot;for(let a of["position","color"])r.setAttribute(a,new Rt(new Float32Array(3*i),3).setUsage(Wd));let s=[];for(let a=0;a<Vc;a++)for(let c=0;c<this.stations-1;c++)for(let l=0;l<In;l++){let h=(a*this.stations+c)*In+l,f=(a*this.stations+c)*In+(l+1)%In;s.push(h,f,h+In,f,f+In,h+In)}r.setIndex(s),this.rods=new St(r,new sr({vertexColors:!0})),this.rods.frustumCulled=!1,t.add(this.rods);let o=new Eo(1,12,8);this.paints=Object.fromEntries([1,-1].map(a=>[a,new sr({color:cr[a].colour})])),this.plain=Object.fromEntries([1,-1].map(a=>[a,this.paints[a].color.toArray()])),this.balls=Array.from({length:2*Vc},()=>{let a=new St(o,this.paints[1]);return a.visible=!1,t.add(a),a})}update(e,t,i,r,s){let o=this.contact.penetration(),a=o[1]>=o[-1]?1:-1,c=t?e.filter(p=>p.force||p.side===a).slice(0,Vc):[];this.rods.visible=c.length>0,this.balls.forEach(p=>p.visible=!1);let{position:l,color:h}=this.rods.geometry.attributes,f=!!this.contact.contact.flanks[0].loads,u=Math.min(2.6*i||1/0,.07*this.contact.contact.base_pitch);c.forEach((p,g)=>{let M=f?p.force!==0:o[p.side]>0,m=M?u:.4*u;al.subVectors(p.to,p.from),es.set(0,0,1).cross(al),es.lengthSq()<1e-12*al.lengthSq()&&es.set(1,0,0).cross(al),es.normalize(),Wc.crossVectors(al,es).normalize();for(let d=0;d<this.stations;d++){let x=f&&r>0?Gc(s(p,d)/r):this.plain[p.side],w=M?x:wy;Xc.copy(p.at(d/(this.stations-1)));for(let S=0;S<In;S++){let R=2*Math.PI*S/In,A=(g*this.stations+d)*In+S;l.setXYZ(A,Xc.x+m*(Math.cos(R)*es.x+Math.sin(R)*Wc.x),Xc.y+m*(Math.cos(R)*es.y+Math.sin(R)*Wc.y),Xc.z+m*(Math.cos(R)*es.z+Math.sin(R)*Wc.z)),h.setXYZ(A,...w)}}if(M)for(let[d,x]of[p.from,p.to].entries()){let w=this.balls[2*g+d];w.visible=!0,w.material=this.paints[p.side],w.position.copy(x),w.scale.setScalar(1.9*u)}}),l.needsUpdate=h.needsUpdate=!0,this.rods.geometry.setDrawRange(0,c.length*(this.stations-1)*In*6)}},al=new N,es=new N,Wc=new N,Xc=new N,wy=[.29,.31,.36];var Ey=.32,Ex=.2,Yc=class{constructor(e,t){this.contact=e,this.root=t,this.times=1,this.plates=null}#e(){let e=new or(1,1,1);this.plates=[1,-1].flatMap(t=>[-1,1].map(i=>{let{colour:r}=cr[t],s={color:r,emissive:r,emissiveIntensity:i>0?.5:.15},o=new St(e,new Rr({...s,transparent:!0,opacity:.85}));return o.matrixAutoUpdate=!1,this.root.add(o),{mesh:o,side:t,end:i}}))}fitting(){let e=this.contact.penetration(),t=Math.max(Math.abs(e[1]),Math.abs(e[-1]),1e-7),i=.25*this.contact.contact.base_pitch/t,r=10**Math.floor(Math.log10(i));return Math.max(1,r*(i/r>=5?5:i/r>=2?2:1))}shown(){return(this.plates??[]).filter(({mesh:e})=>e.visible).map(({mesh:e})=>new N().setFromMatrixPosition(e.matrix).toArray())}update(e){if(!e&&!this.plates)return;this.plates||this.#e();let{contact:t}=this,i=t.contact.base_pitch,r=t.frame(),s=t.penetration();for(let{mesh:o,side:a,end:c}of this.plates){if(o.visible=e,!e)continue;let l=t.normal(a),h=.03*i,f=-.5*this.times*s[a]+.5*h;Yf.set(0,0,1),Tx.crossVectors(Yf,l),$f.makeBasis(Tx.clone().multiplyScalar(Ex*i),l.clone().multiplyScalar(h),Yf.multiplyScalar(Ex*i)),$f.setPosition(l.multiplyScalar(Ey*i+c*f)),o.matrix.multiplyMatrices(r,$f)}}},Yf=new N,Tx=new N,$f=new Le;function ai(n,e=4){if(!Number.isFinite(n))return"\u2013";if(n===0)return"0";let t=Math.abs(n),i=t>=1e6||t<1e-4?t.toExponential(e-1).replace("e+","e"):Ty(t.toPrecision(e));return(n<0?"\u2212":"")+i}function Ty(n){let e=String(Number(n));return n.includes(".")&&!n.includes("e")?n:e}function Io(n,e){let t=Math.min(9,Math.max(0,-Math.floor(Math.log10(e)+1e-9)));return`${n.toFixed(t).replace("-","\u2212")} \xB1 ${e.toFixed(t)}`}function $c(n){let e=n>0?3-Math.floor(Math.log10(n)):0;return e>9||e<-6?t=>ai(t,4):t=>t.toFixed(Math.max(0,e)).replace(/^-(0(\.0*)?)$/,"$1").replace("-","\u2212")}function Ax(n,e,t=n,i=t){let r=Math.abs(t),[s,o]=r>=1e6?[1e-6,"M"]:r>=1e3?[.001,"k"]:[1,""],a=n*s,c=Math.abs(i*s)>=100?1:Math.abs(i*s)>=10?2:3;return`${a<0?"\u2212":""}${Math.abs(a).toFixed(c)}\u2009${o}${e}`}var Ay=[[1,"m"],[.001,"mm"],[1e-6,"\xB5m"],[1e-9,"nm"]],Kf=[[1,"s"],[.001,"ms"],[1e-6,"\xB5s"]],Rx=n=>Kf[n>=.02?0:n>=2e-5?1:2];function Cx(n,e,t){let[i,r]=e.find(([s])=>Math.abs(n)>=s*.999)??e[e.length-1];return`${ai(n/i,t)}\u2009${r}`}var Px=n=>Cx(n,Ay,1).replace(/\.0+(?=\D)/,""),hr=n=>n===0?"0\u2009s":Cx(n,Kf,3);function Ms(n,e){let[t,i]=Kf[e>=5e-4?0:e>=8e-7||Math.abs(n)>=.001?1:2],r=Math.max(0,Math.min(6,Math.ceil(-Math.log10(Math.max(e,1e-12)/t)-1e-9)));return`${(n/t).toFixed(r).replace("-","\u2212")}\u2009${i}`}function Lx(n){if(n>=.999)return"real time";let e=1/n;return`1/${e<10?String(Number(e.toPrecision(2))):String(Math.round(e)).replace(/\B(?=(\d{3})+$)/g,"\u2009")} of real time`}function Dx(n,[e,t],i){let{data:r,count:s}=n.unit_pressure,[o,a]=n.path,c=Math.max(0,Math.min(1,(e-o)/(a-o)))*(s-1),l=Math.min(Math.floor(c),s-2),h=n.cone?Math.exp(t/n.cone[0]):1;return(r[l]+(c-l)*(r[l+1]-r[l]))*Math.sqrt(Math.max(0,i)/h)}var Ry=({place:n,slope:e,from:t,to:i},r)=>{let s=t+r*(i-t);return[n+e*s,s]};function Cy(n){if(!n.unit_pressure)return 0;let e=0;for(let t of n.flanks){if(!t.loads)continue;let[i,r,s]=t.loads.shape;for(let o=0;o<i;o++){let a=t.travel.data[t.travel.count>1?o:0];for(let c of _s(n,t,a)){let l=(c.pair%r+r)%r;for(let h=0;h<s;h++){let f=t.loads.data[(o*r+l)*s+h];f>0&&(e=Math.max(e,Dx(n,Ry(c,h/(s-1)),f)))}}}}return e}var Ss={load:{name:"load per width",legend:"load per width",format:n=>`${ai(n/1e3,3)}\u2009N/mm`,of:(n,e,t)=>t,greatest:({greatest:n})=>n},pressure:{name:"pressure (Hertz)",legend:"Hertzian pressure",format:n=>`${ai(n/1e6,3)}\u2009MPa`,of:Dx,greatest:n=>n.pressure??=Cy(n.contact)}};var Nx=(n,e)=>(n%e+e)%e,Ix=1.004,Zf=class{constructor(e,t){this.contact=e,this.flank=t,[this.nz,this.nx]=t.surfaces[0].points.shape,this.frames=t.travel.count,this.clear()}clear(){let{nz:e,nx:t,flank:i}=this;this.done=-1,this.touched=i.surfaces.map(()=>[]),this.news={all:!0,teeth:i.surfaces.map(()=>new Set)},this.all=new Float32Array(e*t),this.each=i.surfaces.map(r=>new Float32Array(r.teeth*e*t))}upTo(e){for(e<this.done&&this.clear();this.done<e;)this.done++,this.#t(Math.max(0,this.done-1),this.done)}#e(e,t,i){let{flank:r}=this;if(!t||i<t.from||i>t.to)return null;let s=r.loads.shape[2],o=e*r.loads.width+Nx(t.pair,r.forces.width)*s,a=t.to>t.from?(i-t.from)/(t.to-t.from)*(s-1):0,c=Math.min(Math.floor(a),s-2),[l,h]=[r.loads.data[o+c],r.loads.data[o+c+1]];return l+(a-c)*(h-l)}#t(e,t){let{contact:i,flank:r,nz:s,nx:o}=this,[a,c]=i.path,[l,h]=i.width,f=(c-a)/(o-1),u=r.travel.data,g=Math.abs(u[t]-u[e])>.75*i.base_pitch?[]:_s(i,r,u[e]);for(let M of _s(i,r,u[t])){let{pair:m,slope:d}=M,x=g.find(w=>w.pair===m);for(let w=0;w<s;w++){let S=l+(h-l)*w/(s-1),R=this.#e(t,M,S);if(R===null)continue;let A=this.#e(e,x,S),_=u[t]-m*i.base_pitch+d*S,b=A===null?_:u[e]-m*i.base_pitch+d*S,F=Math.max(0,Math.ceil((Math.min(b,_)-a)/f-.5)),L=Math.min(o-1,Math.floor((Math.max(b,_)-a)/f+.5));for(let D=F;D<=L;D++){let k=b===_?1:Math.max(0,Math.min(1,(a+D*f-b)/(_-b)));this.#i(m,w*o+D,(A??R)*(1-k)+R*k)}}}}#i(e,t,i){i>0&&(i>Ix*this.all[t]&&(this.all[t]=i,this.news.all=!0),this.flank.surfaces.forEach((r,s)=>{let o=Nx(r.tooth+r.step*e,r.teeth),a=o*this.nz*this.nx+t;i>Ix*this.each[s][a]&&(this.each[s][a]=i,this.news.teeth[s].add(o),this.touched[s].includes(o)||this.touched[s].push(o))}))}},Kc=class{constructor(e,t,i){this.poses=i,this.greatest=e.greatest,this.mode="off",this.parts=e.contact.flanks.filter(r=>r.loads).map(r=>{let s=new Zf(e.contact,r);return{record:s,meshes:r.surfaces.map((o,a)=>this.#e(s,o,a,t))}})}#e(e,t,i,r){let{nz:s,nx:o}=e,a=s*o,c=new Float32Array(3*a*t.teeth);for(let u=0;u<t.teeth;u++){let p=t.turn*t.step*(u-t.tooth),g=Math.cos(p),M=Math.sin(p);for(let m=0;m<a;m++){let[d,x,w]=t.points.data.subarray(3*m,3*m+3);c.set([g*d-M*x,M*d+g*x,w],3*(u*a+m))}}let l=[];for(let u=0;u<s-1;u++)for(let p=0;p<o-1;p++){let g=u*o+p;l.push(g,g+1,g+o,g+1,g+o+1,g+o)}let h=new Ot;h.setAttribute("position",new Rt(c,3)),h.setAttribute("color",new Rt(new Uint8Array(4*a*t.teeth),4,!0)),h.setIndex(new Rt(new Uint32Array(l.length*t.teeth),1)),h.setDrawRange(0,0);let f=new St(h,new sr({vertexColors:!0,transparent:!0,side:zi,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-40}));return f.matrixAutoUpdate=!1,f.frustumCulled=!1,f.visible=!1,f.userData={body:t.body,gear:i,block:l,drawn:0},r.add(f),f}update(e,t,i,r){let s=this.poses.where.share===1?this.poses.where.low+1:this.poses.where.low;for(let{record:o,meshes:a}of this.parts){let c=e!=="off"&&!t;for(let h of a)h.visible=c,c&&h.matrix.copy(this.poses.world[h.userData.body]);if(!c)continue;o.upTo(s);let l=e!==this.mode||i!==this.painted||r!==this.shade;this.shade=r;for(let h of a)this.#t(o,h,e,i,l);o.news={all:!1,teeth:o.news.teeth.map(()=>new Set)}}this.mode=t?"off":e,this.painted=i}#t(e,t,i,r,s){let{gear:o,block:a}=t.userData,c=e.nz*e.nx,l=e.touched[o];this.#n(t,l,a,c);let f=s||i==="all"&&e.news.all?l:e.news.teeth[o],{color:u}=t.geometry.attributes;for(let p of f){for(let g=0;g<c;g++){let M=i==="all"?e.all[g]:e.each[o][p*c+g],m=4*(p*c+g),d=M>0?Gc(this.#i(e,g,M)/r):Py;for(let x=0;x<3;x++)u.array[m+x]=Math.round(255*d[x]);u.array[m+3]=M>0?255:0}u.needsUpdate=!0}}#i({contact:e,nx:t,nz:i},r,s){let[o,a]=e.path,[c,l]=e.width,h=[o+(a-o)*(r%t)/(t-1),c+(l-c)*Math.floor(r/t)/(i-1)];return this.shade.of(e,h,s)}#n(e,t,i,r){let{geometry:s,userData:o}=e;if(t.length<o.drawn&&(o.drawn=0),t.length===o.drawn)return;let{array:a}=s.index;for(let c=o.drawn;c<t.length;c++)i.forEach((l,h)=>a[c*i.length+h]=t[c]*r+l);o.drawn=t.length,s.index.needsUpdate=!0,s.setDrawRange(0,t.length*i.length)}cut(e){for(let{meshes:t}of this.parts)for(let{material:i}of t)i.clippingPlanes=e.length?e:null,i.needsUpdate=!0}words(){return this.parts.map(({record:e})=>({side:e.flank.side,greatest:e.all.reduce((t,i)=>Math.max(t,i),0),covered:e.all.filter(t=>t>0).length/e.all.length,teeth:e.touched.map(t=>[...t].sort((i,r)=>i-r))}))}},Py=[0,0,0];var Zc=class{constructor(e,t,i,r){this.meshes=e.contacts.map(s=>{let o=new kc(s,r);return{contact:o,rods:new qc(o,i),pattern:new Kc(o,t,r),gauge:new Yc(o,i),lines:[]}}),this.greatest=Math.max(0,...this.meshes.map(({contact:s})=>s.greatest)),this.shade="load",this.pressures=e.contacts.some(s=>s.unit_pressure),this.showsLines=!0,this.mode="off",this.own=!1,this.gauged=-1,this.hidden=!1}get over(){return!this.hidden&&this.meshes.length>0&&(this.showsLines||this.gauged>=0)}pairs(){return this.meshes.flatMap(e=>Array.from({length:e.contact.pairs},(t,i)=>{let r=this.#e(e.contact,i);return{name:`${e.contact.name}, pair ${i+1}`,kind:"pair",unit:"N",size:r,now:()=>e.forces?.[i]??e.contact.pairForces([])[i],largest:Ly(e.contact.contact,r)}}))}#e(e,t){let i=0;for(let{forces:r}of e.contact.flanks)for(let s=t;r&&s<r.data.length;s+=r.width)i=Math.max(i,Math.abs(r.data[s]));return i/Math.cos(e.contact.base_helix)}look(){for(let e of this.meshes)e.lines=e.contact.lines(),e.forces=e.contact.pairForces(e.lines)}top(e){return this.own?Ss[this.shade].greatest(e):this.shade==="load"?this.greatest:this.hardest??=this.greatestPressure()}greatestPressure(){return Math.max(0,...this.meshes.map(({contact:e})=>Ss.pressure.greatest(e)))}value(e,{ends:t,loads:i},r){let s=r/(i.length-1),o=[0,1].map(a=>t[0][a]+(t[1][a]-t[0][a])*s);return Ss[this.shade].of(e.contact,o,i[r])}update(e){this.meshes.forEach(({contact:t,rods:i,pattern:r,gauge:s,lines:o},a)=>{let c=this.top(t),l=(h,f)=>this.value(t,h,f);i.update(o,this.showsLines&&!this.hidden,e,c,l),r.update(t.greatest>0?this.mode:"off",this.hidden,c,Ss[this.shade]),s.update(a===this.gauged&&!this.hidden)})}cut(e){for(let{pattern:t}of this.meshes)t.cut(e)}state(){let e=t=>[t.x,t.y,t.z];return{lines:this.showsLines,pattern:this.mode,gauge:this.gauged,greatest:this.greatest,shade:this.shade,greatestPressure:this.pressures?this.greatestPressure():null,meshes:this.meshes.map(({contact:t,lines:i,pattern:r,gauge:s})=>({name:t.name,penetration:t.penetration(),magnified:s.times,plates:s.shown(),lines:i.map(({pair:o,side:a,force:c,from:l,to:h,loads:f,ends:u})=>({pair:o,side:a,force:c,from:e(l),to:e(h),loads:[...f],values:Array.from(f,(p,g)=>this.value(t,{ends:u,loads:f},g))})),pattern:this.mode==="off"?[]:r.words()}))}}};function Ly(n,e){let t=e*Math.cos(n.base_helix),i=n.pressure_angle.data[0];if(n.cone){let r=Bc(n.cone,i,Math.tan(n.base_helix),t,0);return Object.fromEntries(Object.entries(r).map(([s,o])=>[s,o.length()]))}return{circumferential:t*Math.cos(i),radial:t*Math.sin(i),axial:t*Math.abs(Math.tan(n.base_helix))}}var Jc=class{constructor(e){this.flanks=e,this.now=J("span",{}),this.end=J("span",{}),this.gap=J("div",{className:"ppv-gap"}),this.bar=J("div",{hidden:!(e.greatest>0)},this.what=J("span",{}),J("i",{style:`background:${Hc()}`}),J("div",{className:"ppv-ends"},J("span",{},"0"),this.now,this.end)),this.element=J("div",{className:"ppv-flanks",role:"status"},this.bar,this.gap)}update(){let{flanks:e}=this,t=e.meshes[e.gauged],i=e.greatest>0&&(e.showsLines||e.mode!=="off");if(this.element.hidden=e.hidden||!(i||t),this.element.hidden)return;let{legend:r,format:s}=Ss[e.shade],o=0;for(let{contact:l,lines:h}of e.meshes)for(let f of h)f.loads.forEach((u,p)=>o=Math.max(o,e.value(l,f,p)));if(this.what.textContent=r,this.now.textContent=o>0?`current ${s(o)}`:"no load now",this.end.textContent=e.own?"mesh maximum":s(e.top(e.meshes[0].contact)),this.gap.hidden=!t,!t)return;let a=t.contact.penetration(),c=(l,h)=>`${h} ${a[l]>0?"penetration":"gap"} ${Dy(Math.abs(a[l]))}`;this.gap.textContent=`${t.contact.name}: ${c(1,"front flank")}, ${c(-1,"back flank")}; magnification \xD7 ${ai(t.gauge.times,2)}`}};function Dy(n){let[e,t]=n<.001?[1e-6,"\xB5m"]:[.001,"mm"];return`${ai(n/e,3)}\u2009${t}`}function Ny({contact:n,name:e}){let{cone:t,width:i}=n,r=n.flanks[0].surfaces.map(({gear:o,points:a})=>{let[c,l]=a.shape,h=t?-i[0]/(i[1]-i[0])*(c-1):0,f=Math.min(Math.floor(h),c-2),u=(m,d)=>Math.hypot(a.data[3*(m*l+d)],a.data[3*(m*l+d)+1]),p=[0,l-1].map(m=>2e3*(u(f,m)+(h-f)*(u(f+1,m)-u(f,m)))),[g,M]=[Math.min(...p),Math.max(...p)].map(m=>m.toFixed(2));return`${o} ${g} to ${M}`}),s=t?" at mid-face":"";return`${e}: active diameters ${r.join(", ")} mm${s}.`}function Uo(n,e){for(let{flanks:o}of n.stage.pictures)e(o);let{showsLines:t,mode:i,shade:r}=n.stage.pictures[0].flanks,s=r==="load"?0:Math.max(...n.stage.pictures.map(({flanks:o})=>o.greatestPressure()));for(let{flanks:o}of n.stage.pictures)o.hardest=s||void 0;n.flankRows&&(n.flankRows.shade&&(n.flankRows.shade.select.value=r),n.flankRows.lines.input.checked=t,n.flankRows.pattern.select.value=i),n.changed()}function Qc(n,e,t){let i=n.stage.pictures[0].flanks.meshes[e],r=t??i?.gauge.fitting()??1;Uo(n,s=>{s.gauged=s.meshes.findIndex(({contact:o})=>o.name===i?.contact.name);for(let{gauge:o}of s.meshes)o.times=r}),n.flankRows&&(n.flankRows.times.set(r),n.flankRows.describe(e),n.flankRows.gauge.select.value=String(e))}function Iy(n){let{flanks:e,data:t}=n.stage.pictures[0];e.gauged<0&&Qc(n,0);let i=e.meshes[e.gauged]?.contact.name,r=t.arrows.find(s=>s.kind==="mesh"&&s.name===i);r&&n.intoMesh(r)}function Ux(n){let{meshes:e,greatest:t,pressures:i}=n.stage.pictures[0].flanks,r=u=>Uo(n,u),s=tr("contact lines",!0,u=>r(p=>p.showsLines=u)),o=rn("contact pattern",[["off","none"],["all","all teeth superimposed"],["each","each tooth"]],u=>r(p=>p.mode=u),"Maximum load or pressure up to the current time at every point of a flank"),a=i?rn("colour by",Object.entries(Ss).map(([u,{name:p}])=>[u,p]),u=>r(p=>p.shade=u),"Load per width, or maximum Hertzian pressure of the line contact"):null,c=_r({label:"magnification \xD7",title:"Magnification of the gap along the line of action",least:1,most:1e4,value:1,show:u=>ai(u,2),changed:u=>r(p=>p.meshes.forEach(({gauge:g})=>g.times=u))}),l=rn("show gap of",[["-1","none"],...e.map(({contact:u},p)=>[String(p),u.name])],u=>Qc(n,Number(u)),"Mesh with a magnified gap"),h=tr("separate colour scale per mesh",!1,u=>r(p=>p.own=u)),f=J("p",{className:"ppv-soft"});return n.flankRows={lines:s,pattern:o,shade:a,gauge:l,times:c,describe(u){let p=e[u]??(e.length===1?e[0]:null);f.hidden=!p,p&&(f.textContent=Ny(p.contact))}},n.flankRows.describe(-1),[s.row,t>0?o.row:null,t>0&&a?a.row:null,t>0&&e.length>1?h.row:null,l.row,f,c.row,J("div",{className:"ppv-buttons"},Tt("view gap","View along the axis on the magnified gap",()=>Iy(n))),J("p",{className:"ppv-soft"},t>0?"Spheres at the ends of a line show the flank (yellow: front, purple: back); thin grey lines carry no load.":"Yellow lines: front flanks; purple: back flanks; thin and grey: no contact. The mesh law gives no loads per tooth pair.")].filter(Boolean)}var Uy="uplot",Fy="u-hz",Oy="u-vt",By="u-title",ky="u-wrap",zy="u-under",Gy="u-over",Hy="u-axis",ws="u-off",Vy="u-select",Wy="u-cursor-x",Xy="u-cursor-y",qy="u-cursor-pt",Yy="u-legend",$y="u-live",Ky="u-inline",Zy="u-series",Jy="u-marker",Fx="u-label",Qy="u-value",cl="width",hl="height";var Ox="bottom",Fo="left",Jf="right",pu="#000",Bx=pu+"0",Qf="mousemove",kx="mousedown",jf="mouseup",zx="mouseenter",Gx="mouseleave",Hx="dblclick",jy="resize",eb="scroll",Vx="change",nh="dppxchange",mu="--",Vo=typeof window<"u",ru=Vo?document:null,Bo=Vo?window:null,tb=Vo?navigator:null,At,jc;function su(){let n=devicePixelRatio;At!=n&&(At=n,jc&&au(Vx,jc,su),jc=matchMedia(`(min-resolution: ${At-.001}dppx) and (max-resolution: ${At+.001}dppx)`),Es(Vx,jc,su),Bo.dispatchEvent(new CustomEvent(nh)))}function bn(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function ou(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function qt(n,e,t){n.style[e]=t+"px"}function Xn(n,e,t,i){let r=ru.createElement(n);return e!=null&&bn(r,e),t?.insertBefore(r,i),r}function Un(n,e){return Xn("div",n,e)}var Wx=new WeakMap;function fr(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=Wx.get(n);s!=o&&(n.style.transform=s,Wx.set(n,s),e<0||t<0||e>i||t>r?bn(n,ws):ou(n,ws))}var Xx=new WeakMap;function qx(n,e,t){let i=e+t,r=Xx.get(n);i!=r&&(Xx.set(n,i),n.style.background=e,n.style.borderColor=t)}var Yx=new WeakMap;function $x(n,e,t,i){let r=e+""+t,s=Yx.get(n);r!=s&&(Yx.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var gu={passive:!0},ib={...gu,capture:!0};function Es(n,e,t,i){e.addEventListener(n,t,i?ib:gu)}function au(n,e,t,i){e.removeEventListener(n,t,gu)}Vo&&su();function qn(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:wn((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function y_(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var b_=n=>n!=null,w_=n=>n!=null&&n>0,oh=y_(b_),nb=y_(w_);function rb(n,e,t,i=0,r=!1){let s=r?nb:oh,o=r?w_:b_;[e,t]=s(n,e,t);let a=n[e],c=n[e];if(e>-1)if(i==1)a=n[e],c=n[t];else if(i==-1)a=n[t],c=n[e];else for(let l=e;l<=t;l++){let h=n[l];o(h)&&(h<a?a=h:h>c&&(c=h))}return[a??Bt,c??-Bt]}function ah(n,e,t,i){let r=Jx(n),s=Jx(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Pr:E_,a=r==1?wn:Fn,c=s==1?Fn:wn,l=a(o(Ri(n))),h=c(o(Ri(e))),f=ko(t,l),u=ko(t,h);return t==10&&(l<0&&(f=kt(f,-l)),h<0&&(u=kt(u,-h))),i||t==2?(n=f*r,e=u*s):(n=C_(n,f),e=lh(e,u)),[n,e]}function xu(n,e,t,i){let r=ah(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var _u=.1,Kx={mode:3,pad:_u},ul={pad:0,soft:null,mode:0},sb={min:ul,max:ul};function rh(n,e,t,i){return ch(t)?Zx(n,e,t):(ul.pad=t,ul.soft=i?0:null,ul.mode=i?3:0,Zx(n,e,sb))}function wt(n,e){return n??e}function ob(n,e,t){for(e=wt(e,0),t=wt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Zx(n,e,t){let i=t.min,r=t.max,s=wt(i.pad,0),o=wt(r.pad,0),a=wt(i.hard,-Bt),c=wt(r.hard,Bt),l=wt(i.soft,Bt),h=wt(r.soft,-Bt),f=wt(i.mode,0),u=wt(r.mode,0),p=e-n,g=Pr(p),M=nn(Ri(n),Ri(e)),m=Pr(M),d=Ri(m-g);(p<1e-24||d>10)&&(p=0,(n==0||e==0)&&(p=1e-24,f==2&&l!=Bt&&(s=0),u==2&&h!=-Bt&&(o=0)));let x=p||M||1e3,w=Pr(x),S=ko(10,wn(w)),R=x*(p==0?n==0?.1:1:s),A=kt(C_(n-R,S/10),24),_=n>=l&&(f==1||f==3&&A<=l||f==2&&A>=l)?l:Bt,b=nn(a,A<_&&n>=_?_:Yn(_,A)),F=x*(p==0?e==0?.1:1:o),L=kt(lh(e+F,S/10),24),D=e<=h&&(u==1||u==3&&L>=h||u==2&&L<=h)?h:-Bt,k=Yn(c,L>D&&e<=D?D:nn(D,L));return b==k&&b==0&&(k=100),[b,k]}var ab=new Intl.NumberFormat(Vo?tb.language:"en-US"),vu=n=>ab.format(n),En=Math,ih=En.PI,Ri=En.abs,wn=En.floor,Ai=En.round,Fn=En.ceil,Yn=En.min,nn=En.max,ko=En.pow,Jx=En.sign,Pr=En.log10,E_=En.log2,lb=(n,e=1)=>En.sinh(n)*e,eu=(n,e=1)=>En.asinh(n/e),Bt=1/0;function Qx(n){return(Pr((n^n>>31)-(n>>31))|0)+1}function lu(n,e,t){return Yn(nn(n,e),t)}function T_(n){return typeof n=="function"}function vt(n){return T_(n)?n:()=>n}var cb=()=>{},A_=n=>n,R_=(n,e)=>e,hb=n=>null,jx=n=>!0,e_=(n,e)=>n==e,fb=/\.\d*?(?=9{6,}|0{6,})/gm,Ts=n=>{if(L_(n)||is.has(n))return n;let e=`${n}`,t=e.match(fb);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${Ts(r)}e${s}`}return kt(n,i)};function ys(n,e){return Ts(kt(Ts(n/e))*e)}function lh(n,e){return Ts(Fn(Ts(n/e))*e)}function C_(n,e){return Ts(wn(Ts(n/e))*e)}function kt(n,e=0){if(L_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Ai(i)/t}var is=new Map;function P_(n){return((""+n).split(".")[1]||"").length}function pl(n,e,t,i){let r=[],s=i.map(P_);for(let o=e;o<t;o++){let a=Ri(o),c=kt(ko(n,o),a);for(let l=0;l<i.length;l++){let h=n==10?+`${i[l]}e${o}`:i[l]*c,f=(o>=0?0:a)+(o>=s[l]?0:s[l]),u=n==10?h:kt(h,f);r.push(u),is.set(u,f)}}return r}var dl={},Mu=[],zo=[null,null],ts=Array.isArray,L_=Number.isInteger,ub=n=>n===void 0;function t_(n){return typeof n=="string"}function ch(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function db(n){return n!=null&&typeof n=="object"}var pb=Object.getPrototypeOf(Uint8Array),D_="__proto__";function Go(n,e=ch){let t;if(ts(n)){let i=n.find(r=>r!=null);if(ts(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=Go(n[r],e)}else t=n.slice()}else if(n instanceof pb)t=n.slice();else if(e(n)){t={};for(let i in n)i!=D_&&(t[i]=Go(n[i],e))}else t=n;return t}function yi(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=D_&&(ch(n[r])?yi(n[r],Go(i[r])):n[r]=Go(i[r]))}return n}var mb=0,gb=1,xb=2;function _b(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function vb(n,e){if(yb(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return bb(o[0])||(o=Sb(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let c=n[o][0],l=c.length;for(let h=0;h<l;h++)t.add(c[h])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],c=a[0];for(let l=1;l<a.length;l++){let h=a[l],f=Array(r).fill(void 0),u=e?e[o][l]:gb,p=[];for(let g=0;g<h.length;g++){let M=h[g],m=s.get(c[g]);M===null?u!=mb&&(f[m]=M,u==xb&&p.push(m)):f[m]=M}_b(f,p,r),i.push(f)}}return i}var Mb=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Sb(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let c=0;c<t;c++)a[c]=o[i[c]];r.push(a)}return r}function yb(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function bb(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=nn(1,wn((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let c=n[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var N_=["January","February","March","April","May","June","July","August","September","October","November","December"],I_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function U_(n){return n.slice(0,3)}var wb=I_.map(U_),Eb=N_.map(U_),Tb={MMMM:N_,MMM:Eb,WWWW:I_,WWW:wb};function ll(n){return(n<10?"0":"")+n}function Ab(n){return(n<10?"00":n<100?"0":"")+n}var Rb={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ll(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ll(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ll(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ll(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ll(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Ab(n.getMilliseconds())};function Su(n,e){e=e||Tb;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?Rb[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var Cb=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Pb(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Cb?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var F_=n=>n%1==0,sh=[1,2,2.5,5],Lb=pl(10,-32,0,sh),O_=pl(10,0,32,sh),Db=O_.filter(F_),bs=Lb.concat(O_),yu=`
`,B_="{YYYY}",i_=yu+B_,k_="{M}/{D}",fl=yu+k_,eh=fl+"/{YY}",z_="{aa}",Nb="{h}:{mm}",Oo=Nb+z_,n_=yu+Oo,r_=":{ss}",Ct=null;function G_(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,c=(n==1?pl(10,0,3,sh).filter(F_):pl(10,-3,0,sh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,B_,Ct,Ct,Ct,Ct,Ct,Ct,1],[r*28,"{MMM}",i_,Ct,Ct,Ct,Ct,Ct,1],[r,k_,i_,Ct,Ct,Ct,Ct,Ct,1],[i,"{h}"+z_,eh,Ct,fl,Ct,Ct,Ct,1],[t,Oo,eh,Ct,fl,Ct,Ct,Ct,1],[e,r_,eh+" "+Oo,Ct,fl+" "+Oo,Ct,n_,Ct,1],[n,r_+".{fff}",eh+" "+Oo,Ct,fl+" "+Oo,Ct,n_,Ct,1]];function h(f){return(u,p,g,M,m,d)=>{let x=[],w=m>=o,S=m>=s&&m<o,R=f(g),A=kt(R*n,3),_=tu(R.getFullYear(),w?0:R.getMonth(),S||w?1:R.getDate()),b=kt(_*n,3);if(S||w){let F=S?m/s:0,L=w?m/o:0,D=A==b?A:kt(tu(_.getFullYear()+L,_.getMonth()+F,1)*n,3),k=new Date(Ai(D/n)),G=k.getFullYear(),U=k.getMonth();for(let W=0;D<=M;W++){let Y=tu(G+L*W,U+F*W,1),V=Y-f(kt(Y*n,3));D=kt((+Y+V)*n,3),D<=M&&x.push(D)}}else{let F=m>=r?r:m,L=wn(g)-wn(A),D=b+L+lh(A-b,F);x.push(D);let k=f(D),G=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,U=m/i,W=u.axes[p]._space,Y=d/W;for(;D=kt(D+m,n==1?0:3),!(D>M);)if(U>1){let V=wn(kt(G+U,6))%24,j=f(D).getHours()-V;j>1&&(j=-1),D-=j*i,G=(G+U)%24;let re=x[x.length-1];kt((D-re)/m,3)*Y>=.7&&x.push(D)}else x.push(D)}return x}}return[c,l,h]}var[Ib,Ub,Fb]=G_(1),[Ob,Bb,kb]=G_(.001);pl(2,-53,53,[1]);function s_(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function o_(n,e){return(t,i,r,s,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],c,l,h,f,u,p;return i.map(g=>{let M=n(g),m=M.getFullYear(),d=M.getMonth(),x=M.getDate(),w=M.getHours(),S=M.getMinutes(),R=M.getSeconds(),A=m!=c&&a[2]||d!=l&&a[3]||x!=h&&a[4]||w!=f&&a[5]||S!=u&&a[6]||R!=p&&a[7]||a[1];return c=m,l=d,h=x,f=w,u=S,p=R,A(M)})}}function zb(n,e){let t=Su(e);return(i,r,s,o,a)=>r.map(c=>t(n(c)))}function tu(n,e,t){return new Date(n,e,t)}function a_(n,e){return e(n)}var Gb="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function l_(n,e){return(t,i,r,s)=>s==null?mu:e(n(i))}function Hb(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function Vb(n,e){return n.series[e].fill(n,e)}var Wb={show:!0,live:!0,isolate:!1,mount:cb,markers:{show:!0,width:2,stroke:Hb,fill:Vb,dash:"solid"},idx:null,idxs:null,values:[]};function Xb(n,e){let t=n.cursor.points,i=Un(),r=t.size(n,e);qt(i,cl,r),qt(i,hl,r);let s=r/-2;qt(i,"marginLeft",s),qt(i,"marginTop",s);let o=t.width(n,e,r);return o&&qt(i,"borderWidth",o),i}function qb(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Yb(n,e){let t=n.series[e].points;return t._stroke||t._fill}function $b(n,e){return n.series[e].points.size}var iu=[0,0];function Kb(n,e,t){return iu[0]=e,iu[1]=t,iu}function th(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function nu(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var Zb={show:!0,x:!0,y:!0,lock:!1,move:Kb,points:{one:!1,show:Xb,size:$b,width:0,stroke:Yb,fill:qb},bind:{mousedown:th,mouseup:th,click:th,dblclick:th,mousemove:nu,mouseleave:nu,mouseenter:nu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},H_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},bu=yi({},H_,{filter:R_}),V_=yi({},bu,{size:10}),W_=yi({},H_,{show:!1}),wu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',X_="bold "+wu,q_=1.5,c_={show:!0,scale:"x",stroke:pu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:X_,side:2,grid:bu,ticks:V_,border:W_,font:wu,lineGap:q_,rotate:0},Jb="Value",Qb="Time",h_={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function jb(n,e,t,i,r){return e.map(s=>s==null?"":vu(s))}function ew(n,e,t,i,r,s,o){let a=[],c=is.get(r)||0;t=o?t:kt(lh(t,r),c);for(let l=t;l<=i;l=kt(l+r,c))a.push(Object.is(l,-0)?0:l);return a}function cu(n,e,t,i,r,s,o){let a=[],c=n.scales[n.axes[e].scale].log,l=c==10?Pr:E_,h=wn(l(t));r=ko(c,h),c==10&&(r=bs[qn(r,bs)]);let f=t,u=r*c;c==10&&(u=bs[qn(u,bs)]);do a.push(f),f=f+r,c==10&&!is.has(f)&&(f=kt(f,is.get(r))),f>=u&&(r=f,u=r*c,c==10&&(u=bs[qn(u,bs)]));while(f<=i);return a}function tw(n,e,t,i,r,s,o){let c=n.scales[n.axes[e].scale].asinh,l=i>c?cu(n,e,nn(c,t),i,r):[c],h=i>=0&&t<=0?[0]:[];return(t<-c?cu(n,e,nn(c,-i),-t,r):[c]).reverse().map(u=>-u).concat(h,l)}var Y_=/./,iw=/[12357]/,nw=/[125]/,f_=/1/,hu=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function rw(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],c=n.valToPos,l=s._space,h=c(10,o),f=c(9,o)-h>=l?Y_:c(7,o)-h>=l?iw:c(5,o)-h>=l?nw:f_;if(f==f_){let u=Ri(c(1,o)-h);if(u<l)return hu(e.slice().reverse(),a.distr,f,Fn(l/u)).reverse()}return hu(e,a.distr,f,1)}function sw(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,c=n.valToPos,l=Ri(c(1,o)-c(2,o));return l<a?hu(e.slice().reverse(),3,Y_,Fn(a/l)).reverse():e}function ow(n,e,t,i){return i==null?mu:e==null?"":vu(e)}var u_={show:!0,scale:"y",stroke:pu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:X_,side:3,grid:bu,ticks:V_,border:W_,font:wu,lineGap:q_,rotate:0};function aw(n,e){let t=3+(n||1)*2;return kt(t*e,3)}function lw(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=Ri(o-s),c=n.series[e],l=a/(c.points.space*At);return i[1]-i[0]<=l}var d_={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},$_=(n,e,t,i,r)=>r,p_={show:!0,auto:!0,sorted:0,gaps:$_,alpha:1,facets:[yi({},d_,{scale:"x"}),yi({},d_,{scale:"y"})]},m_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:$_,alpha:1,points:{show:lw,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function cw(n,e,t,i,r){return t/10}var K_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},hw=yi({},K_,{time:!1,ori:1}),g_={};function Z_(n,e){let t=g_[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,c,l){for(let h=0;h<t.plots.length;h++)t.plots[h]!=r&&t.plots[h].pub(i,r,s,o,a,c,l)}},n!=null&&(g_[n]=t)),t}var Ho=1,fu=2;function As(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,c=s[0],l=i==2?s[1]:s[e],h=i==2?o[r.facets[0].scale]:o[n.series[0].scale],f=i==2?o[r.facets[1].scale]:o[r.scale],u=a.left,p=a.top,g=a.width,M=a.height,m=n.valToPosH,d=n.valToPosV;return h.ori==0?t(r,c,l,h,f,m,d,u,p,g,M,fh,Wo,dh,Q_,ev):t(r,c,l,h,f,d,m,p,u,M,g,uh,Xo,Au,j_,tv)}function Eu(n,e){let t=0,i=0,r=wt(n.bands,Mu);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function fw(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,c=n.scales[a];return r==-1?c.min:r==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function Lr(n,e,t,i,r,s){return As(n,e,(o,a,c,l,h,f,u,p,g,M,m)=>{let d=o.pxRound,x=l.dir*(l.ori==0?1:-1),w=l.ori==0?Wo:Xo,S,R;x==1?(S=t,R=i):(S=i,R=t);let A=d(f(a[S],l,M,p)),_=d(u(c[S],h,m,g)),b=d(f(a[R],l,M,p)),F=d(u(s==1?h.max:h.min,h,m,g)),L=new Path2D(r);return w(L,b,F),w(L,A,F),w(L,A,_),L})}function hh(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?dh:Au,c=t;for(let f=0;f<n.length;f++){let u=n[f];if(u[1]>u[0]){let p=u[0]-c;p>0&&a(o,c,i,p,i+s),c=u[1]}}let l=t+r-c,h=10;l>0&&a(o,c,i-h/2,l,i+s+h)}return o}function uw(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Tu(n,e,t,i,r,s,o){let a=[],c=n.length;for(let l=r==1?t:i;l>=t&&l<=i;l+=r)if(e[l]===null){let f=l,u=l;if(r==1)for(;++l<=i&&e[l]===null;)u=l;else for(;--l>=t&&e[l]===null;)u=l;let p=s(n[f]),g=u==f?p:s(n[u]),M=f-r;p=o<=0&&M>=0&&M<c?s(n[M]):p;let d=u+r;g=o>=0&&d>=0&&d<c?s(n[d]):g,g>=p&&a.push([p,g])}return a}function x_(n){return n==0?A_:n==1?Ai:e=>ys(e,n)}function J_(n){let e=n==0?fh:uh,t=n==0?(r,s,o,a,c,l)=>{r.arcTo(s,o,a,c,l)}:(r,s,o,a,c,l)=>{r.arcTo(o,s,c,a,l)},i=n==0?(r,s,o,a,c)=>{r.rect(s,o,a,c)}:(r,s,o,a,c)=>{r.rect(o,s,c,a)};return(r,s,o,a,c,l=0,h=0)=>{l==0&&h==0?i(r,s,o,a,c):(l=Yn(l,a/2,c/2),h=Yn(h,a/2,c/2),e(r,s+l,o),t(r,s+a,o,s+a,o+c,l),t(r,s+a,o+c,s,o+c,h),t(r,s,o+c,s,o,h),t(r,s,o,s+a,o,l),r.closePath())}}var fh=(n,e,t)=>{n.moveTo(e,t)},uh=(n,e,t)=>{n.moveTo(t,e)},Wo=(n,e,t)=>{n.lineTo(e,t)},Xo=(n,e,t)=>{n.lineTo(t,e)},dh=J_(0),Au=J_(1),Q_=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},j_=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},ev=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},tv=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function iv(n){return(e,t,i,r,s)=>As(e,t,(o,a,c,l,h,f,u,p,g,M,m)=>{let{pxRound:d,points:x}=o,w,S;l.ori==0?(w=fh,S=Q_):(w=uh,S=j_);let R=kt(x.width*At,3),A=(x.size-x.width)/2*At,_=kt(A*2,3),b=new Path2D,F=new Path2D,{left:L,top:D,width:k,height:G}=e.bbox;dh(F,L-_,D-_,k+_*2,G+_*2);let U=W=>{if(c[W]!=null){let Y=d(f(a[W],l,M,p)),V=d(u(c[W],h,m,g));w(b,Y+A,V),S(b,Y,V,A,0,ih*2)}};if(s)s.forEach(U);else for(let W=i;W<=r;W++)U(W);return{stroke:R>0?b:null,fill:b,clip:F,flags:Ho|fu}})}function nv(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var dw=nv(Wo),pw=nv(Xo);function rv(n){let e=wt(n?.alignGaps,0);return(t,i,r,s)=>As(t,i,(o,a,c,l,h,f,u,p,g,M,m)=>{[r,s]=oh(c,r,s);let d=o.pxRound,x=G=>d(f(G,l,M,p)),w=G=>d(u(G,h,m,g)),S,R;l.ori==0?(S=Wo,R=dw):(S=Xo,R=pw);let A=l.dir*(l.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ho},b=_.stroke,F=!1;if(s-r>=M*4){let G=fe=>t.posToVal(fe,l.key,!0),U=null,W=null,Y,V,ce,Z=x(a[A==1?r:s]),j=x(a[r]),re=x(a[s]),ue=G(A==1?j+1:re-1);for(let fe=A==1?r:s;fe>=r&&fe<=s;fe+=A){let ee=a[fe],_e=(A==1?ee<ue:ee>ue)?Z:x(ee),Ae=c[fe];_e==Z?Ae!=null?(V=Ae,U==null?(S(b,_e,w(V)),Y=U=W=V):V<U?U=V:V>W&&(W=V)):Ae===null&&(F=!0):(U!=null&&R(b,Z,w(U),w(W),w(Y),w(V)),Ae!=null?(V=Ae,S(b,_e,w(V)),U=W=Y=V):(U=W=null,Ae===null&&(F=!0)),Z=_e,ue=G(Z+A))}U!=null&&U!=W&&ce!=Z&&R(b,Z,w(U),w(W),w(Y),w(V))}else for(let G=A==1?r:s;G>=r&&G<=s;G+=A){let U=c[G];U===null?F=!0:U!=null&&S(b,x(a[G]),w(U))}let[D,k]=Eu(t,i);if(o.fill!=null||D!=0){let G=_.fill=new Path2D(b),U=o.fillTo(t,i,o.min,o.max,D),W=w(U),Y=x(a[r]),V=x(a[s]);A==-1&&([V,Y]=[Y,V]),S(G,V,W),S(G,Y,W)}if(!o.spanGaps){let G=[];F&&G.push(...Tu(a,c,r,s,A,x,e)),_.gaps=G=o.gaps(t,i,r,s,G),_.clip=hh(G,l.ori,p,g,M,m)}return k!=0&&(_.band=k==2?[Lr(t,i,r,s,b,-1),Lr(t,i,r,s,b,1)]:Lr(t,i,r,s,b,k)),_})}function mw(n){let e=wt(n.align,1),t=wt(n.ascDesc,!1),i=wt(n.alignGaps,0),r=wt(n.extend,!1);return(s,o,a,c)=>As(s,o,(l,h,f,u,p,g,M,m,d,x,w)=>{[a,c]=oh(f,a,c);let S=l.pxRound,{left:R,width:A}=s.bbox,_=j=>S(g(j,u,x,m)),b=j=>S(M(j,p,w,d)),F=u.ori==0?Wo:Xo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ho},D=L.stroke,k=u.dir*(u.ori==0?1:-1),G=b(f[k==1?a:c]),U=_(h[k==1?a:c]),W=U,Y=U;r&&e==-1&&(Y=R,F(D,Y,G)),F(D,U,G);for(let j=k==1?a:c;j>=a&&j<=c;j+=k){let re=f[j];if(re==null)continue;let ue=_(h[j]),fe=b(re);e==1?F(D,ue,G):F(D,W,fe),F(D,ue,fe),G=fe,W=ue}let V=W;r&&e==1&&(V=R+A,F(D,V,G));let[ce,Z]=Eu(s,o);if(l.fill!=null||ce!=0){let j=L.fill=new Path2D(D),re=l.fillTo(s,o,l.min,l.max,ce),ue=b(re);F(j,V,ue),F(j,Y,ue)}if(!l.spanGaps){let j=[];j.push(...Tu(h,f,a,c,k,_,i));let re=l.width*At/2,ue=t||e==1?re:-re,fe=t||e==-1?-re:re;j.forEach(ee=>{ee[0]+=ue,ee[1]+=fe}),L.gaps=j=l.gaps(s,o,a,c,j),L.clip=hh(j,u.ori,m,d,x,w)}return Z!=0&&(L.band=Z==2?[Lr(s,o,a,c,D,-1),Lr(s,o,a,c,D,1)]:Lr(s,o,a,c,D,Z)),L})}function __(n,e,t,i,r,s,o=Bt){if(n.length>1){let a=null;for(let c=0,l=1/0;c<n.length;c++)if(e[c]!==void 0){if(a!=null){let h=Ri(n[c]-n[a]);h<l&&(l=h,o=Ri(t(n[c],i,r,s)-t(n[a],i,r,s)))}a=c}}return o}function gw(n){n=n||dl;let e=wt(n.size,[.6,Bt,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=vt(r),o=1-e[0],a=wt(e[1],Bt),c=wt(e[2],1),l=wt(n.disp,dl),h=wt(n.each,p=>{}),{fill:f,stroke:u}=l;return(p,g,M,m)=>As(p,g,(d,x,w,S,R,A,_,b,F,L,D)=>{let k=d.pxRound,G=t,U=i*At,W=a*At,Y=c*At,V,ce;S.ori==0?[V,ce]=s(p,g):[ce,V]=s(p,g);let Z=S.dir*(S.ori==0?1:-1),j=S.ori==0?dh:Au,re=S.ori==0?h:(Ce,Je,st,be,Ut,He,Ze)=>{h(Ce,Je,st,Ut,be,Ze,He)},ue=wt(p.bands,Mu).find(Ce=>Ce.series[0]==g),fe=ue!=null?ue.dir:0,ee=d.fillTo(p,g,d.min,d.max,fe),me=k(_(ee,R,D,F)),_e,Ae,ye,qe=L,rt=k(d.width*At),Ve=!1,dt=null,ht=null,it=null,Yt=null;f!=null&&(rt==0||u!=null)&&(Ve=!0,dt=f.values(p,g,M,m),ht=new Map,new Set(dt).forEach(Ce=>{Ce!=null&&ht.set(Ce,new Path2D)}),rt>0&&(it=u.values(p,g,M,m),Yt=new Map,new Set(it).forEach(Ce=>{Ce!=null&&Yt.set(Ce,new Path2D)})));let{x0:zt,size:pi}=l;if(zt!=null&&pi!=null){G=1,x=zt.values(p,g,M,m),zt.unit==2&&(x=x.map(st=>p.posToVal(b+st*L,S.key,!0)));let Ce=pi.values(p,g,M,m);pi.unit==2?Ae=Ce[0]*L:Ae=A(Ce[0],S,L,b)-A(0,S,L,b),qe=__(x,w,A,S,L,b,qe),ye=qe-Ae+U}else qe=__(x,w,A,S,L,b,qe),ye=qe*o+U,Ae=qe-ye;ye<1&&(ye=0),rt>=Ae/2&&(rt=0),ye<5&&(k=A_);let Nt=ye>0,Ci=qe-ye-(Nt?rt:0);Ae=k(lu(Ci,Y,W)),_e=(G==0?Ae/2:G==Z?0:Ae)-G*Z*((G==0?U/2:0)+(Nt?rt/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},bi=Ve?null:new Path2D,ii=null;if(ue!=null)ii=p.data[ue.series[1]];else{let{y0:Ce,y1:Je}=l;Ce!=null&&Je!=null&&(w=Je.values(p,g,M,m),ii=Ce.values(p,g,M,m))}let mi=V*Ae,B=ce*Ae;for(let Ce=Z==1?M:m;Ce>=M&&Ce<=m;Ce+=Z){let Je=w[Ce];if(Je==null)continue;if(ii!=null){let X=ii[Ce]??0;if(Je-X==0)continue;me=_(X,R,D,F)}let st=S.distr!=2||l!=null?x[Ce]:Ce,be=A(st,S,L,b),Ut=_(wt(Je,ee),R,D,F),He=k(be-_e),Ze=k(nn(Ut,me)),C=k(Yn(Ut,me)),y=Ze-C;if(Je!=null){let X=Je<0?B:mi,he=Je<0?mi:B;Ve?(rt>0&&it[Ce]!=null&&j(Yt.get(it[Ce]),He,C+wn(rt/2),Ae,nn(0,y-rt),X,he),dt[Ce]!=null&&j(ht.get(dt[Ce]),He,C+wn(rt/2),Ae,nn(0,y-rt),X,he)):j(bi,He,C+wn(rt/2),Ae,nn(0,y-rt),X,he),re(p,g,Ce,He-rt/2,C,Ae+rt,y)}}return rt>0?Mt.stroke=Ve?Yt:bi:Ve||(Mt._fill=d.width==0?d._fill:d._stroke??d._fill,Mt.width=0),Mt.fill=Ve?ht:bi,Mt})}function xw(n,e){let t=wt(e?.alignGaps,0);return(i,r,s,o)=>As(i,r,(a,c,l,h,f,u,p,g,M,m,d)=>{[s,o]=oh(l,s,o);let x=a.pxRound,w=V=>x(u(V,h,m,g)),S=V=>x(p(V,f,d,M)),R,A,_;h.ori==0?(R=fh,_=Wo,A=ev):(R=uh,_=Xo,A=tv);let b=h.dir*(h.ori==0?1:-1),F=w(c[b==1?s:o]),L=F,D=[],k=[];for(let V=b==1?s:o;V>=s&&V<=o;V+=b)if(l[V]!=null){let Z=c[V],j=w(Z);D.push(L=j),k.push(S(l[V]))}let G={stroke:n(D,k,R,_,A,x),fill:null,clip:null,band:null,gaps:null,flags:Ho},U=G.stroke,[W,Y]=Eu(i,r);if(a.fill!=null||W!=0){let V=G.fill=new Path2D(U),ce=a.fillTo(i,r,a.min,a.max,W),Z=S(ce);_(V,L,Z),_(V,F,Z)}if(!a.spanGaps){let V=[];V.push(...Tu(c,l,s,o,b,w,t)),G.gaps=V=a.gaps(i,r,s,o,V),G.clip=hh(V,h.ori,g,M,m,d)}return Y!=0&&(G.band=Y==2?[Lr(i,r,s,o,U,-1),Lr(i,r,s,o,U,1)]:Lr(i,r,s,o,U,Y)),G})}function _w(n){return xw(vw,n)}function vw(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let c=Array(o),l=Array(o-1),h=Array(o-1),f=Array(o-1);for(let u=0;u<o-1;u++)h[u]=e[u+1]-e[u],f[u]=n[u+1]-n[u],l[u]=h[u]/f[u];c[0]=l[0];for(let u=1;u<o-1;u++)l[u]===0||l[u-1]===0||l[u-1]>0!=l[u]>0?c[u]=0:(c[u]=3*(f[u-1]+f[u])/((2*f[u]+f[u-1])/l[u-1]+(f[u]+2*f[u-1])/l[u]),isFinite(c[u])||(c[u]=0));c[o-1]=l[o-2];for(let u=0;u<o-1;u++)r(a,n[u]+f[u]/3,e[u]+c[u]*f[u]/3,n[u+1]-f[u]/3,e[u+1]-c[u+1]*f[u]/3,n[u+1],e[u+1])}return a}var uu=new Set;function v_(){for(let n of uu)n.syncRect(!0)}Vo&&(Es(jy,Bo,v_),Es(eb,Bo,v_,!0),Es(nh,Bo,()=>{ei.pxRatio=At}));var Mw=rv(),Sw=iv();function M_(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>du(s,o,e,t))}function yw(n,e){return n.map((t,i)=>i==0?{}:yi({},e,t))}function du(n,e,t,i){return yi({},e==0?t:i,n)}function sv(n,e,t){return e==null?zo:[e,t]}var bw=sv;function ww(n,e,t){return e==null?zo:rh(e,t,_u,!0)}function ov(n,e,t,i){return e==null?zo:ah(e,t,n.scales[i].log,!1)}var Ew=ov;function av(n,e,t,i){return e==null?zo:xu(e,t,n.scales[i].log,!1)}var Tw=av;function Aw(n,e,t,i,r){let s=nn(Qx(n),Qx(e)),o=e-n,a=qn(r/i*o,t);do{let c=t[a],l=i*c/o;if(l>=r&&s+(c<5?is.get(c):0)<=17)return[c,l]}while(++a<t.length);return[0,0]}function S_(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Ai((t=+r)*At))+"px"),[n,e,t]}function Rw(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=kt(e[2]*At,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function ei(n,e,t){let i={mode:wt(n.mode,1)},r=i.mode;function s(v,E,P,I){let H=E.valToPct(v);return I+P*(E.dir==-1?1-H:H)}function o(v,E,P,I){let H=E.valToPct(v);return I+P*(E.dir==-1?H:1-H)}function a(v,E,P,I){return E.ori==0?s(v,E,P,I):o(v,E,P,I)}i.valToPosH=s,i.valToPosV=o;let c=!1;i.status=0;let l=i.root=Un(Uy);if(n.id!=null&&(l.id=n.id),bn(l,n.class),n.title){let v=Un(By,l);v.textContent=n.title}let h=Xn("canvas"),f=i.ctx=h.getContext("2d"),u=Un(ky,l);Es("click",u,v=>{v.target===g&&(Vt!=Fs||$t!=Os)&&ki.click(i,v)},!0);let p=i.under=Un(zy,u);u.appendChild(h);let g=i.over=Un(Gy,u);n=Go(n);let M=+wt(n.pxAlign,1),m=x_(M);(n.plugins||[]).forEach(v=>{v.opts&&(n=v.opts(i,n)||n)});let d=n.ms||.001,x=i.series=r==1?M_(n.series||[],h_,m_,!1):yw(n.series||[null],p_),w=i.axes=M_(n.axes||[],c_,u_,!0),S=i.scales={},R=i.bands=n.bands||[];R.forEach(v=>{v.fill=vt(v.fill||null),v.dir=wt(v.dir,-1)});let A=r==2?x[1].facets[0].scale:x[0].scale,_={axes:gr,series:mt},b=(n.drawOrder||["axes","series"]).map(v=>_[v]);function F(v){let E=v.distr==3?P=>Pr(P>0?P:v.clamp(i,P,v.min,v.max,v.key)):v.distr==4?P=>eu(P,v.asinh):v.distr==100?P=>v.fwd(P):P=>P;return P=>{let I=E(P),{_min:H,_max:K}=v,ae=K-H;return(I-H)/ae}}function L(v){let E=S[v];if(E==null){let P=(n.scales||dl)[v]||dl;if(P.from!=null){L(P.from);let I=yi({},S[P.from],P,{key:v});I.valToPct=F(I),S[v]=I}else{E=S[v]=yi({},v==A?K_:hw,P),E.key=v;let I=E.time,H=E.range,K=ts(H);if((v!=A||r==2&&!I)&&(K&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?Kx:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?Kx:{mode:1,hard:H[1],soft:H[1]}},K=!1),!K&&ch(H))){let ae=H;H=(de,Me,Ie)=>Me==null?zo:rh(Me,Ie,ae)}E.range=vt(H||(I?bw:v==A?E.distr==3?Ew:E.distr==4?Tw:sv:E.distr==3?ov:E.distr==4?av:ww)),E.auto=vt(K?!1:E.auto),E.clamp=vt(E.clamp||cw),E._min=E._max=null,E.valToPct=F(E)}}}L("x"),L("y"),r==1&&x.forEach(v=>{L(v.scale)}),w.forEach(v=>{L(v.scale)});for(let v in n.scales)L(v);let D=S[A],k=D.distr,G,U;D.ori==0?(bn(l,Fy),G=s,U=o):(bn(l,Oy),G=o,U=s);let W={};for(let v in S){let E=S[v];(E.min!=null||E.max!=null)&&(W[v]={min:E.min,max:E.max},E.min=E.max=null)}let Y=n.tzDate||(v=>new Date(Ai(v/d))),V=n.fmtDate||Su,ce=d==1?Fb(Y):kb(Y),Z=o_(Y,s_(d==1?Ub:Bb,V)),j=l_(Y,a_(Gb,V)),re=[],ue=i.legend=yi({},Wb,n.legend),fe=i.cursor=yi({},Zb,{drag:{y:r==2}},n.cursor),ee=ue.show,me=fe.show,_e=ue.markers;ue.idxs=re,_e.width=vt(_e.width),_e.dash=vt(_e.dash),_e.stroke=vt(_e.stroke),_e.fill=vt(_e.fill);let Ae,ye,qe,rt=[],Ve=[],dt,ht=!1,it={};if(ue.live){let v=x[1]?x[1].values:null;ht=v!=null,dt=ht?v(i,1,0):{_:0};for(let E in dt)it[E]=mu}if(ee)if(Ae=Xn("table",Yy,l),qe=Xn("tbody",null,Ae),ue.mount(i,Ae),ht){ye=Xn("thead",null,Ae,qe);let v=Xn("tr",null,ye);Xn("th",null,v);for(var Yt in dt)Xn("th",Fx,v).textContent=Yt}else bn(Ae,Ky),ue.live&&bn(Ae,$y);let zt={show:!0},pi={show:!1};function Nt(v,E){if(E==0&&(ht||!ue.live||r==2))return zo;let P=[],I=Xn("tr",Zy,qe,qe.childNodes[E]);bn(I,v.class),v.show||bn(I,ws);let H=Xn("th",null,I);if(_e.show){let de=Un(Jy,H);if(E>0){let Me=_e.width(i,E);Me&&(de.style.border=Me+"px "+_e.dash(i,E)+" "+_e.stroke(i,E)),de.style.background=_e.fill(i,E)}}let K=Un(Fx,H);v.label instanceof HTMLElement?K.appendChild(v.label):K.textContent=v.label,E>0&&(_e.show||(K.style.color=v.width>0?_e.stroke(i,E):_e.fill(i,E)),Mt("click",H,de=>{if(fe._lock)return;je(de);let Me=x.indexOf(v);if((de.ctrlKey||de.metaKey)!=ue.isolate){let Ie=x.some((Ue,Oe)=>Oe>0&&Oe!=Me&&Ue.show);x.forEach((Ue,Oe)=>{Oe>0&&Jn(Oe,Ie?Oe==Me?zt:pi:zt,!0,vi.setSeries)})}else Jn(Me,{show:!v.show},!0,vi.setSeries)},!1),et&&Mt(zx,H,de=>{fe._lock||(je(de),Jn(x.indexOf(v),ks,!0,vi.setSeries))},!1));for(var ae in dt){let de=Xn("td",Qy,I);de.textContent="--",P.push(de)}return[I,P]}let Ci=new Map;function Mt(v,E,P,I=!0){let H=Ci.get(E)||{},K=fe.bind[v](i,E,P,I);K&&(Es(v,E,H[v]=K),Ci.set(E,H))}function bi(v,E,P){let I=Ci.get(E)||{};for(let H in I)(v==null||H==v)&&(au(H,E,I[H]),delete I[H]);v==null&&Ci.delete(E)}let ii=0,mi=0,B=0,Ce=0,Je=0,st=0,be=Je,Ut=st,He=B,Ze=Ce,C=0,y=0,X=0,he=0;i.bbox={};let oe=!1,xe=!1,ve=!1,te=!1,ne=!1,pe=!1;function O(v,E,P){(P||v!=i.width||E!=i.height)&&se(v,E),ft(!1),ve=!0,xe=!0,Vi()}function se(v,E){i.width=ii=B=v,i.height=mi=Ce=E,Je=st=0,Se(),We();let P=i.bbox;C=P.left=ys(Je*At,.5),y=P.top=ys(st*At,.5),X=P.width=ys(B*At,.5),he=P.height=ys(Ce*At,.5)}let ie=3;function we(){let v=!1,E=0;for(;!v;){E++;let P=Ns(E),I=Zn(E);v=E==ie||P&&I,v||(se(i.width,i.height),xe=!0)}}function ge({width:v,height:E}){O(v,E)}i.setSize=ge;function Se(){let v=!1,E=!1,P=!1,I=!1;w.forEach((H,K)=>{if(H.show&&H._show){let{side:ae,_size:de}=H,Me=ae%2,Ie=H.label!=null?H.labelSize:0,Ue=de+Ie;Ue>0&&(Me?(B-=Ue,ae==3?(Je+=Ue,I=!0):P=!0):(Ce-=Ue,ae==0?(st+=Ue,v=!0):E=!0))}}),$n[0]=v,$n[1]=P,$n[2]=E,$n[3]=I,B-=On[1]+On[3],Je+=On[3],Ce-=On[2]+On[0],st+=On[0]}function We(){let v=Je+B,E=st+Ce,P=Je,I=st;function H(K,ae){switch(K){case 1:return v+=ae,v-ae;case 2:return E+=ae,E-ae;case 3:return P-=ae,P+ae;case 0:return I-=ae,I+ae}}w.forEach((K,ae)=>{if(K.show&&K._show){let de=K.side;K._pos=H(de,K._size),K.label!=null&&(K._lpos=H(de,K.labelSize))}})}if(fe.dataIdx==null){let v=fe.hover,E=v.skip=new Set(v.skip??[]);E.add(void 0);let P=v.prox=vt(v.prox),I=v.bias??=0;fe.dataIdx=(H,K,ae,de)=>{if(K==0)return ae;let Me=ae,Ie=P(H,K,ae,de)??Bt,Ue=Ie>=0&&Ie<Bt,Oe=D.ori==0?B:Ce,nt=fe.left,Et=e[0],yt=e[K];if(E.has(yt[ae])){Me=null;let gt=null,Qe=null,Ye;if(I==0||I==-1)for(Ye=ae;gt==null&&Ye-- >0;)E.has(yt[Ye])||(gt=Ye);if(I==0||I==1)for(Ye=ae;Qe==null&&Ye++<yt.length;)E.has(yt[Ye])||(Qe=Ye);if(gt!=null||Qe!=null)if(Ue){let Xt=gt==null?-1/0:G(Et[gt],D,Oe,0),si=Qe==null?1/0:G(Et[Qe],D,Oe,0),Ni=nt-Xt,It=si-nt;Ni<=It?Ni<=Ie&&(Me=gt):It<=Ie&&(Me=Qe)}else Me=Qe==null?gt:gt==null?Qe:ae-gt<=Qe-ae?gt:Qe}else Ue&&Ri(nt-G(Et[ae],D,Oe,0))>Ie&&(Me=null);return Me}}let je=v=>{fe.event=v};fe.idxs=re,fe._lock=!1;let le=fe.points;le.show=vt(le.show),le.size=vt(le.size),le.stroke=vt(le.stroke),le.width=vt(le.width),le.fill=vt(le.fill);let Be=i.focus=yi({},n.focus||{alpha:.3},fe.focus),et=Be.prox>=0,Re=et&&le.one,lt=[],Ht=[],Ki=[];function Yo(v,E){let P=le.show(i,E);if(P instanceof HTMLElement)return bn(P,qy),bn(P,v.class),fr(P,-10,-10,B,Ce),g.insertBefore(P,lt[E]),P}function Ps(v,E){if(r==1||E>0){let P=r==1&&S[v.scale].time,I=v.value;v.value=P?t_(I)?l_(Y,a_(I,V)):I||j:I||ow,v.label=v.label||(P?Qb:Jb)}if(Re||E>0){v.width=v.width==null?1:v.width,v.paths=v.paths||Mw||hb,v.fillTo=vt(v.fillTo||fw),v.pxAlign=+wt(v.pxAlign,M),v.pxRound=x_(v.pxAlign),v.stroke=vt(v.stroke||null),v.fill=vt(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let P=aw(nn(1,v.width),1),I=v.points=yi({},{size:P,width:nn(1,P*.2),stroke:v.stroke,space:P*2,paths:Sw,_stroke:null,_fill:null},v.points);I.show=vt(I.show),I.filter=vt(I.filter),I.fill=vt(I.fill),I.stroke=vt(I.stroke),I.paths=vt(I.paths),I.pxAlign=v.pxAlign}if(ee){let P=Nt(v,E);rt.splice(E,0,P[0]),Ve.splice(E,0,P[1]),ue.values.push(null)}if(me){re.splice(E,0,null);let P=null;Re?E==0&&(P=Yo(v,E)):E>0&&(P=Yo(v,E)),lt.splice(E,0,P),Ht.splice(E,0,0),Ki.splice(E,0,0)}Di("addSeries",E)}function Qh(v,E){E=E??x.length,v=r==1?du(v,E,h_,m_):du(v,E,{},p_),x.splice(E,0,v),Ps(x[E],E)}i.addSeries=Qh;function bl(v){if(x.splice(v,1),ee){ue.values.splice(v,1),Ve.splice(v,1);let E=rt.splice(v,1)[0];bi(null,E.firstChild),E.remove()}me&&(re.splice(v,1),lt.splice(v,1)[0].remove(),Ht.splice(v,1),Ki.splice(v,1)),Di("delSeries",v)}i.delSeries=bl;let $n=[!1,!1,!1,!1];function dr(v,E){if(v._show=v.show,v.show){let P=v.side%2,I=S[v.scale];I==null&&(v.scale=P?x[1].scale:A,I=S[v.scale]);let H=I.time;v.size=vt(v.size),v.space=vt(v.space),v.rotate=vt(v.rotate),ts(v.incrs)&&v.incrs.forEach(ae=>{!is.has(ae)&&is.set(ae,P_(ae))}),v.incrs=vt(v.incrs||(I.distr==2?Db:H?d==1?Ib:Ob:bs)),v.splits=vt(v.splits||(H&&I.distr==1?ce:I.distr==3?cu:I.distr==4?tw:ew)),v.stroke=vt(v.stroke),v.grid.stroke=vt(v.grid.stroke),v.ticks.stroke=vt(v.ticks.stroke),v.border.stroke=vt(v.border.stroke);let K=v.values;v.values=ts(K)&&!ts(K[0])?vt(K):H?ts(K)?o_(Y,s_(K,V)):t_(K)?zb(Y,K):K||Z:K||jb,v.filter=vt(v.filter||(I.distr>=3&&I.log==10?rw:I.distr==3&&I.log==2?sw:R_)),v.font=S_(v.font),v.labelFont=S_(v.labelFont),v._size=v.size(i,null,E,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&($n[E]=!0,v._el=Un(Hy,u))}}function pr(v,E,P,I){let[H,K,ae,de]=P,Me=E%2,Ie=0;return Me==0&&(de||K)&&(Ie=E==0&&!H||E==2&&!ae?Ai(c_.size/3):0),Me==1&&(H||ae)&&(Ie=E==1&&!K||E==3&&!de?Ai(u_.size/2):0),Ie}let $o=i.padding=(n.padding||[pr,pr,pr,pr]).map(v=>vt(wt(v,pr))),On=i._padding=$o.map((v,E)=>v(i,E,$n,0)),ni,ci=null,hi=null,Kn=r==1?x[0].idxs:null,fn=null,Nr=!1;function Ko(v,E){if(e=v??[],i.data=i._data=e,r==2){ni=0;for(let P=1;P<x.length;P++)ni+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),fn=e[0],ni=fn.length;let P=e;if(k==2){P=e.slice();let I=P[0]=Array(ni);for(let H=0;H<ni;H++)I[H]=H}i._data=e=P}if(ft(!0),Di("setData"),k==2&&(ve=!0),E!==!1){let P=D;P.auto(i,Nr)?Zo():Fr(A,P.min,P.max),te=te||fe.left>=0,pe=!0,Vi()}}i.setData=Ko;function Zo(){Nr=!0;let v,E;r==1&&(ni>0?(ci=Kn[0]=0,hi=Kn[1]=ni-1,v=e[0][ci],E=e[0][hi],k==2?(v=ci,E=hi):v==E&&(k==3?[v,E]=ah(v,v,D.log,!1):k==4?[v,E]=xu(v,v,D.log,!1):D.time?E=v+Ai(86400/d):[v,E]=rh(v,E,_u,!0))):(ci=Kn[0]=v=null,hi=Kn[1]=E=null)),Fr(A,v,E)}let Ls,Ir,Ds,T,z,Q,q,$,Ee,Pe;function Te(v,E,P,I,H,K){v??=Bx,P??=Mu,I??="butt",H??=Bx,K??="round",v!=Ls&&(f.strokeStyle=Ls=v),H!=Ir&&(f.fillStyle=Ir=H),E!=Ds&&(f.lineWidth=Ds=E),K!=z&&(f.lineJoin=z=K),I!=Q&&(f.lineCap=Q=I),P!=T&&f.setLineDash(T=P)}function Ne(v,E,P,I){E!=Ir&&(f.fillStyle=Ir=E),v!=q&&(f.font=q=v),P!=$&&(f.textAlign=$=P),I!=Ee&&(f.textBaseline=Ee=I)}function ze(v,E,P,I,H=0){if(I.length>0&&v.auto(i,Nr)&&(E==null||E.min==null)){let K=wt(ci,0),ae=wt(hi,I.length-1),de=P.min==null?rb(I,K,ae,H,v.distr==3):[P.min,P.max];v.min=Yn(v.min,P.min=de[0]),v.max=nn(v.max,P.max=de[1])}}let tt={min:null,max:null};function pt(){for(let I in S){let H=S[I];W[I]==null&&(H.min==null||W[A]!=null&&H.auto(i,Nr))&&(W[I]=tt)}for(let I in S){let H=S[I];W[I]==null&&H.from!=null&&W[H.from]!=null&&(W[I]=tt)}W[A]!=null&&ft(!0);let v={};for(let I in W){let H=W[I];if(H!=null){let K=v[I]=Go(S[I],db);if(H.min!=null)yi(K,H);else if(I!=A||r==2)if(ni==0&&K.from==null){let ae=K.range(i,null,null,I);K.min=ae[0],K.max=ae[1]}else K.min=Bt,K.max=-Bt}}if(ni>0){x.forEach((I,H)=>{if(r==1){let K=I.scale,ae=W[K];if(ae==null)return;let de=v[K];if(H==0){let Me=de.range(i,de.min,de.max,K);de.min=Me[0],de.max=Me[1],ci=qn(de.min,e[0]),hi=qn(de.max,e[0]),hi-ci>1&&(e[0][ci]<de.min&&ci++,e[0][hi]>de.max&&hi--),I.min=fn[ci],I.max=fn[hi]}else I.show&&I.auto&&ze(de,ae,I,e[H],I.sorted);I.idxs[0]=ci,I.idxs[1]=hi}else if(H>0&&I.show&&I.auto){let[K,ae]=I.facets,de=K.scale,Me=ae.scale,[Ie,Ue]=e[H],Oe=v[de],nt=v[Me];Oe!=null&&ze(Oe,W[de],K,Ie,K.sorted),nt!=null&&ze(nt,W[Me],ae,Ue,ae.sorted),I.min=ae.min,I.max=ae.max}});for(let I in v){let H=v[I],K=W[I];if(H.from==null&&(K==null||K.min==null)){let ae=H.range(i,H.min==Bt?null:H.min,H.max==-Bt?null:H.max,I);H.min=ae[0],H.max=ae[1]}}}for(let I in v){let H=v[I];if(H.from!=null){let K=v[H.from];if(K.min==null)H.min=H.max=null;else{let ae=H.range(i,K.min,K.max,I);H.min=ae[0],H.max=ae[1]}}}let E={},P=!1;for(let I in v){let H=v[I],K=S[I];if(K.min!=H.min||K.max!=H.max){K.min=H.min,K.max=H.max;let ae=K.distr;K._min=ae==3?Pr(K.min):ae==4?eu(K.min,K.asinh):ae==100?K.fwd(K.min):K.min,K._max=ae==3?Pr(K.max):ae==4?eu(K.max,K.asinh):ae==100?K.fwd(K.max):K.max,E[I]=P=!0}}if(P){x.forEach((I,H)=>{r==2?H>0&&E.y&&(I._paths=null):E[I.scale]&&(I._paths=null)});for(let I in E)ve=!0,Di("setScale",I);me&&fe.left>=0&&(te=pe=!0)}for(let I in W)W[I]=null}function ke(v){let E=lu(ci-1,0,ni-1),P=lu(hi+1,0,ni-1);for(;v[E]==null&&E>0;)E--;for(;v[P]==null&&P<ni-1;)P++;return[E,P]}function mt(){if(ni>0){let v=x.some(E=>E._focus)&&Pe!=Be.alpha;v&&(f.globalAlpha=Pe=Be.alpha),x.forEach((E,P)=>{if(P>0&&E.show&&(Qt(P,!1),Qt(P,!0),E._paths==null)){let I=Pe;Pe!=E.alpha&&(f.globalAlpha=Pe=E.alpha);let H=r==2?[0,e[P][0].length-1]:ke(e[P]);E._paths=E.paths(i,P,H[0],H[1]),Pe!=I&&(f.globalAlpha=Pe=I)}}),x.forEach((E,P)=>{if(P>0&&E.show){let I=Pe;Pe!=E.alpha&&(f.globalAlpha=Pe=E.alpha),E._paths!=null&&Pt(P,!1);{let H=E._paths!=null?E._paths.gaps:null,K=E.points.show(i,P,ci,hi,H),ae=E.points.filter(i,P,K,H);(K||ae)&&(E.points._paths=E.points.paths(i,P,ci,hi,ae),Pt(P,!0))}Pe!=I&&(f.globalAlpha=Pe=I),Di("drawSeries",P)}}),v&&(f.globalAlpha=Pe=1)}}function Qt(v,E){let P=E?x[v].points:x[v];P._stroke=P.stroke(i,v),P._fill=P.fill(i,v)}function Pt(v,E){let P=E?x[v].points:x[v],{stroke:I,fill:H,clip:K,flags:ae,_stroke:de=P._stroke,_fill:Me=P._fill,_width:Ie=P.width}=P._paths;Ie=kt(Ie*At,3);let Ue=null,Oe=Ie%2/2;E&&Me==null&&(Me=Ie>0?"#fff":de);let nt=P.pxAlign==1&&Oe>0;if(nt&&f.translate(Oe,Oe),!E){let Et=C-Ie/2,yt=y-Ie/2,gt=X+Ie,Qe=he+Ie;Ue=new Path2D,Ue.rect(Et,yt,gt,Qe)}E?Fe(de,Ie,P.dash,P.cap,Me,I,H,ae,K):Lt(v,de,Ie,P.dash,P.cap,Me,I,H,ae,Ue,K),nt&&f.translate(-Oe,-Oe)}function Lt(v,E,P,I,H,K,ae,de,Me,Ie,Ue){let Oe=!1;Me!=0&&R.forEach((nt,Et)=>{if(nt.series[0]==v){let yt=x[nt.series[1]],gt=e[nt.series[1]],Qe=(yt._paths||dl).band;ts(Qe)&&(Qe=nt.dir==1?Qe[0]:Qe[1]);let Ye,Xt=null;yt.show&&Qe&&ob(gt,ci,hi)?(Xt=nt.fill(i,Et)||K,Ye=yt._paths.clip):Qe=null,Fe(E,P,I,H,Xt,ae,de,Me,Ie,Ue,Ye,Qe),Oe=!0}}),Oe||Fe(E,P,I,H,K,ae,de,Me,Ie,Ue)}let wi=Ho|fu;function Fe(v,E,P,I,H,K,ae,de,Me,Ie,Ue,Oe){Te(v,E,P,I,H),(Me||Ie||Oe)&&(f.save(),Me&&f.clip(Me),Ie&&f.clip(Ie)),Oe?(de&wi)==wi?(f.clip(Oe),Ue&&f.clip(Ue),xt(H,ae),gi(v,K,E)):de&fu?(xt(H,ae),f.clip(Oe),gi(v,K,E)):de&Ho&&(f.save(),f.clip(Oe),Ue&&f.clip(Ue),xt(H,ae),f.restore(),gi(v,K,E)):(xt(H,ae),gi(v,K,E)),(Me||Ie||Oe)&&f.restore()}function gi(v,E,P){P>0&&(E instanceof Map?E.forEach((I,H)=>{f.strokeStyle=Ls=H,f.stroke(I)}):E!=null&&v&&f.stroke(E))}function xt(v,E){E instanceof Map?E.forEach((P,I)=>{f.fillStyle=Ir=I,f.fill(P)}):E!=null&&v&&f.fill(E)}function mr(v,E,P,I){let H=w[v],K;if(I<=0)K=[0,0];else{let ae=H._space=H.space(i,v,E,P,I),de=H._incrs=H.incrs(i,v,E,P,I,ae);K=Aw(E,P,de,I,ae)}return H._found=K}function xi(v,E,P,I,H,K,ae,de,Me,Ie){let Ue=ae%2/2;M==1&&f.translate(Ue,Ue),Te(de,ae,Me,Ie,de),f.beginPath();let Oe,nt,Et,yt,gt=H+(I==0||I==3?-K:K);P==0?(nt=H,yt=gt):(Oe=H,Et=gt);for(let Qe=0;Qe<v.length;Qe++)E[Qe]!=null&&(P==0?Oe=Et=v[Qe]:nt=yt=v[Qe],f.moveTo(Oe,nt),f.lineTo(Et,yt));f.stroke(),M==1&&f.translate(-Ue,-Ue)}function Ns(v){let E=!0;return w.forEach((P,I)=>{if(!P.show)return;let H=S[P.scale];if(H.min==null){P._show&&(E=!1,P._show=!1,ft(!1));return}else P._show||(E=!1,P._show=!0,ft(!1));let K=P.side,ae=K%2,{min:de,max:Me}=H,[Ie,Ue]=mr(I,de,Me,ae==0?B:Ce);if(Ue==0)return;let Oe=H.distr==2,nt=P._splits=P.splits(i,I,de,Me,Ie,Ue,Oe),Et=H.distr==2?nt.map(Ye=>fn[Ye]):nt,yt=H.distr==2?fn[nt[1]]-fn[nt[0]]:Ie,gt=P._values=P.values(i,P.filter(i,Et,I,Ue,yt),I,Ue,yt);P._rotate=K==2?P.rotate(i,gt,I,Ue):0;let Qe=P._size;P._size=Fn(P.size(i,gt,I,v)),Qe!=null&&P._size!=Qe&&(E=!1)}),E}function Zn(v){let E=!0;return $o.forEach((P,I)=>{let H=P(i,I,$n,v);H!=On[I]&&(E=!1),On[I]=H}),E}function gr(){for(let v=0;v<w.length;v++){let E=w[v];if(!E.show||!E._show)continue;let P=E.side,I=P%2,H,K,ae=E.stroke(i,v),de=P==0||P==3?-1:1,[Me,Ie]=E._found;if(E.label!=null){let Qi=E.labelGap*de,pn=Ai((E._lpos+Qi)*At);Ne(E.labelFont[0],ae,"center",P==2?"top":Ox),f.save(),I==1?(H=K=0,f.translate(pn,Ai(y+he/2)),f.rotate((P==3?-ih:ih)/2)):(H=Ai(C+X/2),K=pn);let ss=T_(E.label)?E.label(i,v,Me,Ie):E.label;f.fillText(ss,H,K),f.restore()}if(Ie==0)continue;let Ue=S[E.scale],Oe=I==0?X:he,nt=I==0?C:y,Et=E._splits,yt=Ue.distr==2?Et.map(Qi=>fn[Qi]):Et,gt=Ue.distr==2?fn[Et[1]]-fn[Et[0]]:Me,Qe=E.ticks,Ye=E.border,Xt=Qe.show?Qe.size:0,si=Ai(Xt*At),Ni=Ai((E.alignTo==2?E._size-Xt-E.gap:E.gap)*At),It=E._rotate*-ih/180,oi=m(E._pos*At),un=(si+Ni)*de,Ji=oi+un;K=I==0?Ji:0,H=I==1?Ji:0;let Tn=E.font[0],Bn=E.align==1?Fo:E.align==2?Jf:It>0?Fo:It<0?Jf:I==0?"center":P==3?Jf:Fo,jn=It||I==1?"middle":P==2?"top":Ox;Ne(Tn,ae,Bn,jn);let dn=E.font[1]*E.lineGap,An=Et.map(Qi=>m(a(Qi,Ue,Oe,nt))),kn=E._values;for(let Qi=0;Qi<kn.length;Qi++){let pn=kn[Qi];if(pn!=null){I==0?H=An[Qi]:K=An[Qi],pn=""+pn;let ss=pn.indexOf(`
`)==-1?[pn]:pn.split(/\n/gm);for(let ji=0;ji<ss.length;ji++){let ld=ss[ji];It?(f.save(),f.translate(H,K+ji*dn),f.rotate(It),f.fillText(ld,0,0),f.restore()):f.fillText(ld,H,K+ji*dn)}}}Qe.show&&xi(An,Qe.filter(i,yt,v,Ie,gt),I,P,oi,si,kt(Qe.width*At,3),Qe.stroke(i,v),Qe.dash,Qe.cap);let er=E.grid;er.show&&xi(An,er.filter(i,yt,v,Ie,gt),I,I==0?2:1,I==0?y:C,I==0?he:X,kt(er.width*At,3),er.stroke(i,v),er.dash,er.cap),Ye.show&&xi([oi],[1],I==0?1:0,I==0?1:2,I==1?y:C,I==1?he:X,kt(Ye.width*At,3),Ye.stroke(i,v),Ye.dash,Ye.cap)}Di("drawAxes")}function ft(v){x.forEach((E,P)=>{P>0&&(E._paths=null,v&&(r==1?(E.min=null,E.max=null):E.facets.forEach(I=>{I.min=null,I.max=null})))})}let ri=!1,Zi=!1,Dt=[];function _i(){Zi=!1;for(let v=0;v<Dt.length;v++)Di(...Dt[v]);Dt.length=0}function Vi(){ri||(Mb(Wu),ri=!0)}function wl(v,E=!1){ri=!0,Zi=E,v(i),Wu(),E&&Dt.length>0&&queueMicrotask(_i)}i.batch=wl;function Wu(){if(oe&&(pt(),oe=!1),ve&&(we(),ve=!1),xe){if(qt(p,Fo,Je),qt(p,"top",st),qt(p,cl,B),qt(p,hl,Ce),qt(g,Fo,Je),qt(g,"top",st),qt(g,cl,B),qt(g,hl,Ce),qt(u,cl,ii),qt(u,hl,mi),h.width=Ai(ii*At),h.height=Ai(mi*At),w.forEach(({_el:v,_show:E,_size:P,_pos:I,side:H})=>{if(v!=null)if(E){let K=H===3||H===0?P:0,ae=H%2==1;qt(v,ae?"left":"top",I-K),qt(v,ae?"width":"height",P),qt(v,ae?"top":"left",ae?st:Je),qt(v,ae?"height":"width",ae?Ce:B),ou(v,ws)}else bn(v,ws)}),Ls=Ir=Ds=z=Q=q=$=Ee=T=null,Pe=1,jo(!0),Je!=be||st!=Ut||B!=He||Ce!=Ze){ft(!1);let v=B/He,E=Ce/Ze;if(me&&!te&&fe.left>=0){fe.left*=v,fe.top*=E,Is&&fr(Is,Ai(fe.left),0,B,Ce),Us&&fr(Us,0,Ai(fe.top),B,Ce);for(let P=0;P<lt.length;P++){let I=lt[P];I!=null&&(Ht[P]*=v,Ki[P]*=E,fr(I,Fn(Ht[P]),Fn(Ki[P]),B,Ce))}}if(Wt.show&&!ne&&Wt.left>=0&&Wt.width>0){Wt.left*=v,Wt.width*=v,Wt.top*=E,Wt.height*=E;for(let P in sf)qt(Bs,P,Wt[P])}be=Je,Ut=st,He=B,Ze=Ce}Di("setSize"),xe=!1}ii>0&&mi>0&&(f.clearRect(0,0,h.width,h.height),Di("drawClear"),b.forEach(v=>v()),Di("draw")),Wt.show&&ne&&(El(Wt),ne=!1),me&&te&&(rs(null,!0,!1),te=!1),ue.show&&ue.live&&pe&&(nf(),pe=!1),c||(c=!0,i.status=1,Di("ready")),Nr=!1,ri=!1}i.redraw=(v,E)=>{ve=E||!1,v!==!1?Fr(A,D.min,D.max):Vi()};function jh(v,E){let P=S[v];if(P.from==null){if(ni==0){let I=P.range(i,E.min,E.max,v);E.min=I[0],E.max=I[1]}if(E.min>E.max){let I=E.min;E.min=E.max,E.max=I}if(ni>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;v==A&&P.distr==2&&ni>0&&(E.min=qn(E.min,e[0]),E.max=qn(E.max,e[0]),E.min==E.max&&E.max++),W[v]=E,oe=!0,Vi()}}i.setScale=jh;let ef,tf,Is,Us,Xu,qu,Fs,Os,Yu,$u,Vt,$t,Ur=!1,ki=fe.drag,Pi=ki.x,Li=ki.y;me&&(fe.x&&(ef=Un(Wy,g)),fe.y&&(tf=Un(Xy,g)),D.ori==0?(Is=ef,Us=tf):(Is=tf,Us=ef),Vt=fe.left,$t=fe.top);let Wt=i.select=yi({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Bs=Wt.show?Un(Vy,Wt.over?g:p):null;function El(v,E){if(Wt.show){for(let P in v)Wt[P]=v[P],P in sf&&qt(Bs,P,v[P]);E!==!1&&Di("setSelect")}}i.setSelect=El;function Xv(v){if(x[v].show)ee&&ou(rt[v],ws);else if(ee&&bn(rt[v],ws),me){let P=Re?lt[0]:lt[v];P!=null&&fr(P,-10,-10,B,Ce)}}function Fr(v,E,P){jh(v,{min:E,max:P})}function Jn(v,E,P,I){E.focus!=null&&Zv(v),E.show!=null&&x.forEach((H,K)=>{K>0&&(v==K||v==null)&&(H.show=E.show,Xv(K),r==2?(Fr(H.facets[0].scale,null,null),Fr(H.facets[1].scale,null,null)):Fr(H.scale,null,null),Vi())}),P!==!1&&Di("setSeries",v,E),I&&ea("setSeries",i,v,E)}i.setSeries=Jn;function qv(v,E){yi(R[v],E)}function Yv(v,E){v.fill=vt(v.fill||null),v.dir=wt(v.dir,-1),E=E??R.length,R.splice(E,0,v)}function $v(v){v==null?R.length=0:R.splice(v,1)}i.addBand=Yv,i.setBand=qv,i.delBand=$v;function Kv(v,E){x[v].alpha=E,me&&lt[v]!=null&&(lt[v].style.opacity=E),ee&&rt[v]&&(rt[v].style.opacity=E)}let xr,Or,ns,ks={focus:!0};function Zv(v){if(v!=ns){let E=v==null,P=Be.alpha!=1;x.forEach((I,H)=>{if(r==1||H>0){let K=E||H==0||H==v;I._focus=E?null:K,P&&Kv(H,K?1:Be.alpha)}}),ns=v,P&&Vi()}}ee&&et&&Mt(Gx,Ae,v=>{fe._lock||(je(v),ns!=null&&Jn(null,ks,!0,vi.setSeries))});function Qn(v,E,P){let I=S[E];P&&(v=v/At-(I.ori==1?st:Je));let H=B;I.ori==1&&(H=Ce,v=H-v),I.dir==-1&&(v=H-v);let K=I._min,ae=I._max,de=v/H,Me=K+(ae-K)*de,Ie=I.distr;return Ie==3?ko(10,Me):Ie==4?lb(Me,I.asinh):Ie==100?I.bwd(Me):Me}function Jv(v,E){let P=Qn(v,A,E);return qn(P,e[0],ci,hi)}i.valToIdx=v=>qn(v,e[0]),i.posToIdx=Jv,i.posToVal=Qn,i.valToPos=(v,E,P)=>S[E].ori==0?s(v,S[E],P?X:B,P?C:0):o(v,S[E],P?he:Ce,P?y:0),i.setCursor=(v,E,P)=>{Vt=v.left,$t=v.top,rs(null,E,P)};function Ku(v,E){qt(Bs,Fo,Wt.left=v),qt(Bs,cl,Wt.width=E)}function Zu(v,E){qt(Bs,"top",Wt.top=v),qt(Bs,hl,Wt.height=E)}let Jo=D.ori==0?Ku:Zu,Qo=D.ori==1?Ku:Zu;function Qv(){if(ee&&ue.live)for(let v=r==2?1:0;v<x.length;v++){if(v==0&&ht)continue;let E=ue.values[v],P=0;for(let I in E)Ve[v][P++].firstChild.nodeValue=E[I]}}function nf(v,E){if(v!=null&&(v.idxs?v.idxs.forEach((P,I)=>{re[I]=P}):ub(v.idx)||re.fill(v.idx),ue.idx=re[0]),ee&&ue.live){for(let P=0;P<x.length;P++)(P>0||r==1&&!ht)&&jv(P,re[P]);Qv()}pe=!1,E!==!1&&Di("setLegend")}i.setLegend=nf;function jv(v,E){let P=x[v],I=v==0&&k==2?fn:e[v],H;ht?H=P.values(i,v,E)??it:(H=P.value(i,E==null?null:I[E],v,E),H=H==null?it:{_:H}),ue.values[v]=H}function rs(v,E,P){Yu=Vt,$u=$t,[Vt,$t]=fe.move(i,Vt,$t),fe.left=Vt,fe.top=$t,me&&(Is&&fr(Is,Ai(Vt),0,B,Ce),Us&&fr(Us,0,Ai($t),B,Ce));let I,H=ci>hi;xr=Bt,Or=null;let K=D.ori==0?B:Ce,ae=D.ori==1?B:Ce;if(Vt<0||ni==0||H){I=fe.idx=null;for(let de=0;de<x.length;de++){let Me=lt[de];Me!=null&&fr(Me,-10,-10,B,Ce)}et&&Jn(null,ks,!0,v==null&&vi.setSeries),ue.live&&(re.fill(I),pe=!0)}else{let de,Me,Ie;r==1&&(de=D.ori==0?Vt:$t,Me=Qn(de,A),I=fe.idx=qn(Me,e[0],ci,hi),Ie=G(e[0][I],D,K,0));let Ue=-10,Oe=-10,nt=0,Et=0,yt=!0,gt="",Qe="";for(let Ye=r==2?1:0;Ye<x.length;Ye++){let Xt=x[Ye],si=re[Ye],Ni=si==null?null:r==1?e[Ye][si]:e[Ye][1][si],It=fe.dataIdx(i,Ye,I,Me),oi=It==null?null:r==1?e[Ye][It]:e[Ye][1][It];if(pe=pe||oi!=Ni||It!=si,re[Ye]=It,Ye>0&&Xt.show){let un=It==null?-10:It==I?Ie:G(r==1?e[0][It]:e[Ye][0][It],D,K,0),Ji=oi==null?-10:U(oi,r==1?S[Xt.scale]:S[Xt.facets[1].scale],ae,0);if(et&&oi!=null){let Tn=D.ori==1?Vt:$t,Bn=Ri(Be.dist(i,Ye,It,Ji,Tn));if(Bn<xr){let jn=Be.bias;if(jn!=0){let dn=Qn(Tn,Xt.scale),An=oi>=0?1:-1,kn=dn>=0?1:-1;kn==An&&(kn==1?jn==1?oi>=dn:oi<=dn:jn==1?oi<=dn:oi>=dn)&&(xr=Bn,Or=Ye)}else xr=Bn,Or=Ye}}if(pe||Re){let Tn,Bn;D.ori==0?(Tn=un,Bn=Ji):(Tn=Ji,Bn=un);let jn,dn,An,kn,er,Qi,pn=!0,ss=le.bbox;if(ss!=null){pn=!1;let ji=ss(i,Ye);An=ji.left,kn=ji.top,jn=ji.width,dn=ji.height}else An=Tn,kn=Bn,jn=dn=le.size(i,Ye);if(Qi=le.fill(i,Ye),er=le.stroke(i,Ye),Re)Ye==Or&&xr<=Be.prox&&(Ue=An,Oe=kn,nt=jn,Et=dn,yt=pn,gt=Qi,Qe=er);else{let ji=lt[Ye];ji!=null&&(Ht[Ye]=An,Ki[Ye]=kn,$x(ji,jn,dn,pn),qx(ji,Qi,er),fr(ji,Fn(An),Fn(kn),B,Ce))}}}}if(Re){let Ye=Be.prox,Xt=ns==null?xr<=Ye:xr>Ye||Or!=ns;if(pe||Xt){let si=lt[0];si!=null&&(Ht[0]=Ue,Ki[0]=Oe,$x(si,nt,Et,yt),qx(si,gt,Qe),fr(si,Fn(Ue),Fn(Oe),B,Ce))}}}if(Wt.show&&Ur)if(v!=null){let[de,Me]=vi.scales,[Ie,Ue]=vi.match,[Oe,nt]=v.cursor.sync.scales,Et=v.cursor.drag;if(Pi=Et._x,Li=Et._y,Pi||Li){let{left:yt,top:gt,width:Qe,height:Ye}=v.select,Xt=v.scales[Oe].ori,si=v.posToVal,Ni,It,oi,un,Ji,Tn=de!=null&&Ie(de,Oe),Bn=Me!=null&&Ue(Me,nt);Tn&&Pi?(Xt==0?(Ni=yt,It=Qe):(Ni=gt,It=Ye),oi=S[de],un=G(si(Ni,Oe),oi,K,0),Ji=G(si(Ni+It,Oe),oi,K,0),Jo(Yn(un,Ji),Ri(Ji-un))):Jo(0,K),Bn&&Li?(Xt==1?(Ni=yt,It=Qe):(Ni=gt,It=Ye),oi=S[Me],un=U(si(Ni,nt),oi,ae,0),Ji=U(si(Ni+It,nt),oi,ae,0),Qo(Yn(un,Ji),Ri(Ji-un))):Qo(0,ae)}else of()}else{let de=Ri(Yu-Xu),Me=Ri($u-qu);if(D.ori==1){let nt=de;de=Me,Me=nt}Pi=ki.x&&de>=ki.dist,Li=ki.y&&Me>=ki.dist;let Ie=ki.uni;Ie!=null?Pi&&Li&&(Pi=de>=Ie,Li=Me>=Ie,!Pi&&!Li&&(Me>de?Li=!0:Pi=!0)):ki.x&&ki.y&&(Pi||Li)&&(Pi=Li=!0);let Ue,Oe;Pi&&(D.ori==0?(Ue=Fs,Oe=Vt):(Ue=Os,Oe=$t),Jo(Yn(Ue,Oe),Ri(Oe-Ue)),Li||Qo(0,ae)),Li&&(D.ori==1?(Ue=Fs,Oe=Vt):(Ue=Os,Oe=$t),Qo(Yn(Ue,Oe),Ri(Oe-Ue)),Pi||Jo(0,K)),!Pi&&!Li&&(Jo(0,0),Qo(0,0))}if(ki._x=Pi,ki._y=Li,v==null){if(P){if(ad!=null){let[de,Me]=vi.scales;vi.values[0]=de!=null?Qn(D.ori==0?Vt:$t,de):null,vi.values[1]=Me!=null?Qn(D.ori==1?Vt:$t,Me):null}ea(Qf,i,Vt,$t,B,Ce,I)}if(et){let de=P&&vi.setSeries,Me=Be.prox;ns==null?xr<=Me&&Jn(Or,ks,!0,de):xr>Me?Jn(null,ks,!0,de):Or!=ns&&Jn(Or,ks,!0,de)}}pe&&(ue.idx=I,nf()),E!==!1&&Di("setCursor")}let Br=null;Object.defineProperty(i,"rect",{get(){return Br==null&&jo(!1),Br}});function jo(v=!1){v?Br=null:(Br=g.getBoundingClientRect(),Di("syncRect",Br))}function Ju(v,E,P,I,H,K,ae){fe._lock||Ur&&v!=null&&v.movementX==0&&v.movementY==0||(rf(v,E,P,I,H,K,ae,!1,v!=null),v!=null?rs(null,!0,!0):rs(E,!0,!1))}function rf(v,E,P,I,H,K,ae,de,Me){if(Br==null&&jo(!1),je(v),v!=null)P=v.clientX-Br.left,I=v.clientY-Br.top;else{if(P<0||I<0){Vt=-10,$t=-10;return}let[Ie,Ue]=vi.scales,Oe=E.cursor.sync,[nt,Et]=Oe.values,[yt,gt]=Oe.scales,[Qe,Ye]=vi.match,Xt=E.axes[0].side%2==1,si=D.ori==0?B:Ce,Ni=D.ori==1?B:Ce,It=Xt?K:H,oi=Xt?H:K,un=Xt?I:P,Ji=Xt?P:I;if(yt!=null?P=Qe(Ie,yt)?a(nt,S[Ie],si,0):-10:P=si*(un/It),gt!=null?I=Ye(Ue,gt)?a(Et,S[Ue],Ni,0):-10:I=Ni*(Ji/oi),D.ori==1){let Tn=P;P=I,I=Tn}}Me&&(E==null||E.cursor.event.type==Qf)&&((P<=1||P>=B-1)&&(P=ys(P,B)),(I<=1||I>=Ce-1)&&(I=ys(I,Ce))),de?(Xu=P,qu=I,[Fs,Os]=fe.move(i,P,I)):(Vt=P,$t=I)}let sf={width:0,height:0,left:0,top:0};function of(){El(sf,!1)}let Qu,ju,ed,td;function id(v,E,P,I,H,K,ae){Ur=!0,Pi=Li=ki._x=ki._y=!1,rf(v,E,P,I,H,K,ae,!0,!1),v!=null&&(Mt(jf,ru,nd,!1),ea(kx,i,Fs,Os,B,Ce,null));let{left:de,top:Me,width:Ie,height:Ue}=Wt;Qu=de,ju=Me,ed=Ie,td=Ue}function nd(v,E,P,I,H,K,ae){Ur=ki._x=ki._y=!1,rf(v,E,P,I,H,K,ae,!1,!0);let{left:de,top:Me,width:Ie,height:Ue}=Wt,Oe=Ie>0||Ue>0,nt=Qu!=de||ju!=Me||ed!=Ie||td!=Ue;if(Oe&&nt&&El(Wt),ki.setScale&&Oe&&nt){let Et=de,yt=Ie,gt=Me,Qe=Ue;if(D.ori==1&&(Et=Me,yt=Ue,gt=de,Qe=Ie),Pi&&Fr(A,Qn(Et,A),Qn(Et+yt,A)),Li)for(let Ye in S){let Xt=S[Ye];Ye!=A&&Xt.from==null&&Xt.min!=Bt&&Fr(Ye,Qn(gt+Qe,Ye),Qn(gt,Ye))}of()}else fe.lock&&(fe._lock=!fe._lock,rs(E,!0,v!=null));v!=null&&(bi(jf,ru),ea(jf,i,Vt,$t,B,Ce,null))}function eM(v,E,P,I,H,K,ae){if(fe._lock)return;je(v);let de=Ur;if(Ur){let Me=!0,Ie=!0,Ue=10,Oe,nt;D.ori==0?(Oe=Pi,nt=Li):(Oe=Li,nt=Pi),Oe&&nt&&(Me=Vt<=Ue||Vt>=B-Ue,Ie=$t<=Ue||$t>=Ce-Ue),Oe&&Me&&(Vt=Vt<Fs?0:B),nt&&Ie&&($t=$t<Os?0:Ce),rs(null,!0,!0),Ur=!1}Vt=-10,$t=-10,re.fill(null),rs(null,!0,!0),de&&(Ur=de)}function rd(v,E,P,I,H,K,ae){fe._lock||(je(v),Zo(),of(),v!=null&&ea(Hx,i,Vt,$t,B,Ce,null))}function sd(){w.forEach(Rw),O(i.width,i.height,!0)}Es(nh,Bo,sd);let zs={};zs.mousedown=id,zs.mousemove=Ju,zs.mouseup=nd,zs.dblclick=rd,zs.setSeries=(v,E,P,I)=>{let H=vi.match[2];P=H(i,E,P),P!=-1&&Jn(P,I,!0,!1)},me&&(Mt(kx,g,id),Mt(Qf,g,Ju),Mt(zx,g,v=>{je(v),jo(!1)}),Mt(Gx,g,eM),Mt(Hx,g,rd),uu.add(i),i.syncRect=jo);let Tl=i.hooks=n.hooks||{};function Di(v,E,P){Zi?Dt.push([v,E,P]):v in Tl&&Tl[v].forEach(I=>{I.call(null,i,E,P)})}(n.plugins||[]).forEach(v=>{for(let E in v.hooks)Tl[E]=(Tl[E]||[]).concat(v.hooks[E])});let od=(v,E,P)=>P,vi=yi({key:null,setSeries:!1,filters:{pub:jx,sub:jx},scales:[A,x[1]?x[1].scale:null],match:[e_,e_,od],values:[null,null]},fe.sync);vi.match.length==2&&vi.match.push(od),fe.sync=vi;let ad=vi.key,af=Z_(ad);function ea(v,E,P,I,H,K,ae){vi.filters.pub(v,E,P,I,H,K,ae)&&af.pub(v,E,P,I,H,K,ae)}af.sub(i);function tM(v,E,P,I,H,K,ae){vi.filters.sub(v,E,P,I,H,K,ae)&&zs[v](null,E,P,I,H,K,ae)}i.pub=tM;function iM(){af.unsub(i),uu.delete(i),Ci.clear(),au(nh,Bo,sd),l.remove(),Ae?.remove(),Di("destroy")}i.destroy=iM;function lf(){Di("init",n,e),Ko(e||n.data,!1),W[A]?jh(A,W[A]):Zo(),ne=Wt.show&&(Wt.width>0||Wt.height>0),te=pe=!0,O(n.width,n.height)}return x.forEach(Ps),w.forEach(dr),t?t instanceof HTMLElement?(t.appendChild(l),lf()):t(i,lf):lf(),i}ei.assign=yi;ei.fmtNum=vu;ei.rangeNum=rh;ei.rangeLog=ah;ei.rangeAsinh=xu;ei.orient=As;ei.pxRatio=At;ei.join=vb;ei.fmtDate=Su,ei.tzDate=Pb;ei.sync=Z_;{ei.addGap=uw,ei.clipGaps=hh;let n=ei.paths={points:iv};n.linear=rv,n.stepped=mw,n.bars=gw,n.spline=_w}var lv=84,Cw=4;function Pw(n){let{data:e}=n.times;if(!n.most||e.length<2)return Float64Array.from(e);let t=e.length;return Float64Array.from(e,(i,r)=>i+(r<t-1?e[r+1]-i:i-e[r-1])/2)}function cv(n,e){let t=n.scale??1;return Float64Array.from(e.data,i=>i*t)}var Ru=(n,e)=>e>n+1e-9*Math.abs(n);function Lw(n,e,t=1/0){if(Ru(t,e))return null;let{times:i,least:r,most:s}=n,o=0,a=i.count;for(;a-o>1;){let l=o+a>>1;i.data[l]<=e?o=l:a=l}let c=n.scale??1;return{least:r.data[o]*c,most:(s??r).data[o]*c}}function Dw(n){let e=n.filter(Boolean).map(({least:r,most:s})=>{let o=(a,c)=>a.data.reduce((l,h)=>c(l,h),a.data[0]);return[o(r,Math.min),o(s??r,Math.max)]}),t=Math.min(...e.map(([r])=>r)),i=Math.max(...e.map(([,r])=>r));return{middle:(t+i)/2,span:Math.max(...e.map(([r,s])=>s-r))}}function Nw(n,e){let t=Math.max(n.span,e.span),i=Math.abs(n.middle-e.middle);return i>Cw*t&&t>1e-9*i}var ph=class{constructor(e,t,i,r,s=[]){this.channels=e,this.ends=s,this.marks=t,this.kinds=[...new Set(t.map(o=>o.kind))],this.full=i,this.x=i,this.seek=r,this.time=i[0],this.drawn=[],this.element=J("div",{className:"ppv-plots"}),this.names=new Set(e.flat().filter(o=>o.first).map(o=>o.name)),this.order=[...new Set(e.flat().map(o=>o.name))],this.onRemove=()=>{}}show(e,t){t?this.names.add(e):this.names.delete(e),this.build()}#e(){let e=[];for(let i of this.order){if(!this.names.has(i))continue;let r=this.channels.map(c=>c.find(l=>l.name===i)),s=(r.find(Boolean).shown_unit??r.find(Boolean).unit)||"1",o={name:i,found:r,...Dw(r)},a=e.find(c=>c.unit===s&&!c.members.some(l=>Nw(o,l)));a?a.members.push(o):e.push({unit:s,members:[o]})}let t=[...new Set(e.map(({unit:i})=>i))];return e.sort((i,r)=>t.indexOf(i.unit)-t.indexOf(r.unit))}build(){for(let{plot:t}of this.drawn)t.destroy();this.drawn=[],this.element.replaceChildren();let e=this.#e();this.ratio=window.devicePixelRatio||1,this.turns=e.flatMap(({members:t})=>t).map(({name:t})=>t).filter(t=>!wx(t));for(let{unit:t,members:i}of e){let r=J("div",{className:"ppv-plot"}),s=J("div",{className:"ppv-caption"}),o=J("div",{className:"ppv-box"});r.append(s,o),this.element.append(r);let a=this.#t(t,i,o,s);this.drawn.push({...a,box:o,caption:s})}e.length||this.element.append(J("p",{className:"ppv-none"},this.order.length?"Choose a curve.":"This scene has no curves.")),this.resize(),this.cursor(this.time)}#t(e,t,i,r){let s=[],o=[{}],a=[],c=[],l=getComputedStyle(this.element);t.forEach(({name:d,found:x})=>{let w=zc(this.element,d,this.turns.indexOf(d)),S=[w,Cu(this.element,w)],R=J("output",{}),A=x.find(Boolean);r.append(J("span",{className:"ppv-curve"},...S.filter((b,F)=>x[F]).map(b=>J("i",{style:`background:${b}`})),J("span",{},A.label??d),R,J("small",{},e==="1"?"":e),Tt("\xD7",`Remove ${A.label??d}`,()=>{this.show(d,!1),this.onRemove()})));let _=Math.max(...x.filter(Boolean).map(b=>(b.scale??1)*Math.max(...[b.least,b.most??b.least].map(({data:F})=>F.reduce((L,D)=>Math.max(L,Math.abs(D)),0)))));c.push({values:R,found:x,digits:$c(_)}),x.forEach((b,F)=>{if(!b)return;let L=F?[6,4]:void 0,D={stroke:S[F],width:1.4,dash:L,points:{show:!1},spanGaps:!0},k=[Pw(b),cv(b,b.least)];b.most&&(k.push(cv(b,b.most)),a.push({series:[o.length+1,o.length],fill:`color-mix(in srgb, ${S[F]} ${F?8:30}%, transparent)`}),o.push({...D,width:1})),o.push({...D,width:b.most?1:1.4}),s.push(k)})});let f=s.every(([d])=>d.length===s[0][0].length&&d.every((x,w)=>x===s[0][0][w]))?[s[0][0],...s.flatMap(([,...d])=>d)]:ei.join(s.map(d=>d.map(x=>Array.from(x)))),u=l.getPropertyValue("--v-soft").trim()||"#666",p=l.getPropertyValue("--v-grid").trim()||"#ddd",g={stroke:u,grid:{stroke:p,width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},M=new ei({width:300,height:lv,padding:[6,30,0,0],series:o,bands:a,legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,range:()=>this.x},y:{range:(d,x,w)=>Uw(x,w)}},axes:[{...g,size:22,gap:3,values:(d,x)=>Fw(x)},{...g,size:62,gap:4,space:Iw,values:(d,x)=>Rs(x)}],hooks:{draw:[d=>this.#i(d)]}},f,i),m=J("div",{className:"ppv-cursor"});return M.over.append(m),this.#n(M),{plot:M,line:m,shows:c}}#i(e){let{left:t,top:i,width:r}=e.bbox,s=-9;for(let o of this.marks){let a=e.valToPos(o.time,"x",!0);a<t||a>t+r||a-s<1||(s=a,e.ctx.fillStyle=vs(this.kinds,o.kind),e.ctx.fillRect(a-this.ratio/2,i,1.2*this.ratio,6*this.ratio))}}#n(e){let{over:t}=e,i=s=>e.posToVal(s.clientX-t.getBoundingClientRect().left,"x"),r=!1;t.addEventListener("pointerdown",s=>{s.button||(r=!0,t.setPointerCapture?.(s.pointerId),this.seek(i(s)))}),t.addEventListener("pointermove",s=>r&&this.seek(i(s)));for(let s of["pointerup","pointercancel"])t.addEventListener(s,()=>r=!1);t.addEventListener("dblclick",()=>this.zoom(this.full)),t.addEventListener("wheel",s=>{if(!s.ctrlKey&&!s.shiftKey&&s.deltaY>0&&this.x===this.full)return;s.preventDefault();let o=i(s),a=Math.exp(Math.max(-1,Math.min(1,(s.deltaY||s.deltaX)*.002)));this.zoom([o+(this.x[0]-o)*a,o+(this.x[1]-o)*a])},{passive:!1})}zoom([e,t]){let[i,r]=this.full,s=t-e>=r-i;this.x=s?this.full:[Math.max(i,e),Math.min(r,t)];for(let{plot:o}of this.drawn)o.setData(o.data);this.cursor(this.time)}resize(){let e=this.drawn.reduce((r,{caption:s})=>r+s.offsetHeight,0),t=this.element.clientHeight-e-4,i=Math.max(lv,Math.min(260,Math.floor(t/Math.max(1,this.drawn.length))-4));for(let{plot:r,box:s}of this.drawn)r.setSize({width:Math.max(120,s.clientWidth),height:i});this.cursor(this.time)}cursor(e){this.time=e;for(let{plot:t,line:i,shows:r}of this.drawn){let s=t.valToPos(e,"x");i.hidden=!(s>=-.5&&s<=t.over.clientWidth+.5),i.style.transform=`translateX(${s}px)`;for(let{values:o,found:a,digits:c}of r){let l=a.flatMap((h,f)=>{if(!h)return[];let u=Lw(h,e,this.ends[f]);if(!u)return["\u2013"];let{least:p,most:g}=u;return[...new Set([c(p),c(g)])].join(" \u2026 ")}).join(" | ");o.textContent!==l&&(o.textContent=l)}}}};function Cu(n,e){let t=getComputedStyle(n).getPropertyValue("--v-ink").trim()||"#1f2933";return`color-mix(in srgb, ${e} 40%, ${t})`}var Iw=(n,e,t,i,r)=>Math.max(9,Math.min(24,r/4));function Uw(n,e){if(!(e>=n))return[0,1];let t=.06*(e-n||Math.abs(e)||1);return[n-t,e+t]}function Fw(n){let[e,t]=Rx(Math.max(...n.map(Math.abs)));return Rs(n.map(i=>i/e),t)}function Rs(n,e=""){let t=Math.max(...n.map(Math.abs)),i=n.length>1?Math.abs(n[1]-n[0]):t,r=Math.max(0,Math.min(12,-Math.floor(Math.log10(i||1)+1e-9)));return r<12&&Math.abs(i*10**r-Math.round(i*10**r))>1e-6&&r++,n.map((s,o)=>{let a=t>=1e6||t>0&&t<1e-4?s.toExponential(2):s.toFixed(r);return(o===n.length-1&&e?`${a} ${e}`:a).replace(/^-(0(\.0+)?)$/,"$1").replace("-","\u2212")})}var Ow=92;function hv(n){let e=n.length;return[1.5*n[0]-.5*n[1],1.5*n[e-1]-.5*n[e-2]]}function mh(n,e){let t=0,i=n.length-1;for(;i-t>1;){let r=t+i>>1;n[r]<=e?t=r:i=r}return e-n[t]<n[i]-e?t:i}var Pu=(n,e)=>n.most*10**((e/255-1)*(n.decibels/20)),gh=n=>Math.max(...n)>1e4?[.001,"kHz"]:[1,"Hz"],xh=class{constructor(e,t,i){this.element=e,this.seek=t,this.announce=i,this.drawn=[],this.time=0}destroy(){for(let{plot:e}of this.drawn)e.destroy();this.drawn=[],this.element.replaceChildren()}build(e,t,i){this.destroy(),this.shown=i;for(let o of e){let a=J("div",{className:"ppv-box"});this.element.append(a),this.drawn.push({...this.#e(o,a,t),box:a,map:o})}let[r]=e,s=[...new Set(e.map(({most:o})=>ai(o*i.scale,3)))].join(" | ");this.element.append(J("div",{className:"ppv-map-scale",title:"Amplitudes relative to the maximum of the map"},J("i",{style:`background:${Hc().replace("to right","to top")}`}),J("span",{},`0 dB = ${s} ${i.unit==="1"?"":i.unit}`),J("span",{},`\u2212${r.decibels} dB`))),this.resize()}#e(e,t,i){let r=Array.from(e.times.data),s=Array.from(e.lines.data),[o,a]=hv(r),[c,l]=hv(s),h=Bw(e.levels.data,r.length,s.length),f={stroke:i.soft,grid:{show:!1},ticks:{show:!1},font:"11px system-ui, sans-serif"},[u,p]=e.of?[1,"order"]:gh([s.at(-1)]),g=new ei({width:300,height:160,padding:[6,30,0,0],legend:{show:!1},cursor:{show:!1},series:[{},{show:!1}],scales:{x:{time:!1,range:()=>[o,a]},y:{range:()=>[Math.max(0,c),l]}},axes:[{...f,size:22,gap:3,values:(m,d)=>Rs(d,"s")},{...f,size:62,gap:4,space:28,values:(m,d)=>Rs(d.map(x=>x*u),p)}],hooks:{draw:[()=>this.cursor(this.time)],drawClear:[m=>{let{ctx:d,bbox:x}=m,w=m.valToPos(l,"y",!0),S=m.valToPos(c,"y",!0);d.save(),d.beginPath(),d.rect(x.left,x.top,x.width,x.height),d.clip(),d.imageSmoothingEnabled=!1,d.drawImage(h,x.left,w,x.width,S-w),d.restore()}]}},[r,r.map(()=>null)],t),M=J("div",{className:"ppv-cursor"});return g.over.append(M),this.#t(g,e,r,s),{plot:g,line:M}}#t(e,t,i,r){let{over:s}=e,o=(c,l)=>{let h=s.getBoundingClientRect();return e.posToVal(l==="x"?c.clientX-h.left:c.clientY-h.top,l)},a=!1;s.addEventListener("pointerdown",c=>{c.button||(a=!0,s.setPointerCapture?.(c.pointerId),this.seek(o(c,"x")))}),s.addEventListener("pointermove",c=>{a&&this.seek(o(c,"x"));let l=mh(r,o(c,"y")),h=mh(i,o(c,"x")),f=t.levels.data[h*r.length+l],[u,p]=gh([r.at(-1)]),g=(r[1]-r[0])/2,M=t.of?`order ${Io(r[l],g)}`:`${Io(r[l]*u,g*u)} ${p}`;this.announce(`${ai(i[h],4)} s, ${M}: ${f?"":"< "}${ai(Pu(t,f)*this.shown.scale,3)} ${this.shown.unit}`)}),s.addEventListener("pointerleave",()=>this.announce(""));for(let c of["pointerup","pointercancel"])s.addEventListener(c,()=>a=!1)}cursor(e){this.time=e;for(let{plot:t,line:i}of this.drawn){let r=t.valToPos(e,"x");i.hidden=!(r>=-.5&&r<=t.over.clientWidth+.5),i.style.transform=`translateX(${r}px)`}}resize(){let e=(this.element.clientWidth-Ow)/Math.max(1,this.drawn.length);for(let{plot:t}of this.drawn)t.setSize({width:Math.max(120,Math.floor(e)),height:Math.max(110,this.element.clientHeight)})}};function Bw(n,e,t){let i=J("canvas",{width:e,height:t}),r=i.getContext("2d"),s=r.createImageData(e,t),o=Array.from({length:256},(a,c)=>ol(c/255).map(l=>Math.round(255*l)));for(let a=0;a<e;a++)for(let c=0;c<t;c++)s.data.set([...o[n[a*t+c]],255],4*((t-1-c)*e+a));return r.putImageData(s,0,0),i}var _h=" and time",vh="#d2484f",kw=n=>{let e=Math.floor(Math.log10(n));return+`${Math.max(1,Math.floor(n/10**e))}e${e}`},zw=n=>n.flatMap((e,t)=>e!=null&&n[t-1]===null&&n[t+1]===null?[t]:[]),Gw=({resolution:n,lines:e})=>n??e.data.reduce((t,i,r)=>r?Math.min(t,i-e.data[r-1]):t,e.data[0]),Mh=class{constructor(e,t,i){this.spectra=e.map(s=>s.spectra),this.maps=e.map(s=>s.maps),this.names=[...new Set(this.spectra.flat().map(s=>s.channel))];let r=s=>t.flat().find(o=>o.name===s)?.label??s;this.channels=t,this.name=this.names[0],this.time=e[0]?.times.data[0]??0,this.box=J("div",{className:"ppv-box"}),this.maps_box=J("div",{className:"ppv-maps",hidden:!0}),this.read=J("output",{}),this.unit=J("small",{className:"ppv-soft"}),this.waterfall=new xh(this.maps_box,i,s=>this.read.textContent=s),this.choice=rn("spectrum of",this.names.map(s=>[s,r(s)]),s=>this.choose(s,this.over)),this.ways=rn("over",[],s=>this.choose(this.name,s)),this.near=J("span",{className:"ppv-curve",hidden:!0},J("i",{}),J("span",{},"at the cursor")),this.element=J("div",{className:"ppv-spectra"},J("div",{className:"ppv-caption"},this.choice.row,this.ways.row,this.unit,this.near,this.read),this.box,this.maps_box),this.element.hidden=!0}waysOf(e){let t=({of:r})=>r?`orders of ${r}`:"frequency",i=r=>r.flat().filter(s=>s.channel===e);return[...new Set([...i(this.spectra).map(t),...i(this.maps).map(r=>t(r)+_h)])]}choose(e,t=""){this.name=e;let i=this.waysOf(e),r=i.find(s=>s.split(" ")[0]===t.split(" ")[0]&&s.endsWith(_h)===t.endsWith(_h));this.over=i.includes(t)?t:r??i[0],this.ways.select.replaceChildren(...i.map(s=>J("option",{value:s},s))),this.ways.select.value=this.over,this.choice.select.value=e,this.build()}#e(e){let t=/^orders of (.*?)( and time)?$/.exec(this.over)?.[1]??"";return e.map(i=>i.find(r=>r.channel===this.name&&(r.of??"")===t))}#t(e){let t=e?.unit??"1",i=this.channels.flat().find(({name:r})=>r===this.name);return!i?.shown_unit||i.unit!==t?{unit:t,scale:1}:{unit:i.shown_unit,scale:i.scale??1}}build(){if(!this.over)return this.choose(this.name);this.plot?.destroy(),this.plot=null,this.waterfall.destroy(),this.read.textContent="";let e=getComputedStyle(this.element),t=(o,a)=>e.getPropertyValue(o).trim()||a,i={soft:t("--v-soft","#666"),grid:t("--v-grid","#ddd"),paper:t("--v-paper","#fff")},r=this.over.endsWith(_h);this.shown=this.#t(this.#e(this.spectra).concat(this.#e(this.maps)).find(Boolean));let{unit:s}=this.shown;this.unit.textContent=s==="1"?"peak amplitude":`peak amplitude in ${s}`,r&&(this.unit.textContent="colours: peak amplitude in dB re maximum"),this.box.hidden=r,this.maps_box.hidden=!r,this.near.hidden=!0,r?this.waterfall.build(this.#e(this.maps).filter(Boolean),i,this.shown):this.#i(i),this.resize(),this.cursor(this.time)}#i(e){let t=this.#e(this.spectra),{unit:i,scale:r}=this.shown,s=t.filter(Boolean).map(({lines:d,amplitude:x})=>[Array.from(d.data),Array.from(x.data,w=>w>0?w*r:null)]),o={stroke:e.soft,grid:{stroke:e.grid,width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},a=zc(this.element,this.name,0),{of:c=""}=t.find(Boolean)??{},l={width:1.2,points:{show:!1},spanGaps:!0},h=t.flatMap((d,x)=>d?[{...l,stroke:x?Cu(this.element,a):a,dash:x?[6,4]:void 0}]:[]),f=s.reduce((d,[,x])=>x.reduce((w,S)=>Math.max(w,S??0),d),1e-300),[u,p]=gh(s.map(([d])=>d.at(-1)));if(this.passing=this.#e(this.maps)[0],this.passing){s.push([Array.from(this.passing.lines.data),Array.from(this.passing.lines.data,()=>null)]);let d={show:!1,filter:(x,w)=>zw(x.data[w]),size:4,fill:vh,stroke:vh};h.push({...l,stroke:vh,width:1,spanGaps:!1,points:d}),this.near.hidden=!1,this.near.firstChild.style.background=vh}let g=Math.max(...t.filter(Boolean).map(Gw))/2,M=c?d=>`order ${Io(d,g)}`:d=>`${Io(d*u,g*u)} ${p}`;this.plot=new ei({width:300,height:160,padding:[6,44,0,0],legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},series:[{},...h],scales:{x:{time:!1},y:{distr:3,range:(d,x)=>[kw(Math.max(x??0,f*1e-5)),f*1.6]}},axes:[{...o,size:22,gap:3,values:(d,x)=>Rs(c?x:x.map(w=>w*u),c?"order":p)},{...o,size:62,gap:4,space:28,values:(d,x)=>x.map(w=>w===null?"":ai(w,2))}],hooks:{setCursor:[d=>{let x=d.cursor.idx,S=(x==null?[]:d.data.slice(1).map(R=>R[x])).filter(R=>R!=null).map(R=>ai(R,3));this.read.textContent=S.length?`${M(d.data[0][x])}: ${S.join(" | ")} ${i}`:""}]}},s.length>1?ei.join(s):s[0],this.box);let m=new Map(this.plot.data[0].map((d,x)=>[d,x]));this.rows=this.passing?Array.from(this.passing.lines.data,d=>m.get(d)):[],this.piece=-1}cursor(e){if(this.time=e,this.element.hidden||(this.waterfall.cursor(e),!this.plot||!this.passing))return;let{times:t,lines:i,levels:r}=this.passing,s=mh(t.data,e);if(s===this.piece)return;this.piece=s;let o=this.plot.data.slice(),a=new Array(o[0].length).fill(void 0);this.rows.forEach((l,h)=>{let f=r.data[s*i.data.length+h];a[l]=f?Pu(this.passing,f)*this.shown.scale:null}),this.rows.forEach((l,h)=>{let f=this.rows[h+1];f>l+1&&(a[l]===null||a[f]===null)&&a.fill(null,l+1,f)}),o[o.length-1]=a;let c=this.plot.scales.x.min!=null;this.plot.setData(o,!c),c&&this.plot.redraw()}state(){if(this.element.hidden)return null;let e=this.passing&&this.plot?this.rows.map(i=>this.plot.data.at(-1)[i]):[],t=this.waterfall.drawn.map(({plot:i,line:r})=>({cursor:i.posToVal(new DOMMatrix(getComputedStyle(r).transform).m41,"x")}));return{channel:this.name,over:this.over,ways:this.waysOf(this.name),near:e,maps:t}}resize(){if(this.element.hidden)return;let e=this.element.querySelector(".ppv-caption"),t=Math.max(90,this.element.parentElement.clientHeight-e.offsetHeight-8);this.maps_box.style.height=`${t}px`,this.maps_box.hidden||this.waterfall.resize(),this.plot?.setSize({width:Math.max(120,this.box.clientWidth),height:t}),this.cursor(this.time)}};var Sh=class{constructor(e,t,i,r){let s=e.map(a=>a.channels),o=e.map(a=>a.times?.data.at(-1));this.plots=new ph(s,i,t,r,o),this.spectra=new Mh(e,s,r),this.labels=new Map(s.flat().map(a=>[a.name,a.label??a.name])),this.search=J("input",{type:"search",placeholder:`add a curve (${this.labels.size})`,"aria-label":"Search channels",title:"Search channels by words of their names"}),this.list=J("div",{className:"ppv-list",role:"listbox","aria-label":"Channels",hidden:!0}),this.search.addEventListener("focus",()=>this.fill()),this.search.addEventListener("input",()=>this.fill()),this.search.addEventListener("keydown",a=>{if(a.key==="Escape"&&this.close(),a.key==="Enter"||a.key==="ArrowDown"){let c=this.list.querySelector("button");a.key==="Enter"?c?.click():c?.focus(),a.preventDefault()}a.stopPropagation()}),this.list.addEventListener("keydown",a=>{let c={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[a.key];c&&(document.activeElement?.[c]??this.search).focus(),a.key==="Escape"&&this.close(),(c||a.key==="Escape")&&a.preventDefault(),a.stopPropagation()}),this.picker=J("div",{className:"ppv-picker"},this.search,this.list),this.picker.addEventListener("focusout",a=>{this.picker.contains(a.relatedTarget)||this.close()}),this.tab=Tt("Spectrum","Switch between time curves and spectrum",()=>this.turn()),this.tab.hidden=!this.spectra.names.length,this.plots.onRemove=()=>this.list.hidden||this.fill(),this.body=J("div",{className:"ppv-curves-body"},this.plots.element,this.spectra.element),this.element=J("div",{className:"ppv-curves"},J("div",{className:"ppv-bar"},this.picker,this.tab),this.body),this.element.hidden=!this.labels.size&&!this.spectra.names.length}matches(){let e=this.search.value.toLowerCase().split(/\s+/).filter(Boolean);return[...this.labels].filter(([t,i])=>{let r=`${t} ${i}`.toLowerCase();return e.every(s=>r.includes(s))})}fill(){let e=this.matches();this.list.replaceChildren(...e.slice(0,200).map(([t,i])=>{let r=this.plots.names.has(t);return J("button",{type:"button",role:"option","aria-selected":String(r),title:t,onclick:s=>{this.plots.show(t,!this.plots.names.has(t)),s.currentTarget.setAttribute("aria-selected",String(this.plots.names.has(t)))}},i)})),e.length||this.list.append(J("p",{},"No matching channel.")),e.length>200&&this.list.append(J("p",{},`${e.length-200} more: refine the search.`)),this.list.hidden=!1}close(){this.list.hidden=!0}spectrum(e,t){this.spectra.names.includes(e)&&(this.spectra.element.hidden&&this.turn(),this.spectra.choose(e,t))}turn(){if(!this.spectra.names.length)return;let e=this.spectra.element.hidden;this.spectra.element.hidden=!e,this.plots.element.hidden=e,this.tab.textContent=e?"Curves":"Spectrum",this.picker.style.visibility=e?"hidden":"",e?this.spectra.build():this.resize()}cursor(e){this.plots.cursor(e),this.spectra.cursor(e)}build(){this.element.hidden||(this.plots.build(),this.spectra.element.hidden||this.spectra.build())}resize(){this.element.hidden||(this.plots.element.hidden||this.plots.resize(),this.spectra.resize())}};var Hw=8,yh=class{constructor(e,t,i){this.stage=e,this.label=J("div",{className:"ppv-label",hidden:!0}),this.at=null,this.waiting=!1;let{canvas:r}=e;r.addEventListener("pointermove",o=>{this.at=t.dragging||o.pointerType==="touch"?null:{x:o.clientX,y:o.clientY},this.waiting||setTimeout(()=>this.#e(),60),this.waiting=!0}),r.addEventListener("pointerleave",o=>{this.at=null,o.pointerType!=="touch"&&(this.label.hidden=!0)});let s={x:0,y:0};r.addEventListener("pointerdown",({clientX:o,clientY:a,pointerType:c})=>{s={x:o,y:a},c==="touch"&&(this.label.hidden=!0)}),r.addEventListener("pointerup",({clientX:o,clientY:a,pointerType:c})=>{c!=="touch"||Math.hypot(o-s.x,a-s.y)>Hw||(this.at={x:o,y:a},this.#e(),this.at=null)}),r.addEventListener("dblclick",o=>{let a=e.hit(o.clientX,o.clientY);a&&i(e.pictures[a.picture].data.bodies[a.part.solid.body]?.name)})}#e(){this.waiting=!1;let e=this.at&&this.stage.hit(this.at.x,this.at.y);if(this.label.hidden=!e,!e)return;let{solid:t}=e.part;this.label.textContent=Vw(t);let i=this.stage.canvas.getBoundingClientRect(),r=Math.min(this.at.x-i.left+14,i.width-this.label.offsetWidth-4);this.label.style.transform=`translate(${r}px, ${Math.max(0,this.at.y-i.top-26)}px)`}};function Vw(n){let{name:e}=n;return n.teeth?`${e}, ${n.kind}, ${n.teeth} teeth`:e===n.kind?e:`${e}, ${n.kind}`}var ml=1e-4;function gl(n){let e=10**Math.floor(Math.log10(n)),t=n/e;return e*(t<1.5?1:t<3.5?2:t<7.5?5:10)}var bh=class{constructor(e,t){this.times=e,this.poses=t,this.first=e.length?e[0]:0,this.last=e.length?e[e.length-1]:0,this.time=this.first,this.playing=!1,this.atEnd=null,this.loop="record",this.window=[this.first,this.last],this.body=-1,this.speed=this.#t()}#e(e){return Do(this.poses?.times??this.times,e)}#t(){let e=this.last-this.first,t=0,i=[this.#e(this.first),this.#e(this.last)];this.poses?.bodies.forEach((s,o)=>{t=Math.max(t,Math.abs(this.poses.angle(o,i[1])-this.poses.angle(o,i[0])))});let r=e>0?t>1?2*Math.PI*e/t/3:e/10:1;return gl(Math.max(ml,Math.min(1,r)))}seek(e){this.time=Math.max(this.first,Math.min(this.last,e))}advance(e){if(!this.playing)return;let[t,i]=this.window,r=this.time+e*this.speed;r<t&&(r=t);let s=r>i&&this.atEnd;s&&(r=i),r>i&&(r=i>t?t+(r-t)%(i-t):t),this.time=r,s&&this.atEnd()}step(e){this.playing=!1;let{low:t,share:i}=Do(this.times,this.time),r=t+i,s=e>0?Math.floor(r+1e-9)+e:Math.ceil(r-1e-9)+e;this.time=this.times[Math.max(0,Math.min(this.times.length-1,s))]??0}get frame(){let{low:e,share:t}=Do(this.times,this.time);return e+t}reference(e,t){let i=s=>this.poses&&Math.abs(this.poses.angle(s,this.#e(this.last))-this.poses.angle(s,this.#e(this.first)))>0;if(e>=0&&i(e))return e;let r=t.find(s=>s.teeth&&i(s.body));return r?r.body:this.poses?.bodies.findIndex((s,o)=>i(o))??-1}repeat(e,t,i){if(this.loop="record",this.window=[this.first,this.last],e==="record")return"";let r=this.reference(t,i);if(r<0)return"No body of this scene rotates.";let s=i.find(f=>f.body===r&&f.teeth)?.teeth;if(e==="cycle"&&!s)return"The followed body is not a gear.";let o=2*Math.PI/(e==="cycle"?s:1),a=f=>this.poses.angle(r,this.#e(f));if(Math.abs(a(this.last)-a(this.first))<o)return"The record is shorter than the repeated interval.";let l=this.time;Math.abs(a(this.last)-a(l))<o&&(l=this.#i(f=>Math.abs(a(this.last)-a(f))<=o,this.first,this.last));let h=this.#i(f=>Math.abs(a(f)-a(l))>=o,l,this.last);return this.loop=e,this.body=r,this.window=[l,h],this.seek(l),""}#i(e,t,i){for(let r=0;r<60;r++){let s=(t+i)/2;e(s)?i=s:t=s}return i}};var fv=[["space","play, pause"],["\u2190 \u2192","one frame back, forward"],["Home, End","start, end"],["+ \u2212","faster, slower"],["[ ]","previous, next mark"],["f","fit all"],["1 \u2026 9, 0","follow a body, none"],["s","section"],["m","vibrations \xD71, \xD710, \xD7100, \xD71000"],["drag","rotate; right button or Shift: pan"],["wheel","zoom at the pointer"],["double click","follow the body of a part"]];function uv(n){let e={" ":()=>n.toggle(),ArrowLeft:()=>n.step(-1),ArrowRight:()=>n.step(1),Home:()=>n.seek(n.player.window[0]),End:()=>n.seek(n.player.window[1]),"+":()=>Lu(n,2.1),"=":()=>Lu(n,2.1),"-":()=>Lu(n,.47619047619047616),"[":()=>n.transport.toMark(-1),"]":()=>n.transport.toMark(1),f:()=>n.views?.fit(),s:()=>n.section?.turn(!n.section.on),m:()=>Ww(n),Escape:()=>n.panels.close()};n.root.tabIndex=-1,document.addEventListener("keydown",t=>{if(t.ctrlKey||t.metaKey||t.altKey||t.defaultPrevented)return;let{target:i}=t,r=n.root.contains(i),s=i===document.body&&n.fills;if(!(!r&&!s||i.matches?.("select, input[type=search], input[type=text]")||i.matches?.("input[type=range]")&&i!==n.transport.range&&/^(Arrow|Home|End)/.test(t.key))&&!(t.key===" "&&i.matches?.("button, input[type=checkbox]"))){if(/^[0-9]$/.test(t.key))n.follow(Number(t.key)-1);else if(e[t.key])e[t.key]();else return;t.preventDefault()}})}function Lu(n,e){let{player:t,transport:i}=n;t.speed=Math.max(ml,Math.min(1,gl(t.speed*e))),i.speed.set(t.speed)}function Ww(n){if(!n.magnification)return;let e=n.stage.pictures[0].poses.magnification,t=e>=1e3?1:e>=100?1e3:e>=10?100:10;n.magnification.set(t),n.magnify(t)}var Du=.48,Xw=.32,wh=class{constructor(e){this.sizes=qw(e),this.columns=Cr.filter(i=>e.some(r=>(r.components??r.largest)?.[i])),this.rows=e.map(i=>{let r=i.state?J("span",{className:"ppv-state"}):null,s=this.columns.map(a=>J("td",{className:`ppv-${a}`})),{name:o}=i;return{state:r,cells:s,announced:null,row:J("tr",{},J("th",{scope:"row",title:`${i.kind} ${o}`},r,o),...s)}}),this.folder=Tt("forces","Collapse or expand the forces",()=>this.fold(!this.folded),{"aria-expanded":"true"}),this.folded=this.chosen=!1;let t=J("tr",{},J("td",{},this.folder),...this.columns.map(i=>J("th",{scope:"col",className:`ppv-${i}`},J("i"),i)));if(this.states=J("div",{className:"ppv-states"}),e.some(i=>i.state)){let i=new Set(e.flatMap(r=>[...r.state?.data??[]]).map(r=>r===255?-1:r));for(let{word:r,colour:s}of[1,-1,2,0].filter(o=>i.has(o)).map(o=>cr[o]))this.states.append(J("span",{},J("i",{style:`background:${s}`}),r))}this.element=J("div",{className:"ppv-legend",tabindex:"0",role:"region","aria-label":"Current forces"},J("table",{},J("thead",{},t),J("tbody",{},...this.rows.map(({row:i})=>i))),this.states),this.element.hidden=!e.length}fold(e,t=!0){this.chosen||=t,this.folded=e,this.element.classList.toggle("ppv-folded",e),this.folder.setAttribute("aria-expanded",String(!e))}settle(){if(this.chosen||this.element.hidden)return;this.fold(!1,!1);let{clientWidth:e,clientHeight:t}=this.element.parentElement,{offsetWidth:i,offsetHeight:r}=this.element;this.fold(i>Du*e||i>Xw*e&&r>Du*t,!1)}get share(){if(this.element.hidden||this.folded)return 0;let e=(this.element.offsetWidth+12)/Math.max(this.element.parentElement.clientWidth,1);return e>Du?0:e}get strip(){return this.element.hidden||!this.folded?0:(this.element.offsetWidth+12)/Math.max(this.element.parentElement.clientWidth,1)}get drop(){return(this.element.offsetHeight+12)/Math.max(this.element.parentElement.clientHeight,1)}update(e,t,i){this.element.hidden=i||!e.some(r=>t.has(r.kind)),!this.element.hidden&&e.forEach((r,s)=>{let{row:o,cells:a,state:c}=this.rows[s];if(o.hidden=!t.has(r.kind)||r.kind==="pair"&&!r.total,!o.hidden&&(this.columns.forEach((l,h)=>{let f=l in r.values?this.#e(r.values[l],r.unit):"";a[h].textContent!==f&&(a[h].textContent=f)}),c&&this.rows[s].announced!==r.state)){let{word:l,colour:h}=cr[r.state]??cr[0];this.rows[s].announced=r.state,c.style.background=h,c.title=l,c.setAttribute("aria-label",l)}})}#e(e,t){let{most:i,least:r}=this.sizes[t]??{};return Ax(e,t,i||e,r||e)}lines(e,t){return e.filter(i=>t.has(i.kind)&&(i.kind!=="pair"||i.total)).map(i=>({name:i.name,values:this.columns.filter(r=>r in i.values).map(r=>({part:r,text:this.#e(i.values[r],i.unit)}))}))}};function qw(n){let e={};for(let{unit:t="N",size:i}of n){if(!i)continue;let r=e[t]??={most:i,least:i};r.most=Math.max(r.most,i),r.least=Math.min(r.least,i)}return e}var Yw={contact_loss:"contact loss",impact:"impact",back_flank:"contact on back flank",front_flank:"contact on front flank",faulty_tooth:"faulty tooth in mesh"},Nu=400,xl=n=>Yw[n]??n.replaceAll("_"," ");function dv(n){let{marks:e,kinds:t,stepLength:i}=n.transport,r=new Set,s=J("div",{className:"ppv-marklist"}),o=()=>{let c=e.filter(l=>!r.has(l.kind));s.replaceChildren(...c.slice(0,Nu).map(l=>{let h=Ms(l.time,i/10),f=l.until>l.time?`, ${hr(l.until-l.time)}`:"",u=Tt("",`Go to ${xl(l.kind)} at ${h}`,()=>n.seek(l.time));return u.append(J("i",{style:`background:${vs(t,l.kind)}`}),J("b",{},h),J("span",{},`${xl(l.kind)}${l.what?`, ${l.what}`:""}${f}`)),u}),c.length>Nu?J("p",{className:"ppv-soft"},`${c.length-Nu} more`):"")},a=t.map(c=>{let l=e.filter(f=>f.kind===c).length,h=J("input",{type:"checkbox",checked:!0,onchange:()=>{h.checked?r.delete(c):r.add(c),o()}});return J("label",{className:"ppv-tick"},h,J("i",{className:"ppv-dot",style:`background:${vs(t,c)}`}),J("span",{},`${xl(c)} (${l})`))});return o(),[...a,s]}function _l(n){if(n.length<2)return[""];for(let e of["title","label","subtitle"]){let[t,i]=n.map(r=>r[e]??"");if(t&&i&&t!==i)return $w(t,i)}return["first","second"]}function $w(n,e){if(Math.max(n.length,e.length)<=36)return[n,e];let t=[n,e].map(r=>r.split(/(?<=[\s,_/-])/)),i=0;for(;i<Math.min(t[0].length,t[1].length)-1&&t[0][i]===t[1][i];)i++;return t.map(r=>{let s=(i?"\u2026 ":"")+r.slice(i).join("");return s.length>36?`${s.slice(0,35).trimEnd()}\u2026`:s})}var Kw=1.6,Zw=.06,Eh=class{constructor(e,t,i){this.modes=e,this.changed=i,this.stage=t,this.number=-1,this.phase=0,this.amplitude=1,this.unit=e.map(s=>this.#i(s)),this.buttons=e.map((s,o)=>Tt("",`Animate ${s.name}`,()=>this.choose(this.number===o?-1:o),{"aria-pressed":"false"})),this.buttons.forEach((s,o)=>s.append(...this.#t(e[o]).map(a=>J("span",{},a)))),this.stop=Tt("stop animation","Stop the animation of the mode",()=>this.choose(-1)),this.stop.hidden=!0;let r=_r({label:"amplitude",title:"Amplitude of the mode shape",least:.05,most:20,value:1,show:s=>`\xD7 ${ai(s,2)}`,changed:s=>{this.amplitude=s,this.changed()}});this.rows=[J("div",{className:"ppv-modes"},...this.buttons),r.row,this.stop]}#e({frequency:e,damping:t}){let i=t==null?"":`, damping ${ai(100*t,2)} %${t<0?", unstable":""}`;return`${ai(e,4)} Hz${i}`}#t(e){let[,t,i]=/^(\d+: )?(.*)$/s.exec(e.name);return[(t??"")+this.#e(e),i]}#i(e){let{solids:t,bounds:i}=this.stage.pictures[0],r=0,s=(o,a)=>{let c=0;for(let l=0;l<6;l++)c+=o?o.data[6*a+l]**2:0;return Math.sqrt(c)};this.stage.pictures[0].data.bodies.forEach((o,a)=>{let c=t.reachOf(a);r=Math.max(r,s(e.position,a)+s(e.turn,a)*(c||.1*i.radius))});for(let{modal:o}of t.parts)r=Math.max(r,o?.largest(e)??0);return r>0?Zw*i.radius/r:0}get active(){return this.number>=0}get words(){return this.active?`${this.modes[this.number].name}, ${this.#e(this.modes[this.number])}`:""}choose(e){this.number=e,this.phase=0,this.buttons.forEach((t,i)=>t.setAttribute("aria-pressed",String(i===e))),this.stop.hidden=e<0,this.changed()}advance(e){this.active&&(this.phase=(this.phase+2*Math.PI*e/Kw)%(2*Math.PI))}pose({poses:e}){e.ofMode(this.modes[this.number],this.phase,this.amplitude*this.unit[this.number])}};var Jw=.07,Th=Math.PI/2-.001,Rh=class{constructor(e,t,i,r){this.camera=e,this.element=t,this.changed=i,this.up=new N(...r).normalize(),this.basis=new Ft().setFromUnitVectors(new N(0,1,0),this.up),this.now={target:new N,azimuth:.6,elevation:.4,distance:1},this.goal={target:new N,azimuth:.6,elevation:.4,distance:1},this.nearest=1e-6,this.farthest=1e6,this.chosen=!1,this.takesWheel=()=>!0,this.shift=0,this.drop=0,this.pointers=new Map,t.addEventListener("pointerdown",s=>this.#i(s)),t.addEventListener("pointermove",s=>this.#r(s));for(let s of["pointerup","pointercancel"])t.addEventListener(s,o=>this.#n(o));t.addEventListener("wheel",s=>this.#s(s),{passive:!1}),t.addEventListener("contextmenu",s=>s.preventDefault())}get pixel(){return 2*this.now.distance*Math.tan(this.camera.fov*Math.PI/360)/Math.max(this.element.clientHeight,1)}direction(e=this.now){let t=Math.cos(e.elevation);return new N(t*Math.sin(e.azimuth),Math.sin(e.elevation),t*Math.cos(e.azimuth)).applyQuaternion(this.basis)}look({target:e,direction:t,distance:i},r=!1){if(this.chosen=!0,e&&this.goal.target.copy(e),i&&(this.goal.distance=this.#t(i)),t){let s=t.clone().normalize().applyQuaternion(this.basis.clone().invert());if(this.goal.elevation=Math.max(-Th,Math.min(Th,Math.asin(Math.max(-1,Math.min(1,s.y))))),Math.hypot(s.x,s.z)>1e-6){let o=Math.atan2(s.x,s.z);this.goal.azimuth=o+2*Math.PI*Math.round((this.now.azimuth-o)/(2*Math.PI))}}r&&this.settle(),this.changed()}settle(){this.now.target.copy(this.goal.target);for(let e of["azimuth","elevation","distance"])this.now[e]=this.goal[e];this.#e()}step(e){let t=1-Math.exp(-e/Jw),{now:i,goal:r}=this,s=i.target.distanceTo(r.target)/i.distance+Math.abs(i.azimuth-r.azimuth)+Math.abs(i.elevation-r.elevation)+Math.abs(Math.log(i.distance/r.distance));return s<1e-4?(s&&this.settle(),!1):(i.target.lerp(r.target,t),i.azimuth+=t*(r.azimuth-i.azimuth),i.elevation+=t*(r.elevation-i.elevation),i.distance*=(r.distance/i.distance)**t,this.#e(),!0)}#e(){let{camera:e,now:t}=this;e.position.copy(t.target).addScaledVector(this.direction(),t.distance),pv.lookAt(this.direction(),Qw,this.up),e.quaternion.setFromRotationMatrix(pv),e.updateMatrixWorld(!0)}#t(e){return Math.max(this.nearest,Math.min(this.farthest,e))}#i(e){e.button>2||(this.element.setPointerCapture?.(e.pointerId),this.pointers.set(e.pointerId,{x:e.clientX,y:e.clientY,pan:e.button!==0||e.shiftKey||e.ctrlKey}))}#n(e){this.pointers.delete(e.pointerId)}get dragging(){return this.pointers.size>0}#r(e){let t=this.pointers.get(e.pointerId);if(!t)return;let i=[...this.pointers.entries()].filter(([o])=>o!==e.pointerId).map(([,o])=>o),r=e.clientX-t.x,s=e.clientY-t.y;if(i.length){let[o]=i,a=Math.hypot(t.x-o.x,t.y-o.y),c=Math.hypot(e.clientX-o.x,e.clientY-o.y);a>0&&c>0&&this.zoom(a/c,(e.clientX+o.x)/2,(e.clientY+o.y)/2),this.pan(r/2,s/2)}else t.pan?this.pan(r,s):this.turn(r,s);t.x=e.clientX,t.y=e.clientY}turn(e,t){this.chosen=!0;let i=1.1*Math.PI/Math.max(this.element.clientHeight,1);this.goal.azimuth-=i*e,this.goal.elevation=Math.max(-Th,Math.min(Th,this.goal.elevation+i*t)),this.changed()}pan(e,t){this.chosen=!0;let i=this.pixel;this.goal.target.addScaledVector(Ah.set(1,0,0).applyQuaternion(this.camera.quaternion),-e*i),this.goal.target.addScaledVector(Ah.set(0,1,0).applyQuaternion(this.camera.quaternion),t*i),this.changed()}zoom(e,t,i){this.chosen=!0;let r=this.goal.distance;if(this.goal.distance=this.#t(r*e),t!==void 0){let s=this.element.getBoundingClientRect(),o=this.pixel*r/this.now.distance*(1-this.goal.distance/r);this.goal.target.addScaledVector(Ah.set(1,0,0).applyQuaternion(this.camera.quaternion),(t-s.left-this.middle(t-s.left))*o),this.goal.target.addScaledVector(Ah.set(0,1,0).applyQuaternion(this.camera.quaternion),((.5+this.drop)*s.height-(i-s.top))*o)}this.changed()}middle(e){let t=this.element.clientWidth/(this.pictures??1);return(Math.floor(e/t)+.5-this.shift)*t}#s(e){if(!this.takesWheel(e))return;e.preventDefault();let t=e.deltaMode===1?33:1;this.zoom(Math.exp(Math.max(-1,Math.min(1,e.deltaY*t*.0015))),e.clientX,e.clientY)}},pv=new Le,Qw=new N,Ah=new N;var[jw,eE]=[5126,5125],[mv,tE]=[34962,34963],Iu=class{constructor(){this.pieces=[],this.length=0,this.json={asset:{version:"2.0",generator:"pitchpoint"},scene:0,scenes:[{nodes:[]}],nodes:[],meshes:[],materials:[],accessors:[],bufferViews:[],buffers:[{byteLength:0}]}}put(e,t,i,r=!1){let s={SCALAR:1,VEC3:3,VEC4:4}[t];this.json.bufferViews.push({buffer:0,byteOffset:this.length,byteLength:e.byteLength,...i&&{target:i}});let o={bufferView:this.json.bufferViews.length-1,componentType:e instanceof Float32Array?jw:eE,count:e.length/s,type:t};return r&&(o.min=Array(s).fill(1/0),o.max=Array(s).fill(-1/0),e.forEach((a,c)=>{o.min[c%s]=Math.min(o.min[c%s],a),o.max[c%s]=Math.max(o.max[c%s],a)})),this.pieces.push(new Uint8Array(e.buffer,e.byteOffset,e.byteLength)),this.length+=e.byteLength,this.json.accessors.push(o)-1}bytes(){this.json.buffers[0].byteLength=this.length;let e=new TextEncoder().encode(JSON.stringify(this.json)),t=Math.ceil(e.length/4)*4,i=new Uint8Array(20+t+8+this.length),r=new DataView(i.buffer);[1179937895,2,i.length,t,1313821514].forEach((o,a)=>r.setUint32(4*a,o,!0)),i.fill(32,20,20+t),i.set(e,20),r.setUint32(20+t,this.length,!0),r.setUint32(24+t,5130562,!0);let s=28+t;for(let o of this.pieces)i.set(o,s),s+=o.length;return i}};function gv(n,e,t,i){let r=new Iu,{json:s}=r,o=new N,a=new Ft,c=new N,l=new Ft,h=i.length>1,f=h?r.put(Float32Array.from(i,m=>m-i[0]),"SCALAR",void 0,!0):0,u={name:"record",samplers:[],channels:[]},p=new Set(n.map(({solid:m})=>m.blend?m.blend.bodies[0]:m.body)),g=new Map;for(let m of p){let d={name:m<0?"ground":e[m].name,children:[]};if(g.set(m,d),s.scenes[0].nodes.push(s.nodes.push(d)-1),m<0)continue;let x=new Float32Array(3*i.length),w=new Float32Array(4*i.length);if(t[m].forEach((S,R)=>{S.decompose(o,a,c),R&&a.dot(l)<0&&a.set(-a.x,-a.y,-a.z,-a.w),l.copy(a),o.toArray(x,3*R),a.toArray(w,4*R)}),d.translation=[...x.slice(0,3)],d.rotation=[...w.slice(0,4)],!!h)for(let[S,R,A,_]of[["translation",x,"VEC3",3],["rotation",w,"VEC4",4]]){if(R.every((F,L)=>F===R[L%_]))continue;let b=u.samplers.push({input:f,output:r.put(R,A),interpolation:"LINEAR"})-1;u.channels.push({sampler:b,target:{node:s.nodes.indexOf(d),path:S}})}}let M=new Map;for(let{solid:m,geometry:d,colour:x}of n){let w=x+!!m.see_through;if(!M.has(w)){let{r:L,g:D,b:k}=new Xe(x),G={baseColorFactor:[L,D,k,m.see_through?.22:1],metallicFactor:.1,roughnessFactor:.7};M.set(w,s.materials.push({pbrMetallicRoughness:G,...m.see_through&&{alphaMode:"BLEND"}})-1)}let{position:S,normal:R}=d.attributes,A={POSITION:r.put(S.array,"VEC3",mv,!0),NORMAL:r.put(R.array,"VEC3",mv)},_=r.put(Uint32Array.from(d.index.array),"SCALAR",tE),b=s.meshes.push({name:m.name,primitives:[{attributes:A,indices:_,material:M.get(w)}]})-1,F=s.nodes.push({name:m.name,mesh:b})-1;g.get(m.blend?m.blend.bodies[0]:m.body).children.push(F)}for(let m of g.values())m.children.length||delete m.children;return u.channels.length&&(s.animations=[u]),r.bytes()}var iE=[.5377,.7071,.4591],nE=1e-6;function xv(n,e){let t=n.length/3,i=new Float64Array(t),r=0;for(let c=0;c<t;c++)for(let l=0;l<3;l++)i[c]+=iE[l]*n[3*c+l],r=Math.max(r,nE*Math.abs(n[3*c+l]));let s=Uint32Array.from(i.keys()).sort((c,l)=>i[c]-i[l]),o=new Uint32Array(t);s.forEach((c,l)=>{o[c]=c;for(let h=l-1;h>=0&&i[c]-i[s[h]]<=r;h--){let f=o[s[h]];if(!(Math.hypot(...[0,1,2].map(p=>n[3*c+p]-n[3*f+p]))>r)){o[c]=f;break}}});let a=[];for(let c=0;c<e.length;c+=3){let l=[o[e[c]],o[e[c+1]],o[e[c+2]]];new Set(l).size===3&&a.push(...l)}return a}function vl(n,e){let t=URL.createObjectURL(n),i=J("a",{href:t,download:e});document.body.append(i),i.click(),i.remove(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}function Ml(n,e){return`${n.scenes[0].title.toLowerCase().replace(/[^a-z0-9]+/g,"-").replace(/^-|-$/g,"")||"scene"}.${e}`}function Ch(n,e=1){let{stage:t}=n,{renderer:i,canvas:r}=t;i.setPixelRatio(t.ratio*e),i.setSize(t.size.width,t.size.height),n.draw();let s=J("canvas",{width:r.width,height:r.height}),o=s.getContext("2d");o.drawImage(r,0,0),t.resize(),n.draw();let a=t.ratio*e;o.scale(a,a);let c=getComputedStyle(n.root),l=c.getPropertyValue("--v-ink").trim()||"#222",h=c.getPropertyValue("--v-soft").trim()||"#666",{width:f,height:u}=t.size;o.textBaseline="top",o.font=`600 14px ${c.fontFamily}`,o.fillStyle=l;let p=f/n.scenes.length,g=n.scenes.map((d,x)=>{let w=Uu(o,[d.title,d.label].filter(Boolean).join(", "),p-24);return o.fillText(w,12+x*p,10),o.measureText(w).width+24});o.font=`12px ${c.fontFamily}`,o.fillStyle=h;let M=n.modes?.active?n.modes.words:`t = ${Ms(n.player.time,n.transport.stepLength/10)}`;n.scenes.forEach((d,x)=>o.fillText(Uu(o,[d.subtitle,M].filter(Boolean).join(", "),p-24),12+x*p,28)),n.legends.forEach((d,x)=>{d.element.hidden||aE(o,n,x,{right:(x+1)*p,room:p-g[x]},l,c)}),n.boxes.forEach((d,x)=>{d.element.hidden||sE(o,d,{x:12+x*p,y:u-62,room:p-24},h)}),o.fillStyle=o.strokeStyle=h,n.scales.forEach((d,x)=>{d.hidden||rE(o,d,12+x*p,u)});let m=atob(s.toDataURL("image/png").split(",")[1]);return new Blob([Uint8Array.from(m,d=>d.charCodeAt(0))],{type:"image/png"})}function rE(n,e,t,i){let[r,s]=e.children,o=parseFloat(s.style.width);n.fillText(r.textContent,t,i-30),n.beginPath(),n.moveTo(t,i-15),n.lineTo(t,i-10),n.lineTo(t+o,i-10),n.lineTo(t+o,i-15),n.stroke()}function sE(n,e,{x:t,y:i,room:r},s){if(n.fillStyle=s,n.font=n.font.replace(/^\d+px/,"11px"),!e.bar.hidden){for(let c=0;c<210;c++)n.fillStyle=`rgb(${ol(c/209).map(l=>Math.round(255*l)).join(" ")})`,n.fillRect(t+c,i,1.5,8);n.fillStyle=s;let a=`${e.what.textContent}: 0 \u2026 ${e.end.textContent}, ${e.now.textContent}`;n.fillText(Uu(n,a,r),t,i+11)}if(e.gap.hidden)return;let o=oE(n,e.gap.textContent,r);o.forEach((a,c)=>n.fillText(a,t,i-16-14*(o.length-1-c)))}function oE(n,e,t){let i=[""];for(let r of e.split(" ")){let s=i.at(-1)?`${i.at(-1)} ${r}`:r;i.at(-1)&&n.measureText(s).width>t?i.push(r):i[i.length-1]=s}return i}function Uu(n,e,t){if(n.measureText(e).width<=t)return e;let i=e.length;for(;i>1&&n.measureText(`${e.slice(0,i)}\u2026`).width>t;)i--;return`${e.slice(0,i).trimEnd()}\u2026`}function aE(n,e,t,{right:i,room:r},s,o){let{arrows:a}=e.stage.pictures[t],c=e.legends[t],{columns:l}=c,h=c.folded?[]:c.lines(a.now,a.shown).slice(0,20),f=92*l.length+24+Math.max(0,...h.map(({name:p})=>n.measureText(p).width)),u=f>r?44:0;n.globalAlpha=.85,n.fillStyle=o.getPropertyValue("--v-paper").trim()||"#fff",n.fillRect(i-f,u,f,34+16*h.length),n.globalAlpha=1,n.textAlign="right",l.forEach((p,g)=>{n.fillStyle=rl(e.root,p),n.fillText(p,i-12-92*(l.length-1-g),u+10)}),h.forEach(({name:p,values:g},M)=>{let m=u+27+16*M;n.fillStyle=s,n.font=`12px ${o.fontFamily}`,n.fillText(p,i-12-92*l.length,m);for(let{part:d,text:x}of g)n.fillText(x,i-12-92*(l.length-1-l.indexOf(d)),m)}),n.textAlign="left"}function Ph(n){let e=n.stage.pictures[0].solids.exported(!1).map(({solid:h,geometry:f})=>{let u=f.attributes.position.array;return{solid:h,points:u,index:xv(u,f.index.array)}}),t=e.reduce((h,{index:f})=>h+f.length/3,0),i=new ArrayBuffer(84+50*t),r=new DataView(i);r.setUint32(80,t,!0);let s=84,o=[new N,new N,new N],a=new N,c=new N,l=h=>{for(let f of[h.x,h.y,h.z])r.setFloat32(s,f,!0),s+=4};for(let{solid:h,points:f,index:u}of e){let p=n.stage.pictures[0].poses.ofSolid(h);for(let g=0;g<u.length;g+=3)o.forEach((M,m)=>M.fromArray(f,3*u[g+m]).applyMatrix4(p)),a.subVectors(o[1],o[0]).cross(c.subVectors(o[2],o[0])).normalize(),l(a),o.forEach(l),s+=2}return new Blob([i],{type:"model/stl"})}var _v=1e3;function Lh(n){let{solids:e,poses:t,data:i}=n.stage.pictures[0],r=t.times.length,s=Math.max(1,Math.ceil((r-1)/(_v-1))),o=[];for(let h=0;h<r;h+=s)o.push(h);let a=lE(o.map(h=>t.times[h]),t),c=e.exported(!0),l=t.world.map(()=>[]);for(let h of a)t.at(h),t.world.forEach((f,u)=>l[u].push(new Le().copy(f)));return t.at(n.player.time),n.changed(),new Blob([gv(c,i.bodies,l,a)],{type:"model/gltf-binary"})}function lE(n,e){let t=s=>(e.at(s),e.bodies.map((o,a)=>e.angle(a))),i=[n[0]],r=t(n[0]);for(let s=1;s<n.length&&i.length<8*_v;s++){let o=t(n[s]),a=Math.max(0,...o.map((l,h)=>Math.abs(l-r[h]))),c=Math.min(64,Math.max(1,Math.ceil(a/(Math.PI/2))));for(let l=1;l<=c;l++)i.push(n[s-1]+(n[s]-n[s-1])*l/c);r=o}return i}function vv(n){if(typeof MediaRecorder>"u"||!n.captureStream)return null;let t=["video/mp4;codecs=avc1.42E01E","video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm"].find(i=>MediaRecorder.isTypeSupported(i));return t?{ending:t.slice(6,t.includes(";")?t.indexOf(";"):void 0),start(){let i=new MediaRecorder(n.captureStream(30),{mimeType:t,videoBitsPerSecond:6e6}),r=[];return i.ondataavailable=({data:s})=>s.size&&r.push(s),i.start(500),()=>new Promise(s=>{i.onstop=()=>s(new Blob(r,{type:t.split(";")[0]})),i.stop()})}}:null}var cE=.4,Dh=class{constructor(){this.bar=J("div",{className:"ppv-tools",role:"toolbar","aria-label":"Scene"}),this.panel=J("div",{className:"ppv-panel",hidden:!0}),this.open=null,this.panel.addEventListener("keydown",e=>{e.key==="Escape"&&this.close()})}action(e,t,i){let r=Tt(e,t,i);return this.bar.append(r),r}add(e,t,i){let r=Tt(e,t,()=>this.open===e?this.close():this.show(e,i,r),{"aria-expanded":"false"});return this.bar.append(r),r}show(e,t,i){this.close(),this.open=e,this.opener=i,i.setAttribute("aria-expanded","true"),this.panel.replaceChildren(J("div",{className:"ppv-panel-head"},J("b",{},e),Tt("\xD7","Close",()=>this.close())),...t),this.panel.hidden=!1}get share(){let e=this.open?(this.panel.offsetWidth+12)/Math.max(this.panel.parentElement.clientWidth,1):0;return e>cE?0:e}close(){if(!this.open)return;let e=this.panel.contains(document.activeElement);this.open=null,this.panel.hidden=!0,this.opener.setAttribute("aria-expanded","false"),e&&this.opener.focus()}};function Mv(n){let{stage:e}=n,t=[["axis","Along the axis"],["front","From the side"],["top","From above"],["iso","Oblique"]];n.followed=rn("follow",[["-1","none"],...n.views.names.map((l,h)=>[String(h),l])],l=>n.follow(Number(l)),"Body that the camera follows (1 to 9, 0)");let i=tr("rotate with body",!1,l=>{n.views.turning=l,n.views.follow(n.views.body,l)}),r=n.scenes.flatMap(l=>l.solids),s=r.some(l=>l.see_through)?rn("housing",[["see-through","see-through"],["solid","solid"],["hidden","hidden"]],l=>{for(let h of e.pictures)h.solids.cover(l);n.changed()}).row:null,o=r.some(l=>l.schematic)?tr("schematic parts",!0,l=>{for(let h of e.pictures)h.solids.schematics(l);n.changed()}).row:null,c=n.scenes.flatMap(l=>l.arrows.filter(h=>h.kind==="mesh")).filter((l,h,f)=>f.findIndex(({name:u})=>u===l.name)===h).map(l=>Tt(l.name,`View the mesh ${l.name} along its axis`,()=>n.intoMesh(l)));return[J("div",{className:"ppv-buttons"},...t.map(([l,h])=>Tt(l,h,()=>n.views.named(l)))),n.followed.row,i.row,s,o,c.length?J("div",{},J("span",{className:"ppv-soft"},"view a mesh"),J("div",{className:"ppv-buttons"},...c)):null].filter(Boolean)}var hE={mesh:"mesh forces",pair:"forces of tooth pairs",bearing:"bearing forces",load:"loads"};function Sv(n){let e=n.stage.pictures.map(r=>r.arrows),t=[...new Set(e.flatMap(r=>[...r.kinds]))],i=_r({label:"length",title:"Length of the arrows",least:.05,most:20,value:1,show:r=>`\xD7 ${ai(r,2)}`,changed:r=>{for(let s of e)s.scale=r;n.changed()}});return n.kinds=Object.fromEntries(t.map(r=>[r,tr(hE[r]??r,e.some(s=>s.shown.has(r)),s=>n.arrows(r,s))])),[...Object.values(n.kinds).map(({row:r})=>r),i.row]}function yv(n){let{stage:e}=n,t=c=>vl(Ch(n,c),Ml(n,"png")),i=vv(e.canvas),r=null,s=(c,l)=>{a.textContent=c,a.title=a.ariaLabel=l,a.setAttribute("aria-pressed",String(!!r))},o=i&&`Record a video of the playback up to the end of the record, ${i.ending}`,a=i?Tt("video",o,async()=>{if(!r){n.filming=!0,e.coarsen(!1),r=i.start(),s("stop and save","Stop and save the video; it stops automatically at the end of the playback"),n.player.atEnd=()=>a.click(),n.toggle(!0);return}let c=r;r=null,n.player.atEnd=null,n.filming=!1,n.toggle(!1),s("video",o),vl(await c(),Ml(n,i.ending))}):null;return[J("div",{className:"ppv-buttons"},Tt("picture","PNG of the scene with title, time and forces",()=>t(1)),Tt("picture \xD7 2","PNG with twice the resolution",()=>t(2)),a),J("div",{className:"ppv-buttons"},Tt("GLB (animated)","Solids and their motion, binary glTF",()=>vl(Lh(n),Ml(n,"glb"))),Tt("STL","Solids at the current time, in metres",()=>vl(Ph(n),Ml(n,"stl"))))]}function bv(n){return n.magnification=_r({label:"magnification \xD7",title:"Magnification of vibrations; rotation is not magnified (m)",least:1,most:1e4,value:1,show:e=>String(e<10?Number(e.toPrecision(2)):Math.round(e)),changed:e=>n.magnify(e)}),[n.magnification.row,J("p",{className:"ppv-soft"},"Displacements, tilts and torsion about their means; mean rotation is not magnified.")]}var uB=new N(1,0,0),Uh=new N(0,0,1);function wv(n,e,t,i){let r=Math.hypot(e,t,i);if(r<1e-300)return n.identity();let s=Math.sin(r/2)/r;return n.set(s*e,s*t,s*i,Math.cos(r/2))}var qo=class{constructor(e){this.bodies=e.bodies,this.times=e.times?.data??new Float64Array([0]),this.where={low:0,share:0},this.magnification=1,this.world=this.bodies.map(()=>new Le),this.still=this.bodies.map(()=>new Le),this.rest=this.bodies.map(()=>new Le),this.means=this.bodies.map(t=>({position:t.position&&No(t.position),turn:t.turn&&No(t.turn),spin:t.spin&&No(t.spin)})),this.bodies.forEach((t,i)=>{let[r,s,o]=t.place??[0,0,0],a=new Ft(...t.axes??[0,0,0,1]).normalize();t.frame=new Le().compose(new N(r,s,o),a,new N(1,1,1)),this.rest[i].multiplyMatrices(this.#e(this.rest,i),t.frame)}),this.at(this.times[0])}#e(e,t){let i=this.bodies[t].parent??-1;return i<0?Nh:e[i]}ofSolid(e){if(e.between)return this.#t(e);let t=e.blend?e.blend.bodies[0]:e.body,i=t<0?Nh:this.world[t];return!e.place&&!e.axes?i:(e.seat??=new Le().compose(new N(...e.place??[0,0,0]),new Ft(...e.axes??[0,0,0,1]).normalize(),Ev),e.placed??=new Le,e.placed.multiplyMatrices(i,e.seat))}#t(e){let{bodies:t,ends:i}=e.between,[r,s]=t.map((p,g)=>new N(...i[g]).applyMatrix4(p<0?Nh:this.world[p])),o=s.clone().sub(r),a=o.length()||1e-12,c=o.clone().divideScalar(a),l=t[0]<0?Nh:this.world[t[0]],h=[0,1,2].map(p=>new N().setFromMatrixColumn(l,p)).reduce((p,g)=>Math.abs(g.dot(c))<Math.abs(p.dot(c))-.2?g:p),f=h.addScaledVector(c,-h.dot(c)).normalize(),u=new N().crossVectors(c,f);return e.placed??=new Le,e.placed.makeBasis(f,u,o.lengthSq()?o:c.multiplyScalar(a)).setPosition(r)}#i({gross:e,ratio:t=1},i){return e?t*Jt(e,i):0}angle(e,t=this.where){let{spin:i}=this.bodies[e];return this.#i(this.bodies[e],t)+(i?Jt(i,t):0)}at(e){this.mode=null,this.where=Do(this.times,e);let{where:t,magnification:i}=this,r=(s,o,a)=>{let c=Jt(s,t,a);return i===1?c:o[a]+i*(c-o[a])};return this.bodies.forEach((s,o)=>{this.still[o].multiplyMatrices(this.#e(this.world,o),s.frame),Cs.set(0,0,0);let a=this.means[o];s.position&&Cs.set(r(s.position,a.position,0),r(s.position,a.position,1),r(s.position,a.position,2)),s.travel&&Cs.set(Cs.x+Jt(s.travel,t,0),Cs.y+Jt(s.travel,t,1),Cs.z+Jt(s.travel,t,2)),s.quaternion?(Dr.set(...[0,1,2,3].map(l=>s.quaternion.data[l+(s.quaternion.count>1?4*t.low:0)])),s.quaternion.count>1&&t.share&&(Fu.set(...[4,5,6,7].map(l=>s.quaternion.data[l+4*t.low])),Dr.slerp(Fu,t.share)),Dr.normalize()):(Dr.identity(),s.turn&&wv(Dr,r(s.turn,a.turn,0),r(s.turn,a.turn,1),r(s.turn,a.turn,2)));let c=this.#i(s,t)+(s.spin?r(s.spin,a.spin,0):0);c&&Dr.multiply(Fu.setFromAxisAngle(Uh,c)),Ih.compose(Cs,Dr,Ev),this.world[o].multiplyMatrices(this.still[o],Ih)}),this}ofMode(e,t,i){let r=i*Math.cos(t),s=-i*Math.sin(t);this.mode={shape:e,cosine:r,sine:s};let o=(a,c,l)=>a?r*a.data[6*c+l]+s*a.data[6*c+3+l]:0;return this.bodies.forEach((a,c)=>{wv(Dr,o(e.turn,c,0),o(e.turn,c,1),o(e.turn,c,2));let l=this.rest[c];Ih.makeRotationFromQuaternion(Dr),this.world[c].multiplyMatrices(Ih,l);let h=this.world[c].elements;for(let f=0;f<3;f++)h[12+f]=l.elements[12+f]+o(e.position,c,f);this.still[c].copy(this.world[c])}),this}axis(){let e=new N,t=this.bodies.some(i=>i.gross);return this.bodies.forEach((i,r)=>{if(!i.gross&&(t||!i.spin))return;let s=new N().setFromMatrixColumn(this.rest[r],2);e.addScaledVector(s,e.dot(s)<0?-1:1)}),e.length()>1e-9?e.normalize():Uh.clone()}},Nh=new Le,Ih=new Le,Cs=new N,Ev=new N(1,1,1),Dr=new Ft,Fu=new Ft;var fE=n=>n.length>1?(n[n.length-1]-n[0])/(n.length-1):1/0;function Tv(n){let e=n.map(g=>g.times?.data??[]);if(e.length===1)return{times:e[0],whose:"",note:""};let t=e.map(fE),i=t[1]<t[0]?1:0,[r,s]=[e[i],e[1-i]],o=.5*Math.min(...t),a=[...s].filter(g=>!r.length||g<r[0]-o||g>r[r.length-1]+o),c=Float64Array.from([...r,...a]).sort();if(r.length===s.length&&r.every((g,M)=>Math.abs(g-s[M])<1e-6*o)||!Number.isFinite(t[1-i]))return{times:c,whose:"",note:""};let h=_l(n),[f,u]=[h[i],h[1-i]],p=`Time steps follow the frames of ${f}, every ${hr(t[i])}; the frames of ${u}, every ${hr(t[1-i])}, are interpolated linearly.`;return{times:c,whose:f,note:p}}var Sl={x:new N(1,0,0),y:new N(0,1,0),z:new N(0,0,1)},Fh=class{constructor(e,t){this.stage=e,this.changed=t,this.on=!1,this.normal=new N(0,0,1),this.flipped=!1,this.places=e.pictures.map(()=>0),this.planes=e.pictures.map(()=>new Yi);let[i]=Object.entries(Sl).reduce((r,s)=>Math.abs(s[1].dot(e.pictures[0].poses.axis()))>Math.abs(r[1].dot(e.pictures[0].poses.axis()))?s:r);this.enable=tr("section (s)",!1,r=>this.turn(r)),this.axis=rn("normal to",[...Object.keys(Sl).map(r=>[r,r]),["mesh","axis of the mesh"]],r=>this.along(r)),this.axis.select.lastChild.hidden=!0,this.place=J("input",{type:"range",min:"0",max:"1000",title:"Position of the section plane","aria-label":"Position of the section plane"}),this.place.addEventListener("input",()=>this.#t()),this.output=J("output",{}),this.flip=tr("flip side",!1,r=>{this.flipped=r,this.update(),t()}),this.rows=[this.enable.row,this.axis.row,J("label",{className:"ppv-slider"},J("span",{},"position"),this.place,this.output),this.flip.row],this.along(i)}along(e){e in Sl&&this.normal.copy(Sl[e]),this.axis.select.value=e,this.#i(.5),this.#r()}get at(){return this.places[0]}through(e,t){let i=Object.entries(Sl).find(([,a])=>Math.abs(a.dot(t))>.999999999);this.normal.copy(t).normalize(),i&&this.normal.copy(i[1]),this.axis.select.lastChild.hidden=!!i,this.axis.select.value=i?i[0]:"mesh",this.flipped=this.normal.dot(t)<0,this.flip.input.checked=this.flipped;let r=e.findIndex(Boolean),[s,o]=this.#e(r);this.#i((this.normal.dot(e[r])-s)/(o-s||1)),e.forEach((a,c)=>a&&(this.places[c]=this.normal.dot(a))),this.#n(),this.#s(!0)}#e(e=0){let{alike:t,pictures:i}=this.stage,{low:r,high:s}=t?this.stage.bounds():i[e].bounds,o=1/0,a=-1/0;for(let c=0;c<8;c++){let l=new N(c&1?s.x:r.x,c&2?s.y:r.y,c&4?s.z:r.z).dot(this.normal);o=Math.min(o,l),a=Math.max(a,l)}return[o,a]}#t(){this.#i(Number(this.place.value)/1e3)}#i(e){this.places=this.places.map((t,i)=>{let[r,s]=this.#e(i);return r+e*(s-r)}),this.place.value=String(1e3*e),this.#n(),this.update(),this.changed()}#n(){let e=$c(1e3*Math.max(...this.#e().map(Math.abs)))(this.at*1e3);this.output.textContent=`${Number(e)===0?"0":e} mm`}#r(){let e=this.stage.camera.position.clone().applyMatrix4(this.stage.pictures[0].seen.clone().invert());this.flipped=this.normal.dot(e)<this.at,this.flip.input.checked=this.flipped,this.update()}turn(e){e&&this.#r(),this.#s(e)}#s(e){this.on=e,this.enable.input.checked=e,this.stage.pictures.forEach(({solids:t,flanks:i},r)=>{for(let s of[t,i])s.cut(e?[this.planes[r]]:[])}),this.update(),this.changed()}update(){let e=this.flipped?1:-1;this.planes.forEach((t,i)=>{t.normal.copy(this.normal).multiplyScalar(e),t.constant=-e*this.places[i],t.applyMatrix4(this.stage.pictures[i].seen)})}};var uE=8;function dE(){let n=new bo(.19,.19,.72,12,1,!1).translate(0,.36,0),e=new Mc(.5,.3,16,1,!1).translate(0,.85,0),t=[n.toNonIndexed(),e.toNonIndexed()],i=s=>t.flatMap(o=>[...o.attributes[s].array]),r=new Ot;return r.setAttribute("position",new Gt(i("position"),3)),r.setAttribute("normal",new Gt(i("normal"),3)),r.rotateX(Math.PI/2)}var Oh=class{constructor(e,t,i,r,s){this.arrows=e.arrows,this.poses=i,this.radius=s,this.scale=1,this.kinds=new Set(this.arrows.map(f=>f.kind)),this.shown=new Set(this.kinds),this.shown.delete("pair"),this.arrows.filter(f=>f.kind==="bearing").length>uE&&this.shown.delete("bearing"),this.hidden=!1;let o=dE(),a=new Eo(.5,14,10),c=f=>new Rr({color:f,emissive:f,emissiveIntensity:.35}),l=Object.fromEntries(Cr.map(f=>[f,c(rl(r,f))]));this.states=Object.fromEntries(Object.entries(cr).map(([f,{colour:u}])=>[f,c(u)]));let h=(f,u)=>{let p=new St(f,u);return p.matrixAutoUpdate=!1,t.add(p),p};this.drawn=this.arrows.map(f=>({parts:Object.fromEntries(Cr.filter(u=>(f.components??f.largest)?.[u]).map(u=>[u,h(o,l[u])])),ball:f.state?h(a,this.states[0]):null})),this.largest=this.arrows.map(f=>f.largest??Object.fromEntries(Cr.filter(u=>f.components?.[u]).map(u=>[u,gE(f.components[u].data)]))),this.size=Math.max(0,...this.arrows.map(f=>f.size??0))}get longest(){return .55*this.radius*this.scale}forces(){let{where:e}=this.poses;return this.arrows.map(t=>{if(t.now)return{name:t.name,kind:t.kind,unit:t.unit,...t.now()};let i=t.body<0?null:this.poses.still[t.body],r=new N(Jt(t.at,e,0),Jt(t.at,e,1),Jt(t.at,e,2));i&&r.applyMatrix4(i);let s={},o={},a=new N;for(let f of Cr){let u=t.components?.[f];if(!u)continue;let p=new N(Jt(u,e,0),Jt(u,e,1),Jt(u,e,2));o[f]=p.length(),a.add(p),i&&(Av.extractRotation(i),p.applyMatrix4(Av)),s[f]=p}let c=t.state?e.share===1?e.low+1:e.low:0,l=t.state?t.state.data[t.state.count>1?c:0]:null,h=l===255?-1:l;return{name:t.name,kind:t.kind,unit:t.unit??"N",state:h,vectors:s,values:o,at:r,total:a.length()}})}ends(){return this.hidden||!(this.size>0)?[]:this.forces().flatMap((e,t)=>this.shown.has(e.kind)?Object.entries(e.vectors).map(([i,r])=>{let s=this.longest*(this.largest[t][i]??0)/this.size;return r.clone().setLength(r.length()?s:0).add(e.at)}):[])}update(e){this.now=this.forces(),this.now.forEach((t,i)=>{let r=!this.hidden&&this.shown.has(t.kind),{parts:s,ball:o}=this.drawn[i],a=Math.min(.055*this.radius*Math.sqrt(this.scale),22*e||1/0);for(let[c,l]of Object.entries(s)){let h=t.vectors[c],f=this.size>0?this.longest*h.length()/this.size:0;if(l.visible=r&&f>2*e&&f>0,!l.visible)continue;let u=Math.min(a,.5*f);Rv.copy(h).normalize(),l.matrix.compose(t.at,pE.setFromUnitVectors(Uh,Rv),mE.set(u,u,f))}o&&(o.visible=r,o.material=this.states[t.state]??this.states[0],o.matrix.makeScale(.6*a,.6*a,.6*a).setPosition(t.at))})}},Av=new Le,pE=new Ft,Rv=new N,mE=new N;function gE(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}var yl=1024,kh=class extends St{constructor(e,t){let i=m=>e.reduce((d,x)=>d+m(x.geometry),0),r=i(m=>m.attributes.position.count),s=new Float32Array(3*r),o=new Float32Array(3*r),a=new Uint8Array(3*r),c=new Float32Array(r),l=new Uint32Array(i(m=>m.index.count)),h=new Xe,f=0,u=0;e.forEach(({geometry:m,colour:d},x)=>{let{array:w}=m.attributes.position;s.set(w,3*f),o.set(m.attributes.normal.array,3*f),h.set(d);let S=[h.r,h.g,h.b].map(R=>Math.round(255*R));for(let R=f;R<f+w.length/3;R++)c[R]=x,a.set(S,3*R);for(let R of m.index.array)l[u++]=f+R;f+=w.length/3});let p=new Ot;p.setAttribute("position",new Rt(s,3)),p.setAttribute("normal",new Rt(o,3)),p.setAttribute("color",new Rt(a,3,!0)),p.setAttribute("member",new Rt(c,1)),p.setIndex(new Rt(l,1)),super(p,t),this.parts=e,this.first=[],e.reduce((m,{geometry:{attributes:d}})=>(this.first.push(m),m+d.position.array.length),0);let g=Math.ceil(4*e.length/yl);this.places=new Tr(new Float32Array(4*yl*g),yl,g,Fi,ui),this.frustumCulled=!1,this.matrixAutoUpdate=!1,t.vertexColors=!0;let M=t.onBeforeCompile;t.onBeforeCompile=m=>{M(m),m.uniforms.places={value:this.places},m.vertexShader=`attribute float member;
        uniform highp sampler2D places;
        mat4 placeOf() {
          int at = 4 * int(member + 0.5);
          ivec2 t = ivec2(at % ${yl}, at / ${yl});
          return mat4(texelFetch(places, t, 0), texelFetch(places, t + ivec2(1, 0), 0),
            texelFetch(places, t + ivec2(2, 0), 0), texelFetch(places, t + ivec2(3, 0), 0));
        }
        ${m.vertexShader}`.replace("#include <beginnormal_vertex>",`#include <beginnormal_vertex>
mat4 place = placeOf();
objectNormal = mat3(place) * objectNormal;`).replace("#include <begin_vertex>","vec3 transformed = (place * vec4(position, 1.0)).xyz;")},t.customProgramCacheKey=()=>"batch"}place(e,t){this.places.image.data.set(t.elements,16*e),this.places.needsUpdate=!0}bend(e){let{attributes:t}=this.parts[e].geometry;for(let i of["position","normal"]){let{array:r}=t[i],s=this.geometry.attributes[i];s.array.set(r,this.first[e]),s.addUpdateRange(this.first[e],r.length),s.needsUpdate=!0}}raycast(e,t){this.parts.forEach((i,r)=>{Bh.geometry=i.geometry,Bh.material=this.material,Bh.matrixWorld.fromArray(this.places.image.data,16*r).premultiply(this.matrixWorld);let s=[];Bh.raycast(e,s);for(let o of s)t.push({...o,object:this,member:r})})}},Bh=new St;function zh(n,e,t=40){let i=n.length/3,r=e.length/3,s=new Float64Array(3*r),o=new Float64Array(r);for(let M=0;M<r;M++){let[m,d,x]=[3*e[3*M],3*e[3*M+1],3*e[3*M+2]],w=n[d]-n[m],S=n[d+1]-n[m+1],R=n[d+2]-n[m+2],A=n[x]-n[m],_=n[x+1]-n[m+1],b=n[x+2]-n[m+2],F=S*b-R*_,L=R*A-w*b,D=w*_-S*A,k=Math.hypot(F,L,D);o[M]=k,k&&s.set([F/k,L/k,D/k],3*M)}let a=new Uint32Array(i+1);for(let M=0;M<e.length;M++)a[e[M]+1]++;for(let M=0;M<i;M++)a[M+1]+=a[M];let c=a.slice(0,i),l=new Uint32Array(e.length);for(let M=0;M<e.length;M++)l[c[e[M]]++]=M;let h=Math.cos(t*Math.PI/180),f=[],u=[],p=[],g=new Uint32Array(e.length);for(let M=0;M<i;M++){let m=[];for(let d=a[M];d<a[M+1];d++){let x=3*(l[d]/3|0),w=0,S=0,R=0;for(let b=a[M];b<a[M+1];b++){let F=l[b]/3|0;s[x]*s[3*F]+s[x+1]*s[3*F+1]+s[x+2]*s[3*F+2]<h||(w+=o[F]*s[3*F],S+=o[F]*s[3*F+1],R+=o[F]*s[3*F+2])}let A=Math.hypot(w,S,R)||1;w/=A,S/=A,R/=A;let _=m.find(b=>Math.abs(u[3*b]-w)+Math.abs(u[3*b+1]-S)+Math.abs(u[3*b+2]-R)<1e-6);_===void 0&&(_=p.length,m.push(_),p.push(M),f.push(n[3*M],n[3*M+1],n[3*M+2]),u.push(w,S,R)),g[l[d]]=_}}return{points:Float32Array.from(f),normals:Float32Array.from(u),index:g,source:Uint32Array.from(p)}}var Cv=Math.PI*(3-Math.sqrt(5));function Pv(n){return Array.from({length:n},(e,t)=>{let i=1-(2*t+1)/n,r=Math.sqrt(1-i*i);return new N(r*Math.cos(Cv*t),r*Math.sin(Cv*t),i)})}function Lv(n,e){let{array:t,count:i}=n,r=new Set;for(let{x:s,y:o,z:a}of i?e:[]){let c=0,l=-1/0;for(let h=0;h<i;h++){let f=s*t[3*h]+o*t[3*h+1]+a*t[3*h+2];f>l&&([c,l]=[h,f])}r.add(c)}return[...r].map(s=>new N().fromBufferAttribute(n,s))}var xE=.35;function Vh({points:n,normals:e,index:t}){let i=new Ot;return i.setAttribute("position",new Rt(n,3)),i.setAttribute("normal",new Rt(e,3)),i.setIndex(n.length/3<65536?new Rt(Uint16Array.from(t),1):new Rt(Uint32Array.from(t),1)),i.computeBoundingSphere(),i}function ku(n,e){let t=Math.cos(e),i=Math.sin(e),r=new Float32Array(n.length);for(let s=0;s<n.length;s+=3)r[s]=t*n[s]-i*n[s+1],r[s+1]=i*n[s]+t*n[s+1],r[s+2]=n[s+2];return r}function _E(n,e,t){let i=n.points.data,r=n.triangles.data,s=i.length/3,o=0;for(let m of i)o=Math.max(o,Math.abs(m));let a=new Map,c=[],l=(m,d,x)=>{let w=[m,d,x].map(S=>Math.round(S/o*2e5)).join();return a.has(w)||(a.set(w,c.length/3),c.push(m,d,x)),a.get(w)},h=[];for(let m of[0,-1,1]){let d=m?ku(i,m*e):i,x=Array.from({length:s},(w,S)=>l(d[3*S],d[3*S+1],d[3*S+2]));for(let w of r)h.push(x[w])}let f=zh(Float32Array.from(c),Uint32Array.from(h),t),u=f.index.subarray(0,r.length),p=new Map,g=Uint32Array.from(u,m=>(p.has(m)||p.set(m,p.size),p.get(m))),M=m=>{let d=new Float32Array(3*p.size);for(let[x,w]of p)d.set(m.subarray(3*x,3*x+3),3*w);return d};return Vh({points:M(f.points),normals:M(f.normals),index:g})}var Dv=new Le,Ou=new Le,Gh=new Le,Bu=new ln,Nv=new cn,vE=new N,Hh=class extends Mn{constructor(e,t){super();let{solid:i}=e;this.matrixAutoUpdate=!1;let r=2*Math.PI/Math.max(i.teeth||0,2);this.pieces=i.pieces.map(s=>{let o=Array.from(s.turns.data),a=s.levels.map(f=>{let u=_E(f,r,i.creases??40),p=new Ka(u,t(s.fault),o.length);return p.instanceMatrix=new Zr(new Float32Array(16*o.length),16),p.frustumCulled=!1,p.matrixAutoUpdate=!1,p.count=0,p.visible=!1,Object.assign(p.userData,{part:e,fault:s.fault}),this.add(p),{error:f.error,geometry:u,mesh:p,shown:[]}}),{center:c,radius:l}=a[a.length-1].geometry.boundingSphere,h=o.map(f=>c.clone().applyMatrix4(Dv.makeRotationZ(f)));return{turns:o,levels:a,centres:h,radius:l}})}get meshes(){return this.pieces.flatMap(({levels:e})=>e.map(({mesh:t})=>t))}get drawn(){return this.meshes.reduce((e,t)=>e+(t.visible?t.count*t.geometry.index.count/3:0),0)}get finest(){return this.pieces.reduce((e,{turns:t,levels:i})=>e+t.length*i[i.length-1].geometry.index.count/3,0)}choose(e,t,i){Ou.multiplyMatrices(e,this.matrix),Gh.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),Nv.setFromProjectionMatrix(Gh),Gh.multiplyMatrices(t.matrixWorldInverse,Ou);for(let r of this.pieces){let s=r.levels.map(()=>[]);r.centres.forEach((o,a)=>{if(Bu.center.copy(o).applyMatrix4(Ou),Bu.radius=r.radius,!Nv.intersectsSphere(Bu))return;let c=Math.max(-vE.copy(o).applyMatrix4(Gh).z-r.radius,t.near),l=xE*i*c,h=r.levels.findIndex(({error:f})=>f<=l);h<0&&(h=r.levels.length-1),s[h].push(a)}),r.levels.forEach((o,a)=>this.#e(r,o,s[a]))}}#e(e,t,i){let{mesh:r}=t;i.length===t.shown.length&&i.every((s,o)=>s===t.shown[o])||(t.shown=i,i.forEach((s,o)=>Dv.makeRotationZ(e.turns[s]).toArray(r.instanceMatrix.array,16*o)),r.instanceMatrix.needsUpdate=!0,r.count=i.length,r.visible=i.length>0,r.boundingSphere=null)}whole(e){let t=this.pieces.flatMap(({turns:l,levels:h})=>{let f=h.length-(h.length>2?2:1),{geometry:u}=h[e==="fine"?f:0];return l.map(p=>({geometry:u,turn:p}))}),i=l=>t.reduce((h,{geometry:f})=>h+l(f),0),r=new Float32Array(i(({attributes:l})=>l.position.array.length)),s=new Float32Array(r.length),o=new Uint32Array(i(l=>l.index.count)),[a,c]=[0,0];for(let{geometry:l,turn:h}of t){r.set(ku(l.attributes.position.array,h),a),s.set(ku(l.attributes.normal.array,h),a);for(let f of l.index.array)o[c++]=a/3+f;a+=l.attributes.position.array.length}return Vh({points:r,normals:s,index:o})}};var ME=new Le,Wh=(n,e)=>e<0?ME:n[e],Xh=class{constructor(e,t,i,r){this.blend=e,this.geometry=t,this.source=i,this.poses=r,this.points=t.attributes.position.array.slice(),this.normals=t.attributes.normal.array.slice();let s=Wh(r.rest,e.bodies[0]);this.toBody=e.bodies.map(o=>Wh(r.rest,o).clone().invert().multiply(s)),this.moved=e.bodies.map(()=>new Le),this.drawn=e.bodies.map(()=>new Le)}update(e,t){let{blend:i,poses:r,moved:s,drawn:o}=this,a=Wh(r.world,i.bodies[0]).clone().invert(),c=0;if(s.forEach((g,M)=>{g.multiplyMatrices(a,Wh(r.world,i.bodies[M])).multiply(this.toBody[M]);for(let m=0;m<16;m++)c=Math.max(c,Math.abs(g.elements[m]-o[M].elements[m])*(m<12?t:1))}),c<=e)return!1;s.forEach((g,M)=>o[M].copy(g));let{position:l,normal:h}=this.geometry.attributes,{first:f,second:u,weight:p}=i;for(let g=0;g<this.source.length;g++){let M=this.source[g],m=u.data[M],d=p.data[M],x=o[f?f.data[M]:0].elements,w=o[m].elements,S=this.points[3*g],R=this.points[3*g+1],A=this.points[3*g+2],_=this.normals[3*g],b=this.normals[3*g+1],F=this.normals[3*g+2];for(let L=0;L<3;L++){let D=x[L]+d*(w[L]-x[L]),k=x[4+L]+d*(w[4+L]-x[4+L]),G=x[8+L]+d*(w[8+L]-x[8+L]);l.array[3*g+L]=D*S+k*R+G*A+x[12+L]+d*(w[12+L]-x[12+L]),h.array[3*g+L]=D*_+k*b+G*F}}return l.needsUpdate=h.needsUpdate=!0,this.geometry.computeBoundingSphere(),!0}};var qh=class{constructor(e,t,i,r){this.name=e.name,this.geometry=t,this.poses=r;let{shapes:s,node:o,coordinates:a}=e.modal;this.shapes=s.data,this.count=s.shape[0],this.nodes=s.shape[1],this.node=Uint32Array.from(i,c=>o.data[c]),this.points=t.attributes.position.array.slice(),this.coordinates=a,this.mean=a&&No(a),this.drawn=new Float64Array(this.count),this.moved=new Float64Array(3*this.nodes)}#e(){let{mode:e,magnification:t,where:i}=this.poses;return this.drawn.map((r,s)=>{if(e){let a=e.shape.modal?.[this.name];return a?e.cosine*a.data[2*s]+e.sine*a.data[2*s+1]:0}if(!this.coordinates)return 0;let o=Jt(this.coordinates,i,s);return t===1?o:this.mean[s]+t*(o-this.mean[s])})}largest(e){let t=e.modal?.[this.name],i=0;for(let r=0;t&&r<this.nodes;r++){let s=0;for(let o=0;o<6;o++){let a=0;for(let c=0;c<this.count;c++)a+=t.data[2*c+o%2]*this.shapes[3*(this.nodes*c+r)+(o>>1)];s+=a*a}i=Math.max(i,Math.sqrt(s))}return i}update(){let e=this.#e();if(e.every((i,r)=>i===this.drawn[r]))return!1;this.drawn=e,this.moved.fill(0);for(let i=0;i<this.count;i++){let r=3*this.nodes*i;for(let s=0;s<this.moved.length;s++)this.moved[s]+=e[i]*this.shapes[r+s]}let{position:t}=this.geometry.attributes;for(let i=0;i<this.node.length;i++)for(let r=0;r<3;r++)t.array[3*i+r]=this.points[3*i+r]+this.moved[3*this.node[i]+r];return t.needsUpdate=!0,this.geometry.computeBoundingSphere(),!0}};var Iv=300,SE=2.5,yE=4e-4,bE=.003,wE=new Le().multiplyScalar(0);function EE(n){n.onBeforeCompile=e=>{e.vertexShader=`varying float fromAxis;
      ${e.vertexShader}`.replace("#include <begin_vertex>",`#include <begin_vertex>
        fromAxis = length(position.xy);`),e.fragmentShader=`varying float fromAxis;
      #ifdef DOUBLE_SIDED
        uniform mat4 projectionMatrix;
      #endif
      ${e.fragmentShader}`.replace("#include <opaque_fragment>",`#ifdef DOUBLE_SIDED
        gl_FragDepth = gl_FragCoord.z;
        if (!gl_FrontFacing) {
          float away = 1.0 / gl_FragCoord.w;
          // At oblique incidence the difference in depth is larger.
          float facing = abs(dot(normalize(vNormal), normalize(vViewPosition)));
          float nearer = away - max(${yE} * away, ${bE} * fromAxis / max(facing, 0.15));
          gl_FragDepth = clamp(0.5 + 0.5 * (projectionMatrix[3][2] / nearer - projectionMatrix[2][2]), 0.0, 1.0);
          float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0);
          outgoingLight = diffuseColor.rgb * (stripe < 1.1 ? 0.66 : 0.86);
        }
      #endif
      #include <opaque_fragment>`)}}function Uv(n,e){let t=new Rr({color:n});return e&&Object.assign(t,{transparent:!0,opacity:.22,depthWrite:!1}),EE(t),t}var Yh=class{constructor(e,t,i){this.solids=e.solids,this.root=t,this.poses=i,this.known=new Map;let r={};this.parts=e.solids.map(s=>{let o=r[s.kind]=(r[s.kind]??-1)+1,a={solid:s,colour:bx(s.kind,o,s.schematic)};if(s.pieces)a.repeated=new Hh(a,l=>this.#e(a,l,"repeated")),a.geometry=a.repeated.whole("coarse");else{let l=zh(s.points.data,s.triangles.data,s.creases??40);a.geometry=Vh(l),a.blend=s.blend?new Xh(s.blend,a.geometry,l.source,i):null,a.modal=s.modal?new qh(s,a.geometry,l.source,i):null}let c=a.geometry.attributes.position.array;return Object.assign(a,{radius:AE(c),rim:TE(c)})}),this.triangles=this.parts.reduce((s,o)=>s+(o.repeated?.finest??o.geometry.index.count/3),0),this.meshes=[],this.batches=[],this.parts.length>Iv?this.#i():this.#t(),this.update(0)}#e({colour:e,solid:t},i="",r=""){let s=[e,!!t.see_through,!!i,r].join();if(!this.known.has(s)){let o=i?new Xe(e).lerp(new Xe(yx),.55):e;this.known.set(s,Uv(o,t.see_through))}return this.known.get(s)}get materials(){return[...this.known.values()]}#t(){for(let e of this.parts){let t=e.repeated??new St(e.geometry,this.#e(e));t.matrixAutoUpdate=!1,t.renderOrder=e.solid.see_through?1:0,t.userData.part=e,e.mesh=t,this.meshes.push(...e.repeated?.meshes??[t]),this.root.add(t)}}#i(){for(let e of[!1,!0]){let t=this.parts.filter(s=>!!s.solid.see_through===e);if(!t.length)continue;let i=Uv("#ffffff",e),r=new kh(t,i);t.forEach((s,o)=>Object.assign(s,{batch:r,member:o,repeated:null})),r.renderOrder=e?1:0,this.known.set(`batch ${e}`,i),this.batches.push(r),this.root.add(r)}}update(e){for(let t of this.parts){let i=this.poses.ofSolid(t.solid),r=[t.blend?.update(e,t.radius),t.modal?.update()].some(Boolean);t.batch?(t.batch.place(t.member,this.shows(t)?i:wE),r&&t.batch.bend(t.member)):t.mesh.matrix.copy(i)}}choose(e,t,i){for(let{repeated:r}of this.parts)r?.choose(e,t,i)}exported(e){return this.parts.filter(t=>this.shows(t)).map(t=>{let i=t.repeated?t.repeated.whole("fine"):t.geometry,{solid:r}=t;if(!e||!(r.place||r.axes||r.between))return{...t,geometry:i};let s=this.poses.ofSolid(r).clone(),o=r.between?r.between.bodies[0]:r.body;return o>=0&&s.premultiply(this.poses.world[o].clone().invert()),{...t,solid:{...r,body:o},geometry:i.clone().applyMatrix4(s)}})}get drawn(){return this.parts.reduce((e,t)=>e+(t.repeated?.drawn??(this.shows(t)?t.geometry.index.count/3:0)),0)}cut(e){for(let t of this.materials)t.clippingPlanes=e.length?e:null,t.side=e.length?zi:sn,t.needsUpdate=!0}cover(e){let t=new Set;for(let i of this.parts){if(!i.solid.see_through)continue;i.hidden=e==="hidden",this.#n(i);let r=i.batch?.material??i.mesh.material;t.has(r)||(t.add(r),Object.assign(r,e==="solid"?{transparent:!1,opacity:1,depthWrite:!0}:{transparent:!0,opacity:.22,depthWrite:!1}),r.needsUpdate=!0)}}schematics(e){this.plain=!e;for(let t of this.parts)t.solid.schematic&&this.#n(t)}shows(e){return!e.hidden&&!(this.plain&&e.solid.schematic)}#n(e){e.mesh&&(e.mesh.visible=this.shows(e))}hit(e){let i=e.intersectObjects([...this.meshes,...this.batches].filter(r=>r.visible),!1).map(({object:r,member:s,point:o})=>({part:r.userData.part??r.parts[s],fault:r.userData.fault??"",point:o})).filter(({part:r})=>this.shows(r));return i.find(({part:r,point:s})=>!r.solid.see_through&&this.#r(s))??i.find(({point:r})=>this.#r(r))??null}#r(e){return!this.materials[0]?.clippingPlanes?.some(t=>t.distanceToPoint(e)<0)}bounds(){let e=this.parts.filter(({solid:s})=>!s.see_through||s.schematic),t=this.#s(this.parts),i=e.length&&e.length<this.parts.length?this.#s(e):t;return{...t.radius<SE*i.radius?t:i,size:i.radius,whole:t}}#s(e){let t=new N(1/0,1/0,1/0),i=t.clone().negate(),r=new N,s=[],o=Pv(this.parts.length>Iv?6:64);for(let a of e){let c=this.poses.ofSolid(a.solid),{center:l,radius:h}=a.geometry.boundingSphere;a.geometry.computeBoundingBox();let{min:f,max:u}=a.geometry.boundingBox;if(h>=0){a.reaches??=Lv(a.geometry.attributes.position,o);for(let p of a.reaches)s.push(p.clone().applyMatrix4(c));for(let p=0;p<8;p++)r.set(p&1?u.x:f.x,p&2?u.y:f.y,p&4?u.z:f.z),r.sub(l).clampLength(0,h).add(l).applyMatrix4(c),t.min(r),i.max(r)}}return i.x>=t.x?{centre:t.clone().add(i).multiplyScalar(.5),radius:Math.max(t.distanceTo(i)/2,1e-9),low:t,high:i,outline:s}:{centre:r.set(0,0,0),radius:1,low:r.clone().set(-1,-1,-1),high:r.clone().set(1,1,1),outline:s}}reachOf(e){return Math.max(0,...this.parts.filter(t=>t.solid.body===e).map(t=>t.radius))}};function TE(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1]));return e}function AE(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}var RE=/swiftshader|llvmpipe|softpipe|software|basic render/i;function Ov(){try{let n=document.createElement("canvas").getContext("webgl2");if(!n)return null;let e=n.getExtension("WEBGL_debug_renderer_info"),t=String(n.getParameter(e?e.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),{software:RE.test(t)}}catch{return null}}var Fv={size:1.5,away:.5},zu=class{constructor(e,t,i){this.data=e,this.camera=i,this.seen=new Le,this.factor=1,this.centre=new N,this.scene=new lo,this.over=new lo,this.root=new Mn,this.overRoot=new Mn,this.root.matrixAutoUpdate=this.overRoot.matrixAutoUpdate=!1,this.scene.add(this.root),this.over.add(this.overRoot),this.lights=[this.scene,this.over].map(r=>{let s=new Ja("#ffffff",2.1),o=new Za("#ffffff","#8f98a3",1.25);return r.add(s,s.target,o),{light:s,sky:o}}),this.poses=new qo(e),this.solids=new Yh(e,this.root,this.poses),this.bounds=this.solids.bounds(),this.flanks=new Zc(e,this.root,this.overRoot,this.poses),this.arrows=new Oh({arrows:[...e.arrows,...this.flanks.pairs()]},this.overRoot,this.poses,t,this.bounds.size)}},$h=class{constructor(e,t,i){this.host=e,this.software=i,this.renderer=new nl({antialias:!i,powerPreference:"high-performance"}),this.renderer.autoClear=!1,this.renderer.localClippingEnabled=!0,this.canvas=this.renderer.domElement,this.canvas.className="ppv-canvas",e.append(this.canvas),this.camera=new Bi(28,1,.01,100),this.pictures=t.map((c,l)=>new zu(c,e,l?this.camera.clone():this.camera)),this.alike=CE(this.pictures);let[{bounds:r}]=this.pictures;this.meet(this.pictures.map(()=>new N),this.pictures.map(c=>c.bounds.size));let s=Math.max(...this.pictures.map(c=>c.arrows.size)),o=this.alike?Math.max(...this.pictures.map(c=>c.bounds.size)):r.size,a=Math.max(...this.pictures.map(c=>c.flanks.greatest));for(let{arrows:c,flanks:l,factor:h}of this.pictures)Object.assign(c,{size:s,radius:h*o}),l.greatest=a;this.background=new Xe("#ffffff"),this.size={width:1,height:1},this.drawn=0,this.coarse=!1,this.shift=0,this.drop=0}coarsen(e){return e===this.coarse?!1:(this.coarse=e,this.resize(),!0)}get ratio(){return this.coarse?.6:this.software?1:Math.min(window.devicePixelRatio||1,2)}resize(){let{clientWidth:e,clientHeight:t}=this.host;if(!(!e||!t)){this.size={width:e,height:t},this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(e,t);for(let{camera:i}of this.pictures)i.aspect=e/this.pictures.length/t,i.updateProjectionMatrix()}}bounds(){let e=(this.alike?this.pictures:this.pictures.slice(0,1)).map(({bounds:o})=>o),t=e.reduce((o,a)=>o.min(a.low),e[0].low.clone()),i=e.reduce((o,a)=>o.max(a.high),e[0].high.clone()),r=t.clone().add(i).multiplyScalar(.5),s=Math.max(...e.map(o=>o.centre.distanceTo(r)+o.radius));return{centre:r.applyMatrix4(this.pictures[0].seen),radius:s,low:t,high:i}}targetOf(e,t){let[i]=this.pictures;return e.centre.clone().addScaledVector(t.clone().sub(i.centre),e.factor)}meet(e,t){this.pictures.forEach((i,r)=>{i.centre.copy(e[r]),t&&!this.alike&&(i.factor=t[r]/t[0])})}#e(e,t){let{camera:i,seen:r,factor:s}=e,{whole:o}=e.bounds,a=s*t.now.distance,c=this.targetOf(e,t.now.target);i!==this.camera&&(i.position.copy(c).addScaledVector(t.direction(),a),i.quaternion.copy(this.camera.quaternion));let l=c.distanceTo(o.centre.clone().applyMatrix4(r));i.near=Math.max(.01*a,a-l-1.3*o.radius),i.far=a+l+2.5*o.radius;let h=this.size.width/this.pictures.length;i.setViewOffset(h,this.size.height,this.shift*h,-this.drop*this.size.height,h,this.size.height),i.updateMatrixWorld()}render(e){let{renderer:t}=this;this.setLights(),t.setScissorTest(!0);let i=this.size.width/this.pictures.length,r=this.size.height*Math.min(1,this.ratio),s=(this.software?2.5:1)*2*Math.tan(this.camera.fov*Math.PI/360)/r;this.pictures.forEach((o,a)=>{let{camera:c,seen:l}=o;this.#e(o,e),t.setViewport(a*i,0,i,this.size.height),t.setScissor(a*i,0,i,this.size.height),t.setClearColor(this.background,1),t.clear(),o.root.matrix.copy(l),o.overRoot.matrix.copy(l),o.solids.choose(l,c,s),t.render(o.scene,c),!((o.arrows.hidden||!o.arrows.shown.size)&&!o.flanks.over)&&(t.clearDepth(),t.render(o.over,c))}),this.drawn++}setLights(){let e=new N(-.45,.7,.9).applyQuaternion(this.camera.quaternion),t=new N(0,1,0).applyQuaternion(this.camera.quaternion);for(let i of this.pictures)for(let r of i.lights)r.light.position.copy(e),r.sky.position.copy(t)}hit(e,t){let i=this.canvas.getBoundingClientRect(),r=i.width/this.pictures.length,s=Math.floor((e-i.left)/r),o=this.pictures[s];if(!o)return null;let a=new Ke((e-i.left-s*r)/r*2-1,1-(t-i.top)/i.height*2),c=new Qa;c.setFromCamera(a,o.camera);let l=o.solids.hit(c);return l&&{...l,picture:s}}onScreen(e,t=0){let{seen:i,camera:r}=this.pictures[t],s=e.clone().applyMatrix4(i).project(r),o=this.size.width/this.pictures.length;return{x:(t+(s.x+1)/2)*o,y:(1-s.y)/2*this.size.height,front:s.z<1}}};function CE(n){let[{bounds:e}]=n;return n.every(({bounds:t})=>{let[i,r]=[t.size,e.size].sort((s,o)=>s-o);return r<=Fv.size*i&&t.centre.distanceTo(e.centre)<=Fv.away*r})}function Bv(n){let{canvas:e}=n.stage,t=()=>{e.style.touchAction=n.fills||document.activeElement===e?"none":"pan-y"};for(let i of["focus","blur","pointerenter"])e.addEventListener(i,t);window.addEventListener("resize",t),t()}var Gu=1e6,Kh=class{constructor(e,t,i,r=""){this.player=e,this.marks=[...t].sort((o,a)=>o.time-a.time),this.kinds=[...new Set(this.marks.map(o=>o.kind))],this.does=i,this.stepLength=1/0;for(let o=1;o<e.times.length;o++)this.stepLength=Math.min(this.stepLength,e.times[o]-e.times[o-1]||1/0);Number.isFinite(this.stepLength)||(this.stepLength=1);let s=r&&`, ${hr(this.stepLength)}, the frame interval of ${r}`;this.play=Tt("","Play (space)",i.toggle,{className:"ppv-play"}),this.range=J("input",{type:"range",min:"0",max:String(Gu),step:"1",className:"ppv-range",title:"Time","aria-label":"Time"}),this.range.addEventListener("input",()=>i.seek(this.#e(Number(this.range.value)/Gu))),this.strip=J("canvas",{className:"ppv-marks",role:"img","aria-label":`${this.marks.length} marks`}),this.tip=J("div",{className:"ppv-tip",hidden:!0}),this.strip.addEventListener("pointermove",o=>this.#n(o)),this.strip.addEventListener("pointerleave",()=>this.tip.hidden=!0),this.strip.addEventListener("click",o=>{let a=this.#i(o);i.seek(a?a.time:this.#e(this.#t(o)))}),this.read=J("output",{className:"ppv-now",title:"Time"}),this.speed=_r({label:"",title:"Speed relative to real time (+ and \u2212)",least:ml,most:1,value:e.speed,show:Lx,changed:i.speed}),this.loop=rn("repeat",[["record","whole record"],["turn","one turn"],["cycle","one mesh cycle"]],o=>{let a=i.loop(o);this.loop.select.value=e.loop,this.announce(a)}),this.status=J("span",{className:"ppv-status",role:"status"}),this.jump=this.marks.length?[Tt("\u27E8","Previous mark ([)",()=>this.toMark(-1)),Tt("\u27E9","Next mark (])",()=>this.toMark(1))]:[],this.element=J("div",{className:"ppv-time"},J("div",{className:"ppv-track"},this.strip,this.range,this.tip),J("div",{className:"ppv-transport"},this.play,Tt("|\u25C2","To the start (Home)",()=>i.seek(e.window[0])),Tt("\u25C2",`One frame back (left arrow)${s}`,()=>i.step(-1)),Tt("\u25B8",`One frame forward (right arrow)${s}`,()=>i.step(1)),...this.jump,this.read,this.speed.row,this.loop.row,this.status)),e.times.length<2&&this.element.classList.add("ppv-still")}#e(e){return this.player.first+e*(this.player.last-this.player.first)}#t(e){let t=this.strip.getBoundingClientRect();return Math.max(0,Math.min(1,(e.clientX-t.left)/t.width))}#i(e){let t=this.strip.getBoundingClientRect(),i=this.#e(this.#t(e)),r=6*(this.player.last-this.player.first)/Math.max(t.width,1),s=null;for(let o of this.marks)Math.abs(o.time-i)<=r&&(!s||Math.abs(o.time-i)<Math.abs(s.time-i))&&(s=o);return s}#n(e){let t=this.#i(e);if(this.tip.hidden=!t,this.strip.style.cursor="pointer",!t)return;this.tip.textContent=`${xl(t.kind)}${t.what?`, ${t.what}`:""}, ${Ms(t.time,this.stepLength/10)}`;let i=this.strip.getBoundingClientRect(),r=e.clientX-i.left;this.tip.style.left=`${Math.max(0,Math.min(i.width-180,r))}px`}announce(e){this.status.textContent=e}toMark(e){let t=this.player.time,i=1e-9*(this.player.last-this.player.first),r=e>0?this.marks.find(s=>s.time>t+i):this.marks.findLast(s=>s.time<t-i);r&&this.does.seek(r.time)}draw(){let{strip:e,player:t}=this,i=e.clientWidth,r=e.clientHeight;if(!i)return;let s=window.devicePixelRatio||1;e.width=i*s,e.height=r*s;let o=e.getContext("2d");o.scale(s,s);let a=t.last-t.first||1,c=h=>(h-t.first)/a*i,l=getComputedStyle(this.element);t.loop!=="record"&&(o.fillStyle=l.getPropertyValue("--v-accent"),o.globalAlpha=.35,o.fillRect(c(t.window[0]),r-4,Math.max(2,c(t.window[1])-c(t.window[0])),4),o.globalAlpha=1);for(let h of this.marks)o.fillStyle=vs(this.kinds,h.kind),o.globalAlpha=.3,h.until>h.time&&o.fillRect(c(h.time),3,c(h.until)-c(h.time),r-9),o.globalAlpha=1,o.fillRect(c(h.time)-.75,1,1.5,r-5)}update(){let{player:e}=this,t=e.last-e.first,i=t>0?(e.time-e.first)/t:0;this.range.value=String(Math.round(i*Gu));let r=Ms(e.time,e.playing?this.stepLength:this.stepLength/10);this.range.ariaValueText=r,this.read.textContent=r,this.read.title=`Time; record length ${hr(t)}`;let s=e.playing?"pause":"play";this.play.dataset.state!==s&&(this.play.dataset.state=s,this.play.textContent=e.playing?"\u275A\u275A":"\u25B6\uFE0E",this.play.title=e.playing?"Pause (space)":"Play (space)",this.play.setAttribute("aria-label",this.play.title))}};var Zh=class{constructor(e,t,i=()=>[],r=()=>0){this.stage=e,this.orbit=t,this.legends=i,this.panel=r,this.names=[...new Set(e.pictures.flatMap(({data:s})=>s.bodies.map(({name:o})=>o)))],this.body=-1,this.turning=!1,this.anchors=e.pictures.map(()=>new Le)}bodyIn({data:e}){return this.body<0?-1:e.bodies.findIndex(({name:t})=>t===this.names[this.body])}get first(){return this.bodyIn(this.stage.pictures[0])}get poses(){return this.stage.pictures[0].poses}directions(){let e=this.poses.axis().transformDirection(this.stage.pictures[0].seen),t=this.orbit.up,i=new N().crossVectors(t,e);i.length()<.001&&i.crossVectors(new N(1,0,0),e),i.length()<.001&&i.crossVectors(new N(0,0,1),e),i.normalize();let r=new N().crossVectors(e,i),s=Math.abs(e.dot(t))>.9,[o,a,c]=s?[.55*Math.sign(e.dot(t)),1,.7]:[1,.75,.55];return{axis:e,front:i,top:s?e:r,iso:e.clone().multiplyScalar(o).addScaledVector(i,a).addScaledVector(r,c)}}distanceFor(e){let{camera:t}=this.stage,i=Math.atan(Math.tan(t.fov*Math.PI/360)*Math.min(1,t.aspect));return e/Math.sin(i)}#e(e,t=0){this.stage.shift=this.orbit.shift=e/2,this.stage.drop=this.orbit.drop=t/2}fit(e=!1){let{alike:t,pictures:i}=this.stage,r=i.map(({bounds:M,arrows:m,seen:d})=>[...M.outline,...m.ends()].map(x=>x.clone().applyMatrix4(d))),s=t?[{points:r.flat(),bounds:this.stage.bounds(),factor:1}]:i.map(({bounds:M,seen:m},d)=>({points:r[d],bounds:{radius:M.radius,centre:M.centre.clone().applyMatrix4(m)},factor:M.size/i[0].bounds.size})),o=this.legends()??[],[a,c,l]=["share","strip","drop"].map(M=>Math.max(0,...o.map(m=>m[M]))),[h,f]=[-this.panel(),0],u=()=>s.map(({points:M,bounds:m})=>this.#i(M,m,h,f)),p=u(),g=M=>M>0&&s.some(({points:m},d)=>m.some(x=>p[d].under(x,M,l)));g(a)?h=a:g(c)&&(f=l),(h||f)&&(p=u()),this.#e(h,f),this.#t(i.map((M,m)=>p[t?0:m].target),i.map(({bounds:M})=>M.size),{distance:Math.max(...p.map(({distance:M},m)=>M/s[m].factor))},e),this.orbit.chosen=!1}#t(e,t,i,r=!1){this.stage.meet(e,t),this.orbit.look({target:e[0],...i},r||!this.stage.alike)}#i(e,{centre:t,radius:i},r,s){let{camera:o}=this.stage,a=this.orbit.direction(this.orbit.goal),c=new N().crossVectors(this.orbit.up,a).normalize(),l=new N().crossVectors(a,c),h=Math.tan(o.fov*Math.PI/360),f=.9*h*(1-s),u=.9*h*o.aspect*(1-Math.abs(r)),p=t.clone(),g=this.distanceFor(i);for(let m=0;e.length&&m<3;m++){let d=[1/0,-1/0,1/0,-1/0],x=0;for(let w of e){let S=w.clone().sub(p),[R,A,_]=[S.dot(c),S.dot(l),S.dot(a)],b=Math.max(g-_,.001*i);d[0]=Math.min(d[0],R/b),d[1]=Math.max(d[1],R/b),d[2]=Math.min(d[2],A/b),d[3]=Math.max(d[3],A/b),x=Math.max(x,_+Math.abs(R)/u,_+Math.abs(A)/f)}if(m===2){g=x;break}p.addScaledVector(c,g*(d[0]+d[1])/2),p.addScaledVector(l,g*(d[2]+d[3])/2)}return g=Math.max(g,.1*i),{target:p,distance:g,under:(m,d,x)=>{let w=m.clone().sub(p),S=h*(g-w.dot(a));return w.dot(c)>S*o.aspect*(1-2*d)&&w.dot(l)>S*(1-2*x)}}}named(e,t=!1){let i=this.directions();e==="top"&&this.orbit.look({direction:i.front}),this.orbit.look({direction:i[e]},t),this.fit(t)}follow(e,t=this.turning){this.body=e,this.turning=t;let{pictures:i}=this.stage;if(e<0){let r=i.map(s=>this.stage.targetOf(s,this.orbit.goal.target).applyMatrix4(s.seen.clone().invert()));for(let{seen:s}of i)s.identity();this.stage.meet(r),this.orbit.look({target:r[0]},!0);return}i.forEach((r,s)=>this.anchors[s].multiplyMatrices(r.seen,this.#n(r))),this.orbit.changed()}#n(e){let t=e.poses.world[this.bodyIn(e)]??new Le;return this.turning?t.clone():new Le().setPosition(new N().setFromMatrixPosition(t))}update(){this.body<0||this.stage.pictures.forEach((e,t)=>e.seen.multiplyMatrices(this.anchors[t],this.#n(e).invert()))}look(e,t,i){let r=i/(2*Math.tan(this.stage.camera.fov*Math.PI/360));this.#e(0),this.orbit.look({target:new N(...e),direction:t&&new N(...t),distance:r},!0)}closeUp(){if(this.body<0)return;let{pictures:e}=this.stage,t=e.map(i=>{let r=this.bodyIn(i);return r<0?null:{target:new N().setFromMatrixPosition(i.poses.world[r]).applyMatrix4(i.seen),size:i.solids.reachOf(r)}});this.#r(t,i=>this.distanceFor(1.15*i))}#r(e,t,i){let{pictures:r,alike:s}=this.stage,{target:o}=this.orbit.goal,a=e.map((f,u)=>f?.target??this.stage.targetOf(r[u],o)),c=e.findIndex(f=>f?.size>0);if(c<0)return this.#t(a,void 0,{direction:i});let l=e[c].size/r[c].bounds.size,h=r.map(({bounds:f},u)=>e[u]?.size>0?e[u].size:l*(s?r[c]:{bounds:f}).bounds.size);this.#t(a,h,{direction:i,distance:t(s?Math.max(...h):h[0])})}#s(e,{solids:t,poses:i}){let r=null;for(let s of t.parts){if(!s.solid.teeth)continue;let o=i.ofSolid(s.solid),a=new N().setFromMatrixColumn(o,2),c=e.clone().sub(new N().setFromMatrixPosition(o)),l=c.addScaledVector(a,-c.dot(a)).length(),h=Math.abs(s.rim-l)/s.rim;(!r||h<r.off)&&(r={off:h,axis:a,pitch:2*Math.PI*l/s.solid.teeth})}return r}#o(e,t){let{poses:i,arrows:r,data:s,seen:o,bounds:a}=e,c=r.forces()[s.arrows.indexOf(t)].at,l=this.#s(c,e),h=l?l.axis:i.axis();return{point:c,axis:h,target:c.clone().applyMatrix4(o),size:l?l.pitch:.1*a.radius}}intoMesh(e){let{pictures:t,camera:i}=this.stage,r=t.map(a=>{let c=a.data.arrows.find(({kind:l,name:h})=>l==="mesh"&&h===e.name);return c?this.#o(a,c):null}),s=r.findIndex(Boolean),o=r[s].axis.clone().transformDirection(t[s].seen);return this.#r(r,a=>1.6*a/(2*Math.tan(i.fov*Math.PI/360)),o),r}};var PE="WebGL 2 is not available, so the solids cannot be drawn; curves and time controls work.",LE=900,Jh=class{constructor(e,t){this.root=e,this.scenes=t,this.last=0,this.waiting=0,this.stage=null,this.shared=Tv(t);let{times:i}=this.shared;this.poses=new qo(t[0]),this.player=new bh(i,this.poses);let r=DE(t),s=[this.player.first,this.player.last];this.curves=new Sh(t,s,r,l=>this.seek(l)),this.transport=new Kh(this.player,r,{seek:l=>this.seek(l),toggle:()=>this.toggle(),step:l=>this.step(l),speed:l=>this.player.speed=l,loop:l=>this.loop(l)},this.shared.whose),this.panels=new Dh,this.host=J("div",{className:"ppv-view"}),this.area=J("div",{className:"ppv-scene"},this.host,this.panels.panel);let o=[...new Set(t.map(l=>l.title))].join(" and "),a=t.length>1?"":t[0].subtitle,c=J("div",{className:"ppv-head"},J("div",{className:"ppv-title",title:`${o} ${a}`},J("b",{},o),J("span",{},a)),this.panels.bar);e.replaceChildren(c,this.area,this.transport.element,this.curves.element),this.#t(),this.#i(),uv(this),this.watch=new ResizeObserver(()=>this.resize()),this.watch.observe(e),this.watch.observe(this.curves.body),window.addEventListener("beforeprint",()=>this.draw()),this.dark=window.matchMedia("(prefers-color-scheme: dark)"),this.dark.addEventListener("change",()=>this.colours()),this.resize(),this.curves.build(),this.colours()}#e(e){this.area.append(J("div",{className:"ppv-message",role:"alert"},J("p",{},e)))}#t(){if(!this.scenes.some(o=>o.solids.length)){this.#e("This scene contains no solids: the model defines no geometry, or the result does not contain it.");return}let e=Ov();if(!e){this.#e(PE);return}this.stage=new $h(this.host,this.scenes,e.software);let{stage:t}=this;t.canvas.tabIndex=0,t.canvas.setAttribute("aria-label","3-D scene: drag to rotate, right button to pan, wheel to zoom"),t.canvas.addEventListener("webglcontextlost",()=>this.#e("The graphics context was lost. Reload the page.")),this.orbit=new Rh(t.camera,t.canvas,()=>this.changed(),this.scenes[0].up),this.orbit.takesWheel=o=>{let a=this.fills||o.ctrlKey||document.activeElement===t.canvas;return a||this.#l("click the scene to zoom with the wheel"),a},Bv(this),this.orbit.pictures=t.pictures.length;let{radius:i}=t.bounds();this.orbit.nearest=2e-5*i,this.orbit.farthest=40*i,this.views=new Zh(t,this.orbit,()=>this.legends,()=>this.scenes[1]?0:this.panels.share),this.hover=new yh(t,this.orbit,o=>this.follow(this.views.names.indexOf(o))),this.legends=t.pictures.map(({arrows:o})=>new wh(o.arrows)),this.boxes=t.pictures.map(({flanks:o})=>new Jc(o)),this.scales=t.pictures.map(()=>J("div",{className:"ppv-scale","aria-hidden":"true"},J("span"),J("i"))),this.status=J("div",{className:"ppv-status",role:"status"});let r=_l(this.scenes);this.names=r.map((o,a)=>o&&J("span",{className:"ppv-name",title:this.scenes[a].label},J("span",{},o),J("span",{})));let s=this.legends.map((o,a)=>J("div",{className:"ppv-half"},o.element,this.boxes[a].element,this.names[a],this.scales[a]));this.host.append(J("div",{className:"ppv-halves"},...s),this.hover.label,this.status)}#i(){let{panels:e,stage:t}=this;if(t){e.action("Fit","Fit all (f)",()=>this.views.fit()),e.add("View","Standard views, followed body, housing, view into a mesh",Mv(this)),this.scenes.some(o=>o.arrows.length)&&e.add("Forces","Force arrows",Sv(this)),this.scenes.some(o=>o.contacts.length)&&e.add("Flanks","Contact lines, pattern and gap of the teeth",Ux(this)),this.player.times.length>1&&e.add("Vibration","Magnify vibrations",bv(this)),this.section=new Fh(t,()=>this.changed()),e.add("Section","Section plane through the solids",this.section.rows);let{modes:s}=this.scenes[0];if(s.length&&!this.scenes[1]){this.modes=new Eh(s,t,()=>this.changed());let o=e.add("Modes","Mode shapes",this.modes.rows);this.player.times.length<2&&this.host.clientWidth>=LE&&e.show("Modes",this.modes.rows,o)}e.add("Save","Picture, solids, video",yv(this))}this.transport.marks.length&&e.add("Marks","Events in the record",dv(this));let i=[...new Set([this.shared.note,...this.scenes.flatMap(s=>s.notes)])].filter(Boolean),r=[J("dl",{},...fv.flatMap(([s,o])=>[J("dt",{},s),J("dd",{},o)]))];i.length&&r.unshift(J("ul",{className:"ppv-notes"},...i.map(s=>J("li",{},s)))),e.add(i.length?`Notes (${i.length})`:"?","Notes and keyboard shortcuts",r)}colours(){this.stage?.background.set(getComputedStyle(this.area).backgroundColor),this.curves.build(),this.transport.draw(),this.changed()}resize(){if(!(!this.root.clientWidth||!this.root.clientHeight)){if(this.stage){let e=this.stage.size.width===1;this.stage.resize(),e&&this.draw();for(let t of this.legends)t.settle();e&&this.views.named("iso",!0),this.orbit.chosen||this.views.fit(!0),this.draw()}this.curves.resize(),this.transport.draw(),this.update()}}changed(){this.waiting||(this.waiting=requestAnimationFrame(e=>this.#n(e)))}#n(e){this.waiting=0;let t=this.player.playing||this.easing||this.modes?.active,i=t&&this.last?Math.min(.25,Math.max(0,(e-this.last)/1e3)):1/60;this.last=e,this.player.advance(i),this.modes?.advance(i),this.easing=this.orbit?.step(i)??!1,this.#r(i,t),this.update(),this.draw(),this.frames=(this.frames??0)+1,this.player.playing||this.easing||this.modes?.active?this.changed():this.last=0}#r(e,t){let i=this.player.playing||this.easing||this.modes?.active;t&&i&&(this.pace=.7*(this.pace??e)+.3*e),!this.filming&&this.stage?.coarsen(!!i&&this.pace>(this.stage.coarse?.03:.085))}update(){this.transport.update(),this.curves.cursor(this.player.time),this.#s()}#s(){this.player.time!==this.sent&&(this.sent=this.player.time,this.#o(),this.root.dispatchEvent(new CustomEvent("pp-time",{bubbles:!0,detail:this.sent})))}#o(){this.scenes.length<2||!this.names||this.names.forEach((e,t)=>{let i=this.scenes[t].times?.data.at(-1),r=Ru(i,this.sent)?` (ended at ${hr(i)})`:"";e&&e.lastChild.textContent!==r&&(e.lastChild.textContent=r)})}draw(){let{stage:e,orbit:t}=this;if(!(!e||e.size.width===1)){for(let i of e.pictures)this.modes?.active?this.modes.pose(i):i.poses.at(this.player.time);this.modes?.active||this.views.update(),this.section?.update();for(let i of e.pictures){let r=i.factor*t.pixel;i.solids.update(.25*r),i.arrows.hidden=i.flanks.hidden=!!this.modes?.active,i.flanks.look(),i.flanks.update(r),i.arrows.update(r)}e.render(t),e.pictures.forEach(({arrows:i},r)=>this.legends[r].update(i.now,i.shown,i.hidden));for(let i of this.boxes)i.update();this.#a()}}#a(){let{alike:e,pictures:t}=this.stage,i=this.host.clientWidth/t.length<300?60:90;this.scales.forEach((c,l)=>{let h=t[l].factor*this.orbit.pixel,f=gl(i*h),[u,p]=c.children;c.hidden=e&&l>0,u.textContent=Px(f),p.style.width=`${f/h}px`});let{body:r,names:s}=this.views,o=r>=0?`following ${s[r]}`:"",a=this.stage.pictures[0].poses.magnification>1?`vibrations \xD7 ${this.magnification.row.lastChild.textContent}`:"";this.status.textContent=[o,a,this.modes?.words].filter(Boolean).join(" \xB7 ")}get fills(){return this.root.clientHeight>.8*window.innerHeight}#l(e){this.status.textContent=e,clearTimeout(this.hinted),this.hinted=setTimeout(()=>this.changed(),2500)}advance(e){this.player.advance(e),this.modes?.advance(e),this.update(),this.draw()}seek(e){this.player.seek(e),this.update(),this.changed()}toggle(e=!this.player.playing){this.player.playing=e&&this.player.last>this.player.first,this.transport.update(),this.changed()}step(e){this.player.step(e),this.update(),this.changed()}loop(e){let t=this.player.repeat(e,this.views?.first??-1,this.scenes[0].solids);return this.transport.loop.select.value=this.player.loop,this.transport.draw(),this.changed(),t}follow(e){!this.stage||e>=this.views.names.length||(this.views.follow(e),e>=0&&this.views.closeUp(),this.followed.select.value=String(e),this.changed())}magnify(e){for(let t of this.stage.pictures)t.poses.magnification=e;this.changed()}arrows(e,t){for(let{arrows:i}of this.stage.pictures)t?i.shown.add(e):i.shown.delete(e);this.kinds?.[e]&&(this.kinds[e].input.checked=t),this.changed()}intoMesh(e){let t=this.views.intoMesh(e);this.section.through(t.map(i=>i?.point),t.find(Boolean).axis)}};function DE(n){let e=_l(n);return n.flatMap((t,i)=>t.marks.map(r=>({...r,what:[r.what,e[i]].filter(Boolean).join(", ")})))}function kv(n,e,{shape:t,differences:i,across:r}){let s=new Float64Array(e);for(let l=0,h=1;l<n.length;l+=e,h*=256)for(let f=0;f<e;f++)s[f]+=h*n[l+f];for(let l=0;l<e;l++)s[l]=s[l]%2?-(s[l]+1)/2:s[l]/2;let o=r?t[t.length-1]:t[0];for(let l=0;o&&l<e;l+=o)NE(s,l,l+o,i);if(r)return s;let a=o?e/o:0,c=new Float64Array(e);for(let l=0;l<a;l++)for(let h=0;h<o;h++)c[h*a+l]=s[l*o+h];return c}function NE(n,e,t,i){if(i===0)for(let r=e+1;r<t;r++)n[r]+=n[e];if(i===2)for(let r=e+2;r<t;r++)n[r]+=n[r-1];if(i>0)for(let r=e+1;r<t;r++)n[r]+=n[r-1]}function zv(n,e,t,i){let r=i.length,s=new Float64Array(e*r);for(let o=0;o<e;o++)for(let a=0;a<r;a++){let c=i[a];for(let l=0;l<t.length;l++)c+=t[l][a]*n[o*t.length+l];s[o*r+a]=c}return s}function Gv(n){for(let e of n.channels){if(!e.curve)continue;let[t,i]=e.curve,[r,s]=e.from,{times:o,least:a,span:c}=n.curves[t],l=u=>({data:Float64Array.from({length:a.count},(g,M)=>r+s*u(M)),shape:[a.count],width:1,count:a.count}),h=(u,p)=>u.data[p*u.width+i];e.times=o,e.least=l(u=>h(a,u)),c&&e.least.data.some((u,p)=>h(c,p)!==0)&&(e.most=l(u=>h(a,u)+h(c,u)))}}var Hv="pitchpoint-scene-2",IE={f8:Float64Array,f4:Float32Array,i4:Int32Array,u4:Uint32Array,i2:Int16Array,u2:Uint16Array,u1:Uint8Array},hn=class extends Error{};function UE(n){let e;try{e=atob(n.trim())}catch{throw new hn("The data of this scene cannot be decoded (not base64). The file may be damaged.")}let t=new Uint8Array(e.length);for(let i=0;i<t.length;i++)t[i]=e.charCodeAt(i);return t}async function FE(n){if(typeof DecompressionStream>"u")throw new hn("This browser cannot decompress the data of the scene (no DecompressionStream). Use a newer browser.");try{let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip"));return await new Response(e).arrayBuffer()}catch{throw new hn("The data of this scene cannot be decompressed: the file is truncated or damaged.")}}function OE(n,e,t){let i=e?.type==="planes",r=i?Uint8Array:IE[e?.type],s=e?.shape;if(!r||!Array.isArray(s)||!s.length||s.some(w=>!Number.isInteger(w)||w<0))throw new hn(`This scene cannot be read: ${t} has an unknown type or shape.`);let o=s.reduce((w,S)=>w*S,1),a=e.at,c=i?o*e.bytes:o;if(!Number.isInteger(a)||a<0||a%8||!(a+c*r.BYTES_PER_ELEMENT<=n.byteLength))throw new hn(`This scene is truncated: ${t} is beyond the end of the data.`);let l=new r(n,a,c),h=i?kv(l,o,e):l,f=s[s.length-1],u=s.length>1?o/Math.max(s[0],1):1,p=s[0];if(!e.scale&&!e.offset)return{data:h,shape:s,width:u,count:p};let g=s.length>1?f:1,M=e.scale??Array(g).fill(1),m=!e.mix&&e.offset||Array(g).fill(0),d=new Float64Array(o);for(let w=0;w<o;w++)d[w]=m[w%g]+M[w%g]*h[w];if(e.exponent&&d.forEach((w,S)=>d[S]=Math.exp(w)),!e.mix)return{data:d,shape:s,width:u,count:p};let x=e.offset.length;return{data:zv(d,p,e.mix,e.offset),shape:[p,x],width:x,count:p}}function Hu(n,e,t,i=new Map){if(Array.isArray(n))return n.map((s,o)=>Hu(s,e,s?.name?`${t} ${s.name}`:`${t} ${o+1}`,i));if(n===null||typeof n!="object")return n;if("at"in n&&"type"in n&&"shape"in n){let s=JSON.stringify(n);return i.has(s)||i.set(s,OE(e,n,t)),i.get(s)}let r={};for(let[s,o]of Object.entries(n))r[s]=Hu(o,e,`${s} of ${t}`,i);return r}function li(n,e){if(!n)throw new hn(`This scene cannot be read: ${e}.`)}function BE(n){let e=n.times?.count??0,t=(i,r)=>li(!i||i.count===e||i.count===1,`${r} has ${i?.count} rows for ${e} times`);for(let{channel:i,lines:r,times:s,levels:o}of n.maps)li(r?.count>1&&s?.count>1&&o?.data.length===r.count*s.count,`the map of ${i} has ${o?.data.length} levels for ${r?.count} lines at ${s?.count} times`);n.bodies.forEach((i,r)=>{li(Number.isInteger(i.parent??-1)&&(i.parent??-1)<r,`body ${i.name} is listed before its parent`);for(let s of["position","travel","turn","spin","gross","quaternion"])t(i[s],`${s} of body ${i.name}`)});for(let i of n.solids){li(i.body>=-1&&i.body<n.bodies.length,`solid ${i.name} refers to an unknown body`);let r=i.pieces?i.pieces.flatMap(s=>s.levels??[]):[i];li(r.length,`solid ${i.name} has no surface`);for(let{points:s,triangles:o}of r){li(s?.width===3&&o?.width===3,`solid ${i.name} has no surface`);for(let a of o.data)li(a<s.count,`solid ${i.name} has a triangle with an invalid point index`)}for(let s of i.pieces??[])li(s.turns?.count,`solid ${i.name} has no positions`);if(i.modal){let{shapes:s,node:o,coordinates:a}=i.modal;li(s?.shape.length===3&&o?.count===i.points?.count,`solid ${i.name} has no deformation data`);for(let c of o.data)li(c<s.shape[1],`solid ${i.name} has a point with an invalid node index`);t(a,`the modal coordinates of ${i.name}`)}for(let s of i.between?.bodies??[])li(s>=-1&&s<n.bodies.length,`solid ${i.name} refers to an unknown body`);for(let s of i.blend?.bodies??[])li(s>=-1&&s<n.bodies.length,`the blend of ${i.name} refers to an unknown body`)}for(let i of n.arrows){li(i.body>=-1&&i.body<n.bodies.length,`arrow ${i.name} refers to an unknown body`);for(let r of["circumferential","radial","axial"])t(i.components?.[r],`the ${r} force ${i.name}`);t(i.at,`the position of arrow ${i.name}`),t(i.state,`the state of arrow ${i.name}`)}for(let i of n.contacts)kE(n,i,t);for(let i of n.channels){let r=i.least?.count;li(i.times&&r&&i.times.count===r&&(i.most?.count??r)===r,`channel ${i.name} has times and values of different length`)}}function kE(n,e,t){let{name:i}=e;for(let r of["at","axes","pressure_angle","penetration"])li(e[r],`contact ${i} has no ${r}`),t(e[r],`${r} of contact ${i}`);li(e.width?.length===2&&e.path?.length===2,`contact ${i} has no position`),li(!e.unit_pressure||e.unit_pressure.count>1,`contact ${i} has no pressures`),li(e.base_pitch>0&&e.flanks?.length,`contact ${i} has no flanks`);for(let r of e.flanks){li(r.travel?.count===n.times.count,`contact ${i} does not give the travel at each time`);for(let s of["forces","loads"])t(r[s],`${s} of contact ${i}`);li(!!r.forces==!!r.loads,`contact ${i} has forces without loads, or loads without forces`);for(let s of r.surfaces??[])li(s.body in n.bodies,`a flank of contact ${i} refers to an unknown body`),li(s.points?.shape.length===3&&s.teeth>0,`a flank of contact ${i} has no surface`)}}async function Vu(n=""){let e=document.getElementById(`pp-scene${n}`),t=document.getElementById(`pp-scene-numbers${n}`);if(!e||!t)throw new hn("This page contains no scene.");let i;try{i=JSON.parse(e.textContent??"")}catch{throw new hn("The header of this scene cannot be read: the file is truncated or damaged.")}if(i?.format!==Hv)throw new hn(`This scene has format "${i?.format}"; this viewer requires "${Hv}".`);let r=await FE(UE(t.textContent??"")),o={title:"",subtitle:"",up:[0,1,0],...{bodies:[],solids:[],arrows:[],contacts:[],channels:[],spectra:[],maps:[],marks:[],modes:[],notes:[]},...Hu(i,r,"this scene")};return Gv(o),BE(o),o}function Vv(n){let{player:e,stage:t,curves:i}=n,r=s=>[s.x,s.y,s.z];return{time:e.time,playing:e.playing,frame:e.frame,speed:e.speed,loop:e.loop,window:[...e.window],channels:[...i.plots.names],cursor:i.plots.drawn.map(({plot:s,line:o})=>({at:o.hidden?null:s.posToVal(new DOMMatrix(getComputedStyle(o).transform).m41,"x"),readings:[...o.closest(".ppv-plot").querySelectorAll("output")].map(a=>a.textContent)})),spectrum:i.spectra.state(),marks:n.transport.marks.length,message:n.area.querySelector(".ppv-message")?.textContent??null,drawn:t?.drawn??0,ratio:t?.ratio??0,section:n.section?{on:n.section.on,normal:r(n.section.normal),at:n.section.at}:null,mode:n.modes?.number??-1,following:n.views?.body??-1,camera:n.orbit?{position:r(t.camera.position),target:r(n.orbit.now.target),distance:n.orbit.now.distance,near:t.camera.near,far:t.camera.far}:null,pictures:(t?.pictures??[]).map(s=>({bodies:s.poses.world.map(o=>[...o.elements]),seen:[...s.seen.elements],factor:s.factor,target:r(t.targetOf(s,n.orbit.now.target)),magnification:s.poses.magnification,triangles:s.solids.triangles,drawnTriangles:s.solids.drawn,batches:s.solids.batches.length,contacts:s.flanks.state(),arrows:(s.arrows.now??[]).map((o,a)=>({name:o.name,kind:o.kind,state:o.state,at:r(o.at),vectors:Object.fromEntries(Object.entries(o.vectors).map(([c,l])=>[c,r(l)])),lengths:Object.fromEntries(Object.entries(s.arrows.drawn[a].parts).map(([c,l])=>[c,l.visible?new N().setFromMatrixColumn(l.matrix,2).length():0]))}))}))}}var ur=null;async function zE(n,{compare:e=!1}={}){document.getElementById("ppv-style")||document.head.append(J("style",{id:"ppv-style"},cd+hd));let t=J("div",{className:"ppv"}),i=J("p",{},"Reading the scene \u2026");t.append(J("div",{className:"ppv-message",role:"status"},i)),n.replaceChildren(t);try{let r=[await Vu()];return e&&r.push(await Vu("-2")),ur=new Jh(t,r),t.dataset.ready="scene",!0}catch(r){return i.textContent=r instanceof hn?r.message:`Internal error of the viewer: ${r instanceof Error?r.message:r}.`,t.replaceChildren(J("div",{className:"ppv-message",role:"alert"},i)),t.dataset.ready="failed",r instanceof hn||console.error(r),!1}}var ti=()=>{if(!ur)throw new Error("No scene is displayed.");return ur};function Wv(n){ur?.stage&&ur.stage.background.set(n?"#ffffff":getComputedStyle(ur.area).backgroundColor),ur&&!n&&ur.draw()}window.addEventListener("beforeprint",()=>Wv(!0));window.addEventListener("afterprint",()=>Wv(!1));window.pitchpointViewer={mount:zE,state:()=>ur?Vv(ur):null,seek:n=>ti().seek(n),play:()=>ti().toggle(!0),pause:()=>ti().toggle(!1),step:n=>ti().step(n),repeat:n=>ti().loop(n),advance:n=>ti().advance(n),follow:n=>ti().follow(n),look:(n,e,t)=>ti().views?.look(n,e,t),view:n=>ti().views?.named(n,!0),show:(n,e=!0)=>ti().curves.plots.show(n,e),spectrum:(n,e)=>ti().curves.spectrum(n,e),magnify:n=>ti().magnify(n),arrows:(n,e=!0)=>ti().arrows(n,e),lines:(n=!0)=>Uo(ti(),e=>e.showsLines=n),pattern:n=>Uo(ti(),e=>e.mode=n),shade:n=>Uo(ti(),e=>e.shade=e.pressures?n:"load"),gauge:(n,e)=>Qc(ti(),n,e),mode:n=>ti().modes.choose(n),file:(n,e=1)=>n==="png"?Ch(ti(),e):n==="glb"?Lh(ti()):Ph(ti()),draw:()=>{ti().orbit?.settle(),ti().draw()}};})();
