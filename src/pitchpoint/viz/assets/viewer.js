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
(()=>{var Fd='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var Od=`.ppv { --v-paper: var(--pp-paper, #fff); --v-ink: var(--pp-ink, #1f2933); --v-soft: var(--pp-soft, #5b6672); --v-grid: var(--pp-grid, #e3e7ec);
  --v-accent: #2f6fb3; --v-scene: #f3f5f8; --v-panel: #fff; --v-hover: rgba(31, 41, 51, .07);
  position: relative; display: flex; flex-direction: column; width: 100%; height: 100%; min-height: 240px; min-width: 0; overflow: hidden auto; box-sizing: border-box;
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
.ppv-scene { position: relative; flex: 1 1 62%; min-height: 120px; overflow: hidden; background: var(--v-scene); }
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
.ppv-scale { position: absolute; left: 8px; bottom: 5px; padding: 1px 5px 4px; font-size: 11px; color: var(--v-soft); pointer-events: none; display: grid; grid-template-rows: auto auto; grid-auto-flow: column; column-gap: 14px; }
.ppv-scale[hidden] { display: none; }
.ppv-scale i { display: block; height: 5px; border: 1px solid var(--v-soft); border-top: 0; }
.ppv-scale b { position: relative; display: block; margin-top: 2px; height: 0; border-top: 3px solid var(--v-soft); min-width: 9px; }
.ppv-scale b::after { content: ""; position: absolute; right: -2px; top: -6.5px; border: 5px solid transparent; border-left: 8px solid var(--v-soft); border-right: 0; }
.ppv-scale [hidden] { display: none; }
.ppv-status { position: absolute; left: 50%; bottom: 6px; padding: 1px 7px; transform: translateX(-50%); color: var(--v-soft); font-size: 12px; pointer-events: none; white-space: nowrap; }
.ppv-halves { position: absolute; inset: 0; display: flex; pointer-events: none; }
.ppv-half { position: relative; flex: 1; min-width: 0; container-type: inline-size; }
@container (max-width: 420px) { .ppv-flanks i, .ppv-ends { width: 130px; } .ppv-flanks .ppv-ends { font-size: 10px; } }
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
.ppv-bar { display: flex; gap: 6px; margin-left: auto; }
.ppv-bar button { border-color: var(--v-grid); background: var(--v-paper); }
.ppv-picker { position: relative; }
.ppv-picker input { width: 170px; }
.ppv-list { position: absolute; right: 0; bottom: 100%; width: min(340px, 80vw); max-height: 260px; overflow: auto; background: var(--v-paper); border: 1px solid var(--v-grid); border-radius: 8px; padding: 4px; display: flex; flex-direction: column; box-shadow: 0 3px 14px rgba(0, 0, 0, .12); }
.ppv-list button { text-align: left; white-space: normal; flex: none; background: none; border: 0; }
.ppv-list button[aria-selected="true"] { font-weight: 600; color: var(--v-accent); }
.ppv-list button[aria-selected="true"]::before { content: "\u2713 "; }
.ppv-list .ppv-unfold { color: var(--v-soft); font-size: 12px; padding: 0 8px 2px 20px; }
.ppv-list .ppv-member { padding-left: 28px; }
.ppv-list p, .ppv-none { margin: 6px 8px; color: var(--v-soft); }
.ppv-more { position: absolute; right: 14px; bottom: 2px; z-index: 2; background: var(--v-panel) !important; border-color: var(--v-grid) !important; font-size: 12px !important; padding: 1px 8px !important; }
.ppv-curves-body { flex: 1; min-height: 0; position: relative; }
.ppv-plots { display: grid; align-content: start; height: 100%; overflow-y: auto; overflow-x: hidden; scroll-snap-type: y mandatory; padding: 3px 0 0 4px; }
.ppv-plot { min-width: 0; scroll-snap-align: start; }
.ppv-spectra { padding: 4px; }
.ppv-spectra select { max-width: 260px; }
.ppv-maps:not([hidden]) { display: flex; position: relative; }
.ppv-maps .ppv-box { flex: 1; }
.ppv-maps .ppv-cursor { background: #fff; box-shadow: 0 0 0 1px rgb(0 0 0 / 55%); }
.ppv-map-scale { position: relative; flex: none; width: 92px; font-size: 11px; color: var(--v-soft); }
.ppv-map-scale i { position: absolute; left: 14px; top: 8px; bottom: 26px; width: 12px; border-radius: 2px; }
.ppv-map-scale span { position: absolute; left: 32px; top: 4px; }
.ppv-map-scale span:last-child { top: auto; bottom: 22px; }
.ppv-caption { display: flex; flex-wrap: wrap; gap: 0 14px; min-height: 20px; padding: 0 8px; font-size: 12px; align-items: center; }
.ppv-curve { display: inline-flex; flex-wrap: wrap; align-items: center; gap: 0 5px; min-width: 0; max-width: 100%; }
.ppv-curve > * { white-space: nowrap; }
.ppv-curve span { white-space: normal; min-width: 0; }
.ppv-curve .ppv-parting { border-color: var(--v-grid); margin: 1px 0; }
.ppv-curve i { width: 12px; height: 3px; border-radius: 2px; }
.ppv-curve output { font-variant-numeric: tabular-nums; font-weight: 600; }
.ppv-curve small, .ppv-spectra output { color: var(--v-soft); font-size: 12px; }
.ppv-curve button { padding: 0 4px; font-size: 12px; color: var(--v-soft); }
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
  .ppv-curve { white-space: normal; }
  .ppv-curve :is(output, small, button) { flex: none; white-space: nowrap; }
  .ppv-bar { margin-left: 0; }
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
`;function Y(n,e={},...t){let i=document.createElement(n);for(let[r,s]of Object.entries(e))s==null||s===!1||(r.startsWith("on")?i.addEventListener(r.slice(2),s):r in i&&r!=="list"&&typeof s!="string"?i[r]=s:i.setAttribute(r==="className"?"class":r,s===!0?"":String(s)));return i.append(...t.filter(r=>r!=null)),i}function xt(n,e,t,i={}){return Y("button",{type:"button",title:e,"aria-label":e,onclick:t,...i},n)}function _r({label:n,title:e,least:t,most:i,value:r,show:s,changed:o}){let a=Math.log(i/t),c=Y("output",{},s(r)),l=Y("input",{type:"range",min:"0",max:"1",step:"0.001",title:e,"aria-label":e}),h=()=>t*Math.exp(a*Number(l.value)),f=u=>{l.value=String(Math.log(u/t)/a),c.textContent=l.ariaValueText=s(u)};return l.addEventListener("input",()=>{let u=h();c.textContent=l.ariaValueText=s(u),o(u)}),f(r),{row:Y("label",{className:"ppv-slider"},Y("span",{},n),l,c),set:f,input:l}}function on(n,e,t,i=n){let r=Y("select",{title:i,"aria-label":i,onchange:()=>t(r.value)},...e.map(([s,o])=>Y("option",{value:s},o)));return{row:Y("label",{className:"ppv-choice"},Y("span",{},n),r),select:r}}function Cn(n,e,t,i=null){let r=Y("input",{type:"checkbox",checked:e,onchange:()=>t(r.checked)});return{row:Y("label",{className:"ppv-tick"},r,i,Y("span",{},n)),input:r}}var Bd=0,wf=1,kd=2;var Xs=1,zd=2,as=3,Yi=0,$t=1,Ei=2,sr=0,kr=1,Ef=2,Tf=3,Af=4,Gd=5;var zr=100,Hd=101,Vd=102,Wd=103,Xd=104,qd=200,Yd=201,$d=202,Kd=203,Ll=204,Dl=205,Zd=206,Jd=207,Qd=208,jd=209,ep=210,tp=211,ip=212,np=213,rp=214,sa=0,oa=1,ls=2,Gr=3,aa=4,la=5,ca=6,ha=7,qs=0,sp=1,op=2,gn=0,Nl=1,Il=2,Ul=3,Fl=4,Ol=5,Bl=6,kl=7;var Rf=300,or=301,Hr=302,zl=303,Gl=304,fa=1e3,an=1001,ua=1002,Qt=1003,ap=1004;var da=1005;var Mi=1006,Hl=1007;var xn=1008;var fi=1009,Vl=1010,Wl=1011,vr=1012,Ys=1013,Ui=1014,ui=1015,Fi=1016,$s=1017,Ks=1018,Wn=1020,Xl=35902,ql=35899,Yl=1021,$l=1022,Oi=1023,ln=1026,_n=1027,Zs=1028,Js=1029,vn=1030,Qs=1031;var js=1033,eo=33776,to=33777,io=33778,no=33779,pa=35840,ma=35841,ga=35842,xa=35843,_a=36196,va=37492,Ma=37496,Sa=37488,ya=37489,cs=37490,ba=37491,wa=37808,Ea=37809,Ta=37810,Aa=37811,Ra=37812,Ca=37813,Pa=37814,La=37815,Da=37816,Na=37817,Ia=37818,Ua=37819,Fa=37820,Oa=37821,Ba=36492,ka=36494,za=36495,Ga=36283,Ha=36284,hs=36285,Va=36286;var lp=3200;var Wa=0,cp=1,Pn="",rn="srgb",fs="srgb-linear",us="linear",vt="srgb";var Kl=7680,Cf=7681;var hp=34055,fp=34056;var up=514;var dp=517;var Zl=519,pp=512,mp=513,gp=514,Jl=515,xp=516,_p=517,Ql=518,jl=519,vp=35044,Mp=35048;var Pf="300 es",Wi=2e3,Mr=2001;function yp(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function so(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function bp(){let n=so("canvas");return n.style.display="block",n}var Sp={},ro=null;function Lf(...n){let e="THREE."+n.shift();ro?ro("log",e,...n):console.log(e,...n)}function wp(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Fe(...n){n=wp(n);let e="THREE."+n.shift();if(ro)ro("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function ut(...n){n=wp(n);let e="THREE."+n.shift();if(ro)ro("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ds(...n){let e=n.join(" ");e in Sp||(Sp[e]=!0,Fe(...n))}function Ep(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var Tp={[sa]:sa,[ls]:ca,[aa]:aa,[Gr]:la,[oa]:oa,[ca]:ls,[ha]:ha,[la]:Gr};var $i=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}};var Ki=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var ec=Math.PI/180,Xa=180/Math.PI;function ar(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Ki[n&255]+Ki[n>>8&255]+Ki[n>>16&255]+Ki[n>>24&255]+"-"+Ki[e&255]+Ki[e>>8&255]+"-"+Ki[e>>16&15|64]+Ki[e>>24&255]+"-"+Ki[t&63|128]+Ki[t>>8&255]+"-"+Ki[t>>16&255]+Ki[t>>24&255]+Ki[i&255]+Ki[i>>8&255]+Ki[i>>16&255]+Ki[i>>24&255]).toLowerCase()}function ct(n,e,t){return Math.max(e,Math.min(t,n))}function Ap(n,e){return(n%e+e)%e}function tc(n,e,t){return(1-t)*n+t*e}function Rp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function ic(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Cp(n,e){if(e.constructor===Float32Array)return n;let t=ic(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Pp(n,e){if(e.constructor===Float32Array)return n;let t=ic(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Ke=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};var Ut=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let c=i[r+0],l=i[r+1],h=i[r+2],f=i[r+3],u=s[o+0],d=s[o+1],g=s[o+2],x=s[o+3];if(f!==x||c!==u||l!==d||h!==g){let m=c*u+l*d+h*g+f*x;m<0&&(u=-u,d=-d,g=-g,x=-x,m=-m);let p=1-a;if(m<.9995){let _=Math.acos(m),y=Math.sin(_);p=Math.sin(p*_)/y,a=Math.sin(a*_)/y,c=c*p+u*a,l=l*p+d*a,h=h*p+g*a,f=f*p+x*a}else{c=c*p+u*a,l=l*p+d*a,h=h*p+g*a,f=f*p+x*a;let _=1/Math.sqrt(c*c+l*l+h*h+f*f);c*=_,l*=_,h*=_,f*=_}}e[t]=c,e[t+1]=l,e[t+2]=h,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],c=i[r+1],l=i[r+2],h=i[r+3],f=s[o],u=s[o+1],d=s[o+2],g=s[o+3];return e[t]=a*g+h*f+c*d-l*u,e[t+1]=c*g+h*u+l*f-a*d,e[t+2]=l*g+h*d+a*u-c*f,e[t+3]=h*g-a*f-c*u-l*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,c=Math.sin,l=a(i/2),h=a(r/2),f=a(s/2),u=c(i/2),d=c(r/2),g=c(s/2);switch(o){case"XYZ":this._x=u*h*f+l*d*g,this._y=l*d*f-u*h*g,this._z=l*h*g+u*d*f,this._w=l*h*f-u*d*g;break;case"YXZ":this._x=u*h*f+l*d*g,this._y=l*d*f-u*h*g,this._z=l*h*g-u*d*f,this._w=l*h*f+u*d*g;break;case"ZXY":this._x=u*h*f-l*d*g,this._y=l*d*f+u*h*g,this._z=l*h*g+u*d*f,this._w=l*h*f-u*d*g;break;case"ZYX":this._x=u*h*f-l*d*g,this._y=l*d*f+u*h*g,this._z=l*h*g-u*d*f,this._w=l*h*f+u*d*g;break;case"YZX":this._x=u*h*f+l*d*g,this._y=l*d*f+u*h*g,this._z=l*h*g-u*d*f,this._w=l*h*f-u*d*g;break;case"XZY":this._x=u*h*f-l*d*g,this._y=l*d*f-u*h*g,this._z=l*h*g+u*d*f,this._w=l*h*f+u*d*g;break;default:Fe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],c=t[9],l=t[2],h=t[6],f=t[10],u=i+a+f;if(u>0){let d=.5/Math.sqrt(u+1);this._w=.25/d,this._x=(h-c)*d,this._y=(s-l)*d,this._z=(o-r)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(h-c)/d,this._x=.25*d,this._y=(r+o)/d,this._z=(s+l)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(s-l)/d,this._x=(r+o)/d,this._y=.25*d,this._z=(c+h)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-r)/d,this._x=(s+l)/d,this._y=(c+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,c=t._y,l=t._z,h=t._w;return this._x=i*h+o*a+r*l-s*c,this._y=r*h+o*c+s*a-i*l,this._z=s*h+o*l+i*c-r*a,this._w=o*h-i*a-r*c-s*l,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let c=1-t;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,t=Math.sin(t*l)/h,this._x=this._x*c+i*t,this._y=this._y*c+r*t,this._z=this._z*c+s*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+i*t,this._y=this._y*c+r*t,this._z=this._z*c+s*t,this._w=this._w*c+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}};var C=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Lp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Lp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,c=e.w,l=2*(o*r-a*i),h=2*(a*t-s*r),f=2*(s*i-o*t);return this.x=t+c*l+o*f-a*h,this.y=i+c*h+a*l-s*f,this.z=r+c*f+s*h-o*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,c=t.z;return this.x=r*c-s*a,this.y=s*o-i*c,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Df.copy(this).projectOnVector(e),this.sub(Df)}reflect(e){return this.sub(Df.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Df=new C,Lp=new Ut;var $e=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,c,l)}set(e,t,i,r,s,o,a,c,l){let h=this.elements;return h[0]=e,h[1]=r,h[2]=a,h[3]=t,h[4]=s,h[5]=c,h[6]=i,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],h=i[4],f=i[7],u=i[2],d=i[5],g=i[8],x=r[0],m=r[3],p=r[6],_=r[1],y=r[4],S=r[7],R=r[2],A=r[5],v=r[8];return s[0]=o*x+a*_+c*R,s[3]=o*m+a*y+c*A,s[6]=o*p+a*S+c*v,s[1]=l*x+h*_+f*R,s[4]=l*m+h*y+f*A,s[7]=l*p+h*S+f*v,s[2]=u*x+d*_+g*R,s[5]=u*m+d*y+g*A,s[8]=u*p+d*S+g*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8];return t*o*h-t*a*l-i*s*h+i*a*c+r*s*l-r*o*c}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],f=h*o-a*l,u=a*c-h*s,d=l*s-o*c,g=t*f+i*u+r*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return e[0]=f*x,e[1]=(r*l-h*i)*x,e[2]=(a*i-r*o)*x,e[3]=u*x,e[4]=(h*t-r*c)*x,e[5]=(r*s-a*t)*x,e[6]=d*x,e[7]=(i*c-l*t)*x,e[8]=(o*t-i*s)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let c=Math.cos(s),l=Math.sin(s);return this.set(i*c,i*l,-i*(c*o+l*a)+o+e,-r*l,r*c,-r*(-l*o+c*a)+a+t,0,0,1),this}scale(e,t){return ds("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Nf.makeScale(e,t)),this}rotate(e){return ds("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Nf.makeRotation(-e)),this}translate(e,t){return ds("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Nf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Nf=new $e;var Dp=new $e().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Np=new $e().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function QM(){let n={enabled:!0,workingColorSpace:fs,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===vt&&(r.r=Xn(r.r),r.g=Xn(r.g),r.b=Xn(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===vt&&(r.r=ps(r.r),r.g=ps(r.g),r.b=ps(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Pn?us:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[fs]:{primaries:e,whitePoint:i,transfer:us,toXYZ:Dp,fromXYZ:Np,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:rn},outputColorSpaceConfig:{drawingBufferColorSpace:rn}},[rn]:{primaries:e,whitePoint:i,transfer:vt,toXYZ:Dp,fromXYZ:Np,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:rn}}}),n}var ot=QM();function Xn(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ps(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var oo,nc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{oo===void 0&&(oo=so("canvas")),oo.width=e.width,oo.height=e.height;let r=oo.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=oo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=so("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Xn(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Xn(t[i]/255)*255):t[i]=Xn(t[i]);return{data:t,width:e.width,height:e.height}}else return Fe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}};var jM=0,Vr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:jM++}),this.uuid=ar(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(If(r[o].image)):s.push(If(r[o]))}else s=If(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function If(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?nc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Fe("Texture: Unable to serialize Texture."),{})}var eS=0,Uf=new C,di=class n extends $i{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=an,r=an,s=Mi,o=xn,a=Oi,c=fi,l=n.DEFAULT_ANISOTROPY,h=Pn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:eS++}),this.uuid=ar(),this.name="",this.source=new Vr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new $e,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Uf).x}get height(){return this.source.getSize(Uf).y}get depth(){return this.source.getSize(Uf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Fe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Fe(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Rf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case fa:e.x=e.x-Math.floor(e.x);break;case an:e.x=e.x<0?0:1;break;case ua:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case fa:e.y=e.y-Math.floor(e.y);break;case an:e.y=e.y<0?0:1;break;case ua:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};di.DEFAULT_IMAGE=null;di.DEFAULT_MAPPING=Rf;di.DEFAULT_ANISOTROPY=1;var Et=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,c=e.elements,l=c[0],h=c[4],f=c[8],u=c[1],d=c[5],g=c[9],x=c[2],m=c[6],p=c[10];if(Math.abs(h-u)<.01&&Math.abs(f-x)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(f+x)<.1&&Math.abs(g+m)<.1&&Math.abs(l+d+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let y=(l+1)/2,S=(d+1)/2,R=(p+1)/2,A=(h+u)/4,v=(f+x)/4,E=(g+m)/4;return y>S&&y>R?y<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(y),r=A/i,s=v/i):S>R?S<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(S),i=A/r,s=E/r):R<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(R),i=v/s,r=E/s),this.set(i,r,s,t),this}let _=Math.sqrt((m-g)*(m-g)+(f-x)*(f-x)+(u-h)*(u-h));return Math.abs(_)<.001&&(_=1),this.x=(m-g)/_,this.y=(f-x)/_,this.z=(u-h)/_,this.w=Math.acos((l+d+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};var rc=class extends $i{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Mi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Et(0,0,e,t),this.scissorTest=!1,this.viewport=new Et(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new di({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Mi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Vr(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Xi=class extends rc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}};var ao=class extends di{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Qt,this.minFilter=Qt,this.wrapR=an,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var sc=class extends di{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Qt,this.minFilter=Qt,this.wrapR=an,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var ye=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,c,l,h,f,u,d,g,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,c,l,h,f,u,d,g,x,m)}set(e,t,i,r,s,o,a,c,l,h,f,u,d,g,x,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=r,p[1]=s,p[5]=o,p[9]=a,p[13]=c,p[2]=l,p[6]=h,p[10]=f,p[14]=u,p[3]=d,p[7]=g,p[11]=x,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/lo.setFromMatrixColumn(e,0).length(),s=1/lo.setFromMatrixColumn(e,1).length(),o=1/lo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(r),l=Math.sin(r),h=Math.cos(s),f=Math.sin(s);if(e.order==="XYZ"){let u=o*h,d=o*f,g=a*h,x=a*f;t[0]=c*h,t[4]=-c*f,t[8]=l,t[1]=d+g*l,t[5]=u-x*l,t[9]=-a*c,t[2]=x-u*l,t[6]=g+d*l,t[10]=o*c}else if(e.order==="YXZ"){let u=c*h,d=c*f,g=l*h,x=l*f;t[0]=u+x*a,t[4]=g*a-d,t[8]=o*l,t[1]=o*f,t[5]=o*h,t[9]=-a,t[2]=d*a-g,t[6]=x+u*a,t[10]=o*c}else if(e.order==="ZXY"){let u=c*h,d=c*f,g=l*h,x=l*f;t[0]=u-x*a,t[4]=-o*f,t[8]=g+d*a,t[1]=d+g*a,t[5]=o*h,t[9]=x-u*a,t[2]=-o*l,t[6]=a,t[10]=o*c}else if(e.order==="ZYX"){let u=o*h,d=o*f,g=a*h,x=a*f;t[0]=c*h,t[4]=g*l-d,t[8]=u*l+x,t[1]=c*f,t[5]=x*l+u,t[9]=d*l-g,t[2]=-l,t[6]=a*c,t[10]=o*c}else if(e.order==="YZX"){let u=o*c,d=o*l,g=a*c,x=a*l;t[0]=c*h,t[4]=x-u*f,t[8]=g*f+d,t[1]=f,t[5]=o*h,t[9]=-a*h,t[2]=-l*h,t[6]=d*f+g,t[10]=u-x*f}else if(e.order==="XZY"){let u=o*c,d=o*l,g=a*c,x=a*l;t[0]=c*h,t[4]=-f,t[8]=l*h,t[1]=u*f+x,t[5]=o*h,t[9]=d*f-g,t[2]=g*f-d,t[6]=a*h,t[10]=x*f+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(tS,e,iS)}lookAt(e,t,i){let r=this.elements;return Mn.subVectors(e,t),Mn.lengthSq()===0&&(Mn.z=1),Mn.normalize(),Wr.crossVectors(i,Mn),Wr.lengthSq()===0&&(Math.abs(i.z)===1?Mn.x+=1e-4:Mn.z+=1e-4,Mn.normalize(),Wr.crossVectors(i,Mn)),Wr.normalize(),oc.crossVectors(Mn,Wr),r[0]=Wr.x,r[4]=oc.x,r[8]=Mn.x,r[1]=Wr.y,r[5]=oc.y,r[9]=Mn.y,r[2]=Wr.z,r[6]=oc.z,r[10]=Mn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],h=i[1],f=i[5],u=i[9],d=i[13],g=i[2],x=i[6],m=i[10],p=i[14],_=i[3],y=i[7],S=i[11],R=i[15],A=r[0],v=r[4],E=r[8],F=r[12],D=r[1],N=r[5],k=r[9],G=r[13],I=r[2],W=r[6],$=r[10],V=r[14],ce=r[3],J=r[7],j=r[11],re=r[15];return s[0]=o*A+a*D+c*I+l*ce,s[4]=o*v+a*N+c*W+l*J,s[8]=o*E+a*k+c*$+l*j,s[12]=o*F+a*G+c*V+l*re,s[1]=h*A+f*D+u*I+d*ce,s[5]=h*v+f*N+u*W+d*J,s[9]=h*E+f*k+u*$+d*j,s[13]=h*F+f*G+u*V+d*re,s[2]=g*A+x*D+m*I+p*ce,s[6]=g*v+x*N+m*W+p*J,s[10]=g*E+x*k+m*$+p*j,s[14]=g*F+x*G+m*V+p*re,s[3]=_*A+y*D+S*I+R*ce,s[7]=_*v+y*N+S*W+R*J,s[11]=_*E+y*k+S*$+R*j,s[15]=_*F+y*G+S*V+R*re,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],c=e[9],l=e[13],h=e[2],f=e[6],u=e[10],d=e[14],g=e[3],x=e[7],m=e[11],p=e[15],_=c*d-l*u,y=a*d-l*f,S=a*u-c*f,R=o*d-l*h,A=o*u-c*h,v=o*f-a*h;return t*(x*_-m*y+p*S)-i*(g*_-m*R+p*A)+r*(g*y-x*R+p*v)-s*(g*S-x*A+m*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],c=e[2],l=e[6],h=e[10];return t*(o*h-a*l)-i*(s*h-a*c)+r*(s*l-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],f=e[9],u=e[10],d=e[11],g=e[12],x=e[13],m=e[14],p=e[15],_=t*a-i*o,y=t*c-r*o,S=t*l-s*o,R=i*c-r*a,A=i*l-s*a,v=r*l-s*c,E=h*x-f*g,F=h*m-u*g,D=h*p-d*g,N=f*m-u*x,k=f*p-d*x,G=u*p-d*m,I=_*G-y*k+S*N+R*D-A*F+v*E;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/I;return e[0]=(a*G-c*k+l*N)*W,e[1]=(r*k-i*G-s*N)*W,e[2]=(x*v-m*A+p*R)*W,e[3]=(u*A-f*v-d*R)*W,e[4]=(c*D-o*G-l*F)*W,e[5]=(t*G-r*D+s*F)*W,e[6]=(m*S-g*v-p*y)*W,e[7]=(h*v-u*S+d*y)*W,e[8]=(o*k-a*D+l*E)*W,e[9]=(i*D-t*k-s*E)*W,e[10]=(g*A-x*S+p*_)*W,e[11]=(f*S-h*A-d*_)*W,e[12]=(a*F-o*N-c*E)*W,e[13]=(t*N-i*F+r*E)*W,e[14]=(x*y-g*R-m*_)*W,e[15]=(h*R-f*y+u*_)*W,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,c=e.z,l=s*o,h=s*a;return this.set(l*o+i,l*a-r*c,l*c+r*a,0,l*a+r*c,h*a+i,h*c-r*o,0,l*c-r*a,h*c+r*o,s*c*c+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,c=t._w,l=s+s,h=o+o,f=a+a,u=s*l,d=s*h,g=s*f,x=o*h,m=o*f,p=a*f,_=c*l,y=c*h,S=c*f,R=i.x,A=i.y,v=i.z;return r[0]=(1-(x+p))*R,r[1]=(d+S)*R,r[2]=(g-y)*R,r[3]=0,r[4]=(d-S)*A,r[5]=(1-(u+p))*A,r[6]=(m+_)*A,r[7]=0,r[8]=(g+y)*v,r[9]=(m-_)*v,r[10]=(1-(u+x))*v,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=lo.set(r[0],r[1],r[2]).length(),a=lo.set(r[4],r[5],r[6]).length(),c=lo.set(r[8],r[9],r[10]).length();s<0&&(o=-o),qn.copy(this);let l=1/o,h=1/a,f=1/c;return qn.elements[0]*=l,qn.elements[1]*=l,qn.elements[2]*=l,qn.elements[4]*=h,qn.elements[5]*=h,qn.elements[6]*=h,qn.elements[8]*=f,qn.elements[9]*=f,qn.elements[10]*=f,t.setFromRotationMatrix(qn),i.x=o,i.y=a,i.z=c,this}makePerspective(e,t,i,r,s,o,a=Wi,c=!1){let l=this.elements,h=2*s/(t-e),f=2*s/(i-r),u=(t+e)/(t-e),d=(i+r)/(i-r),g,x;if(c)g=s/(o-s),x=o*s/(o-s);else if(a===Wi)g=-(o+s)/(o-s),x=-2*o*s/(o-s);else if(a===Mr)g=-o/(o-s),x=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=f,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=x,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=Wi,c=!1){let l=this.elements,h=2/(t-e),f=2/(i-r),u=-(t+e)/(t-e),d=-(i+r)/(i-r),g,x;if(c)g=1/(o-s),x=o/(o-s);else if(a===Wi)g=-2/(o-s),x=-(o+s)/(o-s);else if(a===Mr)g=-1/(o-s),x=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=u,l[1]=0,l[5]=f,l[9]=0,l[13]=d,l[2]=0,l[6]=0,l[10]=g,l[14]=x,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},lo=new C,qn=new ye,tS=new C(0,0,0),iS=new C(1,1,1),Wr=new C,oc=new C,Mn=new C;var Ip=new ye,Up=new Ut,Ln=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],c=r[1],l=r[5],h=r[9],f=r[2],u=r[6],d=r[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(u,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,s),this._z=0);break;case"ZXY":this._x=Math.asin(ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,s));break;case"ZYX":this._y=Math.asin(-ct(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(u,d),this._z=Math.atan2(c,s)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ct(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-f,s)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,l),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-h,d),this._y=0);break;default:Fe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Ip.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Ip,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Up.setFromEuler(this),this.setFromQuaternion(Up,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ln.DEFAULT_ORDER="XYZ";var Xr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}};var nS=0,Fp=new C,co=new Ut,Sr=new ye,ac=new C,qa=new C,rS=new C,sS=new Ut,Op=new C(1,0,0),Bp=new C(0,1,0),kp=new C(0,0,1),zp={type:"added"},oS={type:"removed"},ho={type:"childadded",child:null},Ff={type:"childremoved",child:null},Vt=class n extends $i{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:nS++}),this.uuid=ar(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new C,t=new Ln,i=new Ut,r=new C(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new ye},normalMatrix:{value:new $e}}),this.matrix=new ye,this.matrixWorld=new ye,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Xr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return co.setFromAxisAngle(e,t),this.quaternion.multiply(co),this}rotateOnWorldAxis(e,t){return co.setFromAxisAngle(e,t),this.quaternion.premultiply(co),this}rotateX(e){return this.rotateOnAxis(Op,e)}rotateY(e){return this.rotateOnAxis(Bp,e)}rotateZ(e){return this.rotateOnAxis(kp,e)}translateOnAxis(e,t){return Fp.copy(e).applyQuaternion(this.quaternion),this.position.add(Fp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Op,e)}translateY(e){return this.translateOnAxis(Bp,e)}translateZ(e){return this.translateOnAxis(kp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Sr.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?ac.copy(e):ac.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),qa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Sr.lookAt(qa,ac,this.up):Sr.lookAt(ac,qa,this.up),this.quaternion.setFromRotationMatrix(Sr),r&&(Sr.extractRotation(r.matrixWorld),co.setFromRotationMatrix(Sr),this.quaternion.premultiply(co.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ut("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(zp),ho.child=e,this.dispatchEvent(ho),ho.child=null):ut("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(oS),Ff.child=e,this.dispatchEvent(Ff),Ff.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Sr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Sr.multiply(e.parent.matrixWorld)),e.applyMatrix4(Sr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(zp),ho.child=e,this.dispatchEvent(ho),ho.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qa,e,rS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qa,sS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let f=c[l];s(e.shapes,f)}else s(e.shapes,c)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(s(e.materials,this.material[c]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];r.animations.push(s(e.animations,c))}}if(t){let a=o(e.geometries),c=o(e.materials),l=o(e.textures),h=o(e.images),f=o(e.shapes),u=o(e.skeletons),d=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),h.length>0&&(i.images=h),f.length>0&&(i.shapes=f),u.length>0&&(i.skeletons=u),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=r,i;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Vt.DEFAULT_UP=new C(0,1,0);Vt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Vt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Sn=class extends Vt{constructor(){super(),this.isGroup=!0,this.type="Group"}};var aS={type:"move"},fo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Sn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Sn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new C,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new C),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Sn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new C,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new C,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){o=!0;for(let x of e.hand.values()){let m=t.getJointPose(x,i),p=this._getHandJoint(l,x);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],u=h.position.distanceTo(f.position),d=.02,g=.005;l.inputState.pinching&&u>d+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&u<=d-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(c.matrix.fromArray(s.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,s.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(s.linearVelocity)):c.hasLinearVelocity=!1,s.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(s.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(aS)))}return a!==null&&(a.visible=r!==null),c!==null&&(c.visible=s!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Sn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}};var Gp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},qr={h:0,s:0,l:0},lc={h:0,s:0,l:0};function Of(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var ke=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=rn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,ot.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=ot.workingColorSpace){return this.r=e,this.g=t,this.b=i,ot.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=ot.workingColorSpace){if(e=Ap(e,1),t=ct(t,0,1),i=ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=Of(o,s,e+1/3),this.g=Of(o,s,e),this.b=Of(o,s,e-1/3)}return ot.colorSpaceToWorking(this,r),this}setStyle(e,t=rn){function i(s){s!==void 0&&parseFloat(s)<1&&Fe("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Fe("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);Fe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=rn){let i=Gp[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Fe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Xn(e.r),this.g=Xn(e.g),this.b=Xn(e.b),this}copyLinearToSRGB(e){return this.r=ps(e.r),this.g=ps(e.g),this.b=ps(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=rn){return ot.workingToColorSpace(Zi.copy(this),e),Math.round(ct(Zi.r*255,0,255))*65536+Math.round(ct(Zi.g*255,0,255))*256+Math.round(ct(Zi.b*255,0,255))}getHexString(e=rn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=ot.workingColorSpace){ot.workingToColorSpace(Zi.copy(this),t);let i=Zi.r,r=Zi.g,s=Zi.b,o=Math.max(i,r,s),a=Math.min(i,r,s),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let f=o-a;switch(l=h<=.5?f/(o+a):f/(2-o-a),o){case i:c=(r-s)/f+(r<s?6:0);break;case r:c=(s-i)/f+2;break;case s:c=(i-r)/f+4;break}c/=6}return e.h=c,e.s=l,e.l=h,e}getRGB(e,t=ot.workingColorSpace){return ot.workingToColorSpace(Zi.copy(this),t),e.r=Zi.r,e.g=Zi.g,e.b=Zi.b,e}getStyle(e=rn){ot.workingToColorSpace(Zi.copy(this),e);let t=Zi.r,i=Zi.g,r=Zi.b;return e!==rn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(qr),this.setHSL(qr.h+e,qr.s+t,qr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(qr),e.getHSL(lc);let i=tc(qr.h,lc.h,t),r=tc(qr.s,lc.s,t),s=tc(qr.l,lc.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Zi=new ke;ke.NAMES=Gp;var uo=class extends Vt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ln,this.environmentIntensity=1,this.environmentRotation=new Ln,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}};var Yn=new C,yr=new C,Bf=new C,br=new C,po=new C,mo=new C,Hp=new C,kf=new C,zf=new C,Gf=new C,Hf=new Et,Vf=new Et,Wf=new Et,Yr=class n{constructor(e=new C,t=new C,i=new C){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),Yn.subVectors(e,t),r.cross(Yn);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){Yn.subVectors(r,t),yr.subVectors(i,t),Bf.subVectors(e,t);let o=Yn.dot(Yn),a=Yn.dot(yr),c=Yn.dot(Bf),l=yr.dot(yr),h=yr.dot(Bf),f=o*l-a*a;if(f===0)return s.set(0,0,0),null;let u=1/f,d=(l*c-a*h)*u,g=(o*h-a*c)*u;return s.set(1-d-g,g,d)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,br)===null?!1:br.x>=0&&br.y>=0&&br.x+br.y<=1}static getInterpolation(e,t,i,r,s,o,a,c){return this.getBarycoord(e,t,i,r,br)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(s,br.x),c.addScaledVector(o,br.y),c.addScaledVector(a,br.z),c)}static getInterpolatedAttribute(e,t,i,r,s,o){return Hf.setScalar(0),Vf.setScalar(0),Wf.setScalar(0),Hf.fromBufferAttribute(e,t),Vf.fromBufferAttribute(e,i),Wf.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(Hf,s.x),o.addScaledVector(Vf,s.y),o.addScaledVector(Wf,s.z),o}static isFrontFacing(e,t,i,r){return Yn.subVectors(i,t),yr.subVectors(e,t),Yn.cross(yr).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Yn.subVectors(this.c,this.b),yr.subVectors(this.a,this.b),Yn.cross(yr).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;po.subVectors(r,i),mo.subVectors(s,i),kf.subVectors(e,i);let c=po.dot(kf),l=mo.dot(kf);if(c<=0&&l<=0)return t.copy(i);zf.subVectors(e,r);let h=po.dot(zf),f=mo.dot(zf);if(h>=0&&f<=h)return t.copy(r);let u=c*f-h*l;if(u<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),t.copy(i).addScaledVector(po,o);Gf.subVectors(e,s);let d=po.dot(Gf),g=mo.dot(Gf);if(g>=0&&d<=g)return t.copy(s);let x=d*l-c*g;if(x<=0&&l>=0&&g<=0)return a=l/(l-g),t.copy(i).addScaledVector(mo,a);let m=h*g-d*f;if(m<=0&&f-h>=0&&d-g>=0)return Hp.subVectors(s,r),a=(f-h)/(f-h+(d-g)),t.copy(r).addScaledVector(Hp,a);let p=1/(m+x+u);return o=x*p,a=u*p,t.copy(i).addScaledVector(po,o).addScaledVector(mo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}};var Dn=class{constructor(e=new C(1/0,1/0,1/0),t=new C(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint($n.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint($n.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=$n.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,$n):$n.fromBufferAttribute(s,o),$n.applyMatrix4(e.matrixWorld),this.expandByPoint($n);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),cc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),cc.copy(i.boundingBox)),cc.applyMatrix4(e.matrixWorld),this.union(cc)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,$n),$n.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ya),hc.subVectors(this.max,Ya),go.subVectors(e.a,Ya),xo.subVectors(e.b,Ya),_o.subVectors(e.c,Ya),$r.subVectors(xo,go),Kr.subVectors(_o,xo),ms.subVectors(go,_o);let t=[0,-$r.z,$r.y,0,-Kr.z,Kr.y,0,-ms.z,ms.y,$r.z,0,-$r.x,Kr.z,0,-Kr.x,ms.z,0,-ms.x,-$r.y,$r.x,0,-Kr.y,Kr.x,0,-ms.y,ms.x,0];return!Xf(t,go,xo,_o,hc)||(t=[1,0,0,0,1,0,0,0,1],!Xf(t,go,xo,_o,hc))?!1:(fc.crossVectors($r,Kr),t=[fc.x,fc.y,fc.z],Xf(t,go,xo,_o,hc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,$n).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize($n).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(wr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),wr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),wr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),wr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),wr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),wr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),wr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),wr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(wr),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},wr=[new C,new C,new C,new C,new C,new C,new C,new C],$n=new C,cc=new Dn,go=new C,xo=new C,_o=new C,$r=new C,Kr=new C,ms=new C,Ya=new C,hc=new C,fc=new C,gs=new C;function Xf(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){gs.fromArray(n,s);let a=r.x*Math.abs(gs.x)+r.y*Math.abs(gs.y)+r.z*Math.abs(gs.z),c=e.dot(gs),l=t.dot(gs),h=i.dot(gs);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var Si=new C,uc=new Ke,lS=0,Pt=class extends $i{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:lS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=vp,this.updateRanges=[],this.gpuType=ui,this.version=0,this._normalizationScale=e!==void 0?ic(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)uc.fromBufferAttribute(this,t),uc.applyMatrix3(e),this.setXY(t,uc.x,uc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.applyMatrix3(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.applyMatrix4(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.applyNormalMatrix(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Si.fromBufferAttribute(this,t),Si.transformDirection(e),this.setXYZ(t,Si.x,Si.y,Si.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Cp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Pp(e,this.array)}};var vo=class extends Pt{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Mo=class extends Pt{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var bt=class extends Pt{constructor(e,t,i){super(new Float32Array(e),t,i)}};var cS=new Dn,$a=new C,qf=new C,Bi=class{constructor(e=new C,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):cS.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;$a.subVectors(e,this.center);let t=$a.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector($a,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(qf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint($a.copy(e.center).add(qf)),this.expandByPoint($a.copy(e.center).sub(qf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}};var hS=0,Nn=new ye,Yf=new Vt,So=new C,yn=new Dn,Ka=new Dn,ki=new C,Tt=class n extends $i{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:hS++}),this.uuid=ar(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(yp(e)?Mo:vo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new $e().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Nn.makeRotationFromQuaternion(e),this.applyMatrix4(Nn),this}rotateX(e){return Nn.makeRotationX(e),this.applyMatrix4(Nn),this}rotateY(e){return Nn.makeRotationY(e),this.applyMatrix4(Nn),this}rotateZ(e){return Nn.makeRotationZ(e),this.applyMatrix4(Nn),this}translate(e,t,i){return Nn.makeTranslation(e,t,i),this.applyMatrix4(Nn),this}scale(e,t,i){return Nn.makeScale(e,t,i),this.applyMatrix4(Nn),this}lookAt(e){return Yf.lookAt(e),Yf.updateMatrix(),this.applyMatrix4(Yf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(So).negate(),this.translate(So.x,So.y,So.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new bt(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Fe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Dn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ut("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new C(-1/0,-1/0,-1/0),new C(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];yn.setFromBufferAttribute(s),this.morphTargetsRelative?(ki.addVectors(this.boundingBox.min,yn.min),this.boundingBox.expandByPoint(ki),ki.addVectors(this.boundingBox.max,yn.max),this.boundingBox.expandByPoint(ki)):(this.boundingBox.expandByPoint(yn.min),this.boundingBox.expandByPoint(yn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ut('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Bi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ut("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new C,1/0);return}if(e){let i=this.boundingSphere.center;if(yn.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];Ka.setFromBufferAttribute(a),this.morphTargetsRelative?(ki.addVectors(yn.min,Ka.min),yn.expandByPoint(ki),ki.addVectors(yn.max,Ka.max),yn.expandByPoint(ki)):(yn.expandByPoint(Ka.min),yn.expandByPoint(Ka.max))}yn.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)ki.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(ki));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)ki.fromBufferAttribute(a,l),c&&(So.fromBufferAttribute(e,l),ki.add(So)),r=Math.max(r,i.distanceToSquared(ki))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&ut('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ut("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Pt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let F=0;F<i.count;F++)a[F]=new C,c[F]=new C;let h=new C,f=new C,u=new C,d=new Ke,g=new Ke,x=new Ke,m=new C,p=new C;function _(F,D,N){l[F]=l[D]=l[N]=1,h.fromBufferAttribute(i,F),f.fromBufferAttribute(i,D),u.fromBufferAttribute(i,N),d.fromBufferAttribute(s,F),g.fromBufferAttribute(s,D),x.fromBufferAttribute(s,N),f.sub(h),u.sub(h),g.sub(d),x.sub(d);let k=1/(g.x*x.y-x.x*g.y);isFinite(k)&&(m.copy(f).multiplyScalar(x.y).addScaledVector(u,-g.y).multiplyScalar(k),p.copy(u).multiplyScalar(g.x).addScaledVector(f,-x.x).multiplyScalar(k),a[F].add(m),a[D].add(m),a[N].add(m),c[F].add(p),c[D].add(p),c[N].add(p))}let y=this.groups;y.length===0&&(y=[{start:0,count:e.count}]);for(let F=0,D=y.length;F<D;++F){let N=y[F],k=N.start,G=N.count;for(let I=k,W=k+G;I<W;I+=3)_(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let S=new C,R=new C,A=new C,v=new C;function E(F){A.fromBufferAttribute(r,F),v.copy(A);let D=a[F];S.copy(D),S.sub(A.multiplyScalar(A.dot(D))).normalize(),R.crossVectors(v,D);let k=R.dot(c[F])<0?-1:1;o.setXYZW(F,S.x,S.y,S.z,k)}for(let F=0,D=i.count;F<D;++F)l[F]&&E(F);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Pt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let u=0,d=i.count;u<d;u++)i.setXYZ(u,0,0,0);let r=new C,s=new C,o=new C,a=new C,c=new C,l=new C,h=new C,f=new C;if(e)for(let u=0,d=e.count;u<d;u+=3){let g=e.getX(u+0),x=e.getX(u+1),m=e.getX(u+2);r.fromBufferAttribute(t,g),s.fromBufferAttribute(t,x),o.fromBufferAttribute(t,m),h.subVectors(o,s),f.subVectors(r,s),h.cross(f),a.fromBufferAttribute(i,g),c.fromBufferAttribute(i,x),l.fromBufferAttribute(i,m),a.add(h),c.add(h),l.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(x,c.x,c.y,c.z),i.setXYZ(m,l.x,l.y,l.z)}else for(let u=0,d=t.count;u<d;u+=3)r.fromBufferAttribute(t,u+0),s.fromBufferAttribute(t,u+1),o.fromBufferAttribute(t,u+2),h.subVectors(o,s),f.subVectors(r,s),h.cross(f),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)ki.fromBufferAttribute(e,t),ki.normalize(),e.setXYZ(t,ki.x,ki.y,ki.z)}toNonIndexed(){function e(a,c){let l=a.array,h=a.itemSize,f=a.normalized,u=new l.constructor(c.length*h),d=0,g=0;for(let x=0,m=c.length;x<m;x++){a.isInterleavedBufferAttribute?d=c[x]*a.data.stride+a.offset:d=c[x]*h;for(let p=0;p<h;p++)u[g++]=l[d++]}return new Pt(u,h,f)}if(this.index===null)return Fe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let c=r[a],l=e(c,i);t.setAttribute(a,l)}let s=this.morphAttributes;for(let a in s){let c=[],l=s[a];for(let h=0,f=l.length;h<f;h++){let u=l[h],d=e(u,i);c.push(d)}t.morphAttributes[a]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let c in i){let l=i[c];e.data.attributes[c]=l.toJSON(e.data)}let r={},s=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let f=0,u=l.length;f<u;f++){let d=l[f];h.push(d.toJSON(e.data))}h.length>0&&(r[c]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let l in r){let h=r[l];this.setAttribute(l,h.clone(t))}let s=e.morphAttributes;for(let l in s){let h=[],f=s[l];for(let u=0,d=f.length;u<d;u++)h.push(f[u].clone(t));this.morphAttributes[l]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let l=0,h=o.length;l<h;l++){let f=o[l];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var $f=new C,fS=new C,uS=new $e,zi=class{constructor(e=new C(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=$f.subVectors(i,t).cross(fS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta($f),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||uS.getNormalMatrix(e),r=this.coplanarPoint($f).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}};var dS=0,cn=class extends $i{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:dS++}),this.uuid=ar(),this.name="",this.type="Material",this.blending=kr,this.side=Yi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ll,this.blendDst=Dl,this.blendEquation=zr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ke(0,0,0),this.blendAlpha=0,this.depthFunc=Gr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Zl,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Kl,this.stencilZFail=Kl,this.stencilZPass=Kl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Fe(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Fe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let c=s[a];delete c.metadata,o.push(c)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ke().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new zi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ke().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Er=new C,Kf=new C,dc=new C,pc=new C,Zr=class{constructor(e=new C,t=new C(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Er)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Er.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Er.copy(this.origin).addScaledVector(this.direction,t),Er.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){Kf.copy(e).add(t).multiplyScalar(.5),dc.copy(t).sub(e).normalize(),pc.copy(this.origin).sub(Kf);let s=e.distanceTo(t)*.5,o=-this.direction.dot(dc),a=pc.dot(this.direction),c=-pc.dot(dc),l=pc.lengthSq(),h=Math.abs(1-o*o),f,u,d,g;if(h>0)if(f=o*c-a,u=o*a-c,g=s*h,f>=0)if(u>=-g)if(u<=g){let x=1/h;f*=x,u*=x,d=f*(f+o*u+2*a)+u*(o*f+u+2*c)+l}else u=s,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*c)+l;else u=-s,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*c)+l;else u<=-g?(f=Math.max(0,-(-o*s+a)),u=f>0?-s:Math.min(Math.max(-s,-c),s),d=-f*f+u*(u+2*c)+l):u<=g?(f=0,u=Math.min(Math.max(-s,-c),s),d=u*(u+2*c)+l):(f=Math.max(0,-(o*s+a)),u=f>0?s:Math.min(Math.max(-s,-c),s),d=-f*f+u*(u+2*c)+l);else u=o>0?-s:s,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,f),r&&r.copy(Kf).addScaledVector(dc,u),d}intersectSphere(e,t){if(e.radius<0)return null;Er.subVectors(e.center,this.origin);let i=Er.dot(this.direction),r=Er.dot(Er)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,c,l=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,u=this.origin;return l>=0?(i=(e.min.x-u.x)*l,r=(e.max.x-u.x)*l):(i=(e.max.x-u.x)*l,r=(e.min.x-u.x)*l),h>=0?(s=(e.min.y-u.y)*h,o=(e.max.y-u.y)*h):(s=(e.max.y-u.y)*h,o=(e.min.y-u.y)*h),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),f>=0?(a=(e.min.z-u.z)*f,c=(e.max.z-u.z)*f):(a=(e.max.z-u.z)*f,c=(e.min.z-u.z)*f),i>c||a>r)||((a>i||i!==i)&&(i=a),(c<r||r!==r)&&(r=c),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,Er)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,f=e.x-o.x,u=e.y-o.y,d=e.z-o.z,g=t.x-o.x,x=t.y-o.y,m=t.z-o.z,p=i.x-o.x,_=i.y-o.y,y=i.z-o.z,S=Math.abs(c),R=Math.abs(l),A=Math.abs(h),v,E,F,D,N,k,G,I,W,$,V,ce;if(S>=R&&S>=A?(F=c,k=f,W=g,ce=p,c>=0?(v=l,E=h,D=u,N=d,G=x,I=m,$=_,V=y):(v=h,E=l,D=d,N=u,G=m,I=x,$=y,V=_)):R>=A?(F=l,k=u,W=x,ce=_,l>=0?(v=h,E=c,D=d,N=f,G=m,I=g,$=y,V=p):(v=c,E=h,D=f,N=d,G=g,I=m,$=p,V=y)):(F=h,k=d,W=m,ce=y,h>=0?(v=c,E=l,D=f,N=u,G=g,I=x,$=p,V=_):(v=l,E=c,D=u,N=f,G=x,I=g,$=_,V=p)),F===0)return null;let J=v/F,j=E/F,re=1/F,ue=D-J*k,fe=N-j*k,ee=G-J*W,me=I-j*W,_e=$-J*ce,Re=V-j*ce,be=_e*me-Re*ee,qe=ue*Re-fe*_e,rt=ee*fe-me*ue;if(r){if(be<0||qe<0||rt<0)return null}else if((be<0||qe<0||rt<0)&&(be>0||qe>0||rt>0))return null;let We=be+qe+rt;if(We===0)return null;let dt=re*(be*k+qe*W+rt*ce);return(We>0?dt<0:dt>0)?null:this.at(dt/We,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}};var In=class extends cn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ke(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ln,this.combine=qs,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var Vp=new ye,xs=new Zr,mc=new Bi,Wp=new C,gc=new C,xc=new C,_c=new C,Zf=new C,vc=new C,Xp=new C,Mc=new C,St=class extends Vt{constructor(e=new Tt,t=new In){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){vc.set(0,0,0);for(let c=0,l=s.length;c<l;c++){let h=a[c],f=s[c];h!==0&&(Zf.fromBufferAttribute(f,e),o?vc.addScaledVector(Zf,h):vc.addScaledVector(Zf.sub(t),h))}t.add(vc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),mc.copy(i.boundingSphere),mc.applyMatrix4(s),xs.copy(e.ray).recast(e.near),!(mc.containsPoint(xs.origin)===!1&&(xs.intersectSphere(mc,Wp)===null||xs.origin.distanceToSquared(Wp)>(e.far-e.near)**2))&&(Vp.copy(s).invert(),xs.copy(e.ray).applyMatrix4(Vp),!(i.boundingBox!==null&&xs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,xs)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,c=s.attributes.position,l=s.attributes.uv,h=s.attributes.uv1,f=s.attributes.normal,u=s.groups,d=s.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=u.length;g<x;g++){let m=u[g],p=o[m.materialIndex],_=Math.max(m.start,d.start),y=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let S=_,R=y;S<R;S+=3){let A=a.getX(S),v=a.getX(S+1),E=a.getX(S+2);r=Sc(this,p,e,i,l,h,f,A,v,E),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let g=Math.max(0,d.start),x=Math.min(a.count,d.start+d.count);for(let m=g,p=x;m<p;m+=3){let _=a.getX(m),y=a.getX(m+1),S=a.getX(m+2);r=Sc(this,o,e,i,l,h,f,_,y,S),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}else if(c!==void 0)if(Array.isArray(o))for(let g=0,x=u.length;g<x;g++){let m=u[g],p=o[m.materialIndex],_=Math.max(m.start,d.start),y=Math.min(c.count,Math.min(m.start+m.count,d.start+d.count));for(let S=_,R=y;S<R;S+=3){let A=S,v=S+1,E=S+2;r=Sc(this,p,e,i,l,h,f,A,v,E),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let g=Math.max(0,d.start),x=Math.min(c.count,d.start+d.count);for(let m=g,p=x;m<p;m+=3){let _=m,y=m+1,S=m+2;r=Sc(this,o,e,i,l,h,f,_,y,S),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}}};function pS(n,e,t,i,r,s,o,a){let c;if(e.side===$t?c=i.intersectTriangle(o,s,r,!0,a):c=i.intersectTriangle(r,s,o,e.side===Yi,a),c===null)return null;Mc.copy(a),Mc.applyMatrix4(n.matrixWorld);let l=t.ray.origin.distanceTo(Mc);return l<t.near||l>t.far?null:{distance:l,point:Mc.clone(),object:n}}function Sc(n,e,t,i,r,s,o,a,c,l){n.getVertexPosition(a,gc),n.getVertexPosition(c,xc),n.getVertexPosition(l,_c);let h=pS(n,e,t,i,gc,xc,_c,Xp);if(h){let f=new C;Yr.getBarycoord(Xp,gc,xc,_c,f),r&&(h.uv=Yr.getInterpolatedAttribute(r,a,c,l,f,new Ke)),s&&(h.uv1=Yr.getInterpolatedAttribute(s,a,c,l,f,new Ke)),o&&(h.normal=Yr.getInterpolatedAttribute(o,a,c,l,f,new C),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:c,c:l,normal:new C,materialIndex:0};Yr.getNormal(gc,xc,_c,u.normal),h.face=u,h.barycoord=f}return h}var Tr=class extends di{constructor(e=null,t=1,i=1,r,s,o,a,c,l=Qt,h=Qt,f,u){super(null,o,a,c,l,h,r,s,f,u),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Jr=class extends Pt{constructor(e,t,i,r=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var yo=new ye,qp=new ye,yc=[],Yp=new Dn,mS=new ye,Za=new St,Ja=new Bi,Qa=class extends St{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Jr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<i;r++)this.setMatrixAt(r,mS)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Dn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,yo),Yp.copy(e.boundingBox).applyMatrix4(yo),this.boundingBox.union(Yp)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Bi),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,yo),Ja.copy(e.boundingSphere).applyMatrix4(yo),this.boundingSphere.union(Ja)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,r=this.morphTexture.source.data.data,s=i.length+1,o=e*s+1;for(let a=0;a<i.length;a++)i[a]=r[o+a]}raycast(e,t){let i=this.matrixWorld,r=this.count;if(Za.geometry=this.geometry,Za.material=this.material,Za.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ja.copy(this.boundingSphere),Ja.applyMatrix4(i),e.ray.intersectsSphere(Ja)!==!1))for(let s=0;s<r;s++){this.getMatrixAt(s,yo),qp.multiplyMatrices(i,yo),Za.matrixWorld=qp,Za.raycast(e,yc);for(let o=0,a=yc.length;o<a;o++){let c=yc[o];c.instanceId=s,c.object=this,t.push(c)}yc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Jr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,r=i.length+1;this.morphTexture===null&&(this.morphTexture=new Tr(new Float32Array(r*this.count),r,this.count,Zs,ui));let s=this.morphTexture.source.data.data,o=0;for(let l=0;l<i.length;l++)o+=i[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=r*e;return s[c]=a,s.set(i,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}};var _s=new Bi,gS=new Ke(.5,.5),bc=new C,hn=class{constructor(e=new zi,t=new zi,i=new zi,r=new zi,s=new zi,o=new zi){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Wi,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],c=s[2],l=s[3],h=s[4],f=s[5],u=s[6],d=s[7],g=s[8],x=s[9],m=s[10],p=s[11],_=s[12],y=s[13],S=s[14],R=s[15];if(r[0].setComponents(l-o,d-h,p-g,R-_).normalize(),r[1].setComponents(l+o,d+h,p+g,R+_).normalize(),r[2].setComponents(l+a,d+f,p+x,R+y).normalize(),r[3].setComponents(l-a,d-f,p-x,R-y).normalize(),i)r[4].setComponents(c,u,m,S).normalize(),r[5].setComponents(l-c,d-u,p-m,R-S).normalize();else if(r[4].setComponents(l-c,d-u,p-m,R-S).normalize(),t===Wi)r[5].setComponents(l+c,d+u,p+m,R+S).normalize();else if(t===Mr)r[5].setComponents(c,u,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),_s.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),_s.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(_s)}intersectsSprite(e){_s.center.set(0,0,0);let t=gS.distanceTo(e.center);return _s.radius=.7071067811865476+t,_s.applyMatrix4(e.matrixWorld),this.intersectsSphere(_s)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(bc.x=r.normal.x>0?e.max.x:e.min.x,bc.y=r.normal.y>0?e.max.y:e.min.y,bc.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(bc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var $p=new ye,wc=class n{constructor(){this.coordinateSystem=Wi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];$p.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new hn),i[r].setFromProjectionMatrix($p,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new hn),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var vs=class extends cn{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ke(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}};var Ac=new C,Rc=new C,Kp=new ye,ja=new Zr,Ec=new Bi,Jf=new C,Zp=new C,Cc=class extends Vt{constructor(e=new Tt,t=new vs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let r=1,s=t.count;r<s;r++)Ac.fromBufferAttribute(t,r-1),Rc.fromBufferAttribute(t,r),i[r]=i[r-1],i[r]+=Ac.distanceTo(Rc);e.setAttribute("lineDistance",new bt(i,1))}else Fe("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.matrixWorld,s=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ec.copy(i.boundingSphere),Ec.applyMatrix4(r),Ec.radius+=s,e.ray.intersectsSphere(Ec)===!1)return;Kp.copy(r).invert(),ja.copy(e.ray).applyMatrix4(Kp);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=i.index,u=i.attributes.position;if(h!==null){let d=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let x=d,m=g-1;x<m;x+=l){let p=h.getX(x),_=h.getX(x+1),y=Tc(this,e,ja,c,p,_,x);y&&t.push(y)}if(this.isLineLoop){let x=h.getX(g-1),m=h.getX(d),p=Tc(this,e,ja,c,x,m,g-1);p&&t.push(p)}}else{let d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let x=d,m=g-1;x<m;x+=l){let p=Tc(this,e,ja,c,x,x+1,x);p&&t.push(p)}if(this.isLineLoop){let x=Tc(this,e,ja,c,g-1,d,g-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function Tc(n,e,t,i,r,s,o){let a=n.geometry.attributes.position;if(Ac.fromBufferAttribute(a,r),Rc.fromBufferAttribute(a,s),t.distanceSqToSegment(Ac,Rc,Jf,Zp)>i)return;Jf.applyMatrix4(n.matrixWorld);let l=e.ray.origin.distanceTo(Jf);if(!(l<e.near||l>e.far))return{distance:l,point:Zp.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Jp=new C,Qp=new C,el=class extends Cc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let r=0,s=t.count;r<s;r+=2)Jp.fromBufferAttribute(t,r),Qp.fromBufferAttribute(t,r+1),i[r]=r===0?0:i[r-1],i[r+1]=i[r]+Jp.distanceTo(Qp);e.setAttribute("lineDistance",new bt(i,1))}else Fe("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var bo=class extends di{constructor(e=[],t=or,i,r,s,o,a,c,l,h){super(e,t,i,r,s,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var bn=class extends di{constructor(e,t,i=Ui,r,s,o,a=Qt,c=Qt,l,h=ln,f=1){if(h!==ln&&h!==_n)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:f};super(u,r,s,o,a,c,h,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Vr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}};var wo=class extends bn{constructor(e,t=Ui,i=or,r,s,o=Qt,a=Qt,c,l=ln){let h={width:e,height:e,depth:1},f=[h,h,h,h,h,h];super(e,e,t,i,r,s,o,a,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}};var Eo=class extends di{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var lr=class n extends Tt{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let c=[],l=[],h=[],f=[],u=0,d=0;g("z","y","x",-1,-1,i,t,e,o,s,0),g("z","y","x",1,-1,i,t,-e,o,s,1),g("x","z","y",1,1,e,i,t,r,o,2),g("x","z","y",1,-1,e,i,-t,r,o,3),g("x","y","z",1,-1,e,t,i,r,s,4),g("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(c),this.setAttribute("position",new bt(l,3)),this.setAttribute("normal",new bt(h,3)),this.setAttribute("uv",new bt(f,2));function g(x,m,p,_,y,S,R,A,v,E,F){let D=S/v,N=R/E,k=S/2,G=R/2,I=A/2,W=v+1,$=E+1,V=0,ce=0,J=new C;for(let j=0;j<$;j++){let re=j*N-G;for(let ue=0;ue<W;ue++){let fe=ue*D-k;J[x]=fe*_,J[m]=re*y,J[p]=I,l.push(J.x,J.y,J.z),J[x]=0,J[m]=0,J[p]=A>0?1:-1,h.push(J.x,J.y,J.z),f.push(ue/v),f.push(1-j/E),V+=1}}for(let j=0;j<E;j++)for(let re=0;re<v;re++){let ue=u+re+W*j,fe=u+re+W*(j+1),ee=u+(re+1)+W*(j+1),me=u+(re+1)+W*j;c.push(ue,fe,me),c.push(fe,ee,me),ce+=6}a.addGroup(d,ce,F),d+=ce,u+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var To=class n extends Tt{constructor(e=1,t=1,i=1,r=32,s=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:c};let l=this;r=Math.floor(r),s=Math.floor(s);let h=[],f=[],u=[],d=[],g=0,x=[],m=i/2,p=0;_(),o===!1&&(e>0&&y(!0),t>0&&y(!1)),this.setIndex(h),this.setAttribute("position",new bt(f,3)),this.setAttribute("normal",new bt(u,3)),this.setAttribute("uv",new bt(d,2));function _(){let S=new C,R=new C,A=0,v=(t-e)/i;for(let E=0;E<=s;E++){let F=[],D=E/s,N=D*(t-e)+e;for(let k=0;k<=r;k++){let G=k/r,I=G*c+a,W=Math.sin(I),$=Math.cos(I);R.x=N*W,R.y=-D*i+m,R.z=N*$,f.push(R.x,R.y,R.z),S.set(W,v,$).normalize(),u.push(S.x,S.y,S.z),d.push(G,1-D),F.push(g++)}x.push(F)}for(let E=0;E<r;E++)for(let F=0;F<s;F++){let D=x[F][E],N=x[F+1][E],k=x[F+1][E+1],G=x[F][E+1];(e>0||F!==0)&&(h.push(D,N,G),A+=3),(t>0||F!==s-1)&&(h.push(N,k,G),A+=3)}l.addGroup(p,A,0),p+=A}function y(S){let R=g,A=new Ke,v=new C,E=0,F=S===!0?e:t,D=S===!0?1:-1;for(let k=1;k<=r;k++)f.push(0,m*D,0),u.push(0,D,0),d.push(.5,.5),g++;let N=g;for(let k=0;k<=r;k++){let I=k/r*c+a,W=Math.cos(I),$=Math.sin(I);v.x=F*$,v.y=m*D,v.z=F*W,f.push(v.x,v.y,v.z),u.push(0,D,0),A.x=W*.5+.5,A.y=$*.5*D+.5,d.push(A.x,A.y),g++}for(let k=0;k<r;k++){let G=R+k,I=N+k;S===!0?h.push(I,I+1,G):h.push(I+1,I,G),E+=3}l.addGroup(p,E,S===!0?1:2),p+=E}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Pc=class n extends To{constructor(e=1,t=1,i=32,r=1,s=!1,o=0,a=Math.PI*2){super(0,e,t,i,r,s,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:r,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Ao=class n extends Tt{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),c=Math.floor(r),l=a+1,h=c+1,f=e/a,u=t/c,d=[],g=[],x=[],m=[];for(let p=0;p<h;p++){let _=p*u-o;for(let y=0;y<l;y++){let S=y*f-s;g.push(S,-_,0),x.push(0,0,1),m.push(y/a),m.push(1-p/c)}}for(let p=0;p<c;p++)for(let _=0;_<a;_++){let y=_+l*p,S=_+l*(p+1),R=_+1+l*(p+1),A=_+1+l*p;d.push(y,S,A),d.push(S,R,A)}this.setIndex(d),this.setAttribute("position",new bt(g,3)),this.setAttribute("normal",new bt(x,3)),this.setAttribute("uv",new bt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ro=class n extends Tt{constructor(e=1,t=32,i=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let c=Math.min(o+a,Math.PI),l=0,h=[],f=new C,u=new C,d=[],g=[],x=[],m=[];for(let p=0;p<=i;p++){let _=[],y=p/i,S=o+y*a,R=e*Math.cos(S),A=Math.sqrt(e*e-R*R),v=0;p===0&&o===0?v=.5/t:p===i&&c===Math.PI&&(v=-.5/t);for(let E=0;E<=t;E++){let F=E/t,D=r+F*s;f.x=-A*Math.cos(D),f.y=R,f.z=A*Math.sin(D),g.push(f.x,f.y,f.z),u.copy(f).normalize(),x.push(u.x,u.y,u.z),m.push(F+v,1-y),_.push(l++)}h.push(_)}for(let p=0;p<i;p++)for(let _=0;_<t;_++){let y=h[p][_+1],S=h[p][_],R=h[p+1][_],A=h[p+1][_+1];(p!==0||o>0)&&d.push(y,S,A),(p!==i-1||c<Math.PI)&&d.push(S,R,A)}this.setIndex(d),this.setAttribute("position",new bt(g,3)),this.setAttribute("normal",new bt(x,3)),this.setAttribute("uv",new bt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Ar(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(jp(r))r.isRenderTargetTexture?(Fe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(jp(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function Ji(n){let e={};for(let t=0;t<n.length;t++){let i=Ar(n[t]);for(let r in i)e[r]=i[r]}return e}function jp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function em(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Lc(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:ot.workingColorSpace}var tm={clone:Ar,merge:Ji};var im=`
void main() {
gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}
`;var nm=`
void main() {
gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}
`;var Gi=class extends cn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=im,this.fragmentShader=nm,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ar(e.uniforms),this.uniformsGroups=em(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new ke().setHex(r.value);break;case"v2":this.uniforms[i].value=new Ke().fromArray(r.value);break;case"v3":this.uniforms[i].value=new C().fromArray(r.value);break;case"v4":this.uniforms[i].value=new Et().fromArray(r.value);break;case"m3":this.uniforms[i].value=new $e().fromArray(r.value);break;case"m4":this.uniforms[i].value=new ye().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}};var Dc=class extends Gi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Rr=class extends cn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ke(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ke(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Wa,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ln,this.combine=qs,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Nc=class extends cn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=lp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}};var Ic=class extends cn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var Co=class extends Vt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ke(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var tl=class extends Co{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Vt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ke(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}};var Qf=new ye,rm=new C,sm=new C,Uc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=fi,this.map=null,this.mapPass=null,this.matrix=new ye,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new hn,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new Et(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;rm.setFromMatrixPosition(e.matrixWorld),t.position.copy(rm),sm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(sm),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,r){Qf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Qf,e.coordinateSystem,e.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,c=r?r.x/s.x:0,l=r?r.y/s.y:0;e.coordinateSystem===Mr||e.reversedDepth?t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),t.multiply(Qf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var Fc=new C,Oc=new Ut,cr=new C,Po=class extends Vt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ye,this.projectionMatrix=new ye,this.projectionMatrixInverse=new ye,this.coordinateSystem=Wi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Fc,Oc,cr),cr.x===1&&cr.y===1&&cr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fc,Oc,cr.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Fc,Oc,cr),cr.x===1&&cr.y===1&&cr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fc,Oc,cr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}};var Qr=new C,om=new Ke,am=new Ke,Hi=class extends Po{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Xa*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ec*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Xa*2*Math.atan(Math.tan(ec*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Qr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Qr.x,Qr.y).multiplyScalar(-e/Qr.z),Qr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Qr.x,Qr.y).multiplyScalar(-e/Qr.z)}getViewSize(e,t){return this.getViewBounds(e,om,am),t.subVectors(am,om)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ec*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;s+=o.offsetX*r/c,t-=o.offsetY*i/l,r*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Lo=class extends Po{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,c=r-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=l*this.view.offsetX,o=s+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Bc=class extends Uc{constructor(){super(new Lo(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}};var il=class extends Co{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Vt.DEFAULT_UP),this.updateMatrix(),this.target=new Vt,this.shadow=new Bc}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Do=-90,No=1,Ms=class extends Vt{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Hi(Do,No,e,t);r.layers=this.layers,this.add(r);let s=new Hi(Do,No,e,t);s.layers=this.layers,this.add(s);let o=new Hi(Do,No,e,t);o.layers=this.layers,this.add(o);let a=new Hi(Do,No,e,t);a.layers=this.layers,this.add(a);let c=new Hi(Do,No,e,t);c.layers=this.layers,this.add(c);let l=new Hi(Do,No,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,c]=t;for(let l of t)this.remove(l);if(e===Wi)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===Mr)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,c,l,h]=this.children,f=e.getRenderTarget(),u=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(i,4,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(f,u,d),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}};var kc=class extends Hi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var lm=new ye,nl=class{constructor(e,t,i=0,r=1/0){this.ray=new Zr(e,t),this.near=i,this.far=r,this.camera=null,this.layers=new Xr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):ut("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return lm.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(lm),this}intersectObject(e,t=!0,i=[]){return jf(e,this,i,t),i.sort(cm),i}intersectObjects(e,t=!0,i=[]){for(let r=0,s=e.length;r<s;r++)jf(e[r],this,i,t);return i.sort(cm),i}};function cm(n,e){return n.distance-e.distance}function jf(n,e,t,i){let r=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(r=!1),r===!0&&i===!0){let s=n.children;for(let o=0,a=s.length;o<a;o++)jf(s[o],e,t,!0)}}function eu(n,e,t,i){let r=xS(i);switch(t){case Yl:return n*e;case Zs:return n*e/r.components*r.byteLength;case Js:return n*e/r.components*r.byteLength;case vn:return n*e*2/r.components*r.byteLength;case Qs:return n*e*2/r.components*r.byteLength;case $l:return n*e*3/r.components*r.byteLength;case Oi:return n*e*4/r.components*r.byteLength;case js:return n*e*4/r.components*r.byteLength;case eo:case to:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case io:case no:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ma:case xa:return Math.max(n,16)*Math.max(e,8)/4;case pa:case ga:return Math.max(n,8)*Math.max(e,8)/2;case _a:case va:case Sa:case ya:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ma:case cs:case ba:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case wa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ea:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Ta:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Aa:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Ra:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Ca:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Pa:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case La:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Da:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Na:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Ia:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Ua:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Fa:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Oa:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Ba:case ka:case za:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Ga:case Ha:return Math.ceil(n/4)*Math.ceil(e/4)*8;case hs:case Va:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function xS(n){switch(n){case fi:case Vl:return{byteLength:1,components:1};case vr:case Wl:case Fi:return{byteLength:2,components:1};case $s:case Ks:return{byteLength:2,components:4};case Ui:case Ys:case ui:return{byteLength:4,components:1};case Xl:case ql:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Fe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function zc(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function hm(n){let e=new WeakMap;function t(a,c){let l=a.array,h=a.usage,f=l.byteLength,u=n.createBuffer();n.bindBuffer(c,u),n.bufferData(c,l,h),a.onUploadCallback();let d;if(l instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)d=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)d=n.SHORT;else if(l instanceof Uint32Array)d=n.UNSIGNED_INT;else if(l instanceof Int32Array)d=n.INT;else if(l instanceof Int8Array)d=n.BYTE;else if(l instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:u,type:d,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,c,l){let h=c.array,f=c.updateRanges;if(n.bindBuffer(l,a),f.length===0)n.bufferSubData(l,0,h);else{f.sort((d,g)=>d.start-g.start);let u=0;for(let d=1;d<f.length;d++){let g=f[u],x=f[d];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++u,f[u]=x)}f.length=u+1;for(let d=0,g=f.length;d<g;d++){let x=f[d];n.bufferSubData(l,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}c.clearUpdateRanges()}c.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=e.get(a);c&&(n.deleteBuffer(c.buffer),e.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=e.get(a);if(l===void 0)e.set(a,t(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:r,remove:s,update:o}}var fm=`
#ifdef USE_ALPHAHASH
if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif
`;var um=`
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
`;var dm=`
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif
`;var pm=`
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif
`;var mm=`
#ifdef USE_ALPHATEST
#ifdef ALPHA_TO_COVERAGE
diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
if ( diffuseColor.a == 0.0 ) discard;
#else
if ( diffuseColor.a < alphaTest ) discard;
#endif
#endif
`;var gm=`
#ifdef USE_ALPHATEST
uniform float alphaTest;
#endif
`;var xm=`
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
`;var _m=`
#ifdef USE_AOMAP
uniform sampler2D aoMap;
uniform float aoMapIntensity;
#endif
`;var vm=`
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
`;var Mm=`
#ifdef USE_BATCHING
mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif
`;var Sm=`
vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
vPosition = vec3( position );
#endif
`;var ym=`
vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
vec3 objectTangent = vec3( tangent.xyz );
#endif
`;var bm=`
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
`;var wm=`
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
`;var Em=`
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
`;var Tm=`
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
`;var Am=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif
`;var Rm=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
#endif
`;var Cm=`
#if NUM_CLIPPING_PLANES > 0
vClipPosition = - mvPosition.xyz;
#endif
`;var Pm=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
diffuseColor *= vColor;
#endif
`;var Lm=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
varying vec4 vColor;
#endif
`;var Dm=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
varying vec4 vColor;
#endif
`;var Nm=`
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
`;var Im=`
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
`;var Um=`
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
`;var Fm=`
#ifdef USE_DISPLACEMENTMAP
uniform sampler2D displacementMap;
uniform float displacementScale;
uniform float displacementBias;
#endif
`;var Om=`
#ifdef USE_DISPLACEMENTMAP
transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif
`;var Bm=`
#ifdef USE_EMISSIVEMAP
vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
emissiveColor = sRGBTransferEOTF( emissiveColor );
#endif
totalEmissiveRadiance *= emissiveColor.rgb;
#endif
`;var km=`
#ifdef USE_EMISSIVEMAP
uniform sampler2D emissiveMap;
#endif
`;var zm=`
gl_FragColor = linearToOutputTexel( gl_FragColor );
`;var Gm=`
vec4 LinearTransferOETF( in vec4 value ) {
return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}
`;var Hm=`
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
`;var Vm=`
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
`;var Wm=`
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
`;var Xm=`
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
`;var qm=`
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
`;var Ym=`
#ifdef USE_FOG
vFogDepth = - mvPosition.z;
#endif
`;var $m=`
#ifdef USE_FOG
varying float vFogDepth;
#endif
`;var Km=`
#ifdef USE_FOG
#ifdef FOG_EXP2
float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
#else
float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
#endif
gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif
`;var Zm=`
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
`;var Jm=`
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
`;var Qm=`
#ifdef USE_LIGHTMAP
uniform sampler2D lightMap;
uniform float lightMapIntensity;
#endif
`;var jm=`
LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;
`;var eg=`
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
`;var tg=`
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
`;var ig=`
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
`;var ng=`
ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;
`;var rg=`
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
`;var sg=`
BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;
`;var og=`
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
`;var ag=`
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
`;var lg=`
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
`;var cg=`
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
`;var hg=`
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
`;var fg=`
#if defined( RE_IndirectDiffuse )
#if defined( LAMBERT ) || defined( PHONG )
irradiance += iblIrradiance;
#endif
RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
`;var ug=`
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
`;var dg=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif
`;var pg=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
uniform float logDepthBufFC;
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var mg=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var gg=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
vFragDepth = 1.0 + gl_Position.w;
vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif
`;var xg=`
#ifdef USE_MAP
vec4 sampledDiffuseColor = texture2D( map, vMapUv );
#ifdef DECODE_VIDEO_TEXTURE
sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
#endif
diffuseColor *= sampledDiffuseColor;
#endif
`;var _g=`
#ifdef USE_MAP
uniform sampler2D map;
#endif
`;var vg=`
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
`;var Mg=`
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
`;var Sg=`
float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
metalnessFactor *= texelMetalness.b;
#endif
`;var yg=`
#ifdef USE_METALNESSMAP
uniform sampler2D metalnessMap;
#endif
`;var bg=`
#ifdef USE_INSTANCING_MORPH
float morphTargetInfluences[ MORPHTARGETS_COUNT ];
float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
}
#endif
`;var wg=`
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
`;var Eg=`
#ifdef USE_MORPHNORMALS
objectNormal *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var Tg=`
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
`;var Ag=`
#ifdef USE_MORPHTARGETS
transformed *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var Rg=`
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
`;var Cg=`
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
`;var Pg=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var Lg=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var Dg=`
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
`;var Ng=`
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
`;var Ig=`
#ifdef USE_CLEARCOAT
vec3 clearcoatNormal = nonPerturbedNormal;
#endif
`;var Ug=`
#ifdef USE_CLEARCOAT_NORMALMAP
vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
clearcoatMapN.xy *= clearcoatNormalScale;
clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif
`;var Fg=`
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
`;var Og=`
#ifdef USE_IRIDESCENCEMAP
uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform sampler2D iridescenceThicknessMap;
#endif
`;var Bg=`
#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );
`;var kg=`
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
`;var zg=`
#ifdef PREMULTIPLIED_ALPHA
gl_FragColor.rgb *= gl_FragColor.a;
#endif
`;var Gg=`
vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;
`;var Hg=`
#ifdef DITHERING
gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif
`;var Vg=`
#ifdef DITHERING
vec3 dithering( vec3 color ) {
float grid_position = rand( gl_FragCoord.xy );
vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
return color + dither_shift_RGB;
}
#endif
`;var Wg=`
float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
roughnessFactor *= texelRoughness.g;
#endif
`;var Xg=`
#ifdef USE_ROUGHNESSMAP
uniform sampler2D roughnessMap;
#endif
`;var qg=`
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
`;var Yg=`
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
`;var $g=`
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
`;var Kg=`
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
`;var Zg=`
#ifdef USE_SKINNING
mat4 boneMatX = getBoneMatrix( skinIndex.x );
mat4 boneMatY = getBoneMatrix( skinIndex.y );
mat4 boneMatZ = getBoneMatrix( skinIndex.z );
mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif
`;var Jg=`
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
`;var Qg=`
#ifdef USE_SKINNING
vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
vec4 skinned = vec4( 0.0 );
skinned += boneMatX * skinVertex * skinWeight.x;
skinned += boneMatY * skinVertex * skinWeight.y;
skinned += boneMatZ * skinVertex * skinWeight.z;
skinned += boneMatW * skinVertex * skinWeight.w;
transformed = ( bindMatrixInverse * skinned ).xyz;
#endif
`;var jg=`
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
`;var e0=`
float specularStrength;
#ifdef USE_SPECULARMAP
vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
specularStrength = texelSpecular.r;
#else
specularStrength = 1.0;
#endif
`;var t0=`
#ifdef USE_SPECULARMAP
uniform sampler2D specularMap;
#endif
`;var i0=`
#if defined( TONE_MAPPING )
gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif
`;var n0=`
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
`;var r0=`
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
`;var s0=`
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
`;var o0=`
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
`;var a0=`
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
`;var l0=`
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
`;var c0=`
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
`;var h0=`
varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
gl_Position = vec4( position.xy, 1.0, 1.0 );
}
`,f0=`
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
`;var u0=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,d0=`
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
`;var p0=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,m0=`
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
`;var g0=`
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
`,x0=`
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
`;var _0=`
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
`,v0=`
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
`;var M0=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
}
`,S0=`
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
`;var y0=`
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
`,b0=`
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
`;var w0=`
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
`,E0=`
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
`;var T0=`
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
`,A0=`
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
`;var R0=`
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
`,C0=`
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
`;var P0=`
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
`,L0=`
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
`;var D0=`
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
`,N0=`
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
`;var I0=`
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
`,U0=`
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
`;var F0=`
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
`,O0=`
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
`;var B0=`
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
`,k0=`
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
`;var z0=`
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
`,G0=`
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
`;var H0=`
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
`,V0=`
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
`;var at={alphahash_fragment:fm,alphahash_pars_fragment:um,alphamap_fragment:dm,alphamap_pars_fragment:pm,alphatest_fragment:mm,alphatest_pars_fragment:gm,aomap_fragment:xm,aomap_pars_fragment:_m,batching_pars_vertex:vm,batching_vertex:Mm,begin_vertex:Sm,beginnormal_vertex:ym,bsdfs:bm,iridescence_fragment:wm,bumpmap_pars_fragment:Em,clipping_planes_fragment:Tm,clipping_planes_pars_fragment:Am,clipping_planes_pars_vertex:Rm,clipping_planes_vertex:Cm,color_fragment:Pm,color_pars_fragment:Lm,color_pars_vertex:Dm,color_vertex:Nm,common:Im,defaultnormal_vertex:Um,displacementmap_pars_vertex:Fm,displacementmap_vertex:Om,emissivemap_fragment:Bm,emissivemap_pars_fragment:km,colorspace_fragment:zm,colorspace_pars_fragment:Gm,envmap_fragment:Hm,envmap_common_pars_fragment:Vm,envmap_pars_fragment:Wm,envmap_pars_vertex:Xm,envmap_physical_pars_fragment:ig,envmap_vertex:qm,fog_vertex:Ym,fog_pars_vertex:$m,fog_fragment:Km,fog_pars_fragment:Zm,gradientmap_pars_fragment:Jm,lightmap_pars_fragment:Qm,lights_lambert_fragment:jm,lights_lambert_pars_fragment:eg,lights_pars_begin:tg,lights_toon_fragment:ng,lights_toon_pars_fragment:rg,lights_phong_fragment:sg,lights_phong_pars_fragment:og,lights_physical_fragment:ag,lights_physical_pars_fragment:lg,lights_fragment_begin:cg,lights_fragment_maps:hg,lights_fragment_end:fg,lightprobes_pars_fragment:ug,logdepthbuf_fragment:dg,logdepthbuf_pars_fragment:pg,logdepthbuf_pars_vertex:mg,logdepthbuf_vertex:gg,map_fragment:xg,map_pars_fragment:_g,map_particle_fragment:vg,map_particle_pars_fragment:Mg,metalnessmap_fragment:Sg,metalnessmap_pars_fragment:yg,morphinstance_vertex:bg,morphcolor_vertex:wg,morphnormal_vertex:Eg,morphtarget_pars_vertex:Tg,morphtarget_vertex:Ag,normal_fragment_begin:Rg,normal_fragment_maps:Cg,normal_pars_fragment:Pg,normal_pars_vertex:Lg,normal_vertex:Dg,normalmap_pars_fragment:Ng,clearcoat_normal_fragment_begin:Ig,clearcoat_normal_fragment_maps:Ug,clearcoat_pars_fragment:Fg,iridescence_pars_fragment:Og,opaque_fragment:Bg,packing:kg,premultiplied_alpha_fragment:zg,project_vertex:Gg,dithering_fragment:Hg,dithering_pars_fragment:Vg,roughnessmap_fragment:Wg,roughnessmap_pars_fragment:Xg,shadowmap_pars_fragment:qg,shadowmap_pars_vertex:Yg,shadowmap_vertex:$g,shadowmask_pars_fragment:Kg,skinbase_vertex:Zg,skinning_pars_vertex:Jg,skinning_vertex:Qg,skinnormal_vertex:jg,specularmap_fragment:e0,specularmap_pars_fragment:t0,tonemapping_fragment:i0,tonemapping_pars_fragment:n0,transmission_fragment:r0,transmission_pars_fragment:s0,uv_pars_fragment:o0,uv_pars_vertex:a0,uv_vertex:l0,worldpos_vertex:c0,background_vert:h0,background_frag:f0,backgroundCube_vert:u0,backgroundCube_frag:d0,cube_vert:p0,cube_frag:m0,depth_vert:g0,depth_frag:x0,distance_vert:_0,distance_frag:v0,equirect_vert:M0,equirect_frag:S0,linedashed_vert:y0,linedashed_frag:b0,meshbasic_vert:w0,meshbasic_frag:E0,meshlambert_vert:T0,meshlambert_frag:A0,meshmatcap_vert:R0,meshmatcap_frag:C0,meshnormal_vert:P0,meshnormal_frag:L0,meshphong_vert:D0,meshphong_frag:N0,meshphysical_vert:I0,meshphysical_frag:U0,meshtoon_vert:F0,meshtoon_frag:O0,points_vert:B0,points_frag:k0,shadow_vert:z0,shadow_frag:G0,sprite_vert:H0,sprite_frag:V0};var De={common:{diffuse:{value:new ke(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new $e},alphaMap:{value:null},alphaMapTransform:{value:new $e},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new $e}},envmap:{envMap:{value:null},envMapRotation:{value:new $e},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new $e}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new $e}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new $e},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new $e},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new $e},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new $e}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new $e}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new $e}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ke(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ke(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new $e},alphaTest:{value:0},uvTransform:{value:new $e}},sprite:{diffuse:{value:new ke(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new $e},alphaMap:{value:null},alphaMapTransform:{value:new $e},alphaTest:{value:0}}};var Un={basic:{uniforms:Ji([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:at.meshbasic_vert,fragmentShader:at.meshbasic_frag},lambert:{uniforms:Ji([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new ke(0)},envMapIntensity:{value:1}}]),vertexShader:at.meshlambert_vert,fragmentShader:at.meshlambert_frag},phong:{uniforms:Ji([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new ke(0)},specular:{value:new ke(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:at.meshphong_vert,fragmentShader:at.meshphong_frag},standard:{uniforms:Ji([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new ke(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag},toon:{uniforms:Ji([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new ke(0)}}]),vertexShader:at.meshtoon_vert,fragmentShader:at.meshtoon_frag},matcap:{uniforms:Ji([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:at.meshmatcap_vert,fragmentShader:at.meshmatcap_frag},points:{uniforms:Ji([De.points,De.fog]),vertexShader:at.points_vert,fragmentShader:at.points_frag},dashed:{uniforms:Ji([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:at.linedashed_vert,fragmentShader:at.linedashed_frag},depth:{uniforms:Ji([De.common,De.displacementmap]),vertexShader:at.depth_vert,fragmentShader:at.depth_frag},normal:{uniforms:Ji([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:at.meshnormal_vert,fragmentShader:at.meshnormal_frag},sprite:{uniforms:Ji([De.sprite,De.fog]),vertexShader:at.sprite_vert,fragmentShader:at.sprite_frag},background:{uniforms:{uvTransform:{value:new $e},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:at.background_vert,fragmentShader:at.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new $e}},vertexShader:at.backgroundCube_vert,fragmentShader:at.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:at.cube_vert,fragmentShader:at.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:at.equirect_vert,fragmentShader:at.equirect_frag},distance:{uniforms:Ji([De.common,De.displacementmap,{referencePosition:{value:new C},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:at.distance_vert,fragmentShader:at.distance_frag},shadow:{uniforms:Ji([De.lights,De.fog,{color:{value:new ke(0)},opacity:{value:1}}]),vertexShader:at.shadow_vert,fragmentShader:at.shadow_frag}};Un.physical={uniforms:Ji([Un.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new $e},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new $e},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new $e},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new $e},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new $e},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new $e},sheen:{value:0},sheenColor:{value:new ke(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new $e},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new $e},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new $e},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new $e},attenuationDistance:{value:0},attenuationColor:{value:new ke(0)},specularColor:{value:new ke(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new $e},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new $e},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new $e}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag};var Gc={r:0,b:0,g:0},US=new ye,W0=new $e;W0.set(-1,0,0,0,1,0,0,0,1);function X0(n,e,t,i,r,s){let o=new ke(0),a=r===!0?0:1,c,l,h=null,f=0,u=null;function d(_){let y=_.isScene===!0?_.background:null;if(y&&y.isTexture){let S=_.backgroundBlurriness>0;y=e.get(y,S)}return y}function g(_){let y=!1,S=d(_);S===null?m(o,a):S&&S.isColor&&(m(S,1),y=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,s):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||y)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(_,y){let S=d(y);S&&S.isCubeTexture?(l===void 0&&(l=new St(new lr(1,1,1),new Gi({name:"BackgroundCubeMaterial",uniforms:Ar(Un.backgroundCube.uniforms),vertexShader:Un.backgroundCube.vertexShader,fragmentShader:Un.backgroundCube.fragmentShader,side:$t,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(R,A,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=S,l.material.uniforms.backgroundBlurriness.value=y.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(US.makeRotationFromEuler(y.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(W0),l.material.toneMapped=ot.getTransfer(S.colorSpace)!==vt,(h!==S||f!==S.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=S,f=S.version,u=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null)):S&&S.isTexture&&(c===void 0&&(c=new St(new Ao(2,2),new Gi({name:"BackgroundMaterial",uniforms:Ar(Un.background.uniforms),vertexShader:Un.background.vertexShader,fragmentShader:Un.background.fragmentShader,side:Yi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=S,c.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,c.material.toneMapped=ot.getTransfer(S.colorSpace)!==vt,S.matrixAutoUpdate===!0&&S.updateMatrix(),c.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||f!==S.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=S,f=S.version,u=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null))}function m(_,y){_.getRGB(Gc,Lc(n)),t.buffers.color.setClear(Gc.r,Gc.g,Gc.b,y,s)}function p(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,y=1){o.set(_),a=y,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,m(o,a)},render:g,addToRenderList:x,dispose:p}}function q0(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=u(null),s=r,o=!1;function a(N,k,G,I,W){let $=!1,V=f(N,I,G,k);s!==V&&(s=V,l(s.object)),$=d(N,I,G,W),$&&g(N,I,G,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,S(N,k,G,I),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function c(){return n.createVertexArray()}function l(N){return n.bindVertexArray(N)}function h(N){return n.deleteVertexArray(N)}function f(N,k,G,I){let W=I.wireframe===!0,$=i[k.id];$===void 0&&($={},i[k.id]=$);let V=N.isInstancedMesh===!0?N.id:0,ce=$[V];ce===void 0&&(ce={},$[V]=ce);let J=ce[G.id];J===void 0&&(J={},ce[G.id]=J);let j=J[W];return j===void 0&&(j=u(c()),J[W]=j),j}function u(N){let k=[],G=[],I=[];for(let W=0;W<t;W++)k[W]=0,G[W]=0,I[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:G,attributeDivisors:I,object:N,attributes:{},index:null}}function d(N,k,G,I){let W=s.attributes,$=k.attributes,V=0,ce=G.getAttributes();for(let J in ce)if(ce[J].location>=0){let re=W[J],ue=$[J];if(ue===void 0&&(J==="instanceMatrix"&&N.instanceMatrix&&(ue=N.instanceMatrix),J==="instanceColor"&&N.instanceColor&&(ue=N.instanceColor)),re===void 0||re.attribute!==ue||ue&&re.data!==ue.data)return!0;V++}return s.attributesNum!==V||s.index!==I}function g(N,k,G,I){let W={},$=k.attributes,V=0,ce=G.getAttributes();for(let J in ce)if(ce[J].location>=0){let re=$[J];re===void 0&&(J==="instanceMatrix"&&N.instanceMatrix&&(re=N.instanceMatrix),J==="instanceColor"&&N.instanceColor&&(re=N.instanceColor));let ue={};ue.attribute=re,re&&re.data&&(ue.data=re.data),W[J]=ue,V++}s.attributes=W,s.attributesNum=V,s.index=I}function x(){let N=s.newAttributes;for(let k=0,G=N.length;k<G;k++)N[k]=0}function m(N){p(N,0)}function p(N,k){let G=s.newAttributes,I=s.enabledAttributes,W=s.attributeDivisors;G[N]=1,I[N]===0&&(n.enableVertexAttribArray(N),I[N]=1),W[N]!==k&&(n.vertexAttribDivisor(N,k),W[N]=k)}function _(){let N=s.newAttributes,k=s.enabledAttributes;for(let G=0,I=k.length;G<I;G++)k[G]!==N[G]&&(n.disableVertexAttribArray(G),k[G]=0)}function y(N,k,G,I,W,$,V){V===!0?n.vertexAttribIPointer(N,k,G,W,$):n.vertexAttribPointer(N,k,G,I,W,$)}function S(N,k,G,I){x();let W=I.attributes,$=G.getAttributes(),V=k.defaultAttributeValues;for(let ce in $){let J=$[ce];if(J.location>=0){let j=W[ce];if(j===void 0&&(ce==="instanceMatrix"&&N.instanceMatrix&&(j=N.instanceMatrix),ce==="instanceColor"&&N.instanceColor&&(j=N.instanceColor)),j!==void 0){let re=j.normalized,ue=j.itemSize,fe=e.get(j);if(fe===void 0)continue;let ee=fe.buffer,me=fe.type,_e=fe.bytesPerElement,Re=me===n.INT||me===n.UNSIGNED_INT||j.gpuType===Ys;if(j.isInterleavedBufferAttribute){let be=j.data,qe=be.isInterleavedBuffer===!0?be.stride:be.itemSize,rt=j.offset;if(be.isInstancedInterleavedBuffer||be.isInstancedBufferAttribute){for(let We=0;We<J.locationSize;We++)p(J.location+We,be.meshPerAttribute);N.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=be.meshPerAttribute*be.count)}else for(let We=0;We<J.locationSize;We++)m(J.location+We);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let We=0;We<J.locationSize;We++)y(J.location+We,ue/J.locationSize,me,re,qe*_e,(rt+ue/J.locationSize*We)*_e,Re)}else{if(j.isInstancedBufferAttribute){for(let be=0;be<J.locationSize;be++)p(J.location+be,j.meshPerAttribute);N.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let be=0;be<J.locationSize;be++)m(J.location+be);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let be=0;be<J.locationSize;be++)y(J.location+be,ue/J.locationSize,me,re,ue*_e,ue/J.locationSize*be*_e,Re)}}else if(V!==void 0){let re=V[ce];if(re!==void 0)switch(re.length){case 2:n.vertexAttrib2fv(J.location,re);break;case 3:n.vertexAttrib3fv(J.location,re);break;case 4:n.vertexAttrib4fv(J.location,re);break;default:n.vertexAttrib1fv(J.location,re)}}}}_()}function R(){F();for(let N in i){let k=i[N];for(let G in k){let I=k[G];for(let W in I){let $=I[W];for(let V in $)h($[V].object),delete $[V];delete I[W]}}delete i[N]}}function A(N){if(i[N.id]===void 0)return;let k=i[N.id];for(let G in k){let I=k[G];for(let W in I){let $=I[W];for(let V in $)h($[V].object),delete $[V];delete I[W]}}delete i[N.id]}function v(N){for(let k in i){let G=i[k];for(let I in G){let W=G[I];if(W[N.id]===void 0)continue;let $=W[N.id];for(let V in $)h($[V].object),delete $[V];delete W[N.id]}}}function E(N){for(let k in i){let G=i[k],I=N.isInstancedMesh===!0?N.id:0,W=G[I];if(W!==void 0){for(let $ in W){let V=W[$];for(let ce in V)h(V[ce].object),delete V[ce];delete W[$]}delete G[I],Object.keys(G).length===0&&delete i[k]}}}function F(){D(),o=!0,s!==r&&(s=r,l(s.object))}function D(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:F,resetDefaultState:D,dispose:R,releaseStatesOfGeometry:A,releaseStatesOfObject:E,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:m,disableUnusedAttributes:_}}function Y0(n,e,t){let i;function r(c){i=c}function s(c,l){n.drawArrays(i,c,l),t.update(l,i,1)}function o(c,l,h){h!==0&&(n.drawArraysInstanced(i,c,l,h),t.update(l,i,h))}function a(c,l,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,h);let u=0;for(let d=0;d<h;d++)u+=l[d];t.update(u,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function $0(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(v){return!(v!==Oi&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let E=v===Fi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==fi&&v!==ui&&!E&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp",h=c(l);h!==l&&(Fe("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Fe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Fe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),y=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:u,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:_,maxVaryings:y,maxFragmentUniforms:S,maxSamples:R,samples:A}}function K0(n){let e=this,t=null,i=0,r=!1,s=!1,o=new zi,a=new $e,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,u){let d=f.length!==0||u||i!==0||r;return r=u,i=f.length,d},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(f,u){t=h(f,u,0)},this.setState=function(f,u,d){let g=f.clippingPlanes,x=f.clipIntersection,m=f.clipShadows,p=n.get(f);if(!r||g===null||g.length===0||s&&!m)s?h(null):l();else{let _=s?0:i,y=_*4,S=p.clippingState||null;c.value=S,S=h(g,u,y,d);for(let R=0;R!==y;++R)S[R]=t[R];p.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=_}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(f,u,d,g){let x=f!==null?f.length:0,m=null;if(x!==0){if(m=c.value,g!==!0||m===null){let p=d+x*4,_=u.matrixWorldInverse;a.getNormalMatrix(_),(m===null||m.length<p)&&(m=new Float32Array(p));for(let y=0,S=d;y!==x;++y,S+=4)o.copy(f[y]).applyMatrix4(_,a),o.normal.toArray(m,S),m[S+3]=o.constant}c.value=m,c.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}var jr=class extends Xi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new bo(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new lr(5,5,5),s=new Gi({name:"CubemapFromEquirect",uniforms:Ar(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:$t,blending:sr});s.uniforms.tEquirect.value=t;let o=new St(r,s),a=t.minFilter;return t.minFilter===xn&&(t.minFilter=Mi),new Ms(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}};var Z0=256,FS=3,OS=20,ex=256,tx=16,BS=3,kS=new C,zS=new ke,rl=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ms(1,10,null),this._boxMesh=new St(new lr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=kS}=s,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let f=c.autoClear,u=c.autoClearColor,d=c.autoClearDepth,g=c.autoClearStencil,x=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,x===null&&(e.background=c.getClearColor(zS));let m=new Ms(i,r,h);return m.position.copy(a),m.update(c,e),c.autoClear=f,c.autoClearColor=u,c.autoClearDepth=d,c.autoClearStencil=g,e.background=x,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,t)),this._applyPMREM(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=j0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Q0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Z0,Rp(e))}_fromTexture(e,t){e.mapping===or||e.mapping===Hr?this._setSize(e.image.length===0?Z0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=J0(e,!1,!1),i=Math.log2(e)-FS;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=J0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===or||e.mapping===Hr?(this._cubemapMaterial===null&&(this._cubemapMaterial=j0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Q0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=GS(),this._integrationMaterial=HS());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/tx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-BS)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let c=a>0?Math.log2(t)+.5*Math.log2(6/(ex*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=VS());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function J0(n,e,t){return new jr(n,{minFilter:xn,generateMipmaps:e,type:Fi,colorSpace:fs,depthBuffer:t})}function sl(n,e,t){return new Gi({name:n,uniforms:e,vertexShader:at.cube_vert,fragmentShader:t,side:$t,blending:sr,depthTest:!1,depthWrite:!1})}function GS(){return sl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${ex}u

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
	`)}function HS(){return sl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:tx}},`

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
	`)}function VS(){return sl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${OS}
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
	`)}function Q0(){return sl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function j0(){return sl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function ix(n){let e=new WeakMap,t=new WeakMap,i=null;function r(u,d=!1){return u==null?null:d?o(u):s(u)}function s(u){if(u&&u.isTexture){let d=u.mapping;if(d===zl||d===Gl)if(e.has(u)){let g=e.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let x=new jr(g.height);return x.fromEquirectangularTexture(n,u),e.set(u,x),u.addEventListener("dispose",l),a(x.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let d=u.mapping,g=d===zl||d===Gl,x=d===or||d===Hr;if(g||x){let m=t.get(u),p=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==p)return i===null&&(i=new rl(n)),m=g?i.fromEquirectangular(u,m):i.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),m.texture;if(m!==void 0)return m.texture;{let _=u.image;return g&&_&&_.height>0||x&&_&&c(_)?(i===null&&(i=new rl(n)),m=g?i.fromEquirectangular(u):i.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function a(u,d){return d===zl?u.mapping=or:d===Gl&&(u.mapping=Hr),u}function c(u){let d=0,g=6;for(let x=0;x<g;x++)u[x]!==void 0&&d++;return d===g}function l(u){let d=u.target;d.removeEventListener("dispose",l);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function h(u){let d=u.target;d.removeEventListener("dispose",h);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:f}}function nx(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&ds("WebGLRenderer: "+i+" extension not supported."),r}}}function rx(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(g=>delete r[g]);function a(g){c(g.target)}function c(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete r[g.id],o.unregister(g);let x=s.get(g);x&&(e.remove(x),s.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function l(g,x){return r[x.id]!==void 0||(x.addEventListener("dispose",a),r[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function h(g){let x=g.attributes;for(let m in x)e.update(x[m],n.ARRAY_BUFFER)}function f(g){let x=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let _=x!==null?x.array.length:m.array.length/3-1,y=m.count>=65535?Mo:vo,S=new y(Math.ceil(_/3)*6,1),R=S.array;if(x!==null){let v=x.array;p=x.version;for(let E=0,F=0;E<_;E+=3){let D=v[E+0],N=v[E+1],k=v[E+2];R[F++]=D,R[F++]=N,R[F++]=N,R[F++]=k,R[F++]=k,R[F++]=D}}else{p=m.version;for(let v=0,E=0;v<_;v+=3){let F=v+0,D=v+1,N=v+2;R[E++]=F,R[E++]=D,R[E++]=D,R[E++]=N,R[E++]=N,R[E++]=F}}S.version=p;let A=s.get(g);A&&e.remove(A),s.set(g,S)}function u(g){let x=s.get(g);if(x){let m=g.index;m!==null&&x.version<m.version&&f(g)}else f(g);return s.get(g)}function d(){for(let g in r){let x=r[g].deref();x!==void 0&&c(x)}}return{get:l,update:h,getWireframeAttribute:u,dispose:d}}function sx(n,e,t){let i;function r(f){i=f}let s,o;function a(f){s=f.type,o=f.bytesPerElement}function c(f,u){n.drawElements(i,u,s,f*o),t.update(u,i,1)}function l(f,u,d){d!==0&&(n.drawElementsInstanced(i,u,s,f*o,d),t.update(u,i,d))}function h(f,u,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,s,f,0,d);let x=0;for(let m=0;m<d;m++)x+=u[m];t.update(x,i,1)}this.setMode=r,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function ox(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:ut("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function ax(n,e,t){let i=new WeakMap,r=new Et;function s(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=h!==void 0?h.length:0,u=i.get(a);if(u===void 0||u.count!==f){let F=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",F)};u!==void 0&&u.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],y=0;d===!0&&(y=1),g===!0&&(y=2),x===!0&&(y=3);let S=a.attributes.position.count*y,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let A=new Float32Array(S*R*4*f),v=new ao(A,S,R,f);v.type=ui,v.needsUpdate=!0;let E=y*4;for(let D=0;D<f;D++){let N=m[D],k=p[D],G=_[D],I=S*R*4*D;for(let W=0;W<N.count;W++){let $=W*E;d===!0&&(r.fromBufferAttribute(N,W),A[I+$+0]=r.x,A[I+$+1]=r.y,A[I+$+2]=r.z,A[I+$+3]=0),g===!0&&(r.fromBufferAttribute(k,W),A[I+$+4]=r.x,A[I+$+5]=r.y,A[I+$+6]=r.z,A[I+$+7]=0),x===!0&&(r.fromBufferAttribute(G,W),A[I+$+8]=r.x,A[I+$+9]=r.y,A[I+$+10]=r.z,A[I+$+11]=G.itemSize===4?r.w:1)}}u={count:f,texture:v,size:new Ke(S,R)},i.set(a,u),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let x=0;x<l.length;x++)d+=l[x];let g=a.morphTargetsRelative?1:1-d;c.getUniforms().setValue(n,"morphTargetBaseInfluence",g),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",u.texture,t),c.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:s}}function lx(n,e,t,i,r){let s=new WeakMap;function o(l){let h=r.render.frame,f=l.geometry,u=e.get(l,f);if(s.get(u)!==h&&(e.update(u),s.set(u,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),s.get(l)!==h&&(t.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,h))),l.isSkinnedMesh){let d=l.skeleton;s.get(d)!==h&&(d.update(),s.set(d,h))}return u}function a(){s=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var WS={[Nl]:"LINEAR_TONE_MAPPING",[Il]:"REINHARD_TONE_MAPPING",[Ul]:"CINEON_TONE_MAPPING",[Fl]:"ACES_FILMIC_TONE_MAPPING",[Bl]:"AGX_TONE_MAPPING",[kl]:"NEUTRAL_TONE_MAPPING",[Ol]:"CUSTOM_TONE_MAPPING"};function cx(n,e,t,i,r,s){let o=new Xi(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new Tt;h.setAttribute("position",new bt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new bt([0,2,0,0,2,0],2));let f=new Dc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new St(h,f),d=new Lo(-1,1,1,-1,0,1),g=null,x=null,m=!1,p,_=null,y=[],S=!1;this.setSize=function(R,A){o.setSize(R,A),a!==null&&a.setSize(R,A),c!==null&&c.setSize(R,A);for(let v=0;v<y.length;v++){let E=y[v];E.setSize&&E.setSize(R,A)}},this.setEffects=function(R){y=R,S=y.length>0&&y[0].isRenderPass===!0;let A=o.width,v=o.height;y.length>0&&a===null&&(a=new Xi(A,v,{type:Fi,depthBuffer:!1,stencilBuffer:!1}),c=new Xi(A,v,{type:Fi,depthBuffer:!1,stencilBuffer:!1}));let E=r===!0&&y.some(F=>F.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&l===null&&(l=new bn(A,v),s===!0&&(l.format=_n,l.type=Wn)),o.dispose(),o.depthTexture=E?l:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let F=0;F<y.length;F++){let D=y[F];D.setSize&&D.setSize(A,v),E&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(l)}},this.begin=function(R,A){if(m||R.toneMapping===gn&&y.length===0)return!1;if(_=A,A!==null){let v=A.width,E=A.height;(o.width!==v||o.height!==E)&&this.setSize(v,E)}return S===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=gn,!0},this.hasRenderPass=function(){return S},this.end=function(R,A){R.toneMapping=p,m=!0;let v=o,E=a;for(let F=0;F<y.length;F++){let D=y[F];D.enabled!==!1&&(D.render(R,E,v,A),D.needsSwap!==!1&&(v=E,E=E===a?c:a))}if(g!==R.outputColorSpace||x!==R.toneMapping){g=R.outputColorSpace,x=R.toneMapping,f.defines={},ot.getTransfer(g)===vt&&(f.defines.SRGB_TRANSFER="");let F=WS[x];F&&(f.defines[F]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=v.texture,R.setRenderTarget(_),R.render(u,d),_=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),f.dispose()}}var gx=new di,xx=new bn(1,1),_x=new wo(1),vx=new ao,Mx=new sc,Sx=new bo,hx=[],fx=[],ux=new Float32Array(16),dx=new Float32Array(9),px=new Float32Array(4);function Io(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=hx[r];if(s===void 0&&(s=new Float32Array(r),hx[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function Ti(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Ai(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Hc(n,e){let t=fx[e];t===void 0&&(t=new Int32Array(e),fx[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function XS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function qS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ti(t,e))return;n.uniform2fv(this.addr,e),Ai(t,e)}}function YS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ti(t,e))return;n.uniform3fv(this.addr,e),Ai(t,e)}}function $S(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ti(t,e))return;n.uniform4fv(this.addr,e),Ai(t,e)}}function KS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ti(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Ai(t,e)}else{if(Ti(t,i))return;px.set(i),n.uniformMatrix2fv(this.addr,!1,px),Ai(t,i)}}function ZS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ti(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Ai(t,e)}else{if(Ti(t,i))return;dx.set(i),n.uniformMatrix3fv(this.addr,!1,dx),Ai(t,i)}}function JS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ti(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Ai(t,e)}else{if(Ti(t,i))return;ux.set(i),n.uniformMatrix4fv(this.addr,!1,ux),Ai(t,i)}}function QS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function jS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ti(t,e))return;n.uniform2iv(this.addr,e),Ai(t,e)}}function ey(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ti(t,e))return;n.uniform3iv(this.addr,e),Ai(t,e)}}function ty(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ti(t,e))return;n.uniform4iv(this.addr,e),Ai(t,e)}}function iy(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function ny(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ti(t,e))return;n.uniform2uiv(this.addr,e),Ai(t,e)}}function ry(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ti(t,e))return;n.uniform3uiv(this.addr,e),Ai(t,e)}}function sy(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ti(t,e))return;n.uniform4uiv(this.addr,e),Ai(t,e)}}function Vc(n){return n.version===0&&(n.compareFunction=jl,n.needsUpdate=!0),n}function oy(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=Vc(xx):s=gx,t.setTexture2D(e||s,r)}function ay(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||Mx,r)}function ly(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=Vc(_x):s=Sx,t.setTextureCube(e||s,r)}function cy(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||vx,r)}function hy(n){switch(n){case 5126:return XS;case 35664:return qS;case 35665:return YS;case 35666:return $S;case 35674:return KS;case 35675:return ZS;case 35676:return JS;case 5124:case 35670:return QS;case 35667:case 35671:return jS;case 35668:case 35672:return ey;case 35669:case 35673:return ty;case 5125:return iy;case 36294:return ny;case 36295:return ry;case 36296:return sy;case 35678:case 36198:case 36298:case 36306:case 35682:return oy;case 35679:case 36299:case 36307:return ay;case 35680:case 36300:case 36308:case 36293:return ly;case 36289:case 36303:case 36311:case 36292:return cy}}function fy(n,e){n.uniform1fv(this.addr,e)}function uy(n,e){let t=Io(e,this.size,2);n.uniform2fv(this.addr,t)}function dy(n,e){let t=Io(e,this.size,3);n.uniform3fv(this.addr,t)}function py(n,e){let t=Io(e,this.size,4);n.uniform4fv(this.addr,t)}function my(n,e){let t=Io(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function gy(n,e){let t=Io(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function xy(n,e){let t=Io(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function _y(n,e){n.uniform1iv(this.addr,e)}function vy(n,e){n.uniform2iv(this.addr,e)}function My(n,e){n.uniform3iv(this.addr,e)}function Sy(n,e){n.uniform4iv(this.addr,e)}function yy(n,e){n.uniform1uiv(this.addr,e)}function by(n,e){n.uniform2uiv(this.addr,e)}function wy(n,e){n.uniform3uiv(this.addr,e)}function Ey(n,e){n.uniform4uiv(this.addr,e)}function Ty(n,e,t){let i=this.cache,r=e.length,s=Hc(t,r);Ti(i,s)||(n.uniform1iv(this.addr,s),Ai(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=Vc(xx):o=gx;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function Ay(n,e,t){let i=this.cache,r=e.length,s=Hc(t,r);Ti(i,s)||(n.uniform1iv(this.addr,s),Ai(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||Mx,s[o])}function Ry(n,e,t){let i=this.cache,r=e.length,s=Hc(t,r);Ti(i,s)||(n.uniform1iv(this.addr,s),Ai(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Vc(_x):o=Sx;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function Cy(n,e,t){let i=this.cache,r=e.length,s=Hc(t,r);Ti(i,s)||(n.uniform1iv(this.addr,s),Ai(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||vx,s[o])}function Py(n){switch(n){case 5126:return fy;case 35664:return uy;case 35665:return dy;case 35666:return py;case 35674:return my;case 35675:return gy;case 35676:return xy;case 5124:case 35670:return _y;case 35667:case 35671:return vy;case 35668:case 35672:return My;case 35669:case 35673:return Sy;case 5125:return yy;case 36294:return by;case 36295:return wy;case 36296:return Ey;case 35678:case 36198:case 36298:case 36306:case 35682:return Ty;case 35679:case 36299:case 36307:return Ay;case 35680:case 36300:case 36308:case 36293:return Ry;case 36289:case 36303:case 36311:case 36292:return Cy}}var nu=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=hy(t.type)}},ru=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Py(t.type)}},su=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},iu=/(\w+)(\])?(\[|\.)?/g;function mx(n,e){n.seq.push(e),n.map[e.id]=e}function Ly(n,e,t){let i=n.name,r=i.length;for(iu.lastIndex=0;;){let s=iu.exec(i),o=iu.lastIndex,a=s[1],c=s[2]==="]",l=s[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===r){mx(t,l===void 0?new nu(a,n,e):new ru(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new su(a),mx(t,f)),t=f}}}var es=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),c=e.getUniformLocation(t,a.name);Ly(a,c,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],c=i[a.id];c.needsUpdate!==!1&&a.setValue(e,c.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function ou(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var Dy=37297,Ny=0;function Iy(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var yx=new $e;function Uy(n){ot._getMatrix(yx,ot.workingColorSpace,n);let e=`mat3( ${yx.elements.map(t=>t.toFixed(4))} )`;switch(ot.getTransfer(n)){case us:return[e,"LinearTransferOETF"];case vt:return[e,"sRGBTransferOETF"];default:return Fe("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function bx(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+Iy(n.getShaderSource(e),a)}else return s}function Fy(n,e){let t=Uy(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Oy={[Nl]:"Linear",[Il]:"Reinhard",[Ul]:"Cineon",[Fl]:"ACESFilmic",[Bl]:"AgX",[kl]:"Neutral",[Ol]:"Custom"};function By(n,e){let t=Oy[e];return t===void 0?(Fe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Wc=new C;function ky(){ot.getLuminanceCoefficients(Wc);let n=Wc.x.toFixed(4),e=Wc.y.toFixed(4),t=Wc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function zy(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ol).join(`
`)}function Gy(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function Hy(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function ol(n){return n!==""}function wx(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Ex(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Vy=/^[ \t]*#include +<([\w\d./]+)>/gm;function au(n){return n.replace(Vy,Wy)}function Wy(n,e){let t=at[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return au(t)}var Xy=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Tx(n){return n.replace(Xy,qy)}function qy(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function Ax(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var Yy={[Xs]:"SHADOWMAP_TYPE_PCF",[as]:"SHADOWMAP_TYPE_VSM"};function $y(n){return Yy[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Ky={[Hr]:"ENVMAP_MODE_REFRACTION"};function Zy(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Ky[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Jy={[qs]:"ENVMAP_BLENDING_MULTIPLY",[sp]:"ENVMAP_BLENDING_MIX",[op]:"ENVMAP_BLENDING_ADD"};function Qy(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Jy[n.combine]||"ENVMAP_BLENDING_NONE"}function Rx(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,c=$y(t),l=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Zy(t),f=Qy(t),u=zy(t),d=Gy(s),g=r.createProgram(),x,m,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(ol).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(ol).join(`
`),m.length>0&&(m+=`
`)):(x=[Ax(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ol).join(`
`),m=[Ax(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+h:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==gn?"#define TONE_MAPPING":"",t.toneMapping!==gn?at.tonemapping_pars_fragment:"",t.toneMapping!==gn?By("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",at.colorspace_pars_fragment,Fy("linearToOutputTexel",t.outputColorSpace),ky(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ol).join(`
`)),o=au(o),o=wx(o,t),o=Ex(o,t),a=au(a),a=wx(a,t),a=Ex(a,t),o=Tx(o),a=Tx(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,x=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",t.glslVersion===Pf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Pf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let _=p+x+o,y=p+m+a,S=ou(r,r.VERTEX_SHADER,_),R=ou(r,r.FRAGMENT_SHADER,y);r.attachShader(g,S),r.attachShader(g,R),t.index0AttributeName!==void 0?r.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(g,0,"position"),r.linkProgram(g);function A(D){if(n.debug.checkShaderErrors){let N=r.getProgramInfoLog(g)||"",k=r.getShaderInfoLog(S)||"",G=r.getShaderInfoLog(R)||"",I=N.trim(),W=k.trim(),$=G.trim(),V=!0,ce=!0;if(r.getProgramParameter(g,r.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,g,S,R);else{let J=bx(r,S,"vertex"),j=bx(r,R,"fragment");ut("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(g,r.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+I+`
`+J+`
`+j)}else I!==""?Fe("WebGLProgram: Program Info Log:",I):(W===""||$==="")&&(ce=!1);ce&&(D.diagnostics={runnable:V,programLog:I,vertexShader:{log:W,prefix:x},fragmentShader:{log:$,prefix:m}})}r.deleteShader(S),r.deleteShader(R),v=new es(r,g),E=Hy(r,g)}let v;this.getUniforms=function(){return v===void 0&&A(this),v};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=r.getProgramParameter(g,Dy)),F},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Ny++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=R,this}var jy=0,Xc=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new lu(e),t.set(e,i)),i}},lu=class{constructor(e){this.id=jy++,this.code=e,this.usedTimes=0}};function eb(n){return n===vn||n===cs||n===hs}function Cx(n,e,t,i,r,s){let o=new Xr,a=new Xc,c=new Set,l=[],h=new Map,f=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(v){return c.add(v),v===0?"uv":`uv${v}`}function g(v,E,F,D,N,k){let G=D.fog,I=N.geometry,W=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?D.environment:null,$=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,V=e.get(v.envMap||W,$),ce=u[v.type],J=i.precision;v.precision!==null&&(J=i.getMaxPrecision(v.precision),J!==v.precision&&Fe("WebGLProgram.getParameters:",v.precision,"not supported, using",J,"instead."));let j=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,re=j!==void 0?j.length:0,ue=0;I.morphAttributes.position!==void 0&&(ue=1),I.morphAttributes.normal!==void 0&&(ue=2),I.morphAttributes.color!==void 0&&(ue=3);let fe,ee,me,_e;if(ce){let Ce=Un[ce];fe=Ce.vertexShader,ee=Ce.fragmentShader}else{fe=v.vertexShader,ee=v.fragmentShader;let Ce=a.getVertexShaderStage(v),lt=a.getFragmentShaderStage(v);a.update(v,Ce,lt),me=Ce.id,_e=lt.id}let Re=n.getRenderTarget(),be=n.state.buffers.depth.getReversed(),qe=N.isInstancedMesh===!0,rt=N.isBatchedMesh===!0,We=!!v.map,dt=!!v.matcap,ht=!!V,it=ht&&V.isPMREMTexture===!0,Zt=!!v.aoMap,Ht=!!v.lightMap,pi=!!v.bumpMap&&v.wireframe===!1,Ft=!!v.normalMap,Pi=!!v.displacementMap,yt=!!v.emissiveMap,bi=!!v.metalnessMap,ii=!!v.roughnessMap,mi=v.anisotropy>0,B=v.clearcoat>0,Pe=v.diffuseRoughness>0,Je=v.dispersion>0,st=v.retroreflectivity>0,we=v.iridescence>0,kt=v.sheen>0,Ve=v.transmission>0,Ze=mi&&!!v.anisotropyMap,P=B&&!!v.clearcoatMap,b=B&&!!v.clearcoatNormalMap,X=B&&!!v.clearcoatRoughnessMap,he=Pe&&!!v.diffuseRoughnessMap,oe=we&&!!v.iridescenceMap,xe=we&&!!v.iridescenceThicknessMap,ve=kt&&!!v.sheenColorMap,te=kt&&!!v.sheenRoughnessMap,ne=!!v.specularMap,pe=!!v.specularColorMap,O=!!v.specularIntensityMap,se=Ve&&!!v.transmissionMap,ie=Ve&&!!v.thicknessMap,Ee=!!v.gradientMap,ge=!!v.alphaMap,Se=v.alphaTest>0,Xe=!!v.alphaHash,je=!!v.extensions,le=gn;v.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(le=n.toneMapping);let ze=it?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,et={shaderID:ce,shaderType:v.type,shaderName:v.name,vertexShader:fe,fragmentShader:ee,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:_e,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:J,batching:rt,batchingColor:rt&&N._colorsTexture!==null,instancing:qe,instancingColor:qe&&N.instanceColor!==null,instancingMorph:qe&&N.morphTexture!==null,outputColorSpace:Re===null?n.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:ot.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:We,matcap:dt,envMap:ht,envMapMode:ht&&V.mapping,envMapPMREM:it,envMapMaxLod:it?ze.length-1:null,envMapSize:it?ze[0].width:null,aoMap:Zt,lightMap:Ht,bumpMap:pi,normalMap:Ft,displacementMap:Pi,emissiveMap:yt,normalMapObjectSpace:Ft&&v.normalMapType===cp,normalMapTangentSpace:Ft&&v.normalMapType===Wa,packedNormalMap:Ft&&v.normalMapType===Wa&&eb(v.normalMap.format),metalnessMap:bi,roughnessMap:ii,anisotropy:mi,anisotropyMap:Ze,clearcoat:B,clearcoatMap:P,clearcoatNormalMap:b,clearcoatRoughnessMap:X,diffuseRoughness:Pe,diffuseRoughnessMap:he,dispersion:Je,retroreflection:st,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:xe,sheen:kt,sheenColorMap:ve,sheenRoughnessMap:te,specularMap:ne,specularColorMap:pe,specularIntensityMap:O,transmission:Ve,transmissionMap:se,thicknessMap:ie,gradientMap:Ee,opaque:v.transparent===!1&&v.blending===kr&&v.alphaToCoverage===!1,alphaMap:ge,alphaTest:Se,alphaHash:Xe,combine:v.combine,mapUv:We&&d(v.map.channel),aoMapUv:Zt&&d(v.aoMap.channel),lightMapUv:Ht&&d(v.lightMap.channel),bumpMapUv:pi&&d(v.bumpMap.channel),normalMapUv:Ft&&d(v.normalMap.channel),displacementMapUv:Pi&&d(v.displacementMap.channel),emissiveMapUv:yt&&d(v.emissiveMap.channel),metalnessMapUv:bi&&d(v.metalnessMap.channel),roughnessMapUv:ii&&d(v.roughnessMap.channel),anisotropyMapUv:Ze&&d(v.anisotropyMap.channel),clearcoatMapUv:P&&d(v.clearcoatMap.channel),clearcoatNormalMapUv:b&&d(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&d(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&d(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(v.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&d(v.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&d(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(v.sheenRoughnessMap.channel),specularMapUv:ne&&d(v.specularMap.channel),specularColorMapUv:pe&&d(v.specularColorMap.channel),specularIntensityMapUv:O&&d(v.specularIntensityMap.channel),transmissionMapUv:se&&d(v.transmissionMap.channel),thicknessMapUv:ie&&d(v.thicknessMap.channel),alphaMapUv:ge&&d(v.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Ft||mi),vertexNormals:!!I.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!I.attributes.uv&&(We||ge),fog:!!G,useFog:v.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||I.attributes.normal===void 0&&Ft===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:be,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:re,morphTextureStride:ue,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:k.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&F.length>0,shadowMapType:n.shadowMap.type,toneMapping:le,decodeVideoTexture:We&&v.map.isVideoTexture===!0&&ot.getTransfer(v.map.colorSpace)===vt,decodeVideoTextureEmissive:yt&&v.emissiveMap.isVideoTexture===!0&&ot.getTransfer(v.emissiveMap.colorSpace)===vt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Ei,flipSided:v.side===$t,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:je&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&v.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return et.vertexUv1s=c.has(1),et.vertexUv2s=c.has(2),et.vertexUv3s=c.has(3),c.clear(),et}function x(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let F in v.defines)E.push(F),E.push(v.defines[F]);return v.isRawShaderMaterial===!1&&(m(E,v),p(E,v),E.push(n.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function m(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapPMREM),v.push(E.envMapMaxLod),v.push(E.envMapSize),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.diffuseRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.numSunLights),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numSunLightShadows),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.numLightProbeGrids),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function p(v,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function _(v){let E=u[v.type],F;if(E){let D=Un[E];F=tm.clone(D.uniforms)}else F=v.uniforms;return F}function y(v,E){let F=h.get(E);return F!==void 0?++F.usedTimes:(F=new Rx(n,E,v,r),l.push(F),h.set(E,F)),F}function S(v){if(--v.usedTimes===0){let E=l.indexOf(v);l[E]=l[l.length-1],l.pop(),h.delete(v.cacheKey),v.destroy()}}function R(v){a.remove(v)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:x,getUniforms:_,acquireProgram:y,releaseProgram:S,releaseShaderCache:R,programs:l,dispose:A}}function Px(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,c){n.get(o)[a]=c}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function tb(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Lx(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Dx(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(u){let d=0;return u.isInstancedMesh&&(d+=2),u.isSkinnedMesh&&(d+=1),d}function a(u,d,g,x,m,p){let _=n[e];return _===void 0?(_={id:u.id,object:u,geometry:d,material:g,materialVariant:o(u),groupOrder:x,renderOrder:u.renderOrder,z:m,group:p},n[e]=_):(_.id=u.id,_.object=u,_.geometry=d,_.material=g,_.materialVariant=o(u),_.groupOrder=x,_.renderOrder=u.renderOrder,_.z=m,_.group=p),e++,_}function c(u,d,g,x,m,p,_){_.reversedDepth===!0&&(m=-m);let y=a(u,d,g,x,m,p);g.transmission>0?i.push(y):g.transparent===!0?r.push(y):t.push(y)}function l(u,d,g,x,m,p){let _=a(u,d,g,x,m,p);g.transmission>0?i.unshift(_):g.transparent===!0?r.unshift(_):t.unshift(_)}function h(u,d){t.length>1&&t.sort(u||tb),i.length>1&&i.sort(d||Lx),r.length>1&&r.sort(d||Lx)}function f(){for(let u=e,d=n.length;u<d;u++){let g=n[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:c,unshift:l,finish:f,sort:h}}function Nx(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new Dx,n.set(i,[o])):r>=s.length?(o=new Dx,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function ib(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new C,color:new ke};break;case"SpotLight":t={position:new C,direction:new C,color:new ke,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new C,color:new ke,distance:0,decay:0};break;case"HemisphereLight":t={direction:new C,skyColor:new ke,groundColor:new ke};break;case"RectAreaLight":t={color:new ke,position:new C,halfWidth:new C,halfHeight:new C};break}return n[e.id]=t,t}}}function nb(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var rb=0;function sb(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function Ix(n){let e=new ib,t=nb(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new C);let r=new C,s=new ye,o=new ye;function a(l){let h=0,f=0,u=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let d=0,g=0,x=0,m=0,p=0,_=0,y=0,S=0,R=0,A=0,v=0,E=0,F=0,D=0;l.sort(sb);for(let k=0,G=l.length;k<G;k++){let I=l[k],W=I.color,$=I.intensity,V=I.distance,ce=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===vn?ce=I.shadow.map.texture:ce=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=W.r*$,f+=W.g*$,u+=W.b*$;else if(I.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(I.sh.coefficients[J],$);D++}else if(I.isSunLight){let J=e.get(I);if(J.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let j=I.shadow,re=t.get(I);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[g]=re,i.sunShadowMap[g]=ce;let ue=j.getViewportCount();for(let fe=0;fe<ue;fe++)i.sunShadowMatrix[x+fe]=j.getMatrix(fe),i.sunShadowCascade[x+fe]=j._cascadeData[fe];x+=ue,g++}i.sun[d]=J,d++}else if(I.isDirectionalLight){let J=e.get(I);if(J.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let j=I.shadow,re=t.get(I);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize=j.mapSize,i.directionalShadow[m]=re,i.directionalShadowMap[m]=ce,i.directionalShadowMatrix[m]=I.shadow.matrix,R++}i.directional[m]=J,m++}else if(I.isSpotLight){let J=e.get(I);J.position.setFromMatrixPosition(I.matrixWorld),J.color.copy(W).multiplyScalar($),J.distance=V,J.coneCos=Math.cos(I.angle),J.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),J.decay=I.decay,i.spot[_]=J;let j=I.shadow;if(I.map&&(i.spotLightMap[E]=I.map,E++,j.updateMatrices(I),I.castShadow&&F++),i.spotLightMatrix[_]=j.matrix,I.castShadow){let re=t.get(I);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize=j.mapSize,i.spotShadow[_]=re,i.spotShadowMap[_]=ce,v++}_++}else if(I.isRectAreaLight){let J=e.get(I);J.color.copy(W).multiplyScalar($),J.halfWidth.set(I.width*.5,0,0),J.halfHeight.set(0,I.height*.5,0),i.rectArea[y]=J,y++}else if(I.isPointLight){let J=e.get(I);if(J.color.copy(I.color).multiplyScalar(I.intensity),J.distance=I.distance,J.decay=I.decay,I.castShadow){let j=I.shadow,re=t.get(I);re.shadowIntensity=j.intensity,re.shadowBias=j.bias,re.shadowNormalBias=j.normalBias,re.shadowRadius=j.radius,re.shadowMapSize=j.mapSize,re.shadowCameraNear=j.camera.near,re.shadowCameraFar=j.camera.far,i.pointShadow[p]=re,i.pointShadowMap[p]=ce,i.pointShadowMatrix[p]=I.shadow.matrix,A++}i.point[p]=J,p++}else if(I.isHemisphereLight){let J=e.get(I);J.skyColor.copy(I.color).multiplyScalar($),J.groundColor.copy(I.groundColor).multiplyScalar($),i.hemi[S]=J,S++}}y>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=De.LTC_FLOAT_1,i.rectAreaLTC2=De.LTC_FLOAT_2):(i.rectAreaLTC1=De.LTC_HALF_1,i.rectAreaLTC2=De.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=f,i.ambient[2]=u;let N=i.hash;(N.sunLength!==d||N.directionalLength!==m||N.pointLength!==p||N.spotLength!==_||N.rectAreaLength!==y||N.hemiLength!==S||N.numSunShadows!==g||N.numDirectionalShadows!==R||N.numPointShadows!==A||N.numSpotShadows!==v||N.numSpotMaps!==E||N.numLightProbes!==D)&&(i.sun.length=d,i.directional.length=m,i.spot.length=_,i.rectArea.length=y,i.point.length=p,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+E-F,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=F,i.numLightProbes=D,N.sunLength=d,N.directionalLength=m,N.pointLength=p,N.spotLength=_,N.rectAreaLength=y,N.hemiLength=S,N.numSunShadows=g,N.numDirectionalShadows=R,N.numPointShadows=A,N.numSpotShadows=v,N.numSpotMaps=E,N.numLightProbes=D,i.version=rb++)}function c(l,h){let f=0,u=0,d=0,g=0,x=0,m=0,p=h.matrixWorldInverse;for(let _=0,y=l.length;_<y;_++){let S=l[_];if(S.isSunLight){let R=i.sun[f];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(p),f++}else if(S.isDirectionalLight){let R=i.directional[u];R.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(r),R.direction.transformDirection(p),u++}else if(S.isSpotLight){let R=i.spot[g];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(r),R.direction.transformDirection(p),g++}else if(S.isRectAreaLight){let R=i.rectArea[x];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(p),o.identity(),s.copy(S.matrixWorld),s.premultiply(p),o.extractRotation(s),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let R=i.point[d];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(p),d++}else if(S.isHemisphereLight){let R=i.hemi[m];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(p),m++}}}return{setup:a,setupView:c,state:i}}function Ux(n){let e=new Ix(n),t=[],i=[],r=[];function s(f){h.camera=f,t.length=0,i.length=0,r.length=0}function o(f){f.isLightProbeGrid?r.push(f):t.push(f)}function a(f){i.push(f)}function c(){e.setup(t),r.sort((f,u)=>f.priority-u.priority||f.id-u.id)}function l(f){e.setupView(t,f)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function Fx(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new Ux(n),e.set(r,[a])):s>=o.length?(a=new Ux(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var Ox=`
void main() {
gl_Position = vec4( position, 1.0 );
}
`,Bx=`
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
`;var ab=[new C(1,0,0),new C(-1,0,0),new C(0,1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1)],lb=[new C(0,-1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1),new C(0,-1,0),new C(0,-1,0)],kx=new ye,al=new C,cu=new C;function zx(n,e,t){let i=new hn,r=new Ke,s=new Ke,o=new Et,a=new Nc,c=new Ic,l={},h=t.maxTextureSize,f={[Yi]:$t,[$t]:Yi,[Ei]:Ei},u=new Gi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:Ox,fragmentShader:Bx}),d=u.clone();d.defines.HORIZONTAL_PASS=1;let g=new Tt;g.setAttribute("position",new Pt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new St(g,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xs;let p=this.type;this.render=function(A,v,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;this.type===zd&&(Fe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Xs);let F=n.getRenderTarget(),D=n.getActiveCubeFace(),N=n.getActiveMipmapLevel(),k=n.state;k.setBlending(sr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let G=p!==this.type;G&&v.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(W=>W.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,W=A.length;I<W;I++){let $=A[I],V=$.shadow;if(V===void 0){Fe("WebGLShadowMap:",$,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;r.copy(V.mapSize);let ce=V.getFrameExtents();r.multiply(ce),s.copy(V.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/ce.x),r.x=s.x*ce.x,V.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/ce.y),r.y=s.y*ce.y,V.mapSize.y=s.y));let J=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=J,V.map===null||G===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===as){if($.isPointLight){Fe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new Xi(r.x,r.y,{format:vn,type:Fi,minFilter:Mi,magFilter:Mi,generateMipmaps:!1}),V.map.texture.name=$.name+".shadowMap",V.map.depthTexture=new bn(r.x,r.y,ui),V.map.depthTexture.name=$.name+".shadowMapDepth",V.map.depthTexture.format=ln,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Qt,V.map.depthTexture.magFilter=Qt}else $.isPointLight?(V.map=new jr(r.x),V.map.depthTexture=new wo(r.x,Ui)):(V.map=new Xi(r.x,r.y),V.map.depthTexture=new bn(r.x,r.y,Ui)),V.map.depthTexture.name=$.name+".shadowMap",V.map.depthTexture.format=ln,this.type===Xs?(V.map.depthTexture.compareFunction=J?Ql:Jl,V.map.depthTexture.minFilter=Mi,V.map.depthTexture.magFilter=Mi):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Qt,V.map.depthTexture.magFilter=Qt);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==r.x||V.map.height!==r.y)&&V.map.setSize(r.x,r.y);let j=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();$.isPointLight!==!0&&V.updateMatrices($,E);let re=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:E.layers;for(let ue=0;ue<j;ue++){let fe=V.getCamera(ue);if($.isPointLight){let ee=V.camera,me=V.matrix,_e=$.distance||ee.far;_e!==ee.far&&(ee.far=_e,ee.updateProjectionMatrix()),al.setFromMatrixPosition($.matrixWorld),ee.position.copy(al),cu.copy(ee.position),cu.add(ab[ue]),ee.up.copy(lb[ue]),ee.lookAt(cu),ee.updateMatrixWorld(),me.makeTranslation(-al.x,-al.y,-al.z),kx.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),V._frustum.setFromProjectionMatrix(kx,ee.coordinateSystem,ee.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,ue),n.clear();else{ue===0&&(n.setRenderTarget(V.map),n.clear());let ee=V.getViewport(ue);o.set(s.x*ee.x,s.y*ee.y,s.x*ee.z,s.y*ee.w),k.viewport(o)}i=V.getFrustum(ue),S(v,E,fe,$,re,this.type)}V.isPointLightShadow!==!0&&this.type===as&&_(V,E),V.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(F,D,N)};function _(A,v){let E=e.update(x);u.defines.VSM_SAMPLES!==A.blurSamples&&(u.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,u.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null?A.mapPass=new Xi(r.x,r.y,{format:vn,type:Fi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),u.uniforms.shadow_pass.value=A.map.depthTexture,u.uniforms.resolution.value.set(A.map.width,A.map.height),u.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(v,null,E,u,x,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(v,null,E,d,x,null)}function y(A,v,E,F){let D=null,N=E.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(N!==void 0)D=N;else if(D=E.isPointLight===!0?c:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let k=D.uuid,G=v.uuid,I=l[k];I===void 0&&(I={},l[k]=I);let W=I[G];W===void 0&&(W=D.clone(),I[G]=W,v.addEventListener("dispose",R)),D=W}if(D.visible=v.visible,D.wireframe=v.wireframe,F===as?D.side=v.shadowSide!==null?v.shadowSide:v.side:D.side=v.shadowSide!==null?v.shadowSide:f[v.side],D.alphaMap=v.alphaMap,D.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,D.map=v.map,D.clipShadows=v.clipShadows,D.clippingPlanes=v.clippingPlanes,D.clipIntersection=v.clipIntersection,D.displacementMap=v.displacementMap,D.displacementScale=v.displacementScale,D.displacementBias=v.displacementBias,D.wireframeLinewidth=v.wireframeLinewidth,D.linewidth=v.linewidth,E.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let k=n.properties.get(D);k.light=E}return D}function S(A,v,E,F,D,N){if(A.visible===!1)return;if(A.layers.test(D)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&N===as)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,A.matrixWorld);let I=e.update(A),W=A.material;if(Array.isArray(W)){let $=I.groups;for(let V=0,ce=$.length;V<ce;V++){let J=$[V],j=W[J.materialIndex];if(j&&j.visible){let re=y(A,j,F,N);A.onBeforeShadow(n,A,v,E,I,re,J),n.renderBufferDirect(E,null,I,re,A,J),A.onAfterShadow(n,A,v,E,I,re,J)}}}else if(W.visible){let $=y(A,W,F,N);A.onBeforeShadow(n,A,v,E,I,$,null),n.renderBufferDirect(E,null,I,$,A,null),A.onAfterShadow(n,A,v,E,I,$,null)}}let G=A.children;for(let I=0,W=G.length;I<W;I++)S(G[I],v,E,F,D,N)}function R(A){A.target.removeEventListener("dispose",R);for(let E in l){let F=l[E],D=A.target.uuid;D in F&&(F[D].dispose(),delete F[D])}}}function Gx(n,e){function t(){let O=!1,se=new Et,ie=null,Ee=new Et(0,0,0,0);return{setMask:function(ge){ie!==ge&&!O&&(n.colorMask(ge,ge,ge,ge),ie=ge)},setLocked:function(ge){O=ge},setClear:function(ge,Se,Xe,je,le){le===!0&&(ge*=je,Se*=je,Xe*=je),se.set(ge,Se,Xe,je),Ee.equals(se)===!1&&(n.clearColor(ge,Se,Xe,je),Ee.copy(se))},reset:function(){O=!1,ie=null,Ee.set(-1,0,0,0)}}}function i(){let O=!1,se=!1,ie=null,Ee=null,ge=null;return{setReversed:function(Se){if(se!==Se){let Xe=e.get("EXT_clip_control");Se?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),se=Se;let je=ge;ge=null,this.setClear(je)}},getReversed:function(){return se},setTest:function(Se){Se?be(n.DEPTH_TEST):qe(n.DEPTH_TEST)},setMask:function(Se){ie!==Se&&!O&&(n.depthMask(Se),ie=Se)},setFunc:function(Se){if(se&&(Se=Tp[Se]),Ee!==Se){switch(Se){case sa:n.depthFunc(n.NEVER);break;case oa:n.depthFunc(n.ALWAYS);break;case ls:n.depthFunc(n.LESS);break;case Gr:n.depthFunc(n.LEQUAL);break;case aa:n.depthFunc(n.EQUAL);break;case la:n.depthFunc(n.GEQUAL);break;case ca:n.depthFunc(n.GREATER);break;case ha:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ee=Se}},setLocked:function(Se){O=Se},setClear:function(Se){ge!==Se&&(ge=Se,se&&(Se=1-Se),n.clearDepth(Se))},reset:function(){O=!1,ie=null,Ee=null,ge=null,se=!1}}}function r(){let O=!1,se=null,ie=null,Ee=null,ge=null,Se=null,Xe=null,je=null,le=null;return{setTest:function(ze){O||(ze?be(n.STENCIL_TEST):qe(n.STENCIL_TEST))},setMask:function(ze){se!==ze&&!O&&(n.stencilMask(ze),se=ze)},setFunc:function(ze,et,Ce){(ie!==ze||Ee!==et||ge!==Ce)&&(n.stencilFunc(ze,et,Ce),ie=ze,Ee=et,ge=Ce)},setOp:function(ze,et,Ce){(Se!==ze||Xe!==et||je!==Ce)&&(n.stencilOp(ze,et,Ce),Se=ze,Xe=et,je=Ce)},setLocked:function(ze){O=ze},setClear:function(ze){le!==ze&&(n.clearStencil(ze),le=ze)},reset:function(){O=!1,se=null,ie=null,Ee=null,ge=null,Se=null,Xe=null,je=null,le=null}}}let s=new t,o=new i,a=new r,c={},l=new WeakMap,h={},f={},u={},d=new WeakMap,g=[],x=null,m=!1,p=null,_=null,y=null,S=null,R=null,A=null,v=null,E=new ke(0,0,0),F=0,D=!1,N=null,k=null,G=null,I=null,W=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ce=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(J)[1]),V=ce>=1):J.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),V=ce>=2);let j=null,re={},ue=n.getParameter(n.SCISSOR_BOX),fe=n.getParameter(n.VIEWPORT),ee=new Et().fromArray(ue),me=new Et().fromArray(fe);function _e(O,se,ie,Ee){let ge=new Uint8Array(4),Se=n.createTexture();n.bindTexture(O,Se),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<ie;Xe++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(se,0,n.RGBA,1,1,Ee,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(se+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return Se}let Re={};Re[n.TEXTURE_2D]=_e(n.TEXTURE_2D,n.TEXTURE_2D,1),Re[n.TEXTURE_CUBE_MAP]=_e(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[n.TEXTURE_2D_ARRAY]=_e(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Re[n.TEXTURE_3D]=_e(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),be(n.DEPTH_TEST),o.setFunc(Gr),pi(!1),Ft(wf),be(n.CULL_FACE),Zt(sr);function be(O){h[O]!==!0&&(n.enable(O),h[O]=!0)}function qe(O){h[O]!==!1&&(n.disable(O),h[O]=!1)}function rt(O,se){return u[O]!==se?(n.bindFramebuffer(O,se),u[O]=se,O===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=se),O===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=se),!0):!1}function We(O,se){let ie=g,Ee=!1;if(O){ie=d.get(se),ie===void 0&&(ie=[],d.set(se,ie));let ge=O.textures;if(ie.length!==ge.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,Xe=ge.length;Se<Xe;Se++)ie[Se]=n.COLOR_ATTACHMENT0+Se;ie.length=ge.length,Ee=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,Ee=!0);Ee&&n.drawBuffers(ie)}function dt(O){return x!==O?(n.useProgram(O),x=O,!0):!1}let ht={[zr]:n.FUNC_ADD,[Hd]:n.FUNC_SUBTRACT,[Vd]:n.FUNC_REVERSE_SUBTRACT};ht[Wd]=n.MIN,ht[Xd]=n.MAX;let it={[qd]:n.ZERO,[Yd]:n.ONE,[$d]:n.SRC_COLOR,[Ll]:n.SRC_ALPHA,[ep]:n.SRC_ALPHA_SATURATE,[Qd]:n.DST_COLOR,[Zd]:n.DST_ALPHA,[Kd]:n.ONE_MINUS_SRC_COLOR,[Dl]:n.ONE_MINUS_SRC_ALPHA,[jd]:n.ONE_MINUS_DST_COLOR,[Jd]:n.ONE_MINUS_DST_ALPHA,[tp]:n.CONSTANT_COLOR,[ip]:n.ONE_MINUS_CONSTANT_COLOR,[np]:n.CONSTANT_ALPHA,[rp]:n.ONE_MINUS_CONSTANT_ALPHA};function Zt(O,se,ie,Ee,ge,Se,Xe,je,le,ze){if(O===sr){m===!0&&(qe(n.BLEND),m=!1);return}if(m===!1&&(be(n.BLEND),m=!0),O!==Gd){if(O!==p||ze!==D){if((_!==zr||R!==zr)&&(n.blendEquation(n.FUNC_ADD),_=zr,R=zr),ze)switch(O){case kr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ef:n.blendFunc(n.ONE,n.ONE);break;case Tf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Af:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ut("WebGLState: Invalid blending: ",O);break}else switch(O){case kr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ef:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Tf:ut("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Af:ut("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ut("WebGLState: Invalid blending: ",O);break}y=null,S=null,A=null,v=null,E.set(0,0,0),F=0,p=O,D=ze}return}ge=ge||se,Se=Se||ie,Xe=Xe||Ee,(se!==_||ge!==R)&&(n.blendEquationSeparate(ht[se],ht[ge]),_=se,R=ge),(ie!==y||Ee!==S||Se!==A||Xe!==v)&&(n.blendFuncSeparate(it[ie],it[Ee],it[Se],it[Xe]),y=ie,S=Ee,A=Se,v=Xe),(je.equals(E)===!1||le!==F)&&(n.blendColor(je.r,je.g,je.b,le),E.copy(je),F=le),p=O,D=!1}function Ht(O,se){O.side===Ei?qe(n.CULL_FACE):be(n.CULL_FACE);let ie=O.side===$t;se&&(ie=!ie),pi(ie),O.blending===kr&&O.transparent===!1?Zt(sr):Zt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),s.setMask(O.colorWrite);let Ee=O.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),yt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?be(n.SAMPLE_ALPHA_TO_COVERAGE):qe(n.SAMPLE_ALPHA_TO_COVERAGE)}function pi(O){N!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),N=O)}function Ft(O){O!==Bd?(be(n.CULL_FACE),O!==k&&(O===wf?n.cullFace(n.BACK):O===kd?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):qe(n.CULL_FACE),k=O}function Pi(O){O!==G&&(V&&n.lineWidth(O),G=O)}function yt(O,se,ie){O?(be(n.POLYGON_OFFSET_FILL),(I!==se||W!==ie)&&(I=se,W=ie,o.getReversed()&&(se=-se,ie=-ie),n.polygonOffset(se,ie))):qe(n.POLYGON_OFFSET_FILL)}function bi(O){O?be(n.SCISSOR_TEST):qe(n.SCISSOR_TEST)}function ii(O){O===void 0&&(O=n.TEXTURE0+$-1),j!==O&&(n.activeTexture(O),j=O)}function mi(O,se,ie){ie===void 0&&(j===null?ie=n.TEXTURE0+$-1:ie=j);let Ee=re[ie];Ee===void 0&&(Ee={type:void 0,texture:void 0},re[ie]=Ee),(Ee.type!==O||Ee.texture!==se)&&(j!==ie&&(n.activeTexture(ie),j=ie),n.bindTexture(O,se||Re[O]),Ee.type=O,Ee.texture=se)}function B(){let O=re[j];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Pe(){try{n.compressedTexImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function st(){try{n.texSubImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function we(){try{n.texSubImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function kt(){try{n.compressedTexSubImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function Ve(){try{n.compressedTexSubImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function Ze(){try{n.texStorage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function P(){try{n.texStorage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function b(){try{n.texImage2D(...arguments)}catch(O){ut("WebGLState:",O)}}function X(){try{n.texImage3D(...arguments)}catch(O){ut("WebGLState:",O)}}function he(O){return f[O]!==void 0?f[O]:n.getParameter(O)}function oe(O,se){f[O]!==se&&(n.pixelStorei(O,se),f[O]=se)}function xe(O){ee.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function ve(O){me.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function te(O,se){let ie=l.get(se);ie===void 0&&(ie=new WeakMap,l.set(se,ie));let Ee=ie.get(O);Ee===void 0&&(Ee=n.getUniformBlockIndex(se,O.name),n.uniformBlockBinding(se,Ee,Ee),ie.set(O,Ee))}function ne(O,se,ie){let ge=l.get(se).get(O);c[ge]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,ie),c[ge]=ie)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},f={},j=null,re={},u={},c={},d=new WeakMap,g=[],x=null,m=!1,p=null,_=null,y=null,S=null,R=null,A=null,v=null,E=new ke(0,0,0),F=0,D=!1,N=null,k=null,G=null,I=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:be,disable:qe,bindFramebuffer:rt,drawBuffers:We,useProgram:dt,setBlending:Zt,setMaterial:Ht,setFlipSided:pi,setCullFace:Ft,setLineWidth:Pi,setPolygonOffset:yt,setScissorTest:bi,activeTexture:ii,bindTexture:mi,unbindTexture:B,compressedTexImage2D:Pe,compressedTexImage3D:Je,texImage2D:b,texImage3D:X,pixelStorei:oe,getParameter:he,updateUBOMapping:te,uniformBlockBinding:ne,texStorage2D:Ze,texStorage3D:P,texSubImage2D:st,texSubImage3D:we,compressedTexSubImage2D:kt,compressedTexSubImage3D:Ve,scissor:xe,viewport:ve,reset:pe}}function Hx(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Ke,h=new WeakMap,f=new Set,u,d=new WeakMap,g=new Set,x=new FinalizationRegistry(P=>g.delete(P)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(P,b){return m?new OffscreenCanvas(P,b):so("canvas")}function _(P,b,X){let he=1,oe=Ze(P);if((oe.width>X||oe.height>X)&&(he=X/Math.max(oe.width,oe.height)),he<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let xe=Math.floor(he*oe.width),ve=Math.floor(he*oe.height);u===void 0&&(u=p(xe,ve));let te=b?p(xe,ve):u;return te.width=xe,te.height=ve,te.getContext("2d").drawImage(P,0,0,xe,ve),Fe("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+xe+"x"+ve+")."),te}else return"data"in P&&Fe("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function y(P){return P.generateMipmaps}function S(P){n.generateMipmap(P)}function R(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(P,b,X,he,oe,xe=!1){if(P!==null){if(n[P]!==void 0)return n[P];Fe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let ve;he&&(ve=e.get("EXT_texture_norm16"),ve||Fe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=b;if(b===n.RED&&(X===n.FLOAT&&(te=n.R32F),X===n.HALF_FLOAT&&(te=n.R16F),X===n.UNSIGNED_BYTE&&(te=n.R8),X===n.UNSIGNED_SHORT&&ve&&(te=ve.R16_EXT),X===n.SHORT&&ve&&(te=ve.R16_SNORM_EXT)),b===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.R8UI),X===n.UNSIGNED_SHORT&&(te=n.R16UI),X===n.UNSIGNED_INT&&(te=n.R32UI),X===n.BYTE&&(te=n.R8I),X===n.SHORT&&(te=n.R16I),X===n.INT&&(te=n.R32I)),b===n.RG&&(X===n.FLOAT&&(te=n.RG32F),X===n.HALF_FLOAT&&(te=n.RG16F),X===n.UNSIGNED_BYTE&&(te=n.RG8),X===n.UNSIGNED_SHORT&&ve&&(te=ve.RG16_EXT),X===n.SHORT&&ve&&(te=ve.RG16_SNORM_EXT)),b===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RG8UI),X===n.UNSIGNED_SHORT&&(te=n.RG16UI),X===n.UNSIGNED_INT&&(te=n.RG32UI),X===n.BYTE&&(te=n.RG8I),X===n.SHORT&&(te=n.RG16I),X===n.INT&&(te=n.RG32I)),b===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGB8UI),X===n.UNSIGNED_SHORT&&(te=n.RGB16UI),X===n.UNSIGNED_INT&&(te=n.RGB32UI),X===n.BYTE&&(te=n.RGB8I),X===n.SHORT&&(te=n.RGB16I),X===n.INT&&(te=n.RGB32I)),b===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),X===n.UNSIGNED_INT&&(te=n.RGBA32UI),X===n.BYTE&&(te=n.RGBA8I),X===n.SHORT&&(te=n.RGBA16I),X===n.INT&&(te=n.RGBA32I)),b===n.RGB&&(X===n.UNSIGNED_SHORT&&ve&&(te=ve.RGB16_EXT),X===n.SHORT&&ve&&(te=ve.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),b===n.RGBA){let ne=xe?us:ot.getTransfer(oe);X===n.FLOAT&&(te=n.RGBA32F),X===n.HALF_FLOAT&&(te=n.RGBA16F),X===n.UNSIGNED_BYTE&&(te=ne===vt?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&ve&&(te=ve.RGBA16_EXT),X===n.SHORT&&ve&&(te=ve.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(P,b){let X;return P?b===null||b===Ui||b===Wn?X=n.DEPTH24_STENCIL8:b===ui?X=n.DEPTH32F_STENCIL8:b===vr&&(X=n.DEPTH24_STENCIL8,Fe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===Ui||b===Wn?X=n.DEPTH_COMPONENT24:b===ui?X=n.DEPTH_COMPONENT32F:b===vr&&(X=n.DEPTH_COMPONENT16),X}function E(P,b){return y(P)===!0||P.isFramebufferTexture&&P.minFilter!==Qt&&P.minFilter!==Mi?Math.log2(Math.max(b.width,b.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?b.mipmaps.length:1}function F(P){let b=new WeakRef(P);i.get(P).__ref=b,g.add(b),x.register(P,b,b)}function D(P){let b=i.get(P).__ref;b!==void 0&&(g.delete(b),x.unregister(b))}function N(P){G(P.target)}function k(P){I(P.target)}function G(P){P.removeEventListener("dispose",N),D(P),$(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&f.delete(P)}function I(P){P.removeEventListener("dispose",k),D(P),ce(P)}function W(){for(let P of g){let b=P.deref();b!==void 0&&(b.isRenderTarget===!0?I(b):G(b))}g.clear(),f.clear()}function $(P){let b=i.get(P);if(b.__webglInit===void 0)return;let X=P.source,he=d.get(X);if(he){let oe=he[b.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&V(P),Object.keys(he).length===0&&d.delete(X)}i.remove(P)}function V(P){let b=i.get(P);n.deleteTexture(b.__webglTexture);let X=P.source,he=d.get(X);delete he[b.__cacheKey],o.memory.textures--}function ce(P){let b=i.get(P);b.__depthDisposeCallback&&b.__depthDisposeCallback();let X=P.depthTexture;if(X&&X.renderTarget===P&&G(X),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(b.__webglFramebuffer[oe]))for(let xe=0;xe<b.__webglFramebuffer[oe].length;xe++)n.deleteFramebuffer(b.__webglFramebuffer[oe][xe]);else n.deleteFramebuffer(b.__webglFramebuffer[oe]);b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer[oe])}else{if(Array.isArray(b.__webglFramebuffer))for(let oe=0;oe<b.__webglFramebuffer.length;oe++)n.deleteFramebuffer(b.__webglFramebuffer[oe]);else n.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&n.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let oe=0;oe<b.__webglColorRenderbuffer.length;oe++)b.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(b.__webglColorRenderbuffer[oe]);b.__webglDepthRenderbuffer&&n.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let he=P.textures;for(let oe=0,xe=he.length;oe<xe;oe++){let ve=i.get(he[oe]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(he[oe])}i.remove(P)}let J=0;function j(){J=0}function re(){return J}function ue(P){J=P}function fe(){let P=J;return P>=r.maxTextures&&Fe("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+r.maxTextures),J+=1,P}function ee(P){let b=[];return b.push(P.wrapS),b.push(P.wrapT),b.push(P.wrapR||0),b.push(P.magFilter),b.push(P.minFilter),b.push(P.anisotropy),b.push(P.internalFormat),b.push(P.format),b.push(P.type),b.push(P.generateMipmaps),b.push(P.mipmapsAutoUpdate),b.push(P.premultiplyAlpha),b.push(P.flipY),b.push(P.unpackAlignment),b.push(P.colorSpace),b.join()}function me(P,b){let X=i.get(P);if(P.isVideoTexture&&kt(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&X.__version!==P.version){let he=P.image;if(he===null)Fe("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Fe("WebGLRenderer: Texture marked for update but image is incomplete");else{Ht(X,P,b);return}}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+b)}function _e(P,b){let X=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){Ht(X,P,b);return}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+b)}function Re(P,b){let X=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){Ht(X,P,b);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+b)}function be(P,b){let X=i.get(P);if(P.version>0&&X.__version!==P.version){pi(X,P,b);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+b)}let qe={[fa]:n.REPEAT,[an]:n.CLAMP_TO_EDGE,[ua]:n.MIRRORED_REPEAT},rt={[Qt]:n.NEAREST,[ap]:n.NEAREST_MIPMAP_NEAREST,[da]:n.NEAREST_MIPMAP_LINEAR,[Mi]:n.LINEAR,[Hl]:n.LINEAR_MIPMAP_NEAREST,[xn]:n.LINEAR_MIPMAP_LINEAR},We={[pp]:n.NEVER,[jl]:n.ALWAYS,[mp]:n.LESS,[Jl]:n.LEQUAL,[gp]:n.EQUAL,[Ql]:n.GEQUAL,[xp]:n.GREATER,[_p]:n.NOTEQUAL};function dt(P,b){if(b.type===ui&&e.has("OES_texture_float_linear")===!1&&(b.magFilter===Mi||b.magFilter===Hl||b.magFilter===da||b.magFilter===xn||b.minFilter===Mi||b.minFilter===Hl||b.minFilter===da||b.minFilter===xn)&&Fe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,qe[b.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,qe[b.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,qe[b.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,rt[b.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,rt[b.minFilter]),b.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,We[b.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===Qt||b.minFilter!==da&&b.minFilter!==xn||b.type===ui&&e.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||i.get(b).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(P,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,r.getMaxAnisotropy())),i.get(b).__currentAnisotropy=b.anisotropy}}}function ht(P,b){let X=!1;P.__webglInit===void 0&&(P.__webglInit=!0,b.addEventListener("dispose",N),F(b));let he=b.source,oe=d.get(he);oe===void 0&&(oe={},d.set(he,oe));let xe=ee(b);if(xe!==P.__cacheKey){oe[xe]===void 0&&(oe[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[xe].usedTimes++;let ve=oe[P.__cacheKey];ve!==void 0&&(oe[P.__cacheKey].usedTimes--,ve.usedTimes===0&&V(b)),P.__cacheKey=xe,P.__webglTexture=oe[xe].texture}return X}function it(P,b,X){return Math.floor(Math.floor(P/X)/b)}function Zt(P,b,X,he){let xe=P.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,b.width,b.height,X,he,b.data);else{xe.sort((O,se)=>O.start-se.start);let ve=0;for(let O=1;O<xe.length;O++){let se=xe[ve],ie=xe[O],Ee=se.start+se.count,ge=it(ie.start,b.width,4),Se=it(se.start,b.width,4);ie.start<=Ee+1&&ge===Se&&it(ie.start+ie.count-1,b.width,4)===ge?se.count=Math.max(se.count,ie.start+ie.count-se.start):(++ve,xe[ve]=ie)}xe.length=ve+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ne=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,b.width);for(let O=0,se=xe.length;O<se;O++){let ie=xe[O],Ee=Math.floor(ie.start/4),ge=Math.ceil(ie.count/4),Se=Ee%b.width,Xe=Math.floor(Ee/b.width),je=ge,le=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,Se,Xe,je,le,X,he,b.data)}P.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Ht(P,b,X){let he=n.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(he=n.TEXTURE_2D_ARRAY),b.isData3DTexture&&(he=n.TEXTURE_3D);let oe=ht(P,b),xe=b.source;t.bindTexture(he,P.__webglTexture,n.TEXTURE0+X);let ve=i.get(xe);if(xe.version!==ve.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let le=ot.getPrimaries(ot.workingColorSpace),ze=b.colorSpace===Pn?null:ot.getPrimaries(b.colorSpace),et=b.colorSpace===Pn||le===ze?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment);let ne=_(b.image,!1,r.maxTextureSize);ne=Ve(b,ne);let pe=s.convert(b.format,b.colorSpace),O=s.convert(b.type),se=A(b.internalFormat,pe,O,b.normalized,b.colorSpace,b.isVideoTexture);dt(he,b);let ie,Ee=b.mipmaps,ge=b.isVideoTexture!==!0,Se=ve.__version===void 0||oe===!0,Xe=xe.dataReady,je=E(b,ne);if(b.isDepthTexture)se=v(b.format===_n,b.type),Se&&(ge?t.texStorage2D(n.TEXTURE_2D,1,se,ne.width,ne.height):t.texImage2D(n.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,O,null));else if(b.isDataTexture)if(Ee.length>0){ge&&Se&&t.texStorage2D(n.TEXTURE_2D,je,se,Ee[0].width,Ee[0].height);for(let le=0,ze=Ee.length;le<ze;le++)ie=Ee[le],ge?Xe&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,ie.width,ie.height,pe,O,ie.data):t.texImage2D(n.TEXTURE_2D,le,se,ie.width,ie.height,0,pe,O,ie.data);b.generateMipmaps=!1}else ge?(Se&&t.texStorage2D(n.TEXTURE_2D,je,se,ne.width,ne.height),Xe&&Zt(b,ne,pe,O)):t.texImage2D(n.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,O,ne.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){ge&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,se,Ee[0].width,Ee[0].height,ne.depth);for(let le=0,ze=Ee.length;le<ze;le++)if(ie=Ee[le],b.format!==Oi)if(pe!==null)if(ge){if(Xe)if(b.layerUpdates.size>0){let et=eu(ie.width,ie.height,b.format,b.type);for(let Ce of b.layerUpdates){let lt=ie.data.subarray(Ce*et/ie.data.BYTES_PER_ELEMENT,(Ce+1)*et/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,Ce,ie.width,ie.height,1,pe,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,ie.width,ie.height,ne.depth,pe,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,le,se,ie.width,ie.height,ne.depth,0,ie.data,0,0);else Fe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,ie.width,ie.height,ne.depth,pe,O,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,le,se,ie.width,ie.height,ne.depth,0,pe,O,ie.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{ge&&Se&&t.texStorage2D(n.TEXTURE_2D,je,se,Ee[0].width,Ee[0].height);for(let le=0,ze=Ee.length;le<ze;le++)ie=Ee[le],b.format!==Oi?pe!==null?ge?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,le,0,0,ie.width,ie.height,pe,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,le,se,ie.width,ie.height,0,ie.data):Fe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?Xe&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,ie.width,ie.height,pe,O,ie.data):t.texImage2D(n.TEXTURE_2D,le,se,ie.width,ie.height,0,pe,O,ie.data)}else if(b.isDataArrayTexture)if(ge){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,se,ne.width,ne.height,ne.depth),Xe)if(b.layerUpdates.size>0){let le=eu(ne.width,ne.height,b.format,b.type);for(let ze of b.layerUpdates){let et=ne.data.subarray(ze*le/ne.data.BYTES_PER_ELEMENT,(ze+1)*le/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ze,ne.width,ne.height,1,pe,O,et)}b.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,pe,O,ne.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,se,ne.width,ne.height,ne.depth,0,pe,O,ne.data);else if(b.isData3DTexture)ge?(Se&&t.texStorage3D(n.TEXTURE_3D,je,se,ne.width,ne.height,ne.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,pe,O,ne.data)):t.texImage3D(n.TEXTURE_3D,0,se,ne.width,ne.height,ne.depth,0,pe,O,ne.data);else if(b.isFramebufferTexture){if(Se)if(ge)t.texStorage2D(n.TEXTURE_2D,je,se,ne.width,ne.height);else{let le=ne.width,ze=ne.height;for(let et=0;et<je;et++)t.texImage2D(n.TEXTURE_2D,et,se,le,ze,0,pe,O,null),le>>=1,ze>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in n){let le=n.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),ne.parentNode!==le){le.appendChild(ne),f.add(b),le.onpaint=ze=>{let et=ze.changedElements;for(let Ce of f)et.includes(Ce.image)&&(Ce.needsUpdate=!0)},le.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ne);else{let et=n.RGBA,Ce=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Ce,lt,ne)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(ge&&Se){let le=Ze(Ee[0]);t.texStorage2D(n.TEXTURE_2D,je,se,le.width,le.height)}for(let le=0,ze=Ee.length;le<ze;le++)ie=Ee[le],ge?Xe&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,pe,O,ie):t.texImage2D(n.TEXTURE_2D,le,se,pe,O,ie);b.generateMipmaps=!1}else if(ge){if(Se){let le=Ze(ne);t.texStorage2D(n.TEXTURE_2D,je,se,le.width,le.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,O,ne)}else t.texImage2D(n.TEXTURE_2D,0,se,pe,O,ne);y(b)&&b.mipmapsAutoUpdate===!0&&S(he),ve.__version=xe.version,b.onUpdate&&b.onUpdate(b)}P.__version=b.version}function pi(P,b,X){if(b.image.length!==6)return;let he=ht(P,b),oe=b.source;t.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+X);let xe=i.get(oe);if(oe.version!==xe.__version||he===!0){t.activeTexture(n.TEXTURE0+X);let ve=ot.getPrimaries(ot.workingColorSpace),te=b.colorSpace===Pn?null:ot.getPrimaries(b.colorSpace),ne=b.colorSpace===Pn||ve===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let pe=b.isCompressedTexture||b.image[0].isCompressedTexture,O=b.image[0]&&b.image[0].isDataTexture,se=[];for(let Ce=0;Ce<6;Ce++)!pe&&!O?se[Ce]=_(b.image[Ce],!0,r.maxCubemapSize):se[Ce]=O?b.image[Ce].image:b.image[Ce],se[Ce]=Ve(b,se[Ce]);let ie=se[0],Ee=s.convert(b.format,b.colorSpace),ge=s.convert(b.type),Se=A(b.internalFormat,Ee,ge,b.normalized,b.colorSpace),Xe=b.isVideoTexture!==!0,je=xe.__version===void 0||he===!0,le=oe.dataReady,ze=E(b,ie);dt(n.TEXTURE_CUBE_MAP,b);let et;if(b.isDepthTexture){if(Se=v(b.format===_n,b.type),je)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ie.width,ie.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,ie.width,ie.height,0,Ee,ge,null)}else if(pe){Xe&&je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Se,ie.width,ie.height);for(let Ce=0;Ce<6;Ce++){et=se[Ce].mipmaps;for(let lt=0;lt<et.length;lt++){let Wt=et[lt];b.format!==Oi?Ee!==null?Xe?le&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Wt.width,Wt.height,Ee,Wt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,Se,Wt.width,Wt.height,0,Wt.data):Fe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Wt.width,Wt.height,Ee,ge,Wt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,Se,Wt.width,Wt.height,0,Ee,ge,Wt.data)}}}else{if(et=b.mipmaps,Xe&&je){et.length>0&&ze++;let Ce=Ze(se[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Se,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(O){Xe?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,se[Ce].width,se[Ce].height,Ee,ge,se[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,se[Ce].width,se[Ce].height,0,Ee,ge,se[Ce].data);for(let lt=0;lt<et.length;lt++){let Qi=et[lt].image[Ce].image;Xe?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Qi.width,Qi.height,Ee,ge,Qi.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,Se,Qi.width,Qi.height,0,Ee,ge,Qi.data)}}else{Xe?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Ee,ge,se[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,Ee,ge,se[Ce]);for(let lt=0;lt<et.length;lt++){let Wt=et[lt];Xe?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Ee,ge,Wt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,Se,Ee,ge,Wt.image[Ce])}}}y(b)&&b.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),xe.__version=oe.version,b.onUpdate&&b.onUpdate(b)}P.__version=b.version}function Ft(P,b,X,he,oe,xe){let ve=s.convert(X.format,X.colorSpace),te=s.convert(X.type),ne=A(X.internalFormat,ve,te,X.normalized,X.colorSpace),pe=i.get(b),O=i.get(X);if(O.__renderTarget=b,!pe.__hasExternalTextures){let se=Math.max(1,b.width>>xe),ie=Math.max(1,b.height>>xe);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,xe,ne,se,ie,b.depth,0,ve,te,null):t.texImage2D(oe,xe,ne,se,ie,0,ve,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,P),we(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,he,oe,O.__webglTexture,0,st(b)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,he,oe,O.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Pi(P,b,X){if(n.bindRenderbuffer(n.RENDERBUFFER,P),b.depthBuffer){let he=b.depthTexture,oe=he&&he.isDepthTexture?he.type:null,xe=v(b.stencilBuffer,oe),ve=b.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(b),xe,b.width,b.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(b),xe,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,xe,b.width,b.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,P)}else{let he=b.textures;for(let oe=0;oe<he.length;oe++){let xe=he[oe],ve=s.convert(xe.format,xe.colorSpace),te=s.convert(xe.type),ne=A(xe.internalFormat,ve,te,xe.normalized,xe.colorSpace);we(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(b),ne,b.width,b.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(b),ne,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,ne,b.width,b.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function yt(P,b,X){let he=b.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,P),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(b.depthTexture);oe.__renderTarget=b;let xe=he?b.depthTexture.image[0]:b.depthTexture.image;(!oe.__webglTexture||xe.width!==b.width||xe.height!==b.height)&&(xe.width=b.width,xe.height=b.height,b.depthTexture.needsUpdate=!0),he?be(b.depthTexture,0):me(b.depthTexture,0);let ve=oe.__webglTexture,te=st(b),ne=he?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,pe=b.depthTexture.format===_n?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(b.depthTexture.format===ln)we(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ne,ve,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ne,ve,0);else if(b.depthTexture.format===_n)we(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ne,ve,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ne,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function bi(P){let b=i.get(P),X=P.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==P.depthTexture){let he=P.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),he){let oe=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,he.removeEventListener("dispose",oe)};he.addEventListener("dispose",oe),b.__depthDisposeCallback=oe}b.__boundDepthTexture=he}if(P.depthTexture&&!b.__autoAllocateDepthBuffer)if(X)for(let he=0;he<6;he++)yt(b.__webglFramebuffer[he],P,he);else P.texture.mipmaps.length>0?yt(b.__webglFramebuffer[0],P,0):yt(b.__webglFramebuffer,P,0);else if(X){b.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[he]),b.__webglDepthbuffer[he]===void 0)b.__webglDepthbuffer[he]=n.createRenderbuffer(),Pi(b.__webglDepthbuffer[he],P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=b.__webglDepthbuffer[he];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=n.createRenderbuffer(),Pi(b.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=b.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function ii(P,b,X){let he=i.get(P);b!==void 0&&Ft(he.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&bi(P)}function mi(P){let b=P.texture,X=i.get(P),he=i.get(b);P.addEventListener("dispose",k),F(P);let oe=P.textures,xe=P.isWebGLCubeRenderTarget===!0,ve=oe.length>1;if(ve||(he.__webglTexture===void 0&&(he.__webglTexture=n.createTexture()),he.__version=b.version,o.memory.textures++),xe){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(b.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let ne=0;ne<b.mipmaps.length;ne++)X.__webglFramebuffer[te][ne]=n.createFramebuffer()}else X.__webglFramebuffer[te]=n.createFramebuffer()}else{if(b.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<b.mipmaps.length;te++)X.__webglFramebuffer[te]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(ve)for(let te=0,ne=oe.length;te<ne;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&we(P)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ne=oe[te];X.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let pe=s.convert(ne.format,ne.colorSpace),O=s.convert(ne.type),se=A(ne.internalFormat,pe,O,ne.normalized,ne.colorSpace,P.isXRRenderTarget===!0),ie=st(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,se,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,X.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),Pi(X.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,he.__webglTexture),dt(n.TEXTURE_CUBE_MAP,b);for(let te=0;te<6;te++)if(b.mipmaps.length>0)for(let ne=0;ne<b.mipmaps.length;ne++)Ft(X.__webglFramebuffer[te][ne],P,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ne);else Ft(X.__webglFramebuffer[te],P,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);y(b)?S(n.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let te=0,ne=oe.length;te<ne;te++){let pe=oe[te],O=i.get(pe),se=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(se=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(se,O.__webglTexture),dt(se,pe),Ft(X.__webglFramebuffer,P,pe,n.COLOR_ATTACHMENT0+te,se,0),y(pe)&&S(se)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,he.__webglTexture),dt(te,b),b.mipmaps.length>0)for(let ne=0;ne<b.mipmaps.length;ne++)Ft(X.__webglFramebuffer[ne],P,b,n.COLOR_ATTACHMENT0,te,ne);else Ft(X.__webglFramebuffer,P,b,n.COLOR_ATTACHMENT0,te,0);y(b)?S(te):b.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&bi(P)}function B(P){let b=P.textures;for(let X=0,he=b.length;X<he;X++){let oe=b[X];if(y(oe)&&oe.mipmapsAutoUpdate===!0){let xe=R(P),ve=i.get(oe).__webglTexture;t.bindTexture(xe,ve),S(xe),t.unbindTexture()}}}let Pe=[];function Je(P){if(P.samples>0){if(we(P)===!1){let b=P.textures,X=P.width,he=P.height,oe=n.COLOR_BUFFER_BIT,xe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(P),te=b.length>1;if(te)for(let pe=0;pe<b.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let pe=0;pe<b.length;pe++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=i.get(b[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,X,he,0,0,X,he,oe,n.NEAREST),c===!0&&(Pe.length=0,Pe.push(n.COLOR_ATTACHMENT0+pe),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Pe.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<b.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=i.get(b[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&c){let b=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[b])}}}function st(P){return Math.min(r.maxSamples,P.samples)}function we(P){let b=i.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function kt(P){let b=o.render.frame;h.get(P)!==b&&(h.set(P,b),P.update())}function Ve(P,b){let X=P.colorSpace,he=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||X!==fs&&X!==Pn&&(ot.getTransfer(X)===vt?(he!==Oi||oe!==fi)&&Fe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ut("WebGLTextures: Unsupported texture color space:",X)),b}function Ze(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(l.width=P.naturalWidth||P.width,l.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(l.width=P.displayWidth,l.height=P.displayHeight):(l.width=P.width,l.height=P.height),l}this.allocateTextureUnit=fe,this.resetTextureUnits=j,this.getTextureUnits=re,this.setTextureUnits=ue,this.setTexture2D=me,this.setTexture2DArray=_e,this.setTexture3D=Re,this.setTextureCube=be,this.rebindTextures=ii,this.setupRenderTarget=mi,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=bi,this.setupFrameBufferTexture=Ft,this.useMultisampledRTT=we,this.dispose=W}function Vx(n,e){function t(i,r=Pn){let s,o=ot.getTransfer(r);if(i===fi)return n.UNSIGNED_BYTE;if(i===$s)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ks)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Xl)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===ql)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Vl)return n.BYTE;if(i===Wl)return n.SHORT;if(i===vr)return n.UNSIGNED_SHORT;if(i===Ys)return n.INT;if(i===Ui)return n.UNSIGNED_INT;if(i===ui)return n.FLOAT;if(i===Fi)return n.HALF_FLOAT;if(i===Yl)return n.ALPHA;if(i===$l)return n.RGB;if(i===Oi)return n.RGBA;if(i===ln)return n.DEPTH_COMPONENT;if(i===_n)return n.DEPTH_STENCIL;if(i===Zs)return n.RED;if(i===Js)return n.RED_INTEGER;if(i===vn)return n.RG;if(i===Qs)return n.RG_INTEGER;if(i===js)return n.RGBA_INTEGER;if(i===eo||i===to||i===io||i===no)if(o===vt)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===eo)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===to)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===io)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===no)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===eo)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===to)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===io)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===no)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===pa||i===ma||i===ga||i===xa)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===pa)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===ma)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ga)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===xa)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===_a||i===va||i===Ma||i===Sa||i===ya||i===cs||i===ba)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===_a||i===va)return o===vt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===Ma)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===Sa)return s.COMPRESSED_R11_EAC;if(i===ya)return s.COMPRESSED_SIGNED_R11_EAC;if(i===cs)return s.COMPRESSED_RG11_EAC;if(i===ba)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===wa||i===Ea||i===Ta||i===Aa||i===Ra||i===Ca||i===Pa||i===La||i===Da||i===Na||i===Ia||i===Ua||i===Fa||i===Oa)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===wa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ea)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ta)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Aa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ra)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ca)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Pa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===La)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Da)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Na)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ia)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ua)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Fa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Oa)return o===vt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ba||i===ka||i===za)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===Ba)return o===vt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===ka)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===za)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Ga||i===Ha||i===hs||i===Va)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===Ga)return s.COMPRESSED_RED_RGTC1_EXT;if(i===Ha)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===hs)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Va)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Wn?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var cb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,hb=`
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

}`,qc=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Eo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Gi({vertexShader:cb,fragmentShader:hb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new St(new Ao(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}};var Yc=class extends $i{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",c=1,l=null,h=null,f=null,u=null,d=null,g=null,x=typeof XRWebGLBinding<"u",m=new qc,p={},_=t.getContextAttributes(),y=null,S=null,R=[],A=[],v=new Ke,E=null,F=null,D=new Hi;D.viewport=new Et;let N=new Hi;N.viewport=new Et;let k=[D,N],G=new kc,I=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=R[ee];return me===void 0&&(me=new fo,R[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=R[ee];return me===void 0&&(me=new fo,R[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=R[ee];return me===void 0&&(me=new fo,R[ee]=me),me.getHandSpace()};function $(ee){let me=A.indexOf(ee.inputSource);if(me===-1)return;let _e=R[me];_e!==void 0&&(_e.update(ee.inputSource,ee.frame,l||o),_e.dispatchEvent({type:ee.type,data:ee.inputSource}))}function V(){r.removeEventListener("select",$),r.removeEventListener("selectstart",$),r.removeEventListener("selectend",$),r.removeEventListener("squeeze",$),r.removeEventListener("squeezestart",$),r.removeEventListener("squeezeend",$),r.removeEventListener("end",V),r.removeEventListener("inputsourceschange",ce);for(let ee=0;ee<R.length;ee++){let me=A[ee];me!==null&&(A[ee]=null,R[ee].disconnect(me))}I=null,W=null,m.reset();for(let ee in p)delete p[ee];if(e.setRenderTarget(y),d=null,u=null,f=null,r=null,S=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(v.width,v.height,!1),F!==null){let ee=F.camera;ee.fov=F.fov,ee.zoom=F.zoom,ee.updateProjectionMatrix(),F=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){s=ee,i.isPresenting===!0&&Fe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Fe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(ee){l=ee},this.getBaseLayer=function(){return u!==null?u:d},this.getBinding=function(){return f===null&&x&&(f=new XRWebGLBinding(r,t)),f},this.getFrame=function(){return g},this.getSession=function(){return r},this.setSession=async function(ee){if(r=ee,r!==null){if(y=e.getRenderTarget(),r.addEventListener("select",$),r.addEventListener("selectstart",$),r.addEventListener("selectend",$),r.addEventListener("squeeze",$),r.addEventListener("squeezestart",$),r.addEventListener("squeezeend",$),r.addEventListener("end",V),r.addEventListener("inputsourceschange",ce),_.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(v),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,Re=null,be=null;_.depth&&(be=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=_.stencil?_n:ln,Re=_.stencil?Wn:Ui);let qe={colorFormat:t.RGBA8,depthFormat:be,scaleFactor:s};f=this.getBinding(),u=f.createProjectionLayer(qe),r.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),S=new Xi(u.textureWidth,u.textureHeight,{format:Oi,type:fi,depthTexture:new bn(u.textureWidth,u.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let _e={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:s};d=new XRWebGLLayer(r,t,_e),r.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new Xi(d.framebufferWidth,d.framebufferHeight,{format:Oi,type:fi,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await r.requestReferenceSpace(a),fe.setContext(r),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ce(ee){for(let me=0;me<ee.removed.length;me++){let _e=ee.removed[me],Re=A.indexOf(_e);Re>=0&&(A[Re]=null,R[Re].disconnect(_e))}for(let me=0;me<ee.added.length;me++){let _e=ee.added[me],Re=A.indexOf(_e);if(Re===-1){for(let qe=0;qe<R.length;qe++)if(qe>=A.length){A.push(_e),Re=qe;break}else if(A[qe]===null){A[qe]=_e,Re=qe;break}if(Re===-1)break}let be=R[Re];be&&be.connect(_e)}}function J(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(r===null)return;let me=ee.near,_e=ee.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(_e=m.depthFar)),G.near=N.near=D.near=me,G.far=N.far=D.far=_e,(I!==G.near||W!==G.far)&&(r.updateRenderState({depthNear:G.near,depthFar:G.far}),I=G.near,W=G.far),G.layers.mask=ee.layers.mask|6,D.layers.mask=G.layers.mask&-5,N.layers.mask=G.layers.mask&-3;let Re=ee.parent,be=G.cameras;J(G,Re);for(let qe=0;qe<be.length;qe++)J(be[qe],Re);G.projectionMatrix.copy(D.projectionMatrix),G.projectionMatrixInverse.copy(D.projectionMatrixInverse),F===null&&ee.isPerspectiveCamera&&(F={camera:ee,fov:ee.fov,zoom:ee.zoom}),j(ee,G,Re)};function j(ee,me,_e){_e===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(_e.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Xa*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(u===null&&d===null))return c},this.setFoveation=function(ee){c=ee,u!==null&&(u.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(G)},this.getCameraTexture=function(ee){return p[ee]};let re=null;function ue(ee,me){if(h=me.getViewerPose(l||o),g=me,h!==null){let _e=h.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let Re=!1;_e.length!==G.cameras.length&&(G.cameras.length=0,Re=!0);for(let We=0;We<_e.length;We++){let dt=_e[We],ht=null;if(d!==null)ht=d.getViewport(dt);else{let Zt=f.getViewSubImage(u,dt);ht=Zt.viewport,We===0&&(e.setRenderTargetTextures(S,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(S))}let it=k[We];it===void 0&&(it=new Hi,it.layers.enable(We),it.viewport=new Et,k[We]=it),it.matrix.fromArray(dt.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(dt.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ht.x,ht.y,ht.width,ht.height),We===0&&(G.matrix.copy(it.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Re===!0&&G.cameras.push(it)}let be=r.enabledFeatures;if(be&&be.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&x){f=i.getBinding();let We=f.getDepthInformation(_e[0]);We&&We.isValid&&We.texture&&m.init(We,r.renderState)}if(be&&be.includes("camera-access")&&x){e.state.unbindTexture(),f=i.getBinding();for(let We=0;We<_e.length;We++){let dt=_e[We].camera;if(dt){let ht=p[dt];ht||(ht=new Eo,p[dt]=ht);let it=f.getCameraImage(dt);ht.sourceTexture=it}}}}for(let _e=0;_e<R.length;_e++){let Re=A[_e],be=R[_e];Re!==null&&be!==void 0&&be.update(Re,me,l||o)}re&&re(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let fe=new zc;fe.setAnimationLoop(ue),this.setAnimationLoop=function(ee){re=ee},this.dispose=function(){}}};var fb=new ye,Wx=new $e;Wx.set(-1,0,0,0,1,0,0,0,1);function Xx(n,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,Lc(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function r(m,p,_,y,S){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?s(m,p):p.isMeshLambertMaterial?(s(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(s(m,p),f(m,p)):p.isMeshPhongMaterial?(s(m,p),h(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(s(m,p),u(m,p),p.isMeshPhysicalMaterial&&d(m,p,S)):p.isMeshMatcapMaterial?(s(m,p),g(m,p)):p.isMeshDepthMaterial?s(m,p):p.isMeshDistanceMaterial?(s(m,p),x(m,p)):p.isMeshNormalMaterial?s(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?c(m,p,_,y):p.isSpriteMaterial?l(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function s(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===$t&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===$t&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let _=e.get(p),y=_.envMap,S=_.envMapRotation;y&&(m.envMap.value=y,m.envMapRotation.value.setFromMatrix4(fb.makeRotationFromEuler(S)).transpose(),y.isCubeTexture&&y.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Wx),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function c(m,p,_,y){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*_,m.scale.value=y*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function l(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function f(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function u(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,_){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===$t&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=_.texture,m.transmissionSamplerSize.value.set(_.width,_.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function x(m,p){let _=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(_.matrixWorld),m.nearDistance.value=_.shadow.camera.near,m.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function qx(n,e,t,i){let r={},s={};function o(_,y){let S=y.program;i.uniformBlockBinding(_,S,r[_.id])}function a(_,y){let S=r[_.id];S===void 0&&(g(_),S=c(_),r[_.id]=S,_.addEventListener("dispose",m));let R=y.program;i.updateUBOMapping(_,R);let A=e.render.frame;s[_.id]!==A&&(l(_),s[_.id]=A)}function c(_){let y=n.createBuffer(),S=_.__size,R=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,y),n.bufferData(n.UNIFORM_BUFFER,S,R),n.bindBuffer(n.UNIFORM_BUFFER,null),y}function l(_){let y=r[_.id],S=_.uniforms,R=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,y);for(let A=0,v=S.length;A<v;A++){let E=S[A];if(Array.isArray(E))for(let F=0,D=E.length;F<D;F++)h(E[F],A,F,R);else h(E,A,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(_,y,S,R){if(u(_,y,S,R)===!0){let A=_.__offset,v=_.value;if(Array.isArray(v)){let E=0;for(let F=0;F<v.length;F++){let D=v[F],N=x(D,!0);f(D,_.__data,E),E+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else f(v,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,_.__data)}}function f(_,y,S){typeof _=="number"||typeof _=="boolean"?y[S]=_:_.isMatrix3?(y[S]=_.elements[0],y[S+1]=_.elements[1],y[S+2]=_.elements[2],y[S+3]=0,y[S+4]=_.elements[3],y[S+5]=_.elements[4],y[S+6]=_.elements[5],y[S+7]=0,y[S+8]=_.elements[6],y[S+9]=_.elements[7],y[S+10]=_.elements[8],y[S+11]=0):ArrayBuffer.isView(_)?y.set(_.subarray(0,y.length-S),S):_.toArray(y,S)}function u(_,y,S,R){let A=_.value,v=y+"_"+S;if(Array.isArray(A)){R[v]===void 0&&(R[v]=[]);let E=R[v],F=!1;for(let D=0;D<A.length;D++)d(A[D],E,D)===!0&&(F=!0);return F}return d(A,R,v)}function d(_,y,S){if(y[S]===void 0)return typeof _=="number"||typeof _=="boolean"?y[S]=_:ArrayBuffer.isView(_)?y[S]=_.slice():y[S]=_.clone(),!0;{let R=y[S];if(typeof _=="number"||typeof _=="boolean"){if(R!==_)return y[S]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(R.equals(_)===!1)return R.copy(_),!0}}return!1}function g(_){let y=_.uniforms,S=0,R=16;for(let v=0,E=y.length;v<E;v++){let F=Array.isArray(y[v])?y[v]:[y[v]];for(let D=0,N=F.length;D<N;D++){let k=F[D],G=Array.isArray(k.value)?k.value:[k.value],I=Array.isArray(y[v])||Array.isArray(k.value),W=S;for(let V=0,ce=G.length;V<ce;V++){let J=G[V],j=x(J,I),re=S%R,ue=re%j.boundary,fe=re+ue;S+=ue,fe!==0&&R-fe<j.storage&&(S+=R-fe),V===0&&(W=S),S+=j.storage}let $=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new $((S-W)/Float32Array.BYTES_PER_ELEMENT),k.__offset=W}}let A=S%R;return A>0&&(S+=R-A),_.__size=S,_.__cache={},this}function x(_,y){let S={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(S.boundary=4,S.storage=4):_.isVector2?(S.boundary=8,S.storage=8):_.isVector3||_.isColor?(S.boundary=16,S.storage=12):_.isVector4?(S.boundary=16,S.storage=16):_.isMatrix3?(S.boundary=16,S.storage=48):_.isMatrix4?(S.boundary=16,S.storage=64):_.isTexture?Fe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(S.boundary=16,S.storage=_.byteLength):Fe("WebGLRenderer: Unsupported uniform value type.",_),y===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(_){let y=_.target;y.removeEventListener("dispose",m),n.deleteBuffer(r[y.id]),delete r[y.id],delete s[y.id]}function p(){for(let _ in r)n.deleteBuffer(r[_]);r={},s={}}return{bind:o,update:a,dispose:p}}var ub=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),hr=null;function Yx(){return hr===null&&(hr=new Tr(ub,16,16,vn,Fi),hr.name="DFG_LUT",hr.minFilter=Mi,hr.magFilter=Mi,hr.wrapS=an,hr.wrapT=an,hr.generateMipmaps=!1,hr.needsUpdate=!0),hr}var ll=class{constructor(e={}){let{canvas:t=bp(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:u=!1,outputBufferType:d=fi}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let x=d,m=new Set([js,Qs,Js]),p=new Set([fi,Ui,vr,Wn,$s,Ks]),_=new Uint32Array(4),y=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,A=null,v=[],E=[],F=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=gn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,N=!1,k=null,G=null,I=null,W=null;this._outputColorSpace=rn;let $=0,V=0,ce=null,J=-1,j=null,re=new Et,ue=new Et,fe=null,ee=new ke(0),me=0,_e=t.width,Re=t.height,be=1,qe=null,rt=null,We=new Et(0,0,_e,Re),dt=new Et(0,0,_e,Re),ht=!1,it=new hn,Zt=new wc,Ht=!1,pi=!1,Ft=new ye,Pi=new C,yt=new Et,bi={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ii=!1;function mi(){return ce===null?be:1}let B=i;function Pe(T,z){return t.getContext(T,z)}let Je,st,we,kt,Ve,Ze,P,b,X,he,oe,xe,ve,te,ne,pe,O,se,ie,Ee,ge,Se,Xe;try{let T={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),B===null){let z="webgl2";if(B=Pe(z,T),B===null)throw Pe(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(T){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),ut("WebGLRenderer: "+T.message),T}function je(){Je=new nx(B),Je.init(),ge=new Vx(B,Je),st=new $0(B,Je,e,ge),we=new Gx(B,Je),st.reversedDepthBuffer&&u&&we.buffers.depth.setReversed(!0),G=B.createFramebuffer(),I=B.createFramebuffer(),W=B.createFramebuffer(),kt=new ox(B),Ve=new Px,Ze=new Hx(B,Je,we,Ve,st,ge,kt),P=new ix(D),b=new hm(B),Se=new q0(B,b),X=new rx(B,b,kt,Se),he=new lx(B,X,b,Se,kt),se=new ax(B,st,Ze),ne=new K0(Ve),oe=new Cx(D,P,Je,st,Se,ne),xe=new Xx(D,Ve),ve=new Nx,te=new Fx(Je),O=new X0(D,P,we,he,g,c),pe=new zx(D,he,st),Xe=new qx(B,kt,st,we),ie=new Y0(B,Je,kt),Ee=new sx(B,Je,kt),kt.programs=oe.programs,D.capabilities=st,D.extensions=Je,D.properties=Ve,D.renderLists=ve,D.shadowMap=pe,D.state=we,D.info=kt}x!==fi&&(F=new cx(x,t.width,t.height,a,r,s));let le=new Yc(D,B);this.xr=le,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let T=Je.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Je.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return be},this.setPixelRatio=function(T){T!==void 0&&(be=T,this.setSize(_e,Re,!1))},this.getSize=function(T){return T.set(_e,Re)},this.setSize=function(T,z,Q=!0){if(le.isPresenting){Fe("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=T,Re=z,t.width=Math.floor(T*be),t.height=Math.floor(z*be),Q===!0&&(t.style.width=T+"px",t.style.height=z+"px"),F!==null&&F.setSize(t.width,t.height),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(_e*be,Re*be).floor()},this.setDrawingBufferSize=function(T,z,Q){_e=T,Re=z,be=Q,t.width=Math.floor(T*Q),t.height=Math.floor(z*Q),this.setViewport(0,0,T,z)},this.setEffects=function(T){if(x===fi){ut("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let z=0;z<T.length;z++)if(T[z].isOutputPass===!0){Fe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(re)},this.getViewport=function(T){return T.copy(We)},this.setViewport=function(T,z,Q,q){T.isVector4?We.set(T.x,T.y,T.z,T.w):We.set(T,z,Q,q),we.viewport(re.copy(We).multiplyScalar(mi()).round())},this.getScissor=function(T){return T.copy(dt)},this.setScissor=function(T,z,Q,q){T.isVector4?dt.set(T.x,T.y,T.z,T.w):dt.set(T,z,Q,q),we.scissor(ue.copy(dt).multiplyScalar(mi()).round())},this.getScissorTest=function(){return ht},this.setScissorTest=function(T){we.setScissorTest(ht=T)},this.setOpaqueSort=function(T){qe=T},this.setTransparentSort=function(T){rt=T},this.getClearColor=function(T){return T.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(T=!0,z=!0,Q=!0){let q=0;if(T){let K=!1;if(ce!==null){let Te=ce.texture.format;K=m.has(Te)}if(K){let Te=ce.texture.type,Le=p.has(Te),Ae=O.getClearColor(),Ne=O.getClearAlpha(),He=Ae.r,tt=Ae.g,pt=Ae.b;Le?(_[0]=He,_[1]=tt,_[2]=pt,_[3]=Ne,B.clearBufferuiv(B.COLOR,0,_)):(y[0]=He,y[1]=tt,y[2]=pt,y[3]=Ne,B.clearBufferiv(B.COLOR,0,y))}else q|=B.COLOR_BUFFER_BIT}z&&(q|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(q|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&B.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),k=T},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),O.dispose(),ve.dispose(),te.dispose(),Ze.dispose(),Ve.dispose(),P.dispose(),he.dispose(),X.dispose(),Se.dispose(),Xe.dispose(),oe.dispose(),le.dispose(),le.removeEventListener("sessionstart",Al),le.removeEventListener("sessionend",Qn),dr.stop()};function ze(T){T.preventDefault(),Lf("WebGLRenderer: Context Lost."),N=!0}function et(){Lf("WebGLRenderer: Context Restored."),N=!1;let T=kt.autoReset,z=pe.enabled,Q=pe.autoUpdate,q=pe.needsUpdate,K=pe.type;je(),kt.autoReset=T,pe.enabled=z,pe.autoUpdate=Q,pe.needsUpdate=q,pe.type=K}function Ce(T){ut("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function lt(T){let z=T.target;z.removeEventListener("dispose",lt),Wt(z)}function Wt(T){Qi(T),Ve.remove(T)}function Qi(T){let z=Ve.get(T).programs;z!==void 0&&(z.forEach(function(Q){oe.releaseProgram(Q)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,Q,q,K,Te){z===null&&(z=bi);let Le=K.isMesh&&K.matrixWorld.determinantAffine()<0,Ae=ea(T,z,Q,q,K);we.setMaterial(q,Le);let Ne=Q.index,He=1;if(q.wireframe===!0){if(Ne=X.getWireframeAttribute(Q),Ne===void 0)return;He=2}let tt=Q.drawRange,pt=Q.attributes.position,Ge=tt.start*He,mt=(tt.start+tt.count)*He;Te!==null&&(Ge=Math.max(Ge,Te.start*He),mt=Math.min(mt,(Te.start+Te.count)*He)),Ne!==null?(Ge=Math.max(Ge,0),mt=Math.min(mt,Ne.count)):pt!=null&&(Ge=Math.max(Ge,0),mt=Math.min(mt,pt.count));let ei=mt-Ge;if(ei<0||ei===1/0)return;Se.setup(K,q,Ae,Q,Ne);let Dt,Nt=ie;if(Ne!==null&&(Dt=b.get(Ne),Nt=Ee,Nt.setIndex(Dt)),K.isMesh)q.wireframe===!0?(we.setLineWidth(q.wireframeLinewidth*mi()),Nt.setMode(B.LINES)):Nt.setMode(B.TRIANGLES);else if(K.isLine){let wi=q.linewidth;wi===void 0&&(wi=1),we.setLineWidth(wi*mi()),K.isLineSegments?Nt.setMode(B.LINES):K.isLineLoop?Nt.setMode(B.LINE_LOOP):Nt.setMode(B.LINE_STRIP)}else K.isPoints?Nt.setMode(B.POINTS):K.isSprite&&Nt.setMode(B.TRIANGLES);if(K.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Nt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let wi=K._multiDrawStarts,Oe=K._multiDrawCounts,gi=K._multiDrawCount,_t=Ne?b.get(Ne).bytesPerElement:1,mr=Ve.get(q).currentProgram.getUniforms();for(let xi=0;xi<gi;xi++)mr.setValue(B,"_gl_DrawID",xi),Nt.render(wi[xi]/_t,Oe[xi])}else if(K.isInstancedMesh)Nt.renderInstances(Ge,ei,K.count);else if(Q.isInstancedBufferGeometry){let wi=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Oe=Math.min(Q.instanceCount,wi);Nt.renderInstances(Ge,ei,Oe)}else Nt.render(Ge,ei)};function Jo(T,z,Q,q){k!==null&&T.isNodeMaterial&&k.setObject(q,T),Ht===!0&&ne.setState(T,Q,!1),T.transparent===!0&&T.side===Ei&&T.forceSinglePass===!1?(T.side=$t,T.needsUpdate=!0,jn(T,z,q),T.side=Yi,T.needsUpdate=!0,jn(T,z,q),T.side=Ei):jn(T,z,q)}this.compile=function(T,z,Q=null){Q===null&&(Q=T),k!==null&&k.renderStart(T,z,Q),A=te.get(Q),A.init(z),E.push(A),Q.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),T!==Q&&T.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),A.setupLights(),k!==null&&k.updateLights(A.state.lightsArray),pi=this.localClippingEnabled,Ht=ne.init(this.clippingPlanes,pi),Ht===!0&&ne.setGlobalState(this.clippingPlanes,z),k!==null&&pe.render(A.state.shadowsArray,Q,z);let q=new Set;return T.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Te=K.material;if(Te)if(Array.isArray(Te))for(let Le=0;Le<Te.length;Le++){let Ae=Te[Le];Jo(Ae,Q,z,K),q.add(Ae)}else Jo(Te,Q,z,K),q.add(Te)}),A=E.pop(),k!==null&&k.renderEnd(),q},this.compileAsync=function(T,z,Q=null){let q=this.compile(T,z,Q);return new Promise(K=>{function Te(){if(q.forEach(function(Le){let Ne=Ve.get(Le).currentProgram;(Ne===void 0||Ne.isReady())&&q.delete(Le)}),q.size===0){K(T);return}setTimeout(Te,10)}Je.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Is=null;function pf(T){Is&&Is(T)}function Al(){dr.stop()}function Qn(){dr.start()}let dr=new zc;dr.setAnimationLoop(pf),typeof self<"u"&&dr.setContext(self),this.setAnimationLoop=function(T){Is=T,le.setAnimationLoop(T),T===null?dr.stop():dr.start()},le.addEventListener("sessionstart",Al),le.addEventListener("sessionend",Qn),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){ut("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;k!==null&&k.renderStart(T,z);let Q=le.enabled===!0&&le.isPresenting===!0,q=F!==null&&(ce===null||Q)&&F.begin(D,ce);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(z),z=le.getCamera()),T.isScene===!0&&T.onBeforeRender(D,T,z,ce),A=te.get(T,E.length),A.init(z),A.state.textureUnits=Ze.getTextureUnits(),E.push(A),Ft.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Zt.setFromArrayCamera(z):it.setFromProjectionMatrix(Ft,Wi,z.reversedDepth),pi=this.localClippingEnabled,Ht=ne.init(this.clippingPlanes,pi),R=ve.get(T,v.length),R.init(),v.push(R),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Le=D.xr.getDepthSensingMesh();Le!==null&&pr(Le,z,-1/0,D.sortObjects)}pr(T,z,0,D.sortObjects),R.finish(),k!==null&&k.updateLights(A.state.lightsArray),D.sortObjects===!0&&R.sort(qe,rt),ii=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,ii&&O.addToRenderList(R,T),this.info.autoReset===!0&&this.info.reset(),Ht===!0&&ne.beginShadows();let K=A.state.shadowsArray;if(pe.render(K,T,z),Ht===!0&&ne.endShadows(),(q&&F.hasRenderPass())===!1){let Le=R.opaque,Ae=R.transmissive;if(A.setupLights(),z.isArrayCamera){let Ne=z.cameras;if(Ae.length>0)for(let He=0,tt=Ne.length;He<tt;He++){let pt=Ne[He];Gn(Le,Ae,T,pt)}ii&&O.render(T);for(let He=0,tt=Ne.length;He<tt;He++){let pt=Ne[He];Qo(R,T,pt,pt.viewport)}}else Ae.length>0&&Gn(Le,Ae,T,z),ii&&O.render(T),Qo(R,T,z)}ce!==null&&V===0&&(Ze.updateMultisampleRenderTarget(ce),Ze.updateRenderTargetMipmap(ce)),q&&F.end(D),T.isScene===!0&&T.onAfterRender(D,T,z),Se.resetDefaultState(),J=-1,j=null,E.pop(),E.length>0?(A=E[E.length-1],Ze.setTextureUnits(A.state.textureUnits),Ht===!0&&ne.setGlobalState(D.clippingPlanes,A.state.camera)):A=null,v.pop(),v.length>0?R=v[v.length-1]:R=null,k!==null&&k.renderEnd()};function pr(T,z,Q,q){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)Q=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)A.pushLight(T),T.castShadow&&A.pushShadow(T);else if(T.isSprite){let Le=z.isArrayCamera?Zt:it;if(!T.frustumCulled||T.intersectsFrustum(Le)){q&&yt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Ft);let Ae=he.update(T),Ne=T.material;Ne.visible&&R.push(T,Ae,Ne,Q,yt.z,null,z)}}else if(T.isMesh||T.isLine||T.isPoints){let Le=z.isArrayCamera?Zt:it;if(!T.frustumCulled||T.intersectsFrustum(Le)){let Ae=he.update(T),Ne=T.material;if(q&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),yt.copy(T.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),yt.copy(Ae.boundingSphere.center)),yt.applyMatrix4(T.matrixWorld).applyMatrix4(Ft)),Array.isArray(Ne)){let He=Ae.groups;for(let tt=0,pt=He.length;tt<pt;tt++){let Ge=He[tt],mt=Ne[Ge.materialIndex];mt&&mt.visible&&R.push(T,Ae,mt,Q,yt.z,Ge,z)}}else Ne.visible&&R.push(T,Ae,Ne,Q,yt.z,null,z)}}}let Te=T.children;for(let Le=0,Ae=Te.length;Le<Ae;Le++)pr(Te[Le],z,Q,q)}function Qo(T,z,Q,q){let{opaque:K,transmissive:Te,transparent:Le}=T;A.setupLightsView(Q),Ht===!0&&ne.setGlobalState(D.clippingPlanes,Q),q&&we.viewport(re.copy(q)),K.length>0&&ni(K,z,Q),Te.length>0&&ni(Te,z,Q),Le.length>0&&ni(Le,z,Q),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Gn(T,z,Q,q){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[q.id]===void 0){let Ge=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[q.id]=new Xi(1,1,{generateMipmaps:!0,type:Ge?Fi:fi,minFilter:xn,samples:Math.max(4,st.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ot.workingColorSpace})}let Te=A.state.transmissionRenderTarget[q.id],Le=q.viewport||re;Te.setSize(Le.z*D.transmissionResolutionScale,Le.w*D.transmissionResolutionScale);let Ae=D.getRenderTarget(),Ne=D.getActiveCubeFace(),He=D.getActiveMipmapLevel();D.setRenderTarget(Te),D.getClearColor(ee),me=D.getClearAlpha(),me<1&&D.setClearColor(16777215,.5),D.clear(),ii&&O.render(Q);let tt=D.toneMapping;D.toneMapping=gn;let pt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),A.setupLightsView(q),Ht===!0&&ne.setGlobalState(D.clippingPlanes,q),ni(T,Q,q),Ze.updateMultisampleRenderTarget(Te),Ze.updateRenderTargetMipmap(Te),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let mt=0,ei=z.length;mt<ei;mt++){let Dt=z[mt],{object:Nt,geometry:wi,material:Oe,group:gi}=Dt;if(Oe.side===Ei&&Nt.layers.test(q.layers)){let _t=Oe.side;Oe.side=$t,Oe.needsUpdate=!0,ci(Nt,Q,q,wi,Oe,gi),Oe.side=_t,Oe.needsUpdate=!0,Ge=!0}}Ge===!0&&(Ze.updateMultisampleRenderTarget(Te),Ze.updateRenderTargetMipmap(Te))}D.setRenderTarget(Ae,Ne,He),D.setClearColor(ee,me),pt!==void 0&&(q.viewport=pt),D.toneMapping=tt}function ni(T,z,Q){let q=z.isScene===!0?z.overrideMaterial:null;for(let K=0,Te=T.length;K<Te;K++){let Le=T[K],{object:Ae,geometry:Ne,group:He}=Le,tt=Le.material;tt.allowOverride===!0&&q!==null&&(tt=q),Ae.layers.test(Q.layers)&&ci(Ae,z,Q,Ne,tt,He)}}function ci(T,z,Q,q,K,Te){k!==null&&K.isNodeMaterial&&k.setObject(T,K),T.onBeforeRender(D,z,Q,q,K,Te),T.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),K.onBeforeRender(D,z,Q,q,T,Te),K.transparent===!0&&K.side===Ei&&K.forceSinglePass===!1?(K.side=$t,K.needsUpdate=!0,D.renderBufferDirect(Q,z,q,K,T,Te),K.side=Yi,K.needsUpdate=!0,D.renderBufferDirect(Q,z,q,K,T,Te),K.side=Ei):D.renderBufferDirect(Q,z,q,K,T,Te),T.onAfterRender(D,z,Q,q,K,Te)}function hi(T){let z=0;for(let Q of T)Q.texture!==null&&z++;return z}function jn(T,z,Q){z.isScene!==!0&&(z=bi);let q=Ve.get(T),K=A.state.lights,Te=A.state.shadowsArray,Le=K.state.version,Ae=oe.getParameters(T,K.state,Te,z,Q,A.state.lightProbeGridArray),Ne=oe.getProgramCacheKey(Ae),He=q.programs;q.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?z.environment:null,q.fog=z.fog;let tt=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;q.envMap=P.get(T.envMap||q.environment,tt),q.envMapRotation=q.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,He===void 0&&(T.addEventListener("dispose",lt),He=new Map,q.programs=He,q.programVariants=new Map);let pt=He.get(Ne);if(pt!==void 0){if(q.currentProgram===pt&&q.lightsStateVersion===Le)return jo(T,Ae),pt}else Ae.uniforms=oe.getUniforms(T),k!==null&&T.isNodeMaterial&&k.build(T,Q,Ae),T.onBeforeCompile(Ae,D),pt=oe.acquireProgram(Ae,Ne),He.set(Ne,pt),q.uniforms=Ae.uniforms;let Ge=q.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Ge.clippingPlanes=ne.uniform),jo(T,Ae),q.needsLights=Ir(T),q.lightsStateVersion=Le,q.needsLights&&(Ge.ambientLightColor.value=K.state.ambient,Ge.lightProbe.value=K.state.probe,Ge.sunLights.value=K.state.sun,Ge.sunLightShadows.value=K.state.sunShadow,Ge.directionalLights.value=K.state.directional,Ge.directionalLightShadows.value=K.state.directionalShadow,Ge.spotLights.value=K.state.spot,Ge.spotLightShadows.value=K.state.spotShadow,Ge.rectAreaLights.value=K.state.rectArea,Ge.ltc_1.value=K.state.rectAreaLTC1,Ge.ltc_2.value=K.state.rectAreaLTC2,Ge.pointLights.value=K.state.point,Ge.pointLightShadows.value=K.state.pointShadow,Ge.hemisphereLights.value=K.state.hemi,Ge.sunShadowMatrix.value=K.state.sunShadowMatrix,Ge.sunShadowCascade.value=K.state.sunShadowCascade,Ge.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Ge.spotLightMatrix.value=K.state.spotLightMatrix,Ge.spotLightMap.value=K.state.spotLightMap,Ge.pointShadowMatrix.value=K.state.pointShadowMatrix),q.numLightProbeGrids=hi(A.state.lightProbeGridArray),q.currentProgram=pt,q.uniformsList=null,pt}function un(T,z,Q,q,K){let Te=Ve.get(T),Le=Te.currentProgram.id+","+q+","+K,Ae=Te.programVariants.get(Le);return Ae===void 0?(Ae=jn(T,z,Q),Te.programVariants.set(Le,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=q,Te.toneMapping=K),Ae}function Nr(T){if(T.uniformsList===null){let z=T.currentProgram.getUniforms();T.uniformsList=es.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function jo(T,z){let Q=Ve.get(T);Q.outputColorSpace=z.outputColorSpace,Q.batching=z.batching,Q.batchingColor=z.batchingColor,Q.instancing=z.instancing,Q.instancingColor=z.instancingColor,Q.instancingMorph=z.instancingMorph,Q.skinning=z.skinning,Q.morphTargets=z.morphTargets,Q.morphNormals=z.morphNormals,Q.morphColors=z.morphColors,Q.morphTargetsCount=z.morphTargetsCount,Q.numClippingPlanes=z.numClippingPlanes,Q.numIntersection=z.numClipIntersection,Q.vertexAlphas=z.vertexAlphas,Q.vertexTangents=z.vertexTangents,Q.toneMapping=z.toneMapping}function ea(T,z,Q,q,K){z.isScene!==!0&&(z=bi),Ze.resetTextureUnits();let Te=z.fog,Le=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?z.environment:null,Ae=ce===null?D.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:ot.workingColorSpace,Ne=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,He=P.get(q.envMap||Le,Ne),tt=q.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,pt=!!Q.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Ge=!!Q.morphAttributes.position,mt=!!Q.morphAttributes.normal,ei=!!Q.morphAttributes.color,Dt=gn;q.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Dt=D.toneMapping);let Nt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,wi=Nt!==void 0?Nt.length:0,Oe=Ve.get(q),gi=A.state.lights;if(Ht===!0&&(pi===!0||T!==j)){let It=T===j&&q.id===J;ne.setState(q,T,It)}let _t=!1,mr=!1;q.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==gi.state.version||K.isBatchedMesh&&Oe.batching===!1||!K.isBatchedMesh&&Oe.batching===!0||K.isBatchedMesh&&Oe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Oe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Oe.instancing===!1||!K.isInstancedMesh&&Oe.instancing===!0||K.isSkinnedMesh&&Oe.skinning===!1||!K.isSkinnedMesh&&Oe.skinning===!0||K.isInstancedMesh&&Oe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Oe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Oe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Oe.instancingMorph===!1&&K.morphTexture!==null||Oe.envMap!==He||q.fog===!0&&Oe.fog!==Te||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==ne.numPlanes||Oe.numIntersection!==ne.numIntersection)||Oe.vertexAlphas!==tt||Oe.vertexTangents!==pt||Oe.morphTargets!==Ge||Oe.morphNormals!==mt||Oe.morphColors!==ei||Oe.morphTargetsCount!==wi||Oe.numLightProbeGrids!==hi(A.state.lightProbeGridArray)?_t=!0:(Oe.outputColorSpace!==Ae||Oe.toneMapping!==Dt)&&(mr=!0):(_t=!0,Oe.__version=q.version);let xi=Oe.currentProgram;(_t===!0||mr===!0)&&(xi=mr===!0?un(q,z,K,Ae,Dt):jn(q,z,K),k&&q.isNodeMaterial&&k.onUpdateProgram(q,xi,Oe));let Os=!1,er=!1,gr=!1,ft=xi.getUniforms(),ri=Oe.uniforms;if(we.useProgram(xi.program)&&(Os=!0,er=!0,gr=!0),q.id!==J&&(J=q.id,er=!0),Os||j!==T){we.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),ft.setValue(B,"projectionMatrix",T.projectionMatrix),ft.setValue(B,"viewMatrix",T.matrixWorldInverse);let _i=ft.map.cameraPosition;_i!==void 0&&_i.setValue(B,Pi.setFromMatrixPosition(T.matrixWorld)),st.logarithmicDepthBuffer&&ft.setValue(B,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&ft.setValue(B,"isOrthographic",T.isOrthographicCamera===!0),j!==T&&(j=T,er=!0,gr=!0)}if(Oe.needsLights&&(gi.state.sunShadowMap.length>0&&ft.setValue(B,"sunShadowMap",gi.state.sunShadowMap,Ze),gi.state.directionalShadowMap.length>0&&ft.setValue(B,"directionalShadowMap",gi.state.directionalShadowMap,Ze),gi.state.spotShadowMap.length>0&&ft.setValue(B,"spotShadowMap",gi.state.spotShadowMap,Ze),gi.state.pointShadowMap.length>0&&ft.setValue(B,"pointShadowMap",gi.state.pointShadowMap,Ze)),K.isSkinnedMesh){ft.setOptional(B,K,"bindMatrix"),ft.setOptional(B,K,"bindMatrixInverse");let It=K.skeleton;It&&(It.boneTexture===null&&It.computeBoneTexture(),ft.setValue(B,"boneTexture",It.boneTexture,Ze))}K.isBatchedMesh&&(ft.setOptional(B,K,"batchingTexture"),ft.setValue(B,"batchingTexture",K._matricesTexture,Ze),ft.setOptional(B,K,"batchingIdTexture"),ft.setValue(B,"batchingIdTexture",K._indirectTexture,Ze),ft.setOptional(B,K,"batchingColorTexture"),K._colorsTexture!==null&&ft.setValue(B,"batchingColorTexture",K._colorsTexture,Ze));let ji=Q.morphAttributes;if((ji.position!==void 0||ji.normal!==void 0||ji.color!==void 0)&&se.update(K,Q,xi),(er||Oe.receiveShadow!==K.receiveShadow)&&(Oe.receiveShadow=K.receiveShadow,ft.setValue(B,"receiveShadow",K.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&z.environment!==null&&(ri.envMapIntensity.value=z.environmentIntensity),ri.dfgLUT!==void 0&&(ri.dfgLUT.value=Yx()),er){if(ft.setValue(B,"toneMappingExposure",D.toneMappingExposure),Oe.needsLights&&Us(ri,gr),Te&&q.fog===!0&&xe.refreshFogUniforms(ri,Te),xe.refreshMaterialUniforms(ri,q,be,Re,A.state.transmissionRenderTarget[T.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let It=S,_i=0;for(let qi of A.state.lightProbeGridArray)qi.texture!==null&&(It.textures[_i]=qi.texture,It.min[_i]=qi.boundingBox.min,It.max[_i]=qi.boundingBox.max,It.resolution[_i]=qi.resolution,_i++);for(let qi in It)It[qi].length=_i;ri.probesSH.value=It.textures,ri.probesMin.value=It.min,ri.probesMax.value=It.max,ri.probesResolution.value=It.resolution}es.upload(B,Nr(Oe),ri,Ze)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(es.upload(B,Nr(Oe),ri,Ze),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&ft.setValue(B,"center",K.center),ft.setValue(B,"modelViewMatrix",K.modelViewMatrix),ft.setValue(B,"normalMatrix",K.normalMatrix),ft.setValue(B,"modelMatrix",K.matrixWorld),q.uniformsGroups!==void 0){let It=q.uniformsGroups;for(let _i=0,qi=It.length;_i<qi;_i++){let Rl=It[_i];Xe.update(Rl,xi),Xe.bind(Rl,xi)}}return xi}function Us(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.sunLights.needsUpdate=z,T.sunLightShadows.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function Ir(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(T,z,Q){let q=Ve.get(T);q.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),Ve.get(T.texture).__webglTexture=z,Ve.get(T.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:Q,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,z){let Q=Ve.get(T);Q.__webglFramebuffer=z,Q.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,Q=0){ce=T,$=z,V=Q;let q=null,K=!1,Te=!1;if(T){let Ae=Ve.get(T);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(B.FRAMEBUFFER,Ae.__webglFramebuffer),re.copy(T.viewport),ue.copy(T.scissor),fe=T.scissorTest,we.viewport(re),we.scissor(ue),we.setScissorTest(fe),J=-1;return}else if(Ae.__webglFramebuffer===void 0)Ze.setupRenderTarget(T);else if(Ae.__hasExternalTextures)Ze.rebindTextures(T,Ve.get(T.texture).__webglTexture,Ve.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let tt=T.depthTexture;if(Ae.__boundDepthTexture!==tt){if(tt!==null&&Ve.has(tt)&&(T.width!==tt.image.width||T.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(T)}}let Ne=T.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Te=!0);let He=Ve.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(He[z])?q=He[z][Q]:q=He[z],K=!0):T.samples>0&&Ze.useMultisampledRTT(T)===!1?q=Ve.get(T).__webglMultisampledFramebuffer:Array.isArray(He)?q=He[Q]:q=He,re.copy(T.viewport),ue.copy(T.scissor),fe=T.scissorTest}else re.copy(We).multiplyScalar(be).floor(),ue.copy(dt).multiplyScalar(be).floor(),fe=ht;if(Q!==0&&(q=G),we.bindFramebuffer(B.FRAMEBUFFER,q)&&we.drawBuffers(T,q),we.viewport(re),we.scissor(ue),we.setScissorTest(fe),K){let Ae=Ve.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ae.__webglTexture,Q)}else if(Te){let Ae=z;for(let Ne=0;Ne<T.textures.length;Ne++){let He=Ve.get(T.textures[Ne]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ne,He.__webglTexture,Q,Ae)}}else if(T!==null&&Q!==0){let Ae=Ve.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ae.__webglTexture,Q)}J=-1};function Fs(T){let z=Ve.get(T);return(z.__readFormat!==T.format||z.__readType!==T.type)&&(z.__readFormat=T.format,z.__readType=T.type,z.__formatReadable=st.textureFormatReadable(T.format),z.__typeReadable=st.textureTypeReadable(T.type)),z}this.readRenderTargetPixels=function(T,z,Q,q,K,Te,Le,Ae=0){if(!(T&&T.isWebGLRenderTarget)){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Ve.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){we.bindFramebuffer(B.FRAMEBUFFER,Ne);try{let He=T.textures[Ae],tt=He.format,pt=He.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let Ge=Fs(He);if(Ge.__formatReadable===!1){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ge.__typeReadable===!1){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-q&&Q>=0&&Q<=T.height-K&&B.readPixels(z,Q,q,K,ge.convert(tt),ge.convert(pt),Te)}finally{let He=ce!==null?Ve.get(ce).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(T,z,Q,q,K,Te,Le,Ae=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Ve.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(z>=0&&z<=T.width-q&&Q>=0&&Q<=T.height-K){we.bindFramebuffer(B.FRAMEBUFFER,Ne);let He=T.textures[Ae],tt=He.format,pt=He.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let Ge=Fs(He);if(Ge.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ge.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.bufferData(B.PIXEL_PACK_BUFFER,Te.byteLength,B.STREAM_READ),B.readPixels(z,Q,q,K,ge.convert(tt),ge.convert(pt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let ei=ce!==null?Ve.get(ce).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,ei);let Dt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await Ep(B,Dt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Te),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(mt),B.deleteSync(Dt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,z=null,Q=0){let q=Math.pow(2,-Q),K=Math.floor(T.image.width*q),Te=Math.floor(T.image.height*q),Le=z!==null?z.x:0,Ae=z!==null?z.y:0;Ze.setTexture2D(T,0),B.copyTexSubImage2D(B.TEXTURE_2D,Q,0,0,Le,Ae,K,Te),we.unbindTexture()},this.copyTextureToTexture=function(T,z,Q=null,q=null,K=0,Te=0){let Le,Ae,Ne,He,tt,pt,Ge,mt,ei,Dt=T.isCompressedTexture?T.mipmaps[Te]:T.image;if(Q!==null)Le=Q.max.x-Q.min.x,Ae=Q.max.y-Q.min.y,Ne=Q.isBox3?Q.max.z-Q.min.z:1,He=Q.min.x,tt=Q.min.y,pt=Q.isBox3?Q.min.z:0;else{let ft=Math.pow(2,-K);Le=Math.floor(Dt.width*ft),Ae=Math.floor(Dt.height*ft),T.isDataArrayTexture?Ne=Dt.depth:T.isData3DTexture?Ne=Math.floor(Dt.depth*ft):Ne=1,He=0,tt=0,pt=0}q!==null?(Ge=q.x,mt=q.y,ei=q.z):(Ge=0,mt=0,ei=0);let Nt=ge.convert(z.format),wi=ge.convert(z.type),Oe;z.isData3DTexture?(Ze.setTexture3D(z,0),Oe=B.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Ze.setTexture2DArray(z,0),Oe=B.TEXTURE_2D_ARRAY):(Ze.setTexture2D(z,0),Oe=B.TEXTURE_2D),we.activeTexture(B.TEXTURE0),we.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,z.flipY),we.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),we.pixelStorei(B.UNPACK_ALIGNMENT,z.unpackAlignment);let gi=we.getParameter(B.UNPACK_ROW_LENGTH),_t=we.getParameter(B.UNPACK_IMAGE_HEIGHT),mr=we.getParameter(B.UNPACK_SKIP_PIXELS),xi=we.getParameter(B.UNPACK_SKIP_ROWS),Os=we.getParameter(B.UNPACK_SKIP_IMAGES);we.pixelStorei(B.UNPACK_ROW_LENGTH,Dt.width),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Dt.height),we.pixelStorei(B.UNPACK_SKIP_PIXELS,He),we.pixelStorei(B.UNPACK_SKIP_ROWS,tt),we.pixelStorei(B.UNPACK_SKIP_IMAGES,pt);let er=T.isDataArrayTexture||T.isData3DTexture,gr=z.isDataArrayTexture||z.isData3DTexture;if(T.isDepthTexture){let ft=Ve.get(T),ri=Ve.get(z),ji=Ve.get(ft.__renderTarget),It=Ve.get(ri.__renderTarget);we.bindFramebuffer(B.READ_FRAMEBUFFER,ji.__webglFramebuffer),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,It.__webglFramebuffer);for(let _i=0;_i<Ne;_i++)er&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(T).__webglTexture,K,pt+_i),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(z).__webglTexture,Te,ei+_i)),B.blitFramebuffer(He,tt,He+Le,tt+Ae,Ge,mt,Ge+Le,mt+Ae,B.DEPTH_BUFFER_BIT,B.NEAREST);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(K!==0||T.isRenderTargetTexture||Ve.has(T)){let ft=Ve.get(T),ri=Ve.get(z);we.bindFramebuffer(B.READ_FRAMEBUFFER,I),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,W);for(let ji=0;ji<Ne;ji++)er?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ft.__webglTexture,K,pt+ji):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ft.__webglTexture,K),gr?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ri.__webglTexture,Te,ei+ji):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ri.__webglTexture,Te),K!==0?B.blitFramebuffer(He,tt,He+Le,tt+Ae,Ge,mt,Ge+Le,mt+Ae,B.COLOR_BUFFER_BIT,B.NEAREST):gr?B.copyTexSubImage3D(Oe,Te,Ge,mt,ei+ji,He,tt,Le,Ae):B.copyTexSubImage2D(Oe,Te,Ge,mt,He,tt,Le,Ae);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else gr?T.isDataTexture||T.isData3DTexture?B.texSubImage3D(Oe,Te,Ge,mt,ei,Le,Ae,Ne,Nt,wi,Dt.data):z.isCompressedArrayTexture?B.compressedTexSubImage3D(Oe,Te,Ge,mt,ei,Le,Ae,Ne,Nt,Dt.data):B.texSubImage3D(Oe,Te,Ge,mt,ei,Le,Ae,Ne,Nt,wi,Dt):T.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Te,Ge,mt,Le,Ae,Nt,wi,Dt.data):T.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Te,Ge,mt,Dt.width,Dt.height,Nt,Dt.data):B.texSubImage2D(B.TEXTURE_2D,Te,Ge,mt,Le,Ae,Nt,wi,Dt);we.pixelStorei(B.UNPACK_ROW_LENGTH,gi),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,_t),we.pixelStorei(B.UNPACK_SKIP_PIXELS,mr),we.pixelStorei(B.UNPACK_SKIP_ROWS,xi),we.pixelStorei(B.UNPACK_SKIP_IMAGES,Os),Te===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&B.generateMipmap(Oe),we.unbindTexture()},this.initRenderTarget=function(T){Ve.get(T).__webglFramebuffer===void 0&&Ze.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Ze.setTextureCube(T,0):T.isData3DTexture?Ze.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Ze.setTexture2DArray(T,0):Ze.setTexture2D(T,0),we.unbindTexture()},this.resetState=function(){$=0,V=0,ce=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Wi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=ot._getDrawingBufferColorSpace(e),t.unpackColorSpace=ot._getUnpackColorSpace()}};function $x(n,e,t,i){if(!n)return e.clone().multiplyScalar(t).setZ(i);let[r]=n,s=r*Math.exp(i/r),o=t/r;return e.clone().multiplyScalar(s*Math.sin(o)).setZ(s*Math.cos(o)-r)}function $c(n,e,t,i,r){let[s,o]=n,a=Math.abs(i),c=i<0?-1:1,l=Math.cos(r/s),h=Math.sin(r/s),f=a*(l-c*t*h),u=a*(-h-c*t*l),d=f*Math.sin(e),g=d*Math.cos(o)-u*Math.sin(o),x=d*Math.sin(o)+u*Math.cos(o);return{circumferential:new C(0,c*f*Math.cos(e),0),radial:new C(Math.cos(o),0,-Math.sin(o)).multiplyScalar(g),axial:new C(Math.sin(o),0,Math.cos(o)).multiplyScalar(x)}}function Uo(n,e){let t=n.length;if(t<2||e<=n[0])return{low:0,share:0};if(e>=n[t-1])return{low:t-2,share:1};let i=0,r=t-1;for(;r-i>1;){let o=i+r>>1;n[o]<=e?i=o:r=o}let s=n[i+1]-n[i];return{low:i,share:s>0?(e-n[i])/s:0}}function jt(n,e,t=0){let{data:i,width:r,count:s}=n;if(s===1)return i[t];let o=e.low*r+t;return e.share?i[o]+e.share*(i[o+r]-i[o]):i[o]}function Fo(n){let e=new Float64Array(n.width);for(let t=0;t<n.data.length;t++)e[t%n.width]+=n.data[t];return e.map(t=>t/Math.max(n.count,1))}var Kx=(n,e)=>(n%e+e)%e;function Ss(n,e,t){let i=e.side*Math.tan(n.base_helix),[r,s]=n.width,[o,a]=n.path,c=n.base_pitch,l=[i*r,i*s],h=[],f=Math.ceil((t+Math.min(...l)-a)/c),u=Math.floor((t+Math.max(...l)-o)/c);for(let d=f;d<=u;d++){let g=t-d*c,x=i?[(o-g)/i,(a-g)/i]:[r,s];if(!i&&(g<o||g>a))continue;let m=Math.max(r,Math.min(...x)),p=Math.min(s,Math.max(...x));p>=m&&h.push({pair:d,place:g,slope:i,from:m,to:p})}return h}var Kc=class{constructor(e,t){this.contact=e,this.poses=t,this.name=e.name,this.greatest=Math.max(0,...e.flanks.map(i=>db(i.loads))),this.pairs=Math.max(0,...e.flanks.map(i=>i.forces?.width??0)),this.matrix=new ye}frame(){let{contact:e,poses:t}=this,{where:i}=t;return Zx.set(...[0,1,2,3].map(r=>jt(e.axes,i,r))).normalize(),Jx.set(...[0,1,2].map(r=>jt(e.at,i,r))),this.matrix.compose(Jx,Zx,pb)}normal(e){let t=jt(this.contact.pressure_angle,this.poses.where);return new C(Math.sin(t),e*Math.cos(t),0)}lines(){let e=this.frame();return this.contact.flanks.flatMap(t=>{let i=jt(t.travel,this.poses.where),r=this.normal(t.side),s=(o,a)=>$x(this.contact.cone,r,o,a).applyMatrix4(e);return Ss(this.contact,t,i).map(({pair:o,place:a,slope:c,from:l,to:h})=>{let{force:f,loads:u}=this.#e(t,o),d=u.reduce((m,p)=>m+p,0),g=d?u.reduce((m,p,_)=>m+p*_/(u.length-1),0)/d:.5,x=m=>{let p=l+m*(h-l);return s(a+c*p,p)};return{pair:o,side:t.side,slot:Kx(o,Math.max(1,this.pairs)),from:x(0),to:x(1),at:x,centre:x(g),ray:a+c*(l+g*(h-l)),force:f,loads:u,ends:[l,h].map(m=>[a+c*m,m])}})})}#e(e,t){let i=new Float64Array(e.loads?e.loads.shape[2]:2),r=0;if(!e.loads)return{force:r,loads:i};let s=Kx(t,e.forces.width),{low:o,share:a}=this.poses.where;return(a?[o,o+1]:[o]).forEach((l,h)=>{let f=h?a:1-a,u=e.travel.data[l];if(!Ss(this.contact,e,u).some(g=>g.pair===t))return;r+=f*e.forces.data[l*e.forces.width+s];let d=l*e.loads.width+s*i.length;for(let g=0;g<i.length;g++)i[g]+=f*e.loads.data[d+g]}),{force:r,loads:i}}penetration(){let{penetration:e}=this.contact;return{1:jt(e,this.poses.where,0),"-1":jt(e,this.poses.where,1)}}pairForces(e){let t=this.matrix,i=jt(this.contact.pressure_angle,this.poses.where),r=Math.tan(this.contact.base_helix),{cone:s}=this.contact,o=(a,c)=>s?$c(s,i,r,a,c):{circumferential:new C(0,a*Math.cos(i),0),radial:new C(Math.abs(a)*Math.sin(i),0,0),axial:new C(0,0,-a*r)};return Array.from({length:this.pairs},(a,c)=>{let l=e.find(g=>g.slot===c&&g.force),h=o(l?.force??0,l?.ray??0),f={};for(let[g,x]of Object.entries(h))f[g]=x.length(),x.transformDirection(t).setLength(f[g]);let u=Math.hypot(...Object.values(f)),d=l?l.centre:new C().setFromMatrixPosition(t);return{state:l?l.side:0,vectors:h,values:f,at:d,total:u}})}};function db(n){let e=0;for(let t of n?.data??[])t>e&&(e=t);return e}var Zx=new Ut,Jx=new C,pb=new C(1,1,1);var Cr=["circumferential","radial","axial"],mb={circumferential:"#d55e00",radial:"#0072b2",axial:"#009e73"},Fn={1:{word:"front flank",colour:"#e8b400"},"-1":{word:"back flank",colour:"#b0489a"},2:{word:"both flanks",colour:"#7a5a2a"},0:{word:"no contact",colour:"#8a8f98"}},Qx=["#93a9c1","#c1ab8b","#93b5a0","#ad9fc2","#c4a0a0","#8cb0bb"],jx={shaft:"#b3b9bf",bearing:"#6b7885",element:"#d3d8dc",housing:"#9fb3c6",carrier:"#b9b39c",spring:"#8d97a1",body:"#a9b6c0"},i_="#c2452d";function n_(n,e,t=!1){return n==="gear"||n==="body"&&t?Qx[e%Qx.length]:jx[n]??jx.body}function cl(n,e){return getComputedStyle(n).getPropertyValue(`--pp-force-${e}`).trim()||mb[e]}var e_=["#2296a0","#c2509a","#a88a1e","#d2484f","#6b8e23","#8f6b52","#8a8f98"],r_=n=>Cr.some(e=>n.startsWith(`${e}_force`));function Zc(n,e,t){let i=Cr.find(r=>e.startsWith(`${r}_force`));return i?cl(n,i):e_[t%e_.length]}var t_=["#d2484f","#a88a1e","#8a68c4","#2296a0","#2f9e62"],gb={contact_loss:"#8a8f98",impact:"#d2484f",back_flank:"#b0489a",front_flank:"#e8b400",faulty_tooth:"#2296a0"};function ys(n,e){return gb[e]??t_[Math.max(n.indexOf(e),0)%t_.length]}var hl=["#440154","#3b528b","#21918c","#5ec962","#fde725"].map(n=>[1,3,5].map(e=>parseInt(n.slice(e,e+2),16)/255));function fl(n){let e=Math.max(0,Math.min(1,n))*(hl.length-1),t=Math.min(Math.floor(e),hl.length-2);return hl[t].map((i,r)=>i+(e-t)*(hl[t+1][r]-i))}var Jc=n=>fl(n).map(e=>e<=.04045?e/12.92:((e+.055)/1.055)**2.4),Qc=()=>`linear-gradient(to right, ${hl.map(n=>`rgb(${n.map(e=>Math.round(255*e)).join(" ")})`).join(", ")})`;var On=6,jc=24,ih=class{constructor(e,t){this.contact=e,this.stations=e.contact.flanks[0].loads?.shape[2]??2;let i=jc*this.stations*On,r=new Tt;for(let a of["position","color"])r.setAttribute(a,new Pt(new Float32Array(3*i),3).setUsage(Mp));let s=[];for(let a=0;a<jc;a++)for(let c=0;c<this.stations-1;c++)for(let l=0;l<On;l++){let h=(a*this.stations+c)*On+l,f=(a*this.stations+c)*On+(l+1)%On;s.push(h,f,h+On,f,f+On,h+On)}r.setIndex(s),this.rods=new St(r,new In({vertexColors:!0})),this.rods.frustumCulled=!1,t.add(this.rods);let o=new Ro(1,12,8);this.paints=Object.fromEntries([1,-1].map(a=>[a,new In({color:Fn[a].colour})])),this.plain=Object.fromEntries([1,-1].map(a=>[a,this.paints[a].color.toArray()])),this.balls=Array.from({length:2*jc},()=>{let a=new St(o,this.paints[1]);return a.visible=!1,t.add(a),a})}update(e,t,i,r,s){let o=this.contact.penetration(),a=o[1]>=o[-1]?1:-1,c=t?e.filter(d=>d.force||d.side===a).slice(0,jc):[];this.rods.visible=c.length>0,this.balls.forEach(d=>d.visible=!1);let{position:l,color:h}=this.rods.geometry.attributes,f=!!this.contact.contact.flanks[0].loads,u=Math.min(2.6*i||1/0,.07*this.contact.contact.base_pitch);c.forEach((d,g)=>{let x=f?d.force!==0:o[d.side]>0,m=x?u:.4*u;ul.subVectors(d.to,d.from),ts.set(0,0,1).cross(ul),ts.lengthSq()<1e-12*ul.lengthSq()&&ts.set(1,0,0).cross(ul),ts.normalize(),eh.crossVectors(ul,ts).normalize();for(let p=0;p<this.stations;p++){let _=f&&r>0?Jc(s(d,p)/r):this.plain[d.side],y=x?_:xb;th.copy(d.at(p/(this.stations-1)));for(let S=0;S<On;S++){let R=2*Math.PI*S/On,A=(g*this.stations+p)*On+S;l.setXYZ(A,th.x+m*(Math.cos(R)*ts.x+Math.sin(R)*eh.x),th.y+m*(Math.cos(R)*ts.y+Math.sin(R)*eh.y),th.z+m*(Math.cos(R)*ts.z+Math.sin(R)*eh.z)),h.setXYZ(A,...y)}}if(x)for(let[p,_]of[d.from,d.to].entries()){let y=this.balls[2*g+p];y.visible=!0,y.material=this.paints[d.side],y.position.copy(_),y.scale.setScalar(1.9*u)}}),l.needsUpdate=h.needsUpdate=!0,this.rods.geometry.setDrawRange(0,c.length*(this.stations-1)*On*6)}},ul=new C,ts=new C,eh=new C,th=new C,xb=[.29,.31,.36];var _b=.32,s_=.2,nh=class{constructor(e,t){this.contact=e,this.root=t,this.times=1,this.plates=null}#e(){let e=new lr(1,1,1);this.plates=[1,-1].flatMap(t=>[-1,1].map(i=>{let{colour:r}=Fn[t],s={color:r,emissive:r,emissiveIntensity:i>0?.5:.15},o=new St(e,new Rr({...s,transparent:!0,opacity:.85}));return o.matrixAutoUpdate=!1,this.root.add(o),{mesh:o,side:t,end:i}}))}fitting(){let e=this.contact.penetration(),t=Math.max(Math.abs(e[1]),Math.abs(e[-1]),1e-7),i=.25*this.contact.contact.base_pitch/t,r=10**Math.floor(Math.log10(i));return Math.max(1,r*(i/r>=5?5:i/r>=2?2:1))}shown(){return(this.plates??[]).filter(({mesh:e})=>e.visible).map(({mesh:e})=>new C().setFromMatrixPosition(e.matrix).toArray())}update(e){if(!e&&!this.plates)return;this.plates||this.#e();let{contact:t}=this,i=t.contact.base_pitch,r=t.frame(),s=t.penetration();for(let{mesh:o,side:a,end:c}of this.plates){if(o.visible=e,!e)continue;let l=t.normal(a),h=.03*i,f=-.5*this.times*s[a]+.5*h;hu.set(0,0,1),o_.crossVectors(hu,l),fu.makeBasis(o_.clone().multiplyScalar(s_*i),l.clone().multiplyScalar(h),hu.multiplyScalar(s_*i)),fu.setPosition(l.multiplyScalar(_b*i+c*f)),o.matrix.multiplyMatrices(r,fu)}}},hu=new C,o_=new C,fu=new ye;function ai(n,e=4){if(!Number.isFinite(n))return"\u2013";if(n===0)return"0";let t=Math.abs(n),i=t>=1e6||t<1e-4?t.toExponential(e-1).replace("e+","e"):vb(t.toPrecision(e));return(n<0?"\u2212":"")+i}function vb(n){let e=String(Number(n));return n.includes(".")&&!n.includes("e")?n:e}function Oo(n,e){let t=Math.min(9,Math.max(0,-Math.floor(Math.log10(e)+1e-9)));return`${n.toFixed(t).replace("-","\u2212")} \xB1 ${e.toFixed(t)}`}function rh(n){let e=n>0?3-Math.floor(Math.log10(n)):0;return e>9||e<-6?t=>ai(t,4):t=>t.toFixed(Math.max(0,e)).replace(/^-(0(\.0*)?)$/,"$1").replace("-","\u2212")}function sh(n,e,t=n,i=t){let r=Math.abs(t),[s,o]=r>=1e6?[1e-6,"M"]:r>=1e3?[.001,"k"]:[1,""],a=n*s,c=Math.abs(i*s)>=100?1:Math.abs(i*s)>=10?2:3;return`${a<0?"\u2212":""}${Math.abs(a).toFixed(c)}\u2009${o}${e}`}var Mb=[[1,"m"],[.001,"mm"],[1e-6,"\xB5m"],[1e-9,"nm"]],uu=[[1,"s"],[.001,"ms"],[1e-6,"\xB5s"]],a_=n=>uu[n>=.02?0:n>=2e-5?1:2];function l_(n,e,t){let[i,r]=e.find(([s])=>Math.abs(n)>=s*.999)??e[e.length-1];return`${ai(n/i,t)}\u2009${r}`}var c_=n=>l_(n,Mb,1).replace(/\.0+(?=\D)/,""),fr=n=>n===0?"0\u2009s":l_(n,uu,3);function bs(n,e){let[t,i]=uu[e>=5e-4?0:e>=8e-7||Math.abs(n)>=.001?1:2],r=Math.max(0,Math.min(6,Math.ceil(-Math.log10(Math.max(e,1e-12)/t)-1e-9)));return`${(n/t).toFixed(r).replace("-","\u2212")}\u2009${i}`}function h_(n){if(n>=.999)return"real time";let e=1/n;return`1/${e<10?String(Number(e.toPrecision(2))):String(Math.round(e)).replace(/\B(?=(\d{3})+$)/g,"\u2009")} of real time`}function f_(n,[e,t],i){let{data:r,count:s}=n.unit_pressure,[o,a]=n.path,c=Math.max(0,Math.min(1,(e-o)/(a-o)))*(s-1),l=Math.min(Math.floor(c),s-2),h=n.cone?Math.exp(t/n.cone[0]):1;return(r[l]+(c-l)*(r[l+1]-r[l]))*Math.sqrt(Math.max(0,i)/h)}var Sb=({place:n,slope:e,from:t,to:i},r)=>{let s=t+r*(i-t);return[n+e*s,s]};function yb(n){if(!n.unit_pressure)return 0;let e=0;for(let t of n.flanks){if(!t.loads)continue;let[i,r,s]=t.loads.shape;for(let o=0;o<i;o++){let a=t.travel.data[t.travel.count>1?o:0];for(let c of Ss(n,t,a)){let l=(c.pair%r+r)%r;for(let h=0;h<s;h++){let f=t.loads.data[(o*r+l)*s+h];f>0&&(e=Math.max(e,f_(n,Sb(c,h/(s-1)),f)))}}}}return e}var ws={load:{name:"load per width",legend:"load per width",format:n=>`${ai(n/1e3,3)}\u2009N/mm`,of:(n,e,t)=>t,greatest:({greatest:n})=>n},pressure:{name:"pressure (Hertz)",legend:"Hertzian pressure",format:n=>`${ai(n/1e6,3)}\u2009MPa`,of:f_,greatest:n=>n.pressure??=yb(n.contact)}};var u_=(n,e)=>(n%e+e)%e,d_=1.004,du=class{constructor(e,t){this.contact=e,this.flank=t,[this.nz,this.nx]=t.surfaces[0].points.shape,this.frames=t.travel.count,this.clear()}clear(){let{nz:e,nx:t,flank:i}=this;this.done=-1,this.touched=i.surfaces.map(()=>[]),this.news={all:!0,teeth:i.surfaces.map(()=>new Set)},this.all=new Float32Array(e*t),this.each=i.surfaces.map(r=>new Float32Array(r.teeth*e*t))}upTo(e){for(e<this.done&&this.clear();this.done<e;)this.done++,this.#t(Math.max(0,this.done-1),this.done)}#e(e,t,i){let{flank:r}=this;if(!t||i<t.from||i>t.to)return null;let s=r.loads.shape[2],o=e*r.loads.width+u_(t.pair,r.forces.width)*s,a=t.to>t.from?(i-t.from)/(t.to-t.from)*(s-1):0,c=Math.min(Math.floor(a),s-2),[l,h]=[r.loads.data[o+c],r.loads.data[o+c+1]];return l+(a-c)*(h-l)}#t(e,t){let{contact:i,flank:r,nz:s,nx:o}=this,[a,c]=i.path,[l,h]=i.width,f=(c-a)/(o-1),u=r.travel.data,g=Math.abs(u[t]-u[e])>.75*i.base_pitch?[]:Ss(i,r,u[e]);for(let x of Ss(i,r,u[t])){let{pair:m,slope:p}=x,_=g.find(y=>y.pair===m);for(let y=0;y<s;y++){let S=l+(h-l)*y/(s-1),R=this.#e(t,x,S);if(R===null)continue;let A=this.#e(e,_,S),v=u[t]-m*i.base_pitch+p*S,E=A===null?v:u[e]-m*i.base_pitch+p*S,F=Math.max(0,Math.ceil((Math.min(E,v)-a)/f-.5)),D=Math.min(o-1,Math.floor((Math.max(E,v)-a)/f+.5));for(let N=F;N<=D;N++){let k=E===v?1:Math.max(0,Math.min(1,(a+N*f-E)/(v-E)));this.#i(m,y*o+N,(A??R)*(1-k)+R*k)}}}}#i(e,t,i){i>0&&(i>d_*this.all[t]&&(this.all[t]=i,this.news.all=!0),this.flank.surfaces.forEach((r,s)=>{let o=u_(r.tooth+r.step*e,r.teeth),a=o*this.nz*this.nx+t;i>d_*this.each[s][a]&&(this.each[s][a]=i,this.news.teeth[s].add(o),this.touched[s].includes(o)||this.touched[s].push(o))}))}},oh=class{constructor(e,t,i){this.poses=i,this.greatest=e.greatest,this.mode="off",this.parts=e.contact.flanks.filter(r=>r.loads).map(r=>{let s=new du(e.contact,r);return{record:s,meshes:r.surfaces.map((o,a)=>this.#e(s,o,a,t))}})}#e(e,t,i,r){let{nz:s,nx:o}=e,a=s*o,c=new Float32Array(3*a*t.teeth);for(let u=0;u<t.teeth;u++){let d=t.turn*t.step*(u-t.tooth),g=Math.cos(d),x=Math.sin(d);for(let m=0;m<a;m++){let[p,_,y]=t.points.data.subarray(3*m,3*m+3);c.set([g*p-x*_,x*p+g*_,y],3*(u*a+m))}}let l=[];for(let u=0;u<s-1;u++)for(let d=0;d<o-1;d++){let g=u*o+d;l.push(g,g+1,g+o,g+1,g+o+1,g+o)}let h=new Tt;h.setAttribute("position",new Pt(c,3)),h.setAttribute("color",new Pt(new Uint8Array(4*a*t.teeth),4,!0)),h.setIndex(new Pt(new Uint32Array(l.length*t.teeth),1)),h.setDrawRange(0,0);let f=new St(h,new In({vertexColors:!0,transparent:!0,side:Ei,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-40}));return f.matrixAutoUpdate=!1,f.frustumCulled=!1,f.visible=!1,f.userData={body:t.body,gear:i,block:l,drawn:0},r.add(f),f}update(e,t,i,r){let s=this.poses.where.share===1?this.poses.where.low+1:this.poses.where.low;for(let{record:o,meshes:a}of this.parts){let c=e!=="off"&&!t;for(let h of a)h.visible=c,c&&h.matrix.copy(this.poses.world[h.userData.body]);if(!c)continue;o.upTo(s);let l=e!==this.mode||i!==this.painted||r!==this.shade;this.shade=r;for(let h of a)this.#t(o,h,e,i,l);o.news={all:!1,teeth:o.news.teeth.map(()=>new Set)}}this.mode=t?"off":e,this.painted=i}#t(e,t,i,r,s){let{gear:o,block:a}=t.userData,c=e.nz*e.nx,l=e.touched[o];this.#n(t,l,a,c);let f=s||i==="all"&&e.news.all?l:e.news.teeth[o],{color:u}=t.geometry.attributes;for(let d of f){for(let g=0;g<c;g++){let x=i==="all"?e.all[g]:e.each[o][d*c+g],m=4*(d*c+g),p=x>0?Jc(this.#i(e,g,x)/r):bb;for(let _=0;_<3;_++)u.array[m+_]=Math.round(255*p[_]);u.array[m+3]=x>0?255:0}u.needsUpdate=!0}}#i({contact:e,nx:t,nz:i},r,s){let[o,a]=e.path,[c,l]=e.width,h=[o+(a-o)*(r%t)/(t-1),c+(l-c)*Math.floor(r/t)/(i-1)];return this.shade.of(e,h,s)}#n(e,t,i,r){let{geometry:s,userData:o}=e;if(t.length<o.drawn&&(o.drawn=0),t.length===o.drawn)return;let{array:a}=s.index;for(let c=o.drawn;c<t.length;c++)i.forEach((l,h)=>a[c*i.length+h]=t[c]*r+l);o.drawn=t.length,s.index.needsUpdate=!0,s.setDrawRange(0,t.length*i.length)}cut(e){for(let{meshes:t}of this.parts)for(let{material:i}of t)i.clippingPlanes=e.length?e:null,i.needsUpdate=!0}words(){return this.parts.map(({record:e})=>({side:e.flank.side,greatest:e.all.reduce((t,i)=>Math.max(t,i),0),covered:e.all.filter(t=>t>0).length/e.all.length,teeth:e.touched.map(t=>[...t].sort((i,r)=>i-r))}))}},bb=[0,0,0];var ah=class{constructor(e,t,i,r){this.meshes=e.contacts.map(s=>{let o=new Kc(s,r);return{contact:o,rods:new ih(o,i),pattern:new oh(o,t,r),gauge:new nh(o,i),lines:[]}}),this.greatest=Math.max(0,...this.meshes.map(({contact:s})=>s.greatest)),this.shade="load",this.pressures=e.contacts.some(s=>s.unit_pressure),this.showsLines=!0,this.mode="off",this.own=!1,this.gauged=-1,this.hidden=!1}get over(){return!this.hidden&&this.meshes.length>0&&(this.showsLines||this.gauged>=0)}pairs(){return this.meshes.flatMap(e=>Array.from({length:e.contact.pairs},(t,i)=>{let r=this.#e(e.contact,i);return{name:`${e.contact.name}, pair ${i+1}`,kind:"pair",unit:"N",size:r,now:()=>e.forces?.[i]??e.contact.pairForces([])[i],largest:wb(e.contact.contact,r)}}))}#e(e,t){let i=0;for(let{forces:r}of e.contact.flanks)for(let s=t;r&&s<r.data.length;s+=r.width)i=Math.max(i,Math.abs(r.data[s]));return i/Math.cos(e.contact.base_helix)}look(){for(let e of this.meshes)e.lines=e.contact.lines(),e.forces=e.contact.pairForces(e.lines)}top(e){return this.own?ws[this.shade].greatest(e):this.shade==="load"?this.greatest:this.hardest??=this.greatestPressure()}greatestPressure(){return Math.max(0,...this.meshes.map(({contact:e})=>ws.pressure.greatest(e)))}value(e,{ends:t,loads:i},r){let s=r/(i.length-1),o=[0,1].map(a=>t[0][a]+(t[1][a]-t[0][a])*s);return ws[this.shade].of(e.contact,o,i[r])}update(e,t=()=>!1){this.meshes.forEach(({contact:i,rods:r,pattern:s,gauge:o,lines:a},c)=>{let l=this.top(i),h=(f,u)=>this.value(i,f,u);r.update(a.filter(({from:f})=>!t(f)),this.showsLines&&!this.hidden,e,l,h),s.update(i.greatest>0?this.mode:"off",this.hidden,l,ws[this.shade]),o.update(c===this.gauged&&!this.hidden)})}cut(e){for(let{pattern:t}of this.meshes)t.cut(e)}state(){let e=t=>[t.x,t.y,t.z];return{lines:this.showsLines,pattern:this.mode,gauge:this.gauged,greatest:this.greatest,shade:this.shade,greatestPressure:this.pressures?this.greatestPressure():null,meshes:this.meshes.map(({contact:t,lines:i,pattern:r,gauge:s})=>({name:t.name,penetration:t.penetration(),magnified:s.times,plates:s.shown(),lines:i.map(({pair:o,side:a,force:c,from:l,to:h,loads:f,ends:u})=>({pair:o,side:a,force:c,from:e(l),to:e(h),loads:[...f],values:Array.from(f,(d,g)=>this.value(t,{ends:u,loads:f},g))})),pattern:this.mode==="off"?[]:r.words()}))}}};function wb(n,e){let t=e*Math.cos(n.base_helix),i=n.pressure_angle.data[0];if(n.cone){let r=$c(n.cone,i,Math.tan(n.base_helix),t,0);return Object.fromEntries(Object.entries(r).map(([s,o])=>[s,o.length()]))}return{circumferential:t*Math.cos(i),radial:t*Math.sin(i),axial:t*Math.abs(Math.tan(n.base_helix))}}var lh=class{constructor(e){this.flanks=e,this.now=Y("span",{}),this.end=Y("span",{}),this.gap=Y("div",{className:"ppv-gap"}),this.bar=Y("div",{hidden:!(e.greatest>0)},this.what=Y("span",{}),Y("i",{style:`background:${Qc()}`}),Y("div",{className:"ppv-ends"},Y("span",{},"0"),this.now,this.end)),this.element=Y("div",{className:"ppv-flanks",role:"status"},this.bar,this.gap)}update(){let{flanks:e}=this,t=e.meshes[e.gauged],i=e.greatest>0&&(e.showsLines||e.mode!=="off");if(this.element.hidden=e.hidden||!(i||t),this.element.hidden)return;let{legend:r,format:s}=ws[e.shade],o=0;for(let{contact:l,lines:h}of e.meshes)for(let f of h)f.loads.forEach((u,d)=>o=Math.max(o,e.value(l,f,d)));if(this.what.textContent=r,this.now.textContent=o>0?`current ${s(o)}`:"no load now",this.end.textContent=e.own?"mesh maximum":s(e.top(e.meshes[0].contact)),this.gap.hidden=!t,!t)return;let a=t.contact.penetration(),c=(l,h)=>`${h} ${a[l]>0?"penetration":"gap"} ${Eb(Math.abs(a[l]))}`;this.gap.textContent=`${t.contact.name}: ${c(1,"front flank")}, ${c(-1,"back flank")}; magnification \xD7 ${ai(t.gauge.times,2)}`}};function Eb(n){let[e,t]=n<.001?[1e-6,"\xB5m"]:[.001,"mm"];return`${ai(n/e,3)}\u2009${t}`}function Tb({contact:n,name:e}){let{cone:t,width:i}=n,r=n.flanks[0].surfaces.map(({gear:o,points:a})=>{let[c,l]=a.shape,h=t?-i[0]/(i[1]-i[0])*(c-1):0,f=Math.min(Math.floor(h),c-2),u=(m,p)=>Math.hypot(a.data[3*(m*l+p)],a.data[3*(m*l+p)+1]),d=[0,l-1].map(m=>2e3*(u(f,m)+(h-f)*(u(f+1,m)-u(f,m)))),[g,x]=[Math.min(...d),Math.max(...d)].map(m=>m.toFixed(2));return`${o} ${g} to ${x}`}),s=t?" at mid-face":"";return`${e}: active diameters ${r.join(", ")} mm${s}.`}function Bo(n,e){for(let{flanks:o}of n.stage.pictures)e(o);let{showsLines:t,mode:i,shade:r}=n.stage.pictures[0].flanks,s=r==="load"?0:Math.max(...n.stage.pictures.map(({flanks:o})=>o.greatestPressure()));for(let{flanks:o}of n.stage.pictures)o.hardest=s||void 0;n.flankRows&&(n.flankRows.shade&&(n.flankRows.shade.select.value=r),n.flankRows.lines.input.checked=t,n.flankRows.pattern.select.value=i),n.changed()}function ch(n,e,t){let i=n.stage.pictures[0].flanks.meshes[e],r=t??i?.gauge.fitting()??1;Bo(n,s=>{s.gauged=s.meshes.findIndex(({contact:o})=>o.name===i?.contact.name);for(let{gauge:o}of s.meshes)o.times=r}),n.flankRows&&(n.flankRows.times.set(r),n.flankRows.describe(e),n.flankRows.gauge.select.value=String(e))}function Ab(n){let{flanks:e,data:t}=n.stage.pictures[0];e.gauged<0&&ch(n,0);let i=e.meshes[e.gauged]?.contact.name,r=t.arrows.find(s=>s.kind==="mesh"&&s.name===i);r&&n.intoMesh(r)}function p_(n){let{meshes:e,greatest:t,pressures:i}=n.stage.pictures[0].flanks,r=u=>Bo(n,u),s=Cn("contact lines",!0,u=>r(d=>d.showsLines=u)),o=on("contact pattern",[["off","none"],["all","all teeth superimposed"],["each","each tooth"]],u=>r(d=>d.mode=u),"Maximum load or pressure up to the current time at every point of a flank"),a=i?on("colour by",Object.entries(ws).map(([u,{name:d}])=>[u,d]),u=>r(d=>d.shade=u),"Load per width, or maximum Hertzian pressure of the line contact"):null,c=_r({label:"magnification \xD7",title:"Magnification of the gap along the line of action",least:1,most:1e4,value:1,show:u=>ai(u,2),changed:u=>r(d=>d.meshes.forEach(({gauge:g})=>g.times=u))}),l=on("show gap of",[["-1","none"],...e.map(({contact:u},d)=>[String(d),u.name])],u=>ch(n,Number(u)),"Mesh with a magnified gap"),h=Cn("separate colour scale per mesh",!1,u=>r(d=>d.own=u)),f=Y("p",{className:"ppv-soft"});return n.flankRows={lines:s,pattern:o,shade:a,gauge:l,times:c,describe(u){let d=e[u]??(e.length===1?e[0]:null);f.hidden=!d,d&&(f.textContent=Tb(d.contact))}},n.flankRows.describe(-1),[s.row,t>0?o.row:null,t>0&&a?a.row:null,t>0&&e.length>1?h.row:null,l.row,f,c.row,Y("div",{className:"ppv-buttons"},xt("view gap","View along the axis on the magnified gap",()=>Ab(n))),Y("p",{className:"ppv-soft"},t>0?"Spheres at the ends of a line show the flank (yellow: front, purple: back); thin grey lines carry no load.":"Yellow lines: front flanks; purple: back flanks; thin and grey: no contact. The mesh law gives no loads per tooth pair.")].filter(Boolean)}var Rb=["axis","side","front","top","iso"],Cb=["view","projection","section","t","look","follow"];function m_(){let n=new URLSearchParams(location.hash.slice(1));return Object.fromEntries([...n].filter(([e])=>Cb.includes(e)))}var pu=n=>n.split(",").map(Number);function g_(n,e){let{t,view:i,projection:r,section:s,follow:o,look:a}=e;if(t!==void 0&&Number.isFinite(Number(t))&&n.seek(Number(t)),!!n.stage){if(o!==void 0&&n.follow(n.views.names.indexOf(o)),r&&n.project(r==="parallel"),Rb.includes(i)&&n.views.named(i,!0),a){let[c,l,h,f,u,d,g]=pu(a);g>0&&n.views.look([c,l,h],[f,u,d],g)}if(s){let[c,l]=s.split(",").length>2?[pu(s).slice(0,3),pu(s)[3]]:s.split(",");n.section.set(c,l===void 0?void 0:Number(l))}n.draw()}}var mu=n=>String(Number(n.toPrecision(7)));function x_(n){let{stage:e,orbit:t,section:i,views:r,player:s}=n,o=new URLSearchParams;if(s.times.length>1&&o.set("t",mu(s.time)),e){let{target:a,distance:c}=t.now,l=2*c*Math.tan(e.camera.fov*Math.PI/360),h=[...a.toArray(),...t.direction().toArray(),l];o.set("look",h.map(mu).join()),e.parallel&&o.set("projection","parallel"),i.on&&o.set("section",[...new C().copy(i.normal).toArray(),i.at].map(mu).join()),r.body>=0&&o.set("follow",r.names[r.body])}return`${location.href.split("#")[0]}#${o.toString().replaceAll("%2C",",")}`}function gu(n,e){let t=Float64Array.from(n[0].data);for(let i of n.slice(1))for(let r=0;r<t.length;r++)t[r]=e(t[r],i.data[r]);return{data:t,shape:[t.length],width:1,count:t.length}}function Pb(n){let e=gu(n,(t,i)=>t+i);for(let t=0;t<e.data.length;t++)e.data[t]/=n.length;return e}function __(n){let e=new Map;for(let i of n){let{name:r}=i.group??{};r!==void 0&&(e.has(r)||e.set(r,[]),e.get(r).push(i))}let t=new Map;for(let[i,r]of e){let[s]=r;if(!(r.length<2||r.some(({times:o})=>o.count!==s.times.count))){r.sort((o,a)=>o.group.planet-a.group.planet),t.set(i,{...s,name:i,label:s.group.label,group:void 0,members:r.map(o=>o.name),least:gu(r.map(({least:o})=>o),Math.min),most:gu(r.map(({least:o,most:a})=>a??o),Math.max),mean:Pb(r.map(({least:o,mean:a})=>a??o)),first:r.some(o=>o.first)});for(let o of r)Object.assign(o,{whole:i,first:!1,label:s.group.label.replace("planets",`planet ${o.group.planet}`)})}}return n.flatMap(i=>{let r=t.get(i.whole);if(!r)return[i];t.delete(i.whole);let s=r.members.map(o=>n.find(a=>a.name===o));return[r,...s]}).filter((i,r,s)=>s.indexOf(i)===r)}var Lb="uplot",Db="u-hz",Nb="u-vt",Ib="u-title",Ub="u-wrap",Fb="u-under",Ob="u-over",Bb="u-axis",As="u-off",kb="u-select",zb="u-cursor-x",Gb="u-cursor-y",Hb="u-cursor-pt",Vb="u-legend",Wb="u-live",Xb="u-inline",qb="u-series",Yb="u-marker",v_="u-label",$b="u-value",pl="width",ml="height";var M_="bottom",ko="left",xu="right",Iu="#000",S_=Iu+"0",_u="mousemove",y_="mousedown",vu="mouseup",b_="mouseenter",w_="mouseleave",E_="dblclick",Kb="resize",Zb="scroll",T_="change",ph="dppxchange",Uu="--",qo=typeof window<"u",wu=qo?document:null,Go=qo?window:null,Jb=qo?navigator:null,Ct,hh;function Eu(){let n=devicePixelRatio;Ct!=n&&(Ct=n,hh&&Au(T_,hh,Eu),hh=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),Rs(T_,hh,Eu),Go.dispatchEvent(new CustomEvent(ph)))}function wn(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Tu(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Kt(n,e,t){n.style[e]=t+"px"}function Kn(n,e,t,i){let r=wu.createElement(n);return e!=null&&wn(r,e),t?.insertBefore(r,i),r}function Bn(n,e){return Kn("div",n,e)}var A_=new WeakMap;function ur(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=A_.get(n);s!=o&&(n.style.transform=s,A_.set(n,s),e<0||t<0||e>i||t>r?wn(n,As):Tu(n,As))}var R_=new WeakMap;function C_(n,e,t){let i=e+t,r=R_.get(n);i!=r&&(R_.set(n,i),n.style.background=e,n.style.borderColor=t)}var P_=new WeakMap;function L_(n,e,t,i){let r=e+""+t,s=P_.get(n);r!=s&&(P_.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Fu={passive:!0},Qb={...Fu,capture:!0};function Rs(n,e,t,i){e.addEventListener(n,t,i?Qb:Fu)}function Au(n,e,t,i){e.removeEventListener(n,t,Fu)}qo&&Eu();function Zn(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:En((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function sv(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var ov=n=>n!=null,av=n=>n!=null&&n>0,xh=sv(ov),jb=sv(av);function ew(n,e,t,i=0,r=!1){let s=r?jb:xh,o=r?av:ov;[e,t]=s(n,e,t);let a=n[e],c=n[e];if(e>-1)if(i==1)a=n[e],c=n[t];else if(i==-1)a=n[t],c=n[e];else for(let l=e;l<=t;l++){let h=n[l];o(h)&&(h<a?a=h:h>c&&(c=h))}return[a??zt,c??-zt]}function _h(n,e,t,i){let r=I_(n),s=I_(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Pr:lv,a=r==1?En:kn,c=s==1?kn:En,l=a(o(Ci(n))),h=c(o(Ci(e))),f=Ho(t,l),u=Ho(t,h);return t==10&&(l<0&&(f=Gt(f,-l)),h<0&&(u=Gt(u,-h))),i||t==2?(n=f*r,e=u*s):(n=uv(n,f),e=vh(e,u)),[n,e]}function Ou(n,e,t,i){let r=_h(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var Bu=.1,D_={mode:3,pad:Bu},xl={pad:0,soft:null,mode:0},tw={min:xl,max:xl};function mh(n,e,t,i){return Mh(t)?N_(n,e,t):(xl.pad=t,xl.soft=i?0:null,xl.mode=i?3:0,N_(n,e,tw))}function At(n,e){return n??e}function iw(n,e,t){for(e=At(e,0),t=At(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function N_(n,e,t){let i=t.min,r=t.max,s=At(i.pad,0),o=At(r.pad,0),a=At(i.hard,-zt),c=At(r.hard,zt),l=At(i.soft,zt),h=At(r.soft,-zt),f=At(i.mode,0),u=At(r.mode,0),d=e-n,g=Pr(d),x=sn(Ci(n),Ci(e)),m=Pr(x),p=Ci(m-g);(d<1e-24||p>10)&&(d=0,(n==0||e==0)&&(d=1e-24,f==2&&l!=zt&&(s=0),u==2&&h!=-zt&&(o=0)));let _=d||x||1e3,y=Pr(_),S=Ho(10,En(y)),R=_*(d==0?n==0?.1:1:s),A=Gt(uv(n-R,S/10),24),v=n>=l&&(f==1||f==3&&A<=l||f==2&&A>=l)?l:zt,E=sn(a,A<v&&n>=v?v:Jn(v,A)),F=_*(d==0?e==0?.1:1:o),D=Gt(vh(e+F,S/10),24),N=e<=h&&(u==1||u==3&&D>=h||u==2&&D<=h)?h:-zt,k=Jn(c,D>N&&e<=N?N:sn(N,D));return E==k&&E==0&&(k=100),[E,k]}var nw=new Intl.NumberFormat(qo?Jb.language:"en-US"),ku=n=>nw.format(n),Tn=Math,dh=Tn.PI,Ci=Tn.abs,En=Tn.floor,Ri=Tn.round,kn=Tn.ceil,Jn=Tn.min,sn=Tn.max,Ho=Tn.pow,I_=Tn.sign,Pr=Tn.log10,lv=Tn.log2,rw=(n,e=1)=>Tn.sinh(n)*e,Mu=(n,e=1)=>Tn.asinh(n/e),zt=1/0;function U_(n){return(Pr((n^n>>31)-(n>>31))|0)+1}function Ru(n,e,t){return Jn(sn(n,e),t)}function cv(n){return typeof n=="function"}function Mt(n){return cv(n)?n:()=>n}var sw=()=>{},hv=n=>n,fv=(n,e)=>e,ow=n=>null,F_=n=>!0,O_=(n,e)=>n==e,aw=/\.\d*?(?=9{6,}|0{6,})/gm,Cs=n=>{if(pv(n)||ns.has(n))return n;let e=`${n}`,t=e.match(aw);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${Cs(r)}e${s}`}return Gt(n,i)};function Es(n,e){return Cs(Gt(Cs(n/e))*e)}function vh(n,e){return Cs(kn(Cs(n/e))*e)}function uv(n,e){return Cs(En(Cs(n/e))*e)}function Gt(n,e=0){if(pv(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Ri(i)/t}var ns=new Map;function dv(n){return((""+n).split(".")[1]||"").length}function vl(n,e,t,i){let r=[],s=i.map(dv);for(let o=e;o<t;o++){let a=Ci(o),c=Gt(Ho(n,o),a);for(let l=0;l<i.length;l++){let h=n==10?+`${i[l]}e${o}`:i[l]*c,f=(o>=0?0:a)+(o>=s[l]?0:s[l]),u=n==10?h:Gt(h,f);r.push(u),ns.set(u,f)}}return r}var _l={},zu=[],Vo=[null,null],is=Array.isArray,pv=Number.isInteger,lw=n=>n===void 0;function B_(n){return typeof n=="string"}function Mh(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function cw(n){return n!=null&&typeof n=="object"}var hw=Object.getPrototypeOf(Uint8Array),mv="__proto__";function Wo(n,e=Mh){let t;if(is(n)){let i=n.find(r=>r!=null);if(is(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=Wo(n[r],e)}else t=n.slice()}else if(n instanceof hw)t=n.slice();else if(e(n)){t={};for(let i in n)i!=mv&&(t[i]=Wo(n[i],e))}else t=n;return t}function yi(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=mv&&(Mh(n[r])?yi(n[r],Wo(i[r])):n[r]=Wo(i[r]))}return n}var fw=0,uw=1,dw=2;function pw(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function mw(n,e){if(_w(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return vw(o[0])||(o=xw(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let c=n[o][0],l=c.length;for(let h=0;h<l;h++)t.add(c[h])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],c=a[0];for(let l=1;l<a.length;l++){let h=a[l],f=Array(r).fill(void 0),u=e?e[o][l]:uw,d=[];for(let g=0;g<h.length;g++){let x=h[g],m=s.get(c[g]);x===null?u!=fw&&(f[m]=x,u==dw&&d.push(m)):f[m]=x}pw(f,d,r),i.push(f)}}return i}var gw=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function xw(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let c=0;c<t;c++)a[c]=o[i[c]];r.push(a)}return r}function _w(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function vw(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=sn(1,En((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let c=n[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var gv=["January","February","March","April","May","June","July","August","September","October","November","December"],xv=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function _v(n){return n.slice(0,3)}var Mw=xv.map(_v),Sw=gv.map(_v),yw={MMMM:gv,MMM:Sw,WWWW:xv,WWW:Mw};function dl(n){return(n<10?"0":"")+n}function bw(n){return(n<10?"00":n<100?"0":"")+n}var ww={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>dl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>dl(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>dl(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>dl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>dl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>bw(n.getMilliseconds())};function Gu(n,e){e=e||yw;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?ww[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var Ew=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Tw(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Ew?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var vv=n=>n%1==0,gh=[1,2,2.5,5],Aw=vl(10,-32,0,gh),Mv=vl(10,0,32,gh),Rw=Mv.filter(vv),Ts=Aw.concat(Mv),Hu=`
`,Sv="{YYYY}",k_=Hu+Sv,yv="{M}/{D}",gl=Hu+yv,fh=gl+"/{YY}",bv="{aa}",Cw="{h}:{mm}",zo=Cw+bv,z_=Hu+zo,G_=":{ss}",Lt=null;function wv(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,c=(n==1?vl(10,0,3,gh).filter(vv):vl(10,-3,0,gh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,Sv,Lt,Lt,Lt,Lt,Lt,Lt,1],[r*28,"{MMM}",k_,Lt,Lt,Lt,Lt,Lt,1],[r,yv,k_,Lt,Lt,Lt,Lt,Lt,1],[i,"{h}"+bv,fh,Lt,gl,Lt,Lt,Lt,1],[t,zo,fh,Lt,gl,Lt,Lt,Lt,1],[e,G_,fh+" "+zo,Lt,gl+" "+zo,Lt,z_,Lt,1],[n,G_+".{fff}",fh+" "+zo,Lt,gl+" "+zo,Lt,z_,Lt,1]];function h(f){return(u,d,g,x,m,p)=>{let _=[],y=m>=o,S=m>=s&&m<o,R=f(g),A=Gt(R*n,3),v=Su(R.getFullYear(),y?0:R.getMonth(),S||y?1:R.getDate()),E=Gt(v*n,3);if(S||y){let F=S?m/s:0,D=y?m/o:0,N=A==E?A:Gt(Su(v.getFullYear()+D,v.getMonth()+F,1)*n,3),k=new Date(Ri(N/n)),G=k.getFullYear(),I=k.getMonth();for(let W=0;N<=x;W++){let $=Su(G+D*W,I+F*W,1),V=$-f(Gt($*n,3));N=Gt((+$+V)*n,3),N<=x&&_.push(N)}}else{let F=m>=r?r:m,D=En(g)-En(A),N=E+D+vh(A-E,F);_.push(N);let k=f(N),G=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,I=m/i,W=u.axes[d]._space,$=p/W;for(;N=Gt(N+m,n==1?0:3),!(N>x);)if(I>1){let V=En(Gt(G+I,6))%24,j=f(N).getHours()-V;j>1&&(j=-1),N-=j*i,G=(G+I)%24;let re=_[_.length-1];Gt((N-re)/m,3)*$>=.7&&_.push(N)}else _.push(N)}return _}}return[c,l,h]}var[Pw,Lw,Dw]=wv(1),[Nw,Iw,Uw]=wv(.001);vl(2,-53,53,[1]);function H_(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function V_(n,e){return(t,i,r,s,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],c,l,h,f,u,d;return i.map(g=>{let x=n(g),m=x.getFullYear(),p=x.getMonth(),_=x.getDate(),y=x.getHours(),S=x.getMinutes(),R=x.getSeconds(),A=m!=c&&a[2]||p!=l&&a[3]||_!=h&&a[4]||y!=f&&a[5]||S!=u&&a[6]||R!=d&&a[7]||a[1];return c=m,l=p,h=_,f=y,u=S,d=R,A(x)})}}function Fw(n,e){let t=Gu(e);return(i,r,s,o,a)=>r.map(c=>t(n(c)))}function Su(n,e,t){return new Date(n,e,t)}function W_(n,e){return e(n)}var Ow="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function X_(n,e){return(t,i,r,s)=>s==null?Uu:e(n(i))}function Bw(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function kw(n,e){return n.series[e].fill(n,e)}var zw={show:!0,live:!0,isolate:!1,mount:sw,markers:{show:!0,width:2,stroke:Bw,fill:kw,dash:"solid"},idx:null,idxs:null,values:[]};function Gw(n,e){let t=n.cursor.points,i=Bn(),r=t.size(n,e);Kt(i,pl,r),Kt(i,ml,r);let s=r/-2;Kt(i,"marginLeft",s),Kt(i,"marginTop",s);let o=t.width(n,e,r);return o&&Kt(i,"borderWidth",o),i}function Hw(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Vw(n,e){let t=n.series[e].points;return t._stroke||t._fill}function Ww(n,e){return n.series[e].points.size}var yu=[0,0];function Xw(n,e,t){return yu[0]=e,yu[1]=t,yu}function uh(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function bu(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var qw={show:!0,x:!0,y:!0,lock:!1,move:Xw,points:{one:!1,show:Gw,size:Ww,width:0,stroke:Vw,fill:Hw},bind:{mousedown:uh,mouseup:uh,click:uh,dblclick:uh,mousemove:bu,mouseleave:bu,mouseenter:bu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Ev={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Vu=yi({},Ev,{filter:fv}),Tv=yi({},Vu,{size:10}),Av=yi({},Ev,{show:!1}),Wu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Rv="bold "+Wu,Cv=1.5,q_={show:!0,scale:"x",stroke:Iu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Rv,side:2,grid:Vu,ticks:Tv,border:Av,font:Wu,lineGap:Cv,rotate:0},Yw="Value",$w="Time",Y_={show:!0,scale:"x",auto:!1,sorted:1,min:zt,max:-zt,idxs:[]};function Kw(n,e,t,i,r){return e.map(s=>s==null?"":ku(s))}function Zw(n,e,t,i,r,s,o){let a=[],c=ns.get(r)||0;t=o?t:Gt(vh(t,r),c);for(let l=t;l<=i;l=Gt(l+r,c))a.push(Object.is(l,-0)?0:l);return a}function Cu(n,e,t,i,r,s,o){let a=[],c=n.scales[n.axes[e].scale].log,l=c==10?Pr:lv,h=En(l(t));r=Ho(c,h),c==10&&(r=Ts[Zn(r,Ts)]);let f=t,u=r*c;c==10&&(u=Ts[Zn(u,Ts)]);do a.push(f),f=f+r,c==10&&!ns.has(f)&&(f=Gt(f,ns.get(r))),f>=u&&(r=f,u=r*c,c==10&&(u=Ts[Zn(u,Ts)]));while(f<=i);return a}function Jw(n,e,t,i,r,s,o){let c=n.scales[n.axes[e].scale].asinh,l=i>c?Cu(n,e,sn(c,t),i,r):[c],h=i>=0&&t<=0?[0]:[];return(t<-c?Cu(n,e,sn(c,-i),-t,r):[c]).reverse().map(u=>-u).concat(h,l)}var Pv=/./,Qw=/[12357]/,jw=/[125]/,$_=/1/,Pu=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function eE(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],c=n.valToPos,l=s._space,h=c(10,o),f=c(9,o)-h>=l?Pv:c(7,o)-h>=l?Qw:c(5,o)-h>=l?jw:$_;if(f==$_){let u=Ci(c(1,o)-h);if(u<l)return Pu(e.slice().reverse(),a.distr,f,kn(l/u)).reverse()}return Pu(e,a.distr,f,1)}function tE(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,c=n.valToPos,l=Ci(c(1,o)-c(2,o));return l<a?Pu(e.slice().reverse(),3,Pv,kn(a/l)).reverse():e}function iE(n,e,t,i){return i==null?Uu:e==null?"":ku(e)}var K_={show:!0,scale:"y",stroke:Iu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Rv,side:3,grid:Vu,ticks:Tv,border:Av,font:Wu,lineGap:Cv,rotate:0};function nE(n,e){let t=3+(n||1)*2;return Gt(t*e,3)}function rE(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=Ci(o-s),c=n.series[e],l=a/(c.points.space*Ct);return i[1]-i[0]<=l}var Z_={scale:null,auto:!0,sorted:0,min:zt,max:-zt},Lv=(n,e,t,i,r)=>r,J_={show:!0,auto:!0,sorted:0,gaps:Lv,alpha:1,facets:[yi({},Z_,{scale:"x"}),yi({},Z_,{scale:"y"})]},Q_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Lv,alpha:1,points:{show:rE,filter:null},values:null,min:zt,max:-zt,idxs:[],path:null,clip:null};function sE(n,e,t,i,r){return t/10}var Dv={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},oE=yi({},Dv,{time:!1,ori:1}),j_={};function Nv(n,e){let t=j_[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,c,l){for(let h=0;h<t.plots.length;h++)t.plots[h]!=r&&t.plots[h].pub(i,r,s,o,a,c,l)}},n!=null&&(j_[n]=t)),t}var Xo=1,Lu=2;function Ps(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,c=s[0],l=i==2?s[1]:s[e],h=i==2?o[r.facets[0].scale]:o[n.series[0].scale],f=i==2?o[r.facets[1].scale]:o[r.scale],u=a.left,d=a.top,g=a.width,x=a.height,m=n.valToPosH,p=n.valToPosV;return h.ori==0?t(r,c,l,h,f,m,p,u,d,g,x,yh,Yo,wh,Uv,Ov):t(r,c,l,h,f,p,m,d,u,x,g,bh,$o,Yu,Fv,Bv)}function Xu(n,e){let t=0,i=0,r=At(n.bands,zu);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function aE(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,c=n.scales[a];return r==-1?c.min:r==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function Lr(n,e,t,i,r,s){return Ps(n,e,(o,a,c,l,h,f,u,d,g,x,m)=>{let p=o.pxRound,_=l.dir*(l.ori==0?1:-1),y=l.ori==0?Yo:$o,S,R;_==1?(S=t,R=i):(S=i,R=t);let A=p(f(a[S],l,x,d)),v=p(u(c[S],h,m,g)),E=p(f(a[R],l,x,d)),F=p(u(s==1?h.max:h.min,h,m,g)),D=new Path2D(r);return y(D,E,F),y(D,A,F),y(D,A,v),D})}function Sh(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?wh:Yu,c=t;for(let f=0;f<n.length;f++){let u=n[f];if(u[1]>u[0]){let d=u[0]-c;d>0&&a(o,c,i,d,i+s),c=u[1]}}let l=t+r-c,h=10;l>0&&a(o,c,i-h/2,l,i+s+h)}return o}function lE(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function qu(n,e,t,i,r,s,o){let a=[],c=n.length;for(let l=r==1?t:i;l>=t&&l<=i;l+=r)if(e[l]===null){let f=l,u=l;if(r==1)for(;++l<=i&&e[l]===null;)u=l;else for(;--l>=t&&e[l]===null;)u=l;let d=s(n[f]),g=u==f?d:s(n[u]),x=f-r;d=o<=0&&x>=0&&x<c?s(n[x]):d;let p=u+r;g=o>=0&&p>=0&&p<c?s(n[p]):g,g>=d&&a.push([d,g])}return a}function ev(n){return n==0?hv:n==1?Ri:e=>Es(e,n)}function Iv(n){let e=n==0?yh:bh,t=n==0?(r,s,o,a,c,l)=>{r.arcTo(s,o,a,c,l)}:(r,s,o,a,c,l)=>{r.arcTo(o,s,c,a,l)},i=n==0?(r,s,o,a,c)=>{r.rect(s,o,a,c)}:(r,s,o,a,c)=>{r.rect(o,s,c,a)};return(r,s,o,a,c,l=0,h=0)=>{l==0&&h==0?i(r,s,o,a,c):(l=Jn(l,a/2,c/2),h=Jn(h,a/2,c/2),e(r,s+l,o),t(r,s+a,o,s+a,o+c,l),t(r,s+a,o+c,s,o+c,h),t(r,s,o+c,s,o,h),t(r,s,o,s+a,o,l),r.closePath())}}var yh=(n,e,t)=>{n.moveTo(e,t)},bh=(n,e,t)=>{n.moveTo(t,e)},Yo=(n,e,t)=>{n.lineTo(e,t)},$o=(n,e,t)=>{n.lineTo(t,e)},wh=Iv(0),Yu=Iv(1),Uv=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},Fv=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},Ov=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},Bv=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function kv(n){return(e,t,i,r,s)=>Ps(e,t,(o,a,c,l,h,f,u,d,g,x,m)=>{let{pxRound:p,points:_}=o,y,S;l.ori==0?(y=yh,S=Uv):(y=bh,S=Fv);let R=Gt(_.width*Ct,3),A=(_.size-_.width)/2*Ct,v=Gt(A*2,3),E=new Path2D,F=new Path2D,{left:D,top:N,width:k,height:G}=e.bbox;wh(F,D-v,N-v,k+v*2,G+v*2);let I=W=>{if(c[W]!=null){let $=p(f(a[W],l,x,d)),V=p(u(c[W],h,m,g));y(E,$+A,V),S(E,$,V,A,0,dh*2)}};if(s)s.forEach(I);else for(let W=i;W<=r;W++)I(W);return{stroke:R>0?E:null,fill:E,clip:F,flags:Xo|Lu}})}function zv(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var cE=zv(Yo),hE=zv($o);function Gv(n){let e=At(n?.alignGaps,0);return(t,i,r,s)=>Ps(t,i,(o,a,c,l,h,f,u,d,g,x,m)=>{[r,s]=xh(c,r,s);let p=o.pxRound,_=G=>p(f(G,l,x,d)),y=G=>p(u(G,h,m,g)),S,R;l.ori==0?(S=Yo,R=cE):(S=$o,R=hE);let A=l.dir*(l.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xo},E=v.stroke,F=!1;if(s-r>=x*4){let G=fe=>t.posToVal(fe,l.key,!0),I=null,W=null,$,V,ce,J=_(a[A==1?r:s]),j=_(a[r]),re=_(a[s]),ue=G(A==1?j+1:re-1);for(let fe=A==1?r:s;fe>=r&&fe<=s;fe+=A){let ee=a[fe],_e=(A==1?ee<ue:ee>ue)?J:_(ee),Re=c[fe];_e==J?Re!=null?(V=Re,I==null?(S(E,_e,y(V)),$=I=W=V):V<I?I=V:V>W&&(W=V)):Re===null&&(F=!0):(I!=null&&R(E,J,y(I),y(W),y($),y(V)),Re!=null?(V=Re,S(E,_e,y(V)),I=W=$=V):(I=W=null,Re===null&&(F=!0)),J=_e,ue=G(J+A))}I!=null&&I!=W&&ce!=J&&R(E,J,y(I),y(W),y($),y(V))}else for(let G=A==1?r:s;G>=r&&G<=s;G+=A){let I=c[G];I===null?F=!0:I!=null&&S(E,_(a[G]),y(I))}let[N,k]=Xu(t,i);if(o.fill!=null||N!=0){let G=v.fill=new Path2D(E),I=o.fillTo(t,i,o.min,o.max,N),W=y(I),$=_(a[r]),V=_(a[s]);A==-1&&([V,$]=[$,V]),S(G,V,W),S(G,$,W)}if(!o.spanGaps){let G=[];F&&G.push(...qu(a,c,r,s,A,_,e)),v.gaps=G=o.gaps(t,i,r,s,G),v.clip=Sh(G,l.ori,d,g,x,m)}return k!=0&&(v.band=k==2?[Lr(t,i,r,s,E,-1),Lr(t,i,r,s,E,1)]:Lr(t,i,r,s,E,k)),v})}function fE(n){let e=At(n.align,1),t=At(n.ascDesc,!1),i=At(n.alignGaps,0),r=At(n.extend,!1);return(s,o,a,c)=>Ps(s,o,(l,h,f,u,d,g,x,m,p,_,y)=>{[a,c]=xh(f,a,c);let S=l.pxRound,{left:R,width:A}=s.bbox,v=j=>S(g(j,u,_,m)),E=j=>S(x(j,d,y,p)),F=u.ori==0?Yo:$o,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xo},N=D.stroke,k=u.dir*(u.ori==0?1:-1),G=E(f[k==1?a:c]),I=v(h[k==1?a:c]),W=I,$=I;r&&e==-1&&($=R,F(N,$,G)),F(N,I,G);for(let j=k==1?a:c;j>=a&&j<=c;j+=k){let re=f[j];if(re==null)continue;let ue=v(h[j]),fe=E(re);e==1?F(N,ue,G):F(N,W,fe),F(N,ue,fe),G=fe,W=ue}let V=W;r&&e==1&&(V=R+A,F(N,V,G));let[ce,J]=Xu(s,o);if(l.fill!=null||ce!=0){let j=D.fill=new Path2D(N),re=l.fillTo(s,o,l.min,l.max,ce),ue=E(re);F(j,V,ue),F(j,$,ue)}if(!l.spanGaps){let j=[];j.push(...qu(h,f,a,c,k,v,i));let re=l.width*Ct/2,ue=t||e==1?re:-re,fe=t||e==-1?-re:re;j.forEach(ee=>{ee[0]+=ue,ee[1]+=fe}),D.gaps=j=l.gaps(s,o,a,c,j),D.clip=Sh(j,u.ori,m,p,_,y)}return J!=0&&(D.band=J==2?[Lr(s,o,a,c,N,-1),Lr(s,o,a,c,N,1)]:Lr(s,o,a,c,N,J)),D})}function tv(n,e,t,i,r,s,o=zt){if(n.length>1){let a=null;for(let c=0,l=1/0;c<n.length;c++)if(e[c]!==void 0){if(a!=null){let h=Ci(n[c]-n[a]);h<l&&(l=h,o=Ci(t(n[c],i,r,s)-t(n[a],i,r,s)))}a=c}}return o}function uE(n){n=n||_l;let e=At(n.size,[.6,zt,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=Mt(r),o=1-e[0],a=At(e[1],zt),c=At(e[2],1),l=At(n.disp,_l),h=At(n.each,d=>{}),{fill:f,stroke:u}=l;return(d,g,x,m)=>Ps(d,g,(p,_,y,S,R,A,v,E,F,D,N)=>{let k=p.pxRound,G=t,I=i*Ct,W=a*Ct,$=c*Ct,V,ce;S.ori==0?[V,ce]=s(d,g):[ce,V]=s(d,g);let J=S.dir*(S.ori==0?1:-1),j=S.ori==0?wh:Yu,re=S.ori==0?h:(Pe,Je,st,we,kt,Ve,Ze)=>{h(Pe,Je,st,kt,we,Ze,Ve)},ue=At(d.bands,zu).find(Pe=>Pe.series[0]==g),fe=ue!=null?ue.dir:0,ee=p.fillTo(d,g,p.min,p.max,fe),me=k(v(ee,R,N,F)),_e,Re,be,qe=D,rt=k(p.width*Ct),We=!1,dt=null,ht=null,it=null,Zt=null;f!=null&&(rt==0||u!=null)&&(We=!0,dt=f.values(d,g,x,m),ht=new Map,new Set(dt).forEach(Pe=>{Pe!=null&&ht.set(Pe,new Path2D)}),rt>0&&(it=u.values(d,g,x,m),Zt=new Map,new Set(it).forEach(Pe=>{Pe!=null&&Zt.set(Pe,new Path2D)})));let{x0:Ht,size:pi}=l;if(Ht!=null&&pi!=null){G=1,_=Ht.values(d,g,x,m),Ht.unit==2&&(_=_.map(st=>d.posToVal(E+st*D,S.key,!0)));let Pe=pi.values(d,g,x,m);pi.unit==2?Re=Pe[0]*D:Re=A(Pe[0],S,D,E)-A(0,S,D,E),qe=tv(_,y,A,S,D,E,qe),be=qe-Re+I}else qe=tv(_,y,A,S,D,E,qe),be=qe*o+I,Re=qe-be;be<1&&(be=0),rt>=Re/2&&(rt=0),be<5&&(k=hv);let Ft=be>0,Pi=qe-be-(Ft?rt:0);Re=k(Ru(Pi,$,W)),_e=(G==0?Re/2:G==J?0:Re)-G*J*((G==0?I/2:0)+(Ft?rt/2:0));let yt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},bi=We?null:new Path2D,ii=null;if(ue!=null)ii=d.data[ue.series[1]];else{let{y0:Pe,y1:Je}=l;Pe!=null&&Je!=null&&(y=Je.values(d,g,x,m),ii=Pe.values(d,g,x,m))}let mi=V*Re,B=ce*Re;for(let Pe=J==1?x:m;Pe>=x&&Pe<=m;Pe+=J){let Je=y[Pe];if(Je==null)continue;if(ii!=null){let X=ii[Pe]??0;if(Je-X==0)continue;me=v(X,R,N,F)}let st=S.distr!=2||l!=null?_[Pe]:Pe,we=A(st,S,D,E),kt=v(At(Je,ee),R,N,F),Ve=k(we-_e),Ze=k(sn(kt,me)),P=k(Jn(kt,me)),b=Ze-P;if(Je!=null){let X=Je<0?B:mi,he=Je<0?mi:B;We?(rt>0&&it[Pe]!=null&&j(Zt.get(it[Pe]),Ve,P+En(rt/2),Re,sn(0,b-rt),X,he),dt[Pe]!=null&&j(ht.get(dt[Pe]),Ve,P+En(rt/2),Re,sn(0,b-rt),X,he)):j(bi,Ve,P+En(rt/2),Re,sn(0,b-rt),X,he),re(d,g,Pe,Ve-rt/2,P,Re+rt,b)}}return rt>0?yt.stroke=We?Zt:bi:We||(yt._fill=p.width==0?p._fill:p._stroke??p._fill,yt.width=0),yt.fill=We?ht:bi,yt})}function dE(n,e){let t=At(e?.alignGaps,0);return(i,r,s,o)=>Ps(i,r,(a,c,l,h,f,u,d,g,x,m,p)=>{[s,o]=xh(l,s,o);let _=a.pxRound,y=V=>_(u(V,h,m,g)),S=V=>_(d(V,f,p,x)),R,A,v;h.ori==0?(R=yh,v=Yo,A=Ov):(R=bh,v=$o,A=Bv);let E=h.dir*(h.ori==0?1:-1),F=y(c[E==1?s:o]),D=F,N=[],k=[];for(let V=E==1?s:o;V>=s&&V<=o;V+=E)if(l[V]!=null){let J=c[V],j=y(J);N.push(D=j),k.push(S(l[V]))}let G={stroke:n(N,k,R,v,A,_),fill:null,clip:null,band:null,gaps:null,flags:Xo},I=G.stroke,[W,$]=Xu(i,r);if(a.fill!=null||W!=0){let V=G.fill=new Path2D(I),ce=a.fillTo(i,r,a.min,a.max,W),J=S(ce);v(V,D,J),v(V,F,J)}if(!a.spanGaps){let V=[];V.push(...qu(c,l,s,o,E,y,t)),G.gaps=V=a.gaps(i,r,s,o,V),G.clip=Sh(V,h.ori,g,x,m,p)}return $!=0&&(G.band=$==2?[Lr(i,r,s,o,I,-1),Lr(i,r,s,o,I,1)]:Lr(i,r,s,o,I,$)),G})}function pE(n){return dE(mE,n)}function mE(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let c=Array(o),l=Array(o-1),h=Array(o-1),f=Array(o-1);for(let u=0;u<o-1;u++)h[u]=e[u+1]-e[u],f[u]=n[u+1]-n[u],l[u]=h[u]/f[u];c[0]=l[0];for(let u=1;u<o-1;u++)l[u]===0||l[u-1]===0||l[u-1]>0!=l[u]>0?c[u]=0:(c[u]=3*(f[u-1]+f[u])/((2*f[u]+f[u-1])/l[u-1]+(f[u]+2*f[u-1])/l[u]),isFinite(c[u])||(c[u]=0));c[o-1]=l[o-2];for(let u=0;u<o-1;u++)r(a,n[u]+f[u]/3,e[u]+c[u]*f[u]/3,n[u+1]-f[u]/3,e[u+1]-c[u+1]*f[u]/3,n[u+1],e[u+1])}return a}var Du=new Set;function iv(){for(let n of Du)n.syncRect(!0)}qo&&(Rs(Kb,Go,iv),Rs(Zb,Go,iv,!0),Rs(ph,Go,()=>{ti.pxRatio=Ct}));var gE=Gv(),xE=kv();function nv(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>Nu(s,o,e,t))}function _E(n,e){return n.map((t,i)=>i==0?{}:yi({},e,t))}function Nu(n,e,t,i){return yi({},e==0?t:i,n)}function Hv(n,e,t){return e==null?Vo:[e,t]}var vE=Hv;function ME(n,e,t){return e==null?Vo:mh(e,t,Bu,!0)}function Vv(n,e,t,i){return e==null?Vo:_h(e,t,n.scales[i].log,!1)}var SE=Vv;function Wv(n,e,t,i){return e==null?Vo:Ou(e,t,n.scales[i].log,!1)}var yE=Wv;function bE(n,e,t,i,r){let s=sn(U_(n),U_(e)),o=e-n,a=Zn(r/i*o,t);do{let c=t[a],l=i*c/o;if(l>=r&&s+(c<5?ns.get(c):0)<=17)return[c,l]}while(++a<t.length);return[0,0]}function rv(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Ri((t=+r)*Ct))+"px"),[n,e,t]}function wE(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Gt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function ti(n,e,t){let i={mode:At(n.mode,1)},r=i.mode;function s(M,w,L,U){let H=w.valToPct(M);return U+L*(w.dir==-1?1-H:H)}function o(M,w,L,U){let H=w.valToPct(M);return U+L*(w.dir==-1?H:1-H)}function a(M,w,L,U){return w.ori==0?s(M,w,L,U):o(M,w,L,U)}i.valToPosH=s,i.valToPosV=o;let c=!1;i.status=0;let l=i.root=Bn(Lb);if(n.id!=null&&(l.id=n.id),wn(l,n.class),n.title){let M=Bn(Ib,l);M.textContent=n.title}let h=Kn("canvas"),f=i.ctx=h.getContext("2d"),u=Bn(Ub,l);Rs("click",u,M=>{M.target===g&&(Xt!=zs||Jt!=Gs)&&Vi.click(i,M)},!0);let d=i.under=Bn(Fb,u);u.appendChild(h);let g=i.over=Bn(Ob,u);n=Wo(n);let x=+At(n.pxAlign,1),m=ev(x);(n.plugins||[]).forEach(M=>{M.opts&&(n=M.opts(i,n)||n)});let p=n.ms||.001,_=i.series=r==1?nv(n.series||[],Y_,Q_,!1):_E(n.series||[null],J_),y=i.axes=nv(n.axes||[],q_,K_,!0),S=i.scales={},R=i.bands=n.bands||[];R.forEach(M=>{M.fill=Mt(M.fill||null),M.dir=At(M.dir,-1)});let A=r==2?_[1].facets[0].scale:_[0].scale,v={axes:gr,series:mt},E=(n.drawOrder||["axes","series"]).map(M=>v[M]);function F(M){let w=M.distr==3?L=>Pr(L>0?L:M.clamp(i,L,M.min,M.max,M.key)):M.distr==4?L=>Mu(L,M.asinh):M.distr==100?L=>M.fwd(L):L=>L;return L=>{let U=w(L),{_min:H,_max:Z}=M,ae=Z-H;return(U-H)/ae}}function D(M){let w=S[M];if(w==null){let L=(n.scales||_l)[M]||_l;if(L.from!=null){D(L.from);let U=yi({},S[L.from],L,{key:M});U.valToPct=F(U),S[M]=U}else{w=S[M]=yi({},M==A?Dv:oE,L),w.key=M;let U=w.time,H=w.range,Z=is(H);if((M!=A||r==2&&!U)&&(Z&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?D_:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?D_:{mode:1,hard:H[1],soft:H[1]}},Z=!1),!Z&&Mh(H))){let ae=H;H=(de,Me,Ie)=>Me==null?Vo:mh(Me,Ie,ae)}w.range=Mt(H||(U?vE:M==A?w.distr==3?SE:w.distr==4?yE:Hv:w.distr==3?Vv:w.distr==4?Wv:ME)),w.auto=Mt(Z?!1:w.auto),w.clamp=Mt(w.clamp||sE),w._min=w._max=null,w.valToPct=F(w)}}}D("x"),D("y"),r==1&&_.forEach(M=>{D(M.scale)}),y.forEach(M=>{D(M.scale)});for(let M in n.scales)D(M);let N=S[A],k=N.distr,G,I;N.ori==0?(wn(l,Db),G=s,I=o):(wn(l,Nb),G=o,I=s);let W={};for(let M in S){let w=S[M];(w.min!=null||w.max!=null)&&(W[M]={min:w.min,max:w.max},w.min=w.max=null)}let $=n.tzDate||(M=>new Date(Ri(M/p))),V=n.fmtDate||Gu,ce=p==1?Dw($):Uw($),J=V_($,H_(p==1?Lw:Iw,V)),j=X_($,W_(Ow,V)),re=[],ue=i.legend=yi({},zw,n.legend),fe=i.cursor=yi({},qw,{drag:{y:r==2}},n.cursor),ee=ue.show,me=fe.show,_e=ue.markers;ue.idxs=re,_e.width=Mt(_e.width),_e.dash=Mt(_e.dash),_e.stroke=Mt(_e.stroke),_e.fill=Mt(_e.fill);let Re,be,qe,rt=[],We=[],dt,ht=!1,it={};if(ue.live){let M=_[1]?_[1].values:null;ht=M!=null,dt=ht?M(i,1,0):{_:0};for(let w in dt)it[w]=Uu}if(ee)if(Re=Kn("table",Vb,l),qe=Kn("tbody",null,Re),ue.mount(i,Re),ht){be=Kn("thead",null,Re,qe);let M=Kn("tr",null,be);Kn("th",null,M);for(var Zt in dt)Kn("th",v_,M).textContent=Zt}else wn(Re,Xb),ue.live&&wn(Re,Wb);let Ht={show:!0},pi={show:!1};function Ft(M,w){if(w==0&&(ht||!ue.live||r==2))return Vo;let L=[],U=Kn("tr",qb,qe,qe.childNodes[w]);wn(U,M.class),M.show||wn(U,As);let H=Kn("th",null,U);if(_e.show){let de=Bn(Yb,H);if(w>0){let Me=_e.width(i,w);Me&&(de.style.border=Me+"px "+_e.dash(i,w)+" "+_e.stroke(i,w)),de.style.background=_e.fill(i,w)}}let Z=Bn(v_,H);M.label instanceof HTMLElement?Z.appendChild(M.label):Z.textContent=M.label,w>0&&(_e.show||(Z.style.color=M.width>0?_e.stroke(i,w):_e.fill(i,w)),yt("click",H,de=>{if(fe._lock)return;je(de);let Me=_.indexOf(M);if((de.ctrlKey||de.metaKey)!=ue.isolate){let Ie=_.some((Ue,Be)=>Be>0&&Be!=Me&&Ue.show);_.forEach((Ue,Be)=>{Be>0&&tr(Be,Ie?Be==Me?Ht:pi:Ht,!0,vi.setSeries)})}else tr(Me,{show:!M.show},!0,vi.setSeries)},!1),et&&yt(b_,H,de=>{fe._lock||(je(de),tr(_.indexOf(M),Vs,!0,vi.setSeries))},!1));for(var ae in dt){let de=Kn("td",$b,U);de.textContent="--",L.push(de)}return[U,L]}let Pi=new Map;function yt(M,w,L,U=!0){let H=Pi.get(w)||{},Z=fe.bind[M](i,w,L,U);Z&&(Rs(M,w,H[M]=Z),Pi.set(w,H))}function bi(M,w,L){let U=Pi.get(w)||{};for(let H in U)(M==null||H==M)&&(Au(H,w,U[H]),delete U[H]);M==null&&Pi.delete(w)}let ii=0,mi=0,B=0,Pe=0,Je=0,st=0,we=Je,kt=st,Ve=B,Ze=Pe,P=0,b=0,X=0,he=0;i.bbox={};let oe=!1,xe=!1,ve=!1,te=!1,ne=!1,pe=!1;function O(M,w,L){(L||M!=i.width||w!=i.height)&&se(M,w),ft(!1),ve=!0,xe=!0,qi()}function se(M,w){i.width=ii=B=M,i.height=mi=Pe=w,Je=st=0,Se(),Xe();let L=i.bbox;P=L.left=Es(Je*Ct,.5),b=L.top=Es(st*Ct,.5),X=L.width=Es(B*Ct,.5),he=L.height=Es(Pe*Ct,.5)}let ie=3;function Ee(){let M=!1,w=0;for(;!M;){w++;let L=Os(w),U=er(w);M=w==ie||L&&U,M||(se(i.width,i.height),xe=!0)}}function ge({width:M,height:w}){O(M,w)}i.setSize=ge;function Se(){let M=!1,w=!1,L=!1,U=!1;y.forEach((H,Z)=>{if(H.show&&H._show){let{side:ae,_size:de}=H,Me=ae%2,Ie=H.label!=null?H.labelSize:0,Ue=de+Ie;Ue>0&&(Me?(B-=Ue,ae==3?(Je+=Ue,U=!0):L=!0):(Pe-=Ue,ae==0?(st+=Ue,M=!0):w=!0))}}),Qn[0]=M,Qn[1]=L,Qn[2]=w,Qn[3]=U,B-=Gn[1]+Gn[3],Je+=Gn[3],Pe-=Gn[2]+Gn[0],st+=Gn[0]}function Xe(){let M=Je+B,w=st+Pe,L=Je,U=st;function H(Z,ae){switch(Z){case 1:return M+=ae,M-ae;case 2:return w+=ae,w-ae;case 3:return L-=ae,L+ae;case 0:return U-=ae,U+ae}}y.forEach((Z,ae)=>{if(Z.show&&Z._show){let de=Z.side;Z._pos=H(de,Z._size),Z.label!=null&&(Z._lpos=H(de,Z.labelSize))}})}if(fe.dataIdx==null){let M=fe.hover,w=M.skip=new Set(M.skip??[]);w.add(void 0);let L=M.prox=Mt(M.prox),U=M.bias??=0;fe.dataIdx=(H,Z,ae,de)=>{if(Z==0)return ae;let Me=ae,Ie=L(H,Z,ae,de)??zt,Ue=Ie>=0&&Ie<zt,Be=N.ori==0?B:Pe,nt=fe.left,Rt=e[0],wt=e[Z];if(w.has(wt[ae])){Me=null;let gt=null,Qe=null,Ye;if(U==0||U==-1)for(Ye=ae;gt==null&&Ye-- >0;)w.has(wt[Ye])||(gt=Ye);if(U==0||U==1)for(Ye=ae;Qe==null&&Ye++<wt.length;)w.has(wt[Ye])||(Qe=Ye);if(gt!=null||Qe!=null)if(Ue){let Yt=gt==null?-1/0:G(Rt[gt],N,Be,0),si=Qe==null?1/0:G(Rt[Qe],N,Be,0),Ii=nt-Yt,Ot=si-nt;Ii<=Ot?Ii<=Ie&&(Me=gt):Ot<=Ie&&(Me=Qe)}else Me=Qe==null?gt:gt==null?Qe:ae-gt<=Qe-ae?gt:Qe}else Ue&&Ci(nt-G(Rt[ae],N,Be,0))>Ie&&(Me=null);return Me}}let je=M=>{fe.event=M};fe.idxs=re,fe._lock=!1;let le=fe.points;le.show=Mt(le.show),le.size=Mt(le.size),le.stroke=Mt(le.stroke),le.width=Mt(le.width),le.fill=Mt(le.fill);let ze=i.focus=yi({},n.focus||{alpha:.3},fe.focus),et=ze.prox>=0,Ce=et&&le.one,lt=[],Wt=[],Qi=[];function Jo(M,w){let L=le.show(i,w);if(L instanceof HTMLElement)return wn(L,Hb),wn(L,M.class),ur(L,-10,-10,B,Pe),g.insertBefore(L,lt[w]),L}function Is(M,w){if(r==1||w>0){let L=r==1&&S[M.scale].time,U=M.value;M.value=L?B_(U)?X_($,W_(U,V)):U||j:U||iE,M.label=M.label||(L?$w:Yw)}if(Ce||w>0){M.width=M.width==null?1:M.width,M.paths=M.paths||gE||ow,M.fillTo=Mt(M.fillTo||aE),M.pxAlign=+At(M.pxAlign,x),M.pxRound=ev(M.pxAlign),M.stroke=Mt(M.stroke||null),M.fill=Mt(M.fill||null),M._stroke=M._fill=M._paths=M._focus=null;let L=nE(sn(1,M.width),1),U=M.points=yi({},{size:L,width:sn(1,L*.2),stroke:M.stroke,space:L*2,paths:xE,_stroke:null,_fill:null},M.points);U.show=Mt(U.show),U.filter=Mt(U.filter),U.fill=Mt(U.fill),U.stroke=Mt(U.stroke),U.paths=Mt(U.paths),U.pxAlign=M.pxAlign}if(ee){let L=Ft(M,w);rt.splice(w,0,L[0]),We.splice(w,0,L[1]),ue.values.push(null)}if(me){re.splice(w,0,null);let L=null;Ce?w==0&&(L=Jo(M,w)):w>0&&(L=Jo(M,w)),lt.splice(w,0,L),Wt.splice(w,0,0),Qi.splice(w,0,0)}Ni("addSeries",w)}function pf(M,w){w=w??_.length,M=r==1?Nu(M,w,Y_,Q_):Nu(M,w,{},J_),_.splice(w,0,M),Is(_[w],w)}i.addSeries=pf;function Al(M){if(_.splice(M,1),ee){ue.values.splice(M,1),We.splice(M,1);let w=rt.splice(M,1)[0];bi(null,w.firstChild),w.remove()}me&&(re.splice(M,1),lt.splice(M,1)[0].remove(),Wt.splice(M,1),Qi.splice(M,1)),Ni("delSeries",M)}i.delSeries=Al;let Qn=[!1,!1,!1,!1];function dr(M,w){if(M._show=M.show,M.show){let L=M.side%2,U=S[M.scale];U==null&&(M.scale=L?_[1].scale:A,U=S[M.scale]);let H=U.time;M.size=Mt(M.size),M.space=Mt(M.space),M.rotate=Mt(M.rotate),is(M.incrs)&&M.incrs.forEach(ae=>{!ns.has(ae)&&ns.set(ae,dv(ae))}),M.incrs=Mt(M.incrs||(U.distr==2?Rw:H?p==1?Pw:Nw:Ts)),M.splits=Mt(M.splits||(H&&U.distr==1?ce:U.distr==3?Cu:U.distr==4?Jw:Zw)),M.stroke=Mt(M.stroke),M.grid.stroke=Mt(M.grid.stroke),M.ticks.stroke=Mt(M.ticks.stroke),M.border.stroke=Mt(M.border.stroke);let Z=M.values;M.values=is(Z)&&!is(Z[0])?Mt(Z):H?is(Z)?V_($,H_(Z,V)):B_(Z)?Fw($,Z):Z||J:Z||Kw,M.filter=Mt(M.filter||(U.distr>=3&&U.log==10?eE:U.distr==3&&U.log==2?tE:fv)),M.font=rv(M.font),M.labelFont=rv(M.labelFont),M._size=M.size(i,null,w,0),M._space=M._rotate=M._incrs=M._found=M._splits=M._values=null,M._size>0&&(Qn[w]=!0,M._el=Bn(Bb,u))}}function pr(M,w,L,U){let[H,Z,ae,de]=L,Me=w%2,Ie=0;return Me==0&&(de||Z)&&(Ie=w==0&&!H||w==2&&!ae?Ri(q_.size/3):0),Me==1&&(H||ae)&&(Ie=w==1&&!Z||w==3&&!de?Ri(K_.size/2):0),Ie}let Qo=i.padding=(n.padding||[pr,pr,pr,pr]).map(M=>Mt(At(M,pr))),Gn=i._padding=Qo.map((M,w)=>M(i,w,Qn,0)),ni,ci=null,hi=null,jn=r==1?_[0].idxs:null,un=null,Nr=!1;function jo(M,w){if(e=M??[],i.data=i._data=e,r==2){ni=0;for(let L=1;L<_.length;L++)ni+=e[L][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),un=e[0],ni=un.length;let L=e;if(k==2){L=e.slice();let U=L[0]=Array(ni);for(let H=0;H<ni;H++)U[H]=H}i._data=e=L}if(ft(!0),Ni("setData"),k==2&&(ve=!0),w!==!1){let L=N;L.auto(i,Nr)?ea():Fr(A,L.min,L.max),te=te||fe.left>=0,pe=!0,qi()}}i.setData=jo;function ea(){Nr=!0;let M,w;r==1&&(ni>0?(ci=jn[0]=0,hi=jn[1]=ni-1,M=e[0][ci],w=e[0][hi],k==2?(M=ci,w=hi):M==w&&(k==3?[M,w]=_h(M,M,N.log,!1):k==4?[M,w]=Ou(M,M,N.log,!1):N.time?w=M+Ri(86400/p):[M,w]=mh(M,w,Bu,!0))):(ci=jn[0]=M=null,hi=jn[1]=w=null)),Fr(A,M,w)}let Us,Ir,Fs,T,z,Q,q,K,Te,Le;function Ae(M,w,L,U,H,Z){M??=S_,L??=zu,U??="butt",H??=S_,Z??="round",M!=Us&&(f.strokeStyle=Us=M),H!=Ir&&(f.fillStyle=Ir=H),w!=Fs&&(f.lineWidth=Fs=w),Z!=z&&(f.lineJoin=z=Z),U!=Q&&(f.lineCap=Q=U),L!=T&&f.setLineDash(T=L)}function Ne(M,w,L,U){w!=Ir&&(f.fillStyle=Ir=w),M!=q&&(f.font=q=M),L!=K&&(f.textAlign=K=L),U!=Te&&(f.textBaseline=Te=U)}function He(M,w,L,U,H=0){if(U.length>0&&M.auto(i,Nr)&&(w==null||w.min==null)){let Z=At(ci,0),ae=At(hi,U.length-1),de=L.min==null?ew(U,Z,ae,H,M.distr==3):[L.min,L.max];M.min=Jn(M.min,L.min=de[0]),M.max=sn(M.max,L.max=de[1])}}let tt={min:null,max:null};function pt(){for(let U in S){let H=S[U];W[U]==null&&(H.min==null||W[A]!=null&&H.auto(i,Nr))&&(W[U]=tt)}for(let U in S){let H=S[U];W[U]==null&&H.from!=null&&W[H.from]!=null&&(W[U]=tt)}W[A]!=null&&ft(!0);let M={};for(let U in W){let H=W[U];if(H!=null){let Z=M[U]=Wo(S[U],cw);if(H.min!=null)yi(Z,H);else if(U!=A||r==2)if(ni==0&&Z.from==null){let ae=Z.range(i,null,null,U);Z.min=ae[0],Z.max=ae[1]}else Z.min=zt,Z.max=-zt}}if(ni>0){_.forEach((U,H)=>{if(r==1){let Z=U.scale,ae=W[Z];if(ae==null)return;let de=M[Z];if(H==0){let Me=de.range(i,de.min,de.max,Z);de.min=Me[0],de.max=Me[1],ci=Zn(de.min,e[0]),hi=Zn(de.max,e[0]),hi-ci>1&&(e[0][ci]<de.min&&ci++,e[0][hi]>de.max&&hi--),U.min=un[ci],U.max=un[hi]}else U.show&&U.auto&&He(de,ae,U,e[H],U.sorted);U.idxs[0]=ci,U.idxs[1]=hi}else if(H>0&&U.show&&U.auto){let[Z,ae]=U.facets,de=Z.scale,Me=ae.scale,[Ie,Ue]=e[H],Be=M[de],nt=M[Me];Be!=null&&He(Be,W[de],Z,Ie,Z.sorted),nt!=null&&He(nt,W[Me],ae,Ue,ae.sorted),U.min=ae.min,U.max=ae.max}});for(let U in M){let H=M[U],Z=W[U];if(H.from==null&&(Z==null||Z.min==null)){let ae=H.range(i,H.min==zt?null:H.min,H.max==-zt?null:H.max,U);H.min=ae[0],H.max=ae[1]}}}for(let U in M){let H=M[U];if(H.from!=null){let Z=M[H.from];if(Z.min==null)H.min=H.max=null;else{let ae=H.range(i,Z.min,Z.max,U);H.min=ae[0],H.max=ae[1]}}}let w={},L=!1;for(let U in M){let H=M[U],Z=S[U];if(Z.min!=H.min||Z.max!=H.max){Z.min=H.min,Z.max=H.max;let ae=Z.distr;Z._min=ae==3?Pr(Z.min):ae==4?Mu(Z.min,Z.asinh):ae==100?Z.fwd(Z.min):Z.min,Z._max=ae==3?Pr(Z.max):ae==4?Mu(Z.max,Z.asinh):ae==100?Z.fwd(Z.max):Z.max,w[U]=L=!0}}if(L){_.forEach((U,H)=>{r==2?H>0&&w.y&&(U._paths=null):w[U.scale]&&(U._paths=null)});for(let U in w)ve=!0,Ni("setScale",U);me&&fe.left>=0&&(te=pe=!0)}for(let U in W)W[U]=null}function Ge(M){let w=Ru(ci-1,0,ni-1),L=Ru(hi+1,0,ni-1);for(;M[w]==null&&w>0;)w--;for(;M[L]==null&&L<ni-1;)L++;return[w,L]}function mt(){if(ni>0){let M=_.some(w=>w._focus)&&Le!=ze.alpha;M&&(f.globalAlpha=Le=ze.alpha),_.forEach((w,L)=>{if(L>0&&w.show&&(ei(L,!1),ei(L,!0),w._paths==null)){let U=Le;Le!=w.alpha&&(f.globalAlpha=Le=w.alpha);let H=r==2?[0,e[L][0].length-1]:Ge(e[L]);w._paths=w.paths(i,L,H[0],H[1]),Le!=U&&(f.globalAlpha=Le=U)}}),_.forEach((w,L)=>{if(L>0&&w.show){let U=Le;Le!=w.alpha&&(f.globalAlpha=Le=w.alpha),w._paths!=null&&Dt(L,!1);{let H=w._paths!=null?w._paths.gaps:null,Z=w.points.show(i,L,ci,hi,H),ae=w.points.filter(i,L,Z,H);(Z||ae)&&(w.points._paths=w.points.paths(i,L,ci,hi,ae),Dt(L,!0))}Le!=U&&(f.globalAlpha=Le=U),Ni("drawSeries",L)}}),M&&(f.globalAlpha=Le=1)}}function ei(M,w){let L=w?_[M].points:_[M];L._stroke=L.stroke(i,M),L._fill=L.fill(i,M)}function Dt(M,w){let L=w?_[M].points:_[M],{stroke:U,fill:H,clip:Z,flags:ae,_stroke:de=L._stroke,_fill:Me=L._fill,_width:Ie=L.width}=L._paths;Ie=Gt(Ie*Ct,3);let Ue=null,Be=Ie%2/2;w&&Me==null&&(Me=Ie>0?"#fff":de);let nt=L.pxAlign==1&&Be>0;if(nt&&f.translate(Be,Be),!w){let Rt=P-Ie/2,wt=b-Ie/2,gt=X+Ie,Qe=he+Ie;Ue=new Path2D,Ue.rect(Rt,wt,gt,Qe)}w?Oe(de,Ie,L.dash,L.cap,Me,U,H,ae,Z):Nt(M,de,Ie,L.dash,L.cap,Me,U,H,ae,Ue,Z),nt&&f.translate(-Be,-Be)}function Nt(M,w,L,U,H,Z,ae,de,Me,Ie,Ue){let Be=!1;Me!=0&&R.forEach((nt,Rt)=>{if(nt.series[0]==M){let wt=_[nt.series[1]],gt=e[nt.series[1]],Qe=(wt._paths||_l).band;is(Qe)&&(Qe=nt.dir==1?Qe[0]:Qe[1]);let Ye,Yt=null;wt.show&&Qe&&iw(gt,ci,hi)?(Yt=nt.fill(i,Rt)||Z,Ye=wt._paths.clip):Qe=null,Oe(w,L,U,H,Yt,ae,de,Me,Ie,Ue,Ye,Qe),Be=!0}}),Be||Oe(w,L,U,H,Z,ae,de,Me,Ie,Ue)}let wi=Xo|Lu;function Oe(M,w,L,U,H,Z,ae,de,Me,Ie,Ue,Be){Ae(M,w,L,U,H),(Me||Ie||Be)&&(f.save(),Me&&f.clip(Me),Ie&&f.clip(Ie)),Be?(de&wi)==wi?(f.clip(Be),Ue&&f.clip(Ue),_t(H,ae),gi(M,Z,w)):de&Lu?(_t(H,ae),f.clip(Be),gi(M,Z,w)):de&Xo&&(f.save(),f.clip(Be),Ue&&f.clip(Ue),_t(H,ae),f.restore(),gi(M,Z,w)):(_t(H,ae),gi(M,Z,w)),(Me||Ie||Be)&&f.restore()}function gi(M,w,L){L>0&&(w instanceof Map?w.forEach((U,H)=>{f.strokeStyle=Us=H,f.stroke(U)}):w!=null&&M&&f.stroke(w))}function _t(M,w){w instanceof Map?w.forEach((L,U)=>{f.fillStyle=Ir=U,f.fill(L)}):w!=null&&M&&f.fill(w)}function mr(M,w,L,U){let H=y[M],Z;if(U<=0)Z=[0,0];else{let ae=H._space=H.space(i,M,w,L,U),de=H._incrs=H.incrs(i,M,w,L,U,ae);Z=bE(w,L,de,U,ae)}return H._found=Z}function xi(M,w,L,U,H,Z,ae,de,Me,Ie){let Ue=ae%2/2;x==1&&f.translate(Ue,Ue),Ae(de,ae,Me,Ie,de),f.beginPath();let Be,nt,Rt,wt,gt=H+(U==0||U==3?-Z:Z);L==0?(nt=H,wt=gt):(Be=H,Rt=gt);for(let Qe=0;Qe<M.length;Qe++)w[Qe]!=null&&(L==0?Be=Rt=M[Qe]:nt=wt=M[Qe],f.moveTo(Be,nt),f.lineTo(Rt,wt));f.stroke(),x==1&&f.translate(-Ue,-Ue)}function Os(M){let w=!0;return y.forEach((L,U)=>{if(!L.show)return;let H=S[L.scale];if(H.min==null){L._show&&(w=!1,L._show=!1,ft(!1));return}else L._show||(w=!1,L._show=!0,ft(!1));let Z=L.side,ae=Z%2,{min:de,max:Me}=H,[Ie,Ue]=mr(U,de,Me,ae==0?B:Pe);if(Ue==0)return;let Be=H.distr==2,nt=L._splits=L.splits(i,U,de,Me,Ie,Ue,Be),Rt=H.distr==2?nt.map(Ye=>un[Ye]):nt,wt=H.distr==2?un[nt[1]]-un[nt[0]]:Ie,gt=L._values=L.values(i,L.filter(i,Rt,U,Ue,wt),U,Ue,wt);L._rotate=Z==2?L.rotate(i,gt,U,Ue):0;let Qe=L._size;L._size=kn(L.size(i,gt,U,M)),Qe!=null&&L._size!=Qe&&(w=!1)}),w}function er(M){let w=!0;return Qo.forEach((L,U)=>{let H=L(i,U,Qn,M);H!=Gn[U]&&(w=!1),Gn[U]=H}),w}function gr(){for(let M=0;M<y.length;M++){let w=y[M];if(!w.show||!w._show)continue;let L=w.side,U=L%2,H,Z,ae=w.stroke(i,M),de=L==0||L==3?-1:1,[Me,Ie]=w._found;if(w.label!=null){let tn=w.labelGap*de,mn=Ri((w._lpos+tn)*Ct);Ne(w.labelFont[0],ae,"center",L==2?"top":M_),f.save(),U==1?(H=Z=0,f.translate(mn,Ri(b+he/2)),f.rotate((L==3?-dh:dh)/2)):(H=Ri(P+X/2),Z=mn);let os=cv(w.label)?w.label(i,M,Me,Ie):w.label;f.fillText(os,H,Z),f.restore()}if(Ie==0)continue;let Ue=S[w.scale],Be=U==0?X:he,nt=U==0?P:b,Rt=w._splits,wt=Ue.distr==2?Rt.map(tn=>un[tn]):Rt,gt=Ue.distr==2?un[Rt[1]]-un[Rt[0]]:Me,Qe=w.ticks,Ye=w.border,Yt=Qe.show?Qe.size:0,si=Ri(Yt*Ct),Ii=Ri((w.alignTo==2?w._size-Yt-w.gap:w.gap)*Ct),Ot=w._rotate*-dh/180,oi=m(w._pos*Ct),dn=(si+Ii)*de,en=oi+dn;Z=U==0?en:0,H=U==1?en:0;let An=w.font[0],Hn=w.align==1?ko:w.align==2?xu:Ot>0?ko:Ot<0?xu:U==0?"center":L==3?xu:ko,nr=Ot||U==1?"middle":L==2?"top":M_;Ne(An,ae,Hn,nr);let pn=w.font[1]*w.lineGap,Rn=Rt.map(tn=>m(a(tn,Ue,Be,nt))),Vn=w._values;for(let tn=0;tn<Vn.length;tn++){let mn=Vn[tn];if(mn!=null){U==0?H=Rn[tn]:Z=Rn[tn],mn=""+mn;let os=mn.indexOf(`
`)==-1?[mn]:mn.split(/\n/gm);for(let nn=0;nn<os.length;nn++){let Ud=os[nn];Ot?(f.save(),f.translate(H,Z+nn*pn),f.rotate(Ot),f.fillText(Ud,0,0),f.restore()):f.fillText(Ud,H,Z+nn*pn)}}}Qe.show&&xi(Rn,Qe.filter(i,wt,M,Ie,gt),U,L,oi,si,Gt(Qe.width*Ct,3),Qe.stroke(i,M),Qe.dash,Qe.cap);let rr=w.grid;rr.show&&xi(Rn,rr.filter(i,wt,M,Ie,gt),U,U==0?2:1,U==0?b:P,U==0?he:X,Gt(rr.width*Ct,3),rr.stroke(i,M),rr.dash,rr.cap),Ye.show&&xi([oi],[1],U==0?1:0,U==0?1:2,U==1?b:P,U==1?he:X,Gt(Ye.width*Ct,3),Ye.stroke(i,M),Ye.dash,Ye.cap)}Ni("drawAxes")}function ft(M){_.forEach((w,L)=>{L>0&&(w._paths=null,M&&(r==1?(w.min=null,w.max=null):w.facets.forEach(U=>{U.min=null,U.max=null})))})}let ri=!1,ji=!1,It=[];function _i(){ji=!1;for(let M=0;M<It.length;M++)Ni(...It[M]);It.length=0}function qi(){ri||(gw(xd),ri=!0)}function Rl(M,w=!1){ri=!0,ji=w,M(i),xd(),w&&It.length>0&&queueMicrotask(_i)}i.batch=Rl;function xd(){if(oe&&(pt(),oe=!1),ve&&(Ee(),ve=!1),xe){if(Kt(d,ko,Je),Kt(d,"top",st),Kt(d,pl,B),Kt(d,ml,Pe),Kt(g,ko,Je),Kt(g,"top",st),Kt(g,pl,B),Kt(g,ml,Pe),Kt(u,pl,ii),Kt(u,ml,mi),h.width=Ri(ii*Ct),h.height=Ri(mi*Ct),y.forEach(({_el:M,_show:w,_size:L,_pos:U,side:H})=>{if(M!=null)if(w){let Z=H===3||H===0?L:0,ae=H%2==1;Kt(M,ae?"left":"top",U-Z),Kt(M,ae?"width":"height",L),Kt(M,ae?"top":"left",ae?st:Je),Kt(M,ae?"height":"width",ae?Pe:B),Tu(M,As)}else wn(M,As)}),Us=Ir=Fs=z=Q=q=K=Te=T=null,Le=1,na(!0),Je!=we||st!=kt||B!=Ve||Pe!=Ze){ft(!1);let M=B/Ve,w=Pe/Ze;if(me&&!te&&fe.left>=0){fe.left*=M,fe.top*=w,Bs&&ur(Bs,Ri(fe.left),0,B,Pe),ks&&ur(ks,0,Ri(fe.top),B,Pe);for(let L=0;L<lt.length;L++){let U=lt[L];U!=null&&(Wt[L]*=M,Qi[L]*=w,ur(U,kn(Wt[L]),kn(Qi[L]),B,Pe))}}if(qt.show&&!ne&&qt.left>=0&&qt.width>0){qt.left*=M,qt.width*=M,qt.top*=w,qt.height*=w;for(let L in Mf)Kt(Hs,L,qt[L])}we=Je,kt=st,Ve=B,Ze=Pe}Ni("setSize"),xe=!1}ii>0&&mi>0&&(f.clearRect(0,0,h.width,h.height),Ni("drawClear"),E.forEach(M=>M()),Ni("draw")),qt.show&&ne&&(Cl(qt),ne=!1),me&&te&&(ss(null,!0,!1),te=!1),ue.show&&ue.live&&pe&&(_f(),pe=!1),c||(c=!0,i.status=1,Ni("ready")),Nr=!1,ri=!1}i.redraw=(M,w)=>{ve=w||!1,M!==!1?Fr(A,N.min,N.max):qi()};function mf(M,w){let L=S[M];if(L.from==null){if(ni==0){let U=L.range(i,w.min,w.max,M);w.min=U[0],w.max=U[1]}if(w.min>w.max){let U=w.min;w.min=w.max,w.max=U}if(ni>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;M==A&&L.distr==2&&ni>0&&(w.min=Zn(w.min,e[0]),w.max=Zn(w.max,e[0]),w.min==w.max&&w.max++),W[M]=w,oe=!0,qi()}}i.setScale=mf;let gf,xf,Bs,ks,_d,vd,zs,Gs,Md,Sd,Xt,Jt,Ur=!1,Vi=fe.drag,Li=Vi.x,Di=Vi.y;me&&(fe.x&&(gf=Bn(zb,g)),fe.y&&(xf=Bn(Gb,g)),N.ori==0?(Bs=gf,ks=xf):(Bs=xf,ks=gf),Xt=fe.left,Jt=fe.top);let qt=i.select=yi({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Hs=qt.show?Bn(kb,qt.over?g:d):null;function Cl(M,w){if(qt.show){for(let L in M)qt[L]=M[L],L in Mf&&Kt(Hs,L,M[L]);w!==!1&&Ni("setSelect")}}i.setSelect=Cl;function BM(M){if(_[M].show)ee&&Tu(rt[M],As);else if(ee&&wn(rt[M],As),me){let L=Ce?lt[0]:lt[M];L!=null&&ur(L,-10,-10,B,Pe)}}function Fr(M,w,L){mf(M,{min:w,max:L})}function tr(M,w,L,U){w.focus!=null&&VM(M),w.show!=null&&_.forEach((H,Z)=>{Z>0&&(M==Z||M==null)&&(H.show=w.show,BM(Z),r==2?(Fr(H.facets[0].scale,null,null),Fr(H.facets[1].scale,null,null)):Fr(H.scale,null,null),qi())}),L!==!1&&Ni("setSeries",M,w),U&&ra("setSeries",i,M,w)}i.setSeries=tr;function kM(M,w){yi(R[M],w)}function zM(M,w){M.fill=Mt(M.fill||null),M.dir=At(M.dir,-1),w=w??R.length,R.splice(w,0,M)}function GM(M){M==null?R.length=0:R.splice(M,1)}i.addBand=zM,i.setBand=kM,i.delBand=GM;function HM(M,w){_[M].alpha=w,me&&lt[M]!=null&&(lt[M].style.opacity=w),ee&&rt[M]&&(rt[M].style.opacity=w)}let xr,Or,rs,Vs={focus:!0};function VM(M){if(M!=rs){let w=M==null,L=ze.alpha!=1;_.forEach((U,H)=>{if(r==1||H>0){let Z=w||H==0||H==M;U._focus=w?null:Z,L&&HM(H,Z?1:ze.alpha)}}),rs=M,L&&qi()}}ee&&et&&yt(w_,Re,M=>{fe._lock||(je(M),rs!=null&&tr(null,Vs,!0,vi.setSeries))});function ir(M,w,L){let U=S[w];L&&(M=M/Ct-(U.ori==1?st:Je));let H=B;U.ori==1&&(H=Pe,M=H-M),U.dir==-1&&(M=H-M);let Z=U._min,ae=U._max,de=M/H,Me=Z+(ae-Z)*de,Ie=U.distr;return Ie==3?Ho(10,Me):Ie==4?rw(Me,U.asinh):Ie==100?U.bwd(Me):Me}function WM(M,w){let L=ir(M,A,w);return Zn(L,e[0],ci,hi)}i.valToIdx=M=>Zn(M,e[0]),i.posToIdx=WM,i.posToVal=ir,i.valToPos=(M,w,L)=>S[w].ori==0?s(M,S[w],L?X:B,L?P:0):o(M,S[w],L?he:Pe,L?b:0),i.setCursor=(M,w,L)=>{Xt=M.left,Jt=M.top,ss(null,w,L)};function yd(M,w){Kt(Hs,ko,qt.left=M),Kt(Hs,pl,qt.width=w)}function bd(M,w){Kt(Hs,"top",qt.top=M),Kt(Hs,ml,qt.height=w)}let ta=N.ori==0?yd:bd,ia=N.ori==1?yd:bd;function XM(){if(ee&&ue.live)for(let M=r==2?1:0;M<_.length;M++){if(M==0&&ht)continue;let w=ue.values[M],L=0;for(let U in w)We[M][L++].firstChild.nodeValue=w[U]}}function _f(M,w){if(M!=null&&(M.idxs?M.idxs.forEach((L,U)=>{re[U]=L}):lw(M.idx)||re.fill(M.idx),ue.idx=re[0]),ee&&ue.live){for(let L=0;L<_.length;L++)(L>0||r==1&&!ht)&&qM(L,re[L]);XM()}pe=!1,w!==!1&&Ni("setLegend")}i.setLegend=_f;function qM(M,w){let L=_[M],U=M==0&&k==2?un:e[M],H;ht?H=L.values(i,M,w)??it:(H=L.value(i,w==null?null:U[w],M,w),H=H==null?it:{_:H}),ue.values[M]=H}function ss(M,w,L){Md=Xt,Sd=Jt,[Xt,Jt]=fe.move(i,Xt,Jt),fe.left=Xt,fe.top=Jt,me&&(Bs&&ur(Bs,Ri(Xt),0,B,Pe),ks&&ur(ks,0,Ri(Jt),B,Pe));let U,H=ci>hi;xr=zt,Or=null;let Z=N.ori==0?B:Pe,ae=N.ori==1?B:Pe;if(Xt<0||ni==0||H){U=fe.idx=null;for(let de=0;de<_.length;de++){let Me=lt[de];Me!=null&&ur(Me,-10,-10,B,Pe)}et&&tr(null,Vs,!0,M==null&&vi.setSeries),ue.live&&(re.fill(U),pe=!0)}else{let de,Me,Ie;r==1&&(de=N.ori==0?Xt:Jt,Me=ir(de,A),U=fe.idx=Zn(Me,e[0],ci,hi),Ie=G(e[0][U],N,Z,0));let Ue=-10,Be=-10,nt=0,Rt=0,wt=!0,gt="",Qe="";for(let Ye=r==2?1:0;Ye<_.length;Ye++){let Yt=_[Ye],si=re[Ye],Ii=si==null?null:r==1?e[Ye][si]:e[Ye][1][si],Ot=fe.dataIdx(i,Ye,U,Me),oi=Ot==null?null:r==1?e[Ye][Ot]:e[Ye][1][Ot];if(pe=pe||oi!=Ii||Ot!=si,re[Ye]=Ot,Ye>0&&Yt.show){let dn=Ot==null?-10:Ot==U?Ie:G(r==1?e[0][Ot]:e[Ye][0][Ot],N,Z,0),en=oi==null?-10:I(oi,r==1?S[Yt.scale]:S[Yt.facets[1].scale],ae,0);if(et&&oi!=null){let An=N.ori==1?Xt:Jt,Hn=Ci(ze.dist(i,Ye,Ot,en,An));if(Hn<xr){let nr=ze.bias;if(nr!=0){let pn=ir(An,Yt.scale),Rn=oi>=0?1:-1,Vn=pn>=0?1:-1;Vn==Rn&&(Vn==1?nr==1?oi>=pn:oi<=pn:nr==1?oi<=pn:oi>=pn)&&(xr=Hn,Or=Ye)}else xr=Hn,Or=Ye}}if(pe||Ce){let An,Hn;N.ori==0?(An=dn,Hn=en):(An=en,Hn=dn);let nr,pn,Rn,Vn,rr,tn,mn=!0,os=le.bbox;if(os!=null){mn=!1;let nn=os(i,Ye);Rn=nn.left,Vn=nn.top,nr=nn.width,pn=nn.height}else Rn=An,Vn=Hn,nr=pn=le.size(i,Ye);if(tn=le.fill(i,Ye),rr=le.stroke(i,Ye),Ce)Ye==Or&&xr<=ze.prox&&(Ue=Rn,Be=Vn,nt=nr,Rt=pn,wt=mn,gt=tn,Qe=rr);else{let nn=lt[Ye];nn!=null&&(Wt[Ye]=Rn,Qi[Ye]=Vn,L_(nn,nr,pn,mn),C_(nn,tn,rr),ur(nn,kn(Rn),kn(Vn),B,Pe))}}}}if(Ce){let Ye=ze.prox,Yt=rs==null?xr<=Ye:xr>Ye||Or!=rs;if(pe||Yt){let si=lt[0];si!=null&&(Wt[0]=Ue,Qi[0]=Be,L_(si,nt,Rt,wt),C_(si,gt,Qe),ur(si,kn(Ue),kn(Be),B,Pe))}}}if(qt.show&&Ur)if(M!=null){let[de,Me]=vi.scales,[Ie,Ue]=vi.match,[Be,nt]=M.cursor.sync.scales,Rt=M.cursor.drag;if(Li=Rt._x,Di=Rt._y,Li||Di){let{left:wt,top:gt,width:Qe,height:Ye}=M.select,Yt=M.scales[Be].ori,si=M.posToVal,Ii,Ot,oi,dn,en,An=de!=null&&Ie(de,Be),Hn=Me!=null&&Ue(Me,nt);An&&Li?(Yt==0?(Ii=wt,Ot=Qe):(Ii=gt,Ot=Ye),oi=S[de],dn=G(si(Ii,Be),oi,Z,0),en=G(si(Ii+Ot,Be),oi,Z,0),ta(Jn(dn,en),Ci(en-dn))):ta(0,Z),Hn&&Di?(Yt==1?(Ii=wt,Ot=Qe):(Ii=gt,Ot=Ye),oi=S[Me],dn=I(si(Ii,nt),oi,ae,0),en=I(si(Ii+Ot,nt),oi,ae,0),ia(Jn(dn,en),Ci(en-dn))):ia(0,ae)}else Sf()}else{let de=Ci(Md-_d),Me=Ci(Sd-vd);if(N.ori==1){let nt=de;de=Me,Me=nt}Li=Vi.x&&de>=Vi.dist,Di=Vi.y&&Me>=Vi.dist;let Ie=Vi.uni;Ie!=null?Li&&Di&&(Li=de>=Ie,Di=Me>=Ie,!Li&&!Di&&(Me>de?Di=!0:Li=!0)):Vi.x&&Vi.y&&(Li||Di)&&(Li=Di=!0);let Ue,Be;Li&&(N.ori==0?(Ue=zs,Be=Xt):(Ue=Gs,Be=Jt),ta(Jn(Ue,Be),Ci(Be-Ue)),Di||ia(0,ae)),Di&&(N.ori==1?(Ue=zs,Be=Xt):(Ue=Gs,Be=Jt),ia(Jn(Ue,Be),Ci(Be-Ue)),Li||ta(0,Z)),!Li&&!Di&&(ta(0,0),ia(0,0))}if(Vi._x=Li,Vi._y=Di,M==null){if(L){if(Id!=null){let[de,Me]=vi.scales;vi.values[0]=de!=null?ir(N.ori==0?Xt:Jt,de):null,vi.values[1]=Me!=null?ir(N.ori==1?Xt:Jt,Me):null}ra(_u,i,Xt,Jt,B,Pe,U)}if(et){let de=L&&vi.setSeries,Me=ze.prox;rs==null?xr<=Me&&tr(Or,Vs,!0,de):xr>Me?tr(null,Vs,!0,de):Or!=rs&&tr(Or,Vs,!0,de)}}pe&&(ue.idx=U,_f()),w!==!1&&Ni("setCursor")}let Br=null;Object.defineProperty(i,"rect",{get(){return Br==null&&na(!1),Br}});function na(M=!1){M?Br=null:(Br=g.getBoundingClientRect(),Ni("syncRect",Br))}function wd(M,w,L,U,H,Z,ae){fe._lock||Ur&&M!=null&&M.movementX==0&&M.movementY==0||(vf(M,w,L,U,H,Z,ae,!1,M!=null),M!=null?ss(null,!0,!0):ss(w,!0,!1))}function vf(M,w,L,U,H,Z,ae,de,Me){if(Br==null&&na(!1),je(M),M!=null)L=M.clientX-Br.left,U=M.clientY-Br.top;else{if(L<0||U<0){Xt=-10,Jt=-10;return}let[Ie,Ue]=vi.scales,Be=w.cursor.sync,[nt,Rt]=Be.values,[wt,gt]=Be.scales,[Qe,Ye]=vi.match,Yt=w.axes[0].side%2==1,si=N.ori==0?B:Pe,Ii=N.ori==1?B:Pe,Ot=Yt?Z:H,oi=Yt?H:Z,dn=Yt?U:L,en=Yt?L:U;if(wt!=null?L=Qe(Ie,wt)?a(nt,S[Ie],si,0):-10:L=si*(dn/Ot),gt!=null?U=Ye(Ue,gt)?a(Rt,S[Ue],Ii,0):-10:U=Ii*(en/oi),N.ori==1){let An=L;L=U,U=An}}Me&&(w==null||w.cursor.event.type==_u)&&((L<=1||L>=B-1)&&(L=Es(L,B)),(U<=1||U>=Pe-1)&&(U=Es(U,Pe))),de?(_d=L,vd=U,[zs,Gs]=fe.move(i,L,U)):(Xt=L,Jt=U)}let Mf={width:0,height:0,left:0,top:0};function Sf(){Cl(Mf,!1)}let Ed,Td,Ad,Rd;function Cd(M,w,L,U,H,Z,ae){Ur=!0,Li=Di=Vi._x=Vi._y=!1,vf(M,w,L,U,H,Z,ae,!0,!1),M!=null&&(yt(vu,wu,Pd,!1),ra(y_,i,zs,Gs,B,Pe,null));let{left:de,top:Me,width:Ie,height:Ue}=qt;Ed=de,Td=Me,Ad=Ie,Rd=Ue}function Pd(M,w,L,U,H,Z,ae){Ur=Vi._x=Vi._y=!1,vf(M,w,L,U,H,Z,ae,!1,!0);let{left:de,top:Me,width:Ie,height:Ue}=qt,Be=Ie>0||Ue>0,nt=Ed!=de||Td!=Me||Ad!=Ie||Rd!=Ue;if(Be&&nt&&Cl(qt),Vi.setScale&&Be&&nt){let Rt=de,wt=Ie,gt=Me,Qe=Ue;if(N.ori==1&&(Rt=Me,wt=Ue,gt=de,Qe=Ie),Li&&Fr(A,ir(Rt,A),ir(Rt+wt,A)),Di)for(let Ye in S){let Yt=S[Ye];Ye!=A&&Yt.from==null&&Yt.min!=zt&&Fr(Ye,ir(gt+Qe,Ye),ir(gt,Ye))}Sf()}else fe.lock&&(fe._lock=!fe._lock,ss(w,!0,M!=null));M!=null&&(bi(vu,wu),ra(vu,i,Xt,Jt,B,Pe,null))}function YM(M,w,L,U,H,Z,ae){if(fe._lock)return;je(M);let de=Ur;if(Ur){let Me=!0,Ie=!0,Ue=10,Be,nt;N.ori==0?(Be=Li,nt=Di):(Be=Di,nt=Li),Be&&nt&&(Me=Xt<=Ue||Xt>=B-Ue,Ie=Jt<=Ue||Jt>=Pe-Ue),Be&&Me&&(Xt=Xt<zs?0:B),nt&&Ie&&(Jt=Jt<Gs?0:Pe),ss(null,!0,!0),Ur=!1}Xt=-10,Jt=-10,re.fill(null),ss(null,!0,!0),de&&(Ur=de)}function Ld(M,w,L,U,H,Z,ae){fe._lock||(je(M),ea(),Sf(),M!=null&&ra(E_,i,Xt,Jt,B,Pe,null))}function Dd(){y.forEach(wE),O(i.width,i.height,!0)}Rs(ph,Go,Dd);let Ws={};Ws.mousedown=Cd,Ws.mousemove=wd,Ws.mouseup=Pd,Ws.dblclick=Ld,Ws.setSeries=(M,w,L,U)=>{let H=vi.match[2];L=H(i,w,L),L!=-1&&tr(L,U,!0,!1)},me&&(yt(y_,g,Cd),yt(_u,g,wd),yt(b_,g,M=>{je(M),na(!1)}),yt(w_,g,YM),yt(E_,g,Ld),Du.add(i),i.syncRect=na);let Pl=i.hooks=n.hooks||{};function Ni(M,w,L){ji?It.push([M,w,L]):M in Pl&&Pl[M].forEach(U=>{U.call(null,i,w,L)})}(n.plugins||[]).forEach(M=>{for(let w in M.hooks)Pl[w]=(Pl[w]||[]).concat(M.hooks[w])});let Nd=(M,w,L)=>L,vi=yi({key:null,setSeries:!1,filters:{pub:F_,sub:F_},scales:[A,_[1]?_[1].scale:null],match:[O_,O_,Nd],values:[null,null]},fe.sync);vi.match.length==2&&vi.match.push(Nd),fe.sync=vi;let Id=vi.key,yf=Nv(Id);function ra(M,w,L,U,H,Z,ae){vi.filters.pub(M,w,L,U,H,Z,ae)&&yf.pub(M,w,L,U,H,Z,ae)}yf.sub(i);function $M(M,w,L,U,H,Z,ae){vi.filters.sub(M,w,L,U,H,Z,ae)&&Ws[M](null,w,L,U,H,Z,ae)}i.pub=$M;function KM(){yf.unsub(i),Du.delete(i),Pi.clear(),Au(ph,Go,Dd),l.remove(),Re?.remove(),Ni("destroy")}i.destroy=KM;function bf(){Ni("init",n,e),jo(e||n.data,!1),W[A]?mf(A,W[A]):ea(),ne=qt.show&&(qt.width>0||qt.height>0),te=pe=!0,O(n.width,n.height)}return _.forEach(Is),y.forEach(dr),t?t instanceof HTMLElement?(t.appendChild(l),bf()):t(i,bf):bf(),i}ti.assign=yi;ti.fmtNum=ku;ti.rangeNum=mh;ti.rangeLog=_h;ti.rangeAsinh=Ou;ti.orient=Ps;ti.pxRatio=Ct;ti.join=mw;ti.fmtDate=Gu,ti.tzDate=Tw;ti.sync=Nv;{ti.addGap=lE,ti.clipGaps=Sh;let n=ti.paths={points:kv};n.linear=Gv,n.stepped=fE,n.bars=uE,n.spline=pE}var Ml=84,EE=260,TE=340,AE=3,Ku=4,RE=8,CE=20,Xv=26,PE=4;function LE(n){let{data:e}=n.times;if(!n.most||e.length<2)return Float64Array.from(e);let t=e.length;return Float64Array.from(e,(i,r)=>i+(r<t-1?e[r+1]-i:i-e[r-1])/2)}function $u(n,e){let t=n.scale??1;return Float64Array.from(e.data,i=>i*t)}var Zu=(n,e)=>e>n+1e-9*Math.abs(n);function DE(n,e,t=1/0){if(Zu(t,e))return null;let{times:i,least:r,most:s}=n,o=0,a=i.count;for(;a-o>1;){let l=o+a>>1;i.data[l]<=e?o=l:a=l}let c=n.scale??1;return{least:r.data[o]*c,most:(s??r).data[o]*c}}function NE(n){let e=n.filter(Boolean).map(({least:r,most:s})=>{let o=(a,c)=>a.data.reduce((l,h)=>c(l,h),a.data[0]);return[o(r,Math.min),o(s??r,Math.max)]}),t=Math.min(...e.map(([r])=>r)),i=Math.max(...e.map(([,r])=>r));return{middle:(t+i)/2,span:Math.max(...e.map(([r,s])=>s-r))}}function IE(n,e){let t=Math.max(n.span,e.span),i=Math.abs(n.middle-e.middle);return i>PE*t&&t>1e-9*i}var qv={className:"ppv-parting"},Eh=class{constructor(e,t,i,r,s=[]){this.channels=e,this.ends=s,this.marks=t,this.kinds=[...new Set(t.map(o=>o.kind))],this.full=i,this.x=i,this.seek=r,this.time=i[0],this.drawn=[],this.element=Y("div",{className:"ppv-plots",tabindex:"-1"}),this.more=xt("","Scroll to the next plots",()=>this.element.scrollBy({top:this.element.clientHeight}),{className:"ppv-more"}),this.more.hidden=!0,this.element.addEventListener("scroll",()=>this.#s()),this.names=new Set(e.flat().filter(o=>o.first).map(o=>o.name)),this.order=[...new Set(e.flat().map(o=>o.name))],this.onRemove=()=>{},this.needs=()=>{}}show(e,t){t?this.names.add(e):this.names.delete(e),this.build()}#e(){let e=[];for(let i of this.order){if(!this.names.has(i))continue;let r=this.channels.map(c=>c.find(l=>l.name===i)),s=(r.find(Boolean).shown_unit??r.find(Boolean).unit)||"1",o={name:i,found:r,...NE(r)},a=e.find(c=>c.unit===s&&!c.members.some(l=>IE(o,l)));a?a.members.push(o):e.push({unit:s,members:[o]})}let t=[...new Set(e.map(({unit:i})=>i))];return e.sort((i,r)=>t.indexOf(i.unit)-t.indexOf(r.unit))}build(){for(let{plot:t}of this.drawn)t.destroy();this.drawn=[],this.element.replaceChildren();let e=this.#e();this.ratio=window.devicePixelRatio||1,this.turns=e.flatMap(({members:t})=>t).filter(({name:t,found:i})=>!r_(t)||i.find(Boolean).whole).map(({name:t})=>t);for(let{unit:t,members:i}of e){let r=Y("div",{className:"ppv-plot"}),s=Y("div",{className:"ppv-caption"}),o=Y("div",{className:"ppv-box"});r.append(s,o),this.element.append(r);let a=this.#i(t,i,o,s);this.drawn.push({...a,holder:r,box:o,caption:s})}e.length||this.element.append(Y("p",{className:"ppv-none"},this.order.length?"Choose a curve.":"This scene has no curves.")),this.resize(),this.cursor(this.time)}part(e){let t=this.channels.flat(),{members:i,whole:r}=t.find(a=>a.name===e)??{},[s,o]=i?[[e],i]:[t.find(a=>a.name===r).members,[r]];for(let a of s)this.names.delete(a);for(let a of o)this.names.add(a);this.build(),this.onRemove()}#t(e,t){let{name:i,members:r,whole:s}=e;return r?xt("apart",`Show the ${r.length} planets apart`,()=>this.part(i),qv):!s||t.has(s)?null:(t.add(s),xt("together","Show the range of all planets",()=>this.part(i),qv))}#i(e,t,i,r){let s=[],o=[{}],a=[],c=[],l=getComputedStyle(this.element),h=new Set;t.forEach(({name:_,found:y})=>{let S=Zc(this.element,y.find(Boolean).whole?"":_,this.turns.indexOf(_)),R=[S,Ju(this.element,S)],A=Y("output",{}),v=y.find(Boolean);r.append(Y("span",{className:"ppv-curve"},...R.filter((F,D)=>y[D]).map(F=>Y("i",{style:`background:${F}`})),Y("span",{},v.label??_),A,Y("small",{},e==="1"?"":e),this.#t(v,h),xt("\xD7",`Remove ${v.label??_}`,()=>{this.show(_,!1),this.onRemove()})));let E=Math.max(...y.filter(Boolean).map(F=>(F.scale??1)*Math.max(...[F.least,F.most??F.least].map(({data:D})=>D.reduce((N,k)=>Math.max(N,Math.abs(k)),0)))));c.push({values:A,found:y,digits:rh(E)}),y.forEach((F,D)=>{if(!F)return;let N=D?[6,4]:void 0,k={stroke:R[D],width:1.4,dash:N,pxAlign:0,points:{show:!1},spanGaps:!0},G=[LE(F),$u(F,F.least)];if(F.most){G.push($u(F,F.most)),a.push({series:[o.length+1,o.length],fill:`color-mix(in srgb, ${R[D]} ${D?12:26}%, transparent)`});let I=`color-mix(in srgb, ${R[D]} 40%, transparent)`;o.push({...k,stroke:I,width:.6},{...k,stroke:I,width:.6}),F.mean&&G.push($u(F,F.mean)),F.mean&&o.push(k)}else o.push(k);s.push(G)})});let u=s.every(([_])=>_.length===s[0][0].length&&_.every((y,S)=>y===s[0][0][S]))?[s[0][0],...s.flatMap(([,..._])=>_)]:ti.join(s.map(_=>_.map(y=>Array.from(y)))),d=l.getPropertyValue("--v-soft").trim()||"#666",g=l.getPropertyValue("--v-grid").trim()||"#ddd",x={stroke:d,grid:{stroke:g,width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},m=new ti({width:300,height:Ml,padding:[6,30,0,0],series:o,bands:a,legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,range:()=>this.x},y:{range:(_,y,S)=>BE(y,S)}},axes:[{...x,size:22,gap:3,values:(_,y)=>kE(y)},{...x,size:OE,gap:4,space:UE,values:(_,y)=>FE(_,y,Ls(y))}],hooks:{draw:[_=>this.#n(_)]}},u,i),p=Y("div",{className:"ppv-cursor"});return m.over.append(p),this.#r(m),{plot:m,line:p,shows:c}}#n(e){let{left:t,top:i,width:r}=e.bbox,s={};for(let o of this.marks){let a=e.valToPos(o.time,"x",!0);a<t||a>t+r||a-(s[o.kind]??-9)<Ku*this.ratio||(s[o.kind]=a,e.ctx.fillStyle=ys(this.kinds,o.kind),e.ctx.fillRect(a-this.ratio/2,i,1.2*this.ratio,6*this.ratio))}}#r(e){let{over:t}=e,i=s=>e.posToVal(s.clientX-t.getBoundingClientRect().left,"x"),r=!1;t.addEventListener("pointerdown",s=>{s.button||(r=!0,t.setPointerCapture?.(s.pointerId),this.seek(i(s)))}),t.addEventListener("pointermove",s=>r&&this.seek(i(s)));for(let s of["pointerup","pointercancel"])t.addEventListener(s,()=>r=!1);t.addEventListener("dblclick",()=>this.zoom(this.full)),t.addEventListener("wheel",s=>{if(!s.ctrlKey&&!s.shiftKey&&s.deltaY>0&&this.x===this.full)return;s.preventDefault();let o=i(s),a=Math.exp(Math.max(-1,Math.min(1,(s.deltaY||s.deltaX)*.002)));this.zoom([o+(this.x[0]-o)*a,o+(this.x[1]-o)*a])},{passive:!1})}zoom([e,t]){let[i,r]=this.full,s=t-e>=r-i;this.x=s?this.full:[Math.max(i,e),Math.min(r,t)];for(let{plot:o}of this.drawn)o.setData(o.data);this.cursor(this.time)}#s(){let{scrollTop:e,clientHeight:t,offsetTop:i}=this.element,r=0;for(let{holder:s}of this.drawn){let o=s.offsetTop-i+s.offsetHeight>e+t+1;s.style.opacity=o?"0":"",r+=Number(o)}this.more.hidden=!r,this.more.textContent=`\u25BE ${r} more`,this.more.setAttribute("aria-label",`Scroll to ${r} more plot${r===1?"":"s"}`)}resize(){let e=Math.max(1,this.drawn.length);this.element.style.height="";let{clientWidth:t}=this.element,i=Math.max(1,Math.min(e,AE,Math.floor(t/TE))),r=Math.max(1,Math.floor(this.element.clientHeight/(Ml+CE))),s=Math.max(1,Math.min(i,Math.ceil(e/r)));this.element.style.gridTemplateColumns=`repeat(${s}, minmax(0, 1fr))`;let o=[];this.drawn.forEach(({caption:g},x)=>{let m=Math.floor(x/s);o[m]=Math.max(o[m]??0,g.offsetHeight)});let a=()=>{let g=this.element.clientHeight-4,x=o.findIndex((m,p)=>o.slice(0,p+1).reduce((_,y)=>_+y+Ml,0)>g);return{room:g,whole:x<0?o.length:Math.max(1,x)}},c=()=>a().whole===o.length;this.needs(this.drawn.length?o[0]+Ml+RE+(o.length>1&&!c()?Xv:0):0),c()||(this.element.style.height=`calc(100% - ${Xv}px)`);let{room:l,whole:h}=a(),f=o.slice(0,h).reduce((g,x)=>g+x,0),u=Math.max(Ml,Math.min(EE,Math.floor((l-f)/h)));this.drawn.forEach(({plot:g,box:x,caption:m},p)=>{m.style.minHeight=s>1?`${o[Math.floor(p/s)]}px`:"",g.setSize({width:Math.max(120,x.clientWidth),height:u})});let d=o.slice(-h).reduce((g,x)=>g+x+u,0);this.element.style.paddingBottom=h<o.length?`${Math.max(0,this.element.clientHeight-d-3)}px`:"",this.#s(),this.cursor(this.time)}cursor(e){this.time=e;for(let{plot:t,line:i,shows:r}of this.drawn){let s=t.valToPos(e,"x");i.hidden=!(s>=-.5&&s<=t.over.clientWidth+.5),i.style.transform=`translateX(${s}px)`;for(let{values:o,found:a,digits:c}of r){let l=a.flatMap((h,f)=>{if(!h)return[];let u=DE(h,e,this.ends[f]);if(!u)return["\u2013"];let{least:d,most:g}=u;return[...new Set([c(d),c(g)])].join(" \u2026 ")}).join(" | ");o.textContent!==l&&(o.textContent=l)}}}};function Ju(n,e){let t=getComputedStyle(n).getPropertyValue("--v-ink").trim()||"#1f2933";return`color-mix(in srgb, ${e} 40%, ${t})`}var UE=(n,e,t,i,r)=>Math.max(9,Math.min(24,r/4));function FE(n,e,t){let{min:i,max:r}=n.scales.y;return t.map((s,o)=>e[o]-i<.02*(r-i)?"":s)}function OE(n,e){return Math.max(56,12+6.6*Math.max(0,...(e??[]).map(t=>t?.length??0)))}function BE(n,e){if(!(e>=n))return[0,1];let t=1e-7*Math.max(Math.abs(n),Math.abs(e)),i=e-n>t?.06*(e-n):.06*(Math.abs(e)||1);return[n-i,e+i]}function kE(n){let[e,t]=a_(Math.max(...n.map(Math.abs)));return Ls(n.map(i=>i/e),t)}function Ls(n,e=""){let t=Math.max(...n.map(Math.abs)),i=n.length>1?Math.abs(n[1]-n[0]):t,r=Math.max(0,Math.min(12,-Math.floor(Math.log10(i||1)+1e-9)));return r<12&&Math.abs(i*10**r-Math.round(i*10**r))>1e-6&&r++,n.map((s,o)=>{let a=t>=1e6||t>0&&t<1e-4?s.toExponential(2):s.toFixed(r);return(o===n.length-1&&e?`${a} ${e}`:a).replace(/^-(0(\.0+)?)$/,"$1").replace("-","\u2212")})}var zE=92;function Yv(n){let e=n.length;return[1.5*n[0]-.5*n[1],1.5*n[e-1]-.5*n[e-2]]}function Th(n,e){let t=0,i=n.length-1;for(;i-t>1;){let r=t+i>>1;n[r]<=e?t=r:i=r}return e-n[t]<n[i]-e?t:i}var Qu=(n,e)=>n.most*10**((e/255-1)*(n.decibels/20)),Ah=n=>Math.max(...n)>1e4?[.001,"kHz"]:[1,"Hz"],Rh=class{constructor(e,t,i){this.element=e,this.seek=t,this.announce=i,this.drawn=[],this.time=0}destroy(){for(let{plot:e}of this.drawn)e.destroy();this.drawn=[],this.element.replaceChildren()}build(e,t,i){this.destroy(),this.shown=i;for(let o of e){let a=Y("div",{className:"ppv-box"});this.element.append(a),this.drawn.push({...this.#e(o,a,t),box:a,map:o})}let[r]=e,s=[...new Set(e.map(({most:o})=>ai(o*i.scale,3)))].join(" | ");this.element.append(Y("div",{className:"ppv-map-scale",title:"Amplitudes relative to the maximum of the map"},Y("i",{style:`background:${Qc().replace("to right","to top")}`}),Y("span",{},`0 dB = ${s} ${i.unit==="1"?"":i.unit}`),Y("span",{},`\u2212${r.decibels} dB`))),this.resize()}#e(e,t,i){let r=Array.from(e.times.data),s=Array.from(e.lines.data),[o,a]=Yv(r),[c,l]=Yv(s),h=GE(e.levels.data,r.length,s.length),f={stroke:i.soft,grid:{show:!1},ticks:{show:!1},font:"11px system-ui, sans-serif"},[u,d]=e.of?[1,"order"]:Ah([s.at(-1)]),g=new ti({width:300,height:160,padding:[6,30,0,0],legend:{show:!1},cursor:{show:!1},series:[{},{show:!1}],scales:{x:{time:!1,range:()=>[o,a]},y:{range:()=>[Math.max(0,c),l]}},axes:[{...f,size:22,gap:3,values:(m,p)=>Ls(p,"s")},{...f,size:62,gap:4,space:28,values:(m,p)=>Ls(p.map(_=>_*u),d)}],hooks:{draw:[()=>this.cursor(this.time)],drawClear:[m=>{let{ctx:p,bbox:_}=m,y=m.valToPos(l,"y",!0),S=m.valToPos(c,"y",!0);p.save(),p.beginPath(),p.rect(_.left,_.top,_.width,_.height),p.clip(),p.imageSmoothingEnabled=!1,p.drawImage(h,_.left,y,_.width,S-y),p.restore()}]}},[r,r.map(()=>null)],t),x=Y("div",{className:"ppv-cursor"});return g.over.append(x),this.#t(g,e,r,s),{plot:g,line:x}}#t(e,t,i,r){let{over:s}=e,o=(c,l)=>{let h=s.getBoundingClientRect();return e.posToVal(l==="x"?c.clientX-h.left:c.clientY-h.top,l)},a=!1;s.addEventListener("pointerdown",c=>{c.button||(a=!0,s.setPointerCapture?.(c.pointerId),this.seek(o(c,"x")))}),s.addEventListener("pointermove",c=>{a&&this.seek(o(c,"x"));let l=Th(r,o(c,"y")),h=Th(i,o(c,"x")),f=t.levels.data[h*r.length+l],[u,d]=Ah([r.at(-1)]),g=(r[1]-r[0])/2,x=t.of?`order ${Oo(r[l],g)}`:`${Oo(r[l]*u,g*u)} ${d}`;this.announce(`${ai(i[h],4)} s, ${x}: ${f?"":"< "}${ai(Qu(t,f)*this.shown.scale,3)} ${this.shown.unit}`)}),s.addEventListener("pointerleave",()=>this.announce(""));for(let c of["pointerup","pointercancel"])s.addEventListener(c,()=>a=!1)}cursor(e){this.time=e;for(let{plot:t,line:i}of this.drawn){let r=t.valToPos(e,"x");i.hidden=!(r>=-.5&&r<=t.over.clientWidth+.5),i.style.transform=`translateX(${r}px)`}}resize(){let e=(this.element.clientWidth-zE)/Math.max(1,this.drawn.length);for(let{plot:t}of this.drawn)t.setSize({width:Math.max(120,Math.floor(e)),height:Math.max(110,this.element.clientHeight)})}};function GE(n,e,t){let i=Y("canvas",{width:e,height:t}),r=i.getContext("2d"),s=r.createImageData(e,t),o=Array.from({length:256},(a,c)=>fl(c/255).map(l=>Math.round(255*l)));for(let a=0;a<e;a++)for(let c=0;c<t;c++)s.data.set([...o[n[a*t+c]],255],4*((t-1-c)*e+a));return r.putImageData(s,0,0),i}var Ch=" and time",Ph="#d2484f",HE=n=>{let e=Math.floor(Math.log10(n));return+`${Math.max(1,Math.floor(n/10**e))}e${e}`},VE=n=>n.flatMap((e,t)=>e!=null&&n[t-1]===null&&n[t+1]===null?[t]:[]),WE=({resolution:n,lines:e})=>n??e.data.reduce((t,i,r)=>r?Math.min(t,i-e.data[r-1]):t,e.data[0]),Lh=class{constructor(e,t,i){this.spectra=e.map(s=>s.spectra),this.maps=e.map(s=>s.maps),this.names=[...new Set(this.spectra.flat().map(s=>s.channel))];let r=s=>t.flat().find(o=>o.name===s)?.label??s;this.channels=t,this.name=this.names[0],this.time=e[0]?.times.data[0]??0,this.box=Y("div",{className:"ppv-box"}),this.maps_box=Y("div",{className:"ppv-maps",hidden:!0}),this.read=Y("output",{}),this.unit=Y("small",{className:"ppv-soft"}),this.waterfall=new Rh(this.maps_box,i,s=>this.read.textContent=s),this.choice=on("spectrum of",this.names.map(s=>[s,r(s)]),s=>this.choose(s,this.over)),this.ways=on("over",[],s=>this.choose(this.name,s)),this.near=Y("span",{className:"ppv-curve",hidden:!0},Y("i",{}),Y("span",{},"at the cursor")),this.element=Y("div",{className:"ppv-spectra"},Y("div",{className:"ppv-caption"},this.choice.row,this.ways.row,this.unit,this.near,this.read),this.box,this.maps_box),this.element.hidden=!0}waysOf(e){let t=({of:r})=>r?`orders of ${r}`:"frequency",i=r=>r.flat().filter(s=>s.channel===e);return[...new Set([...i(this.spectra).map(t),...i(this.maps).map(r=>t(r)+Ch)])]}choose(e,t=""){this.name=e;let i=this.waysOf(e),r=i.find(s=>s.split(" ")[0]===t.split(" ")[0]&&s.endsWith(Ch)===t.endsWith(Ch));this.over=i.includes(t)?t:r??i[0],this.ways.select.replaceChildren(...i.map(s=>Y("option",{value:s},s))),this.ways.select.value=this.over,this.choice.select.value=e,this.build()}#e(e){let t=/^orders of (.*?)( and time)?$/.exec(this.over)?.[1]??"";return e.map(i=>i.find(r=>r.channel===this.name&&(r.of??"")===t))}#t(e){let t=e?.unit??"1",i=this.channels.flat().find(({name:r})=>r===this.name);return!i?.shown_unit||i.unit!==t?{unit:t,scale:1}:{unit:i.shown_unit,scale:i.scale??1}}build(){if(!this.over)return this.choose(this.name);this.plot?.destroy(),this.plot=null,this.waterfall.destroy(),this.read.textContent="";let e=getComputedStyle(this.element),t=(o,a)=>e.getPropertyValue(o).trim()||a,i={soft:t("--v-soft","#666"),grid:t("--v-grid","#ddd"),paper:t("--v-paper","#fff")},r=this.over.endsWith(Ch);this.shown=this.#t(this.#e(this.spectra).concat(this.#e(this.maps)).find(Boolean));let{unit:s}=this.shown;this.unit.textContent=s==="1"?"peak amplitude":`peak amplitude in ${s}`,r&&(this.unit.textContent="colours: peak amplitude in dB re maximum"),this.box.hidden=r,this.maps_box.hidden=!r,this.near.hidden=!0,r?this.waterfall.build(this.#e(this.maps).filter(Boolean),i,this.shown):this.#i(i),this.resize(),this.cursor(this.time)}#i(e){let t=this.#e(this.spectra),{unit:i,scale:r}=this.shown,s=t.filter(Boolean).map(({lines:p,amplitude:_})=>[Array.from(p.data),Array.from(_.data,y=>y>0?y*r:null)]),o={stroke:e.soft,grid:{stroke:e.grid,width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},a=Zc(this.element,this.name,0),{of:c=""}=t.find(Boolean)??{},l={width:1.2,points:{show:!1},spanGaps:!0},h=t.flatMap((p,_)=>p?[{...l,stroke:_?Ju(this.element,a):a,dash:_?[6,4]:void 0}]:[]),f=s.reduce((p,[,_])=>_.reduce((y,S)=>Math.max(y,S??0),p),1e-300),[u,d]=Ah(s.map(([p])=>p.at(-1)));if(this.passing=this.#e(this.maps)[0],this.passing){s.push([Array.from(this.passing.lines.data),Array.from(this.passing.lines.data,()=>null)]);let p={show:!1,filter:(_,y)=>VE(_.data[y]),size:4,fill:Ph,stroke:Ph};h.push({...l,stroke:Ph,width:1,spanGaps:!1,points:p}),this.near.hidden=!1,this.near.firstChild.style.background=Ph}let g=Math.max(...t.filter(Boolean).map(WE))/2,x=c?p=>`order ${Oo(p,g)}`:p=>`${Oo(p*u,g*u)} ${d}`;this.plot=new ti({width:300,height:160,padding:[6,44,0,0],legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},series:[{},...h],scales:{x:{time:!1},y:{distr:3,range:(p,_)=>[HE(Math.max(_??0,f*1e-5)),f*1.6]}},axes:[{...o,size:22,gap:3,values:(p,_)=>Ls(c?_:_.map(y=>y*u),c?"order":d)},{...o,size:62,gap:4,space:28,values:(p,_)=>_.map(y=>y===null?"":ai(y,2))}],hooks:{setCursor:[p=>{let _=p.cursor.idx,S=(_==null?[]:p.data.slice(1).map(R=>R[_])).filter(R=>R!=null).map(R=>ai(R,3));this.read.textContent=S.length?`${x(p.data[0][_])}: ${S.join(" | ")} ${i}`:""}]}},s.length>1?ti.join(s):s[0],this.box);let m=new Map(this.plot.data[0].map((p,_)=>[p,_]));this.rows=this.passing?Array.from(this.passing.lines.data,p=>m.get(p)):[],this.piece=-1}cursor(e){if(this.time=e,this.element.hidden||(this.waterfall.cursor(e),!this.plot||!this.passing))return;let{times:t,lines:i,levels:r}=this.passing,s=Th(t.data,e);if(s===this.piece)return;this.piece=s;let o=this.plot.data.slice(),a=new Array(o[0].length).fill(void 0);this.rows.forEach((l,h)=>{let f=r.data[s*i.data.length+h];a[l]=f?Qu(this.passing,f)*this.shown.scale:null}),this.rows.forEach((l,h)=>{let f=this.rows[h+1];f>l+1&&(a[l]===null||a[f]===null)&&a.fill(null,l+1,f)}),o[o.length-1]=a;let c=this.plot.scales.x.min!=null;this.plot.setData(o,!c),c&&this.plot.redraw()}state(){if(this.element.hidden)return null;let e=this.passing&&this.plot?this.rows.map(i=>this.plot.data.at(-1)[i]):[],t=this.waterfall.drawn.map(({plot:i,line:r})=>({cursor:i.posToVal(new DOMMatrix(getComputedStyle(r).transform).m41,"x")}));return{channel:this.name,over:this.over,ways:this.waysOf(this.name),near:e,maps:t}}resize(){if(this.element.hidden)return;let e=this.element.querySelector(".ppv-caption"),t=Math.max(90,this.element.parentElement.clientHeight-e.offsetHeight-8);this.maps_box.style.height=`${t}px`,this.maps_box.hidden||this.waterfall.resize(),this.plot?.setSize({width:Math.max(120,this.box.clientWidth),height:t}),this.cursor(this.time)}};var Dh=class{constructor(e,t,i,r){let s=e.map(a=>__(a.channels)),o=e.map(a=>a.times?.data.at(-1));this.plots=new Eh(s,i,t,r,o),this.spectra=new Lh(e,s,r),this.labels=new Map(s.flat().map(a=>[a.name,a.label??a.name])),this.members=new Map(s.flat().filter(a=>a.members).map(({name:a,members:c})=>[a,c])),this.whole=new Map([...this.members].flatMap(([a,c])=>c.map(l=>[l,a]))),this.unfolded=new Set,this.search=Y("input",{type:"search",placeholder:`add a curve (${this.labels.size-this.whole.size})`,"aria-label":"Search channels",title:"Search channels by words of their names"}),this.list=Y("div",{className:"ppv-list",role:"listbox","aria-label":"Channels",hidden:!0}),this.search.addEventListener("focus",()=>this.fill()),this.search.addEventListener("input",()=>this.fill()),this.search.addEventListener("keydown",a=>{if(a.key==="Escape"&&this.close(),a.key==="Enter"||a.key==="ArrowDown"){let c=this.list.querySelector("button");a.key==="Enter"?c?.click():c?.focus(),a.preventDefault()}a.stopPropagation()}),this.list.addEventListener("keydown",a=>{let c={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[a.key];c&&(document.activeElement?.[c]??this.search).focus(),a.key==="Escape"&&this.close(),(c||a.key==="Escape")&&a.preventDefault(),a.stopPropagation()}),this.picker=Y("div",{className:"ppv-picker"},this.search,this.list),this.picker.addEventListener("focusout",a=>{this.picker.contains(a.relatedTarget)||this.close()}),this.tab=xt("Spectrum","Switch between time curves and spectrum",()=>this.turn()),this.tab.hidden=!this.spectra.names.length,this.plots.onRemove=()=>this.list.hidden||this.fill(),this.body=Y("div",{className:"ppv-curves-body"},this.plots.element,this.plots.more,this.spectra.element),this.element=Y("div",{className:"ppv-curves"},this.body),this.bar=Y("div",{className:"ppv-bar"},this.picker,this.tab),this.plots.needs=a=>this.element.style.minHeight=`${a}px`,this.bar.hidden=this.element.hidden=!this.labels.size&&!this.spectra.names.length}matches(){let e=this.search.value.toLowerCase().split(/\s+/).filter(Boolean);return[...this.labels].filter(([t,i])=>{let r=this.whole.get(t);if(r&&!this.unfolded.has(r)&&!this.plots.names.has(t))return!1;let s=`${t} ${i}`.toLowerCase();return e.every(o=>s.includes(o))})}fill(){let e=this.matches();this.list.replaceChildren(...e.slice(0,200).flatMap(([t,i])=>this.#e(t,i))),e.length||this.list.append(Y("p",{},"No matching channel.")),e.length>200&&this.list.append(Y("p",{},`${e.length-200} more: refine the search.`)),this.list.hidden=!1}#e(e,t){let i=this.whole.has(e),r=Y("button",{type:"button",role:"option",className:i?"ppv-member":"","aria-selected":String(this.plots.names.has(e)),title:e,onclick:c=>{this.plots.show(e,!this.plots.names.has(e)),c.currentTarget.setAttribute("aria-selected",String(this.plots.names.has(e)))}},t),s=this.members.get(e);if(!s)return[r];let o=this.unfolded.has(e),a=Y("button",{type:"button",className:"ppv-unfold","aria-expanded":String(o),onclick:()=>{o?this.unfolded.delete(e):this.unfolded.add(e),this.fill(),[...this.list.querySelectorAll(".ppv-unfold")].find(({dataset:l})=>l.group===e)?.focus()}},`${o?"\u25BE":"\u25B8"} ${s.length} planets`);return a.dataset.group=e,a.setAttribute("aria-label",`List the planets of ${t}`),[r,a]}close(){this.list.hidden=!0}spectrum(e,t){this.spectra.names.includes(e)&&(this.spectra.element.hidden&&this.turn(),this.spectra.choose(e,t))}turn(){if(!this.spectra.names.length)return;let e=this.spectra.element.hidden;this.spectra.element.hidden=!e,this.plots.element.hidden=e,this.plots.more.hidden=!0,this.tab.textContent=e?"Curves":"Spectrum",this.picker.style.visibility=e?"hidden":"",e?this.spectra.build():this.resize()}cursor(e){this.plots.cursor(e),this.spectra.cursor(e)}build(){this.element.hidden||(this.plots.build(),this.spectra.element.hidden||this.spectra.build())}resize(){this.element.hidden||(this.plots.element.hidden||this.plots.resize(),this.spectra.resize())}};var XE=8,Nh=class{constructor(e,t,i){this.stage=e,this.label=Y("div",{className:"ppv-label",hidden:!0}),this.at=null,this.waiting=!1;let{canvas:r}=e;r.addEventListener("pointermove",o=>{this.at=t.dragging||o.pointerType==="touch"?null:{x:o.clientX,y:o.clientY},this.waiting||setTimeout(()=>this.#e(),60),this.waiting=!0}),r.addEventListener("pointerleave",o=>{this.at=null,o.pointerType!=="touch"&&(this.label.hidden=!0)});let s={x:0,y:0};r.addEventListener("pointerdown",({clientX:o,clientY:a,pointerType:c})=>{s={x:o,y:a},c==="touch"&&(this.label.hidden=!0)}),r.addEventListener("pointerup",({clientX:o,clientY:a,pointerType:c})=>{c!=="touch"||Math.hypot(o-s.x,a-s.y)>XE||(this.at={x:o,y:a},this.#e(),this.at=null)}),r.addEventListener("dblclick",o=>{let a=e.hit(o.clientX,o.clientY);if(!a)return;let{bodies:c}=e.pictures[a.picture].data,l=c[a.part.solid.body];for(;l?.part;)l=c[l.parent];i(l?.name)})}#e(){this.waiting=!1;let e=this.at&&this.stage.hit(this.at.x,this.at.y);if(this.label.hidden=!e,!e)return;let{solid:t}=e.part;this.label.textContent=qE(t,e.fault);let i=this.stage.canvas.getBoundingClientRect(),r=Math.min(this.at.x-i.left+14,i.width-this.label.offsetWidth-4);this.label.style.transform=`translate(${r}px, ${Math.max(0,this.at.y-i.top-26)}px)`}};function qE(n,e=""){let{name:t}=n;return n.kind==="element"||e&&!n.teeth?e?`${t}, ${e}`:t:n.teeth?`${t}, ${n.kind}, ${n.teeth} teeth`:t===n.kind?t:`${t}, ${n.kind}`}var Sl=1e-4;function Ko(n){let e=10**Math.floor(Math.log10(n)),t=n/e;return e*(t<1.5?1:t<3.5?2:t<7.5?5:10)}var Ih=class{constructor(e,t){this.times=e,this.poses=t,this.first=e.length?e[0]:0,this.last=e.length?e[e.length-1]:0,this.time=this.first,this.playing=!1,this.atEnd=null,this.loop="record",this.window=[this.first,this.last],this.body=-1,this.speed=this.#t()}#e(e){return Uo(this.poses?.times??this.times,e)}#t(){let e=this.last-this.first,t=0,i=[this.#e(this.first),this.#e(this.last)];this.poses?.bodies.forEach((s,o)=>{t=Math.max(t,Math.abs(this.poses.angle(o,i[1])-this.poses.angle(o,i[0])))});let r=e>0?t>1?2*Math.PI*e/t/3:e/10:1;return Ko(Math.max(Sl,Math.min(1,r)))}seek(e){this.time=Math.max(this.first,Math.min(this.last,e))}advance(e){if(!this.playing)return;let[t,i]=this.window,r=this.time+e*this.speed;r<t&&(r=t);let s=r>i&&this.atEnd;s&&(r=i),r>i&&(r=i>t?t+(r-t)%(i-t):t),this.time=r,s&&this.atEnd()}step(e){this.playing=!1;let{low:t,share:i}=Uo(this.times,this.time),r=t+i,s=e>0?Math.floor(r+1e-9)+e:Math.ceil(r-1e-9)+e;this.time=this.times[Math.max(0,Math.min(this.times.length-1,s))]??0}get frame(){let{low:e,share:t}=Uo(this.times,this.time);return e+t}reference(e,t){let i=s=>this.poses&&Math.abs(this.poses.angle(s,this.#e(this.last))-this.poses.angle(s,this.#e(this.first)))>0;if(e>=0&&i(e))return e;let r=t.find(s=>s.teeth&&i(s.body));return r?r.body:this.poses?.bodies.findIndex((s,o)=>i(o))??-1}repeat(e,t,i){if(this.loop="record",this.window=[this.first,this.last],e==="record")return"";let r=this.reference(t,i);if(r<0)return"No body of this scene rotates.";let s=i.find(f=>f.body===r&&f.teeth)?.teeth;if(e==="cycle"&&!s)return"The followed body is not a gear.";let o=2*Math.PI/(e==="cycle"?s:1),a=f=>this.poses.angle(r,this.#e(f));if(Math.abs(a(this.last)-a(this.first))<o)return"The record is shorter than the repeated interval.";let l=this.time;Math.abs(a(this.last)-a(l))<o&&(l=this.#i(f=>Math.abs(a(this.last)-a(f))<=o,this.first,this.last));let h=this.#i(f=>Math.abs(a(f)-a(l))>=o,l,this.last);return this.loop=e,this.body=r,this.window=[l,h],this.seek(l),""}#i(e,t,i){for(let r=0;r<60;r++){let s=(t+i)/2;e(s)?i=s:t=s}return i}};var $v=[["space","play, pause"],["\u2190 \u2192","one frame back, forward"],["Home, End","start, end"],["+ \u2212","faster, slower"],["[ ]","previous, next mark"],["f","fit all"],["1 \u2026 9, 0","follow a body, none"],["a e t i","view along the axis, from the side, from above, oblique"],["o","parallel or central projection"],["s, S","section; parallel to the screen"],["p, P","move the section"],["m","vibrations \xD71, \xD710, \xD7100, \xD71000"],["drag","rotate; right button or Shift: pan"],["wheel","zoom at the pointer"],["double click","follow the body of a part"]];function Kv(n){let e={" ":()=>n.toggle(),ArrowLeft:()=>n.step(-1),ArrowRight:()=>n.step(1),Home:()=>n.seek(n.player.window[0]),End:()=>n.seek(n.player.window[1]),"+":()=>ju(n,2.1),"=":()=>ju(n,2.1),"-":()=>ju(n,.47619047619047616),"[":()=>n.transport.toMark(-1),"]":()=>n.transport.toMark(1),f:()=>n.views?.fit(),a:()=>n.views?.named("axis"),e:()=>n.views?.named("side"),t:()=>n.views?.named("top"),i:()=>n.views?.named("iso"),o:()=>n.project(!n.stage?.parallel),s:()=>n.section?.turn(!n.section.on),S:()=>n.section?.facing(),p:()=>n.section?.move(.01),P:()=>n.section?.move(-.01),m:()=>YE(n),Escape:()=>n.panels.close()};n.root.tabIndex=-1,document.addEventListener("keydown",t=>{if(t.ctrlKey||t.metaKey||t.altKey||t.defaultPrevented)return;let{target:i}=t,r=n.root.contains(i),s=i===document.body&&n.fills;if(!(!r&&!s||i.matches?.("select, input[type=search], input[type=text]")||i.matches?.("input[type=range]")&&i!==n.transport.range&&/^(Arrow|Home|End)/.test(t.key))&&!(t.key===" "&&i.matches?.("button, input[type=checkbox]"))){if(/^[0-9]$/.test(t.key))n.follow(Number(t.key)-1);else if(e[t.key])e[t.key]();else return;t.preventDefault()}})}function ju(n,e){let{player:t,transport:i}=n;t.speed=Math.max(Sl,Math.min(1,Ko(t.speed*e))),i.speed.set(t.speed)}function YE(n){if(!n.magnification)return;let e=n.stage.pictures[0].poses.magnification,t=e>=1e3?1:e>=100?1e3:e>=10?100:10;n.magnification.set(t),n.magnify(t)}var ed=.48,$E=.32,Uh=class{constructor(e){this.sizes=KE(e),this.columns=Cr.filter(i=>e.some(r=>(r.components??r.largest)?.[i])),this.rows=e.map(i=>{let r=i.state?Y("span",{className:"ppv-state"}):null,s=this.columns.map(a=>Y("td",{className:`ppv-${a}`})),{name:o}=i;return{state:r,cells:s,announced:null,row:Y("tr",{},Y("th",{scope:"row",title:`${i.kind} ${o}`},r,o),...s)}}),this.folder=xt("forces","Collapse or expand the forces",()=>this.fold(!this.folded),{"aria-expanded":"true"}),this.folded=this.chosen=!1;let t=Y("tr",{},Y("td",{},this.folder),...this.columns.map(i=>Y("th",{scope:"col",className:`ppv-${i}`},Y("i"),i)));this.states=Y("div",{className:"ppv-states"}),this.seen=new Set;for(let i of e)for(let r of i.state?.data??[])this.seen.add(r===255?-1:r);this.#e(),this.element=Y("div",{className:"ppv-legend",tabindex:"0",role:"region","aria-label":"Current forces"},Y("table",{},Y("thead",{},t),Y("tbody",{},...this.rows.map(({row:i})=>i))),this.states),this.element.hidden=!e.length}#e(){this.states.replaceChildren(...[1,-1,2,0].filter(e=>this.seen.has(e)).map(e=>Y("span",{},Y("i",{style:`background:${Fn[e].colour}`}),Fn[e].word)))}fold(e,t=!0){this.chosen||=t,this.folded=e,this.element.classList.toggle("ppv-folded",e),this.folder.setAttribute("aria-expanded",String(!e))}settle(){if(this.chosen||this.element.hidden)return;this.fold(!1,!1);let{clientWidth:e,clientHeight:t}=this.element.parentElement,{offsetWidth:i,offsetHeight:r}=this.element,s=this.element.scrollHeight>this.element.clientHeight+1;this.fold(s||i>ed*e||i>$E*e&&r>ed*t,!1)}get share(){if(this.element.hidden||this.folded)return 0;let e=(this.element.offsetWidth+12)/Math.max(this.element.parentElement.clientWidth,1);return e>ed?0:e}get strip(){return this.element.hidden||!this.folded?0:(this.element.offsetWidth+12)/Math.max(this.element.parentElement.clientWidth,1)}get drop(){return(this.element.offsetHeight+12)/Math.max(this.element.parentElement.clientHeight,1)}update(e,t,i){this.element.hidden=i||!e.some(r=>t.has(r.kind)),!this.element.hidden&&e.forEach((r,s)=>{let{row:o,cells:a,state:c}=this.rows[s];if(o.hidden=!t.has(r.kind)||r.kind==="pair"&&!r.total,!o.hidden&&(this.columns.forEach((l,h)=>{let f=l in r.values?this.#t(r.values[l],r.unit):"";a[h].textContent!==f&&(a[h].textContent=f)}),c&&this.rows[s].announced!==r.state)){r.state in Fn&&!this.seen.has(r.state)&&(this.seen.add(r.state),this.#e());let{word:l,colour:h}=Fn[r.state]??Fn[0];this.rows[s].announced=r.state,c.style.background=h,c.title=l,c.setAttribute("aria-label",l)}})}#t(e,t){let{most:i,least:r}=this.sizes[t]??{};return sh(e,t,i||e,r||e)}lines(e,t){return e.filter(i=>t.has(i.kind)&&(i.kind!=="pair"||i.total)).map(i=>({name:i.name,values:this.columns.filter(r=>r in i.values).map(r=>({part:r,text:this.#t(i.values[r],i.unit)}))}))}};function KE(n){let e={};for(let{unit:t="N",size:i}of n){if(!i)continue;let r=e[t]??={most:i,least:i};r.most=Math.max(r.most,i),r.least=Math.min(r.least,i)}return e}var ZE={contact_loss:"contact loss",impact:"impact",back_flank:"contact on back flank",front_flank:"contact on front flank",faulty_tooth:"faulty tooth in mesh"},td=400,yl=n=>ZE[n]??n.replaceAll("_"," ");function Zv(n){let{marks:e,kinds:t,stepLength:i}=n.transport,r=new Set,s=Y("div",{className:"ppv-marklist"}),o=()=>{let c=e.filter(l=>!r.has(l.kind));s.replaceChildren(...c.slice(0,td).map(l=>{let h=bs(l.time,i/10),f=l.until>l.time?`, ${fr(l.until-l.time)}`:"",u=xt("",`Go to ${yl(l.kind)} at ${h}`,()=>n.seek(l.time));return u.append(Y("i",{style:`background:${ys(t,l.kind)}`}),Y("b",{},h),Y("span",{},`${yl(l.kind)}${l.what?`, ${l.what}`:""}${f}`)),u}),c.length>td?Y("p",{className:"ppv-soft"},`${c.length-td} more`):"")},a=t.map(c=>{let l=e.filter(f=>f.kind===c).length,h=Y("input",{type:"checkbox",checked:!0,onchange:()=>{h.checked?r.delete(c):r.add(c),o()}});return Y("label",{className:"ppv-tick"},h,Y("i",{className:"ppv-dot",style:`background:${ys(t,c)}`}),Y("span",{},`${yl(c)} (${l})`))});return o(),[...a,s]}function bl(n){if(n.length<2)return[""];for(let e of["title","label","subtitle"]){let[t,i]=n.map(r=>r[e]??"");if(t&&i&&t!==i)return JE(t,i)}return["first","second"]}function JE(n,e){if(Math.max(n.length,e.length)<=36)return[n,e];let t=[n,e].map(r=>r.split(/(?<=[\s,_/-])/)),i=0;for(;i<Math.min(t[0].length,t[1].length)-1&&t[0][i]===t[1][i];)i++;return t.map(r=>{let s=(i?"\u2026 ":"")+r.slice(i).join("");return s.length>36?`${s.slice(0,35).trimEnd()}\u2026`:s})}var QE=1.6,jE=.06,Fh=class{constructor(e,t,i){this.modes=e,this.changed=i,this.stage=t,this.number=-1,this.phase=0,this.amplitude=1,this.unit=e.map(s=>this.#i(s)),this.buttons=e.map((s,o)=>xt("",`Animate ${s.name}`,()=>this.choose(this.number===o?-1:o),{"aria-pressed":"false"})),this.buttons.forEach((s,o)=>s.append(...this.#t(e[o]).map(a=>Y("span",{},a)))),this.stop=xt("stop animation","Stop the animation of the mode",()=>this.choose(-1)),this.stop.hidden=!0;let r=_r({label:"amplitude",title:"Amplitude of the mode shape",least:.05,most:20,value:1,show:s=>`\xD7 ${ai(s,2)}`,changed:s=>{this.amplitude=s,this.changed()}});this.rows=[Y("div",{className:"ppv-modes"},...this.buttons),r.row,this.stop]}#e({frequency:e,damping:t}){let i=t==null?"":`, damping ${ai(100*t,2)} %${t<0?", unstable":""}`;return`${ai(e,4)} Hz${i}`}#t(e){let[,t,i]=/^(\d+: )?(.*)$/s.exec(e.name);return[(t??"")+this.#e(e),i]}#i(e){let{solids:t,bounds:i}=this.stage.pictures[0],r=0,s=(o,a)=>{let c=0;for(let l=0;l<6;l++)c+=o?o.data[6*a+l]**2:0;return Math.sqrt(c)};this.stage.pictures[0].data.bodies.forEach((o,a)=>{let c=t.reachOf(a);r=Math.max(r,s(e.position,a)+s(e.turn,a)*(c||.1*i.radius))});for(let{modal:o}of t.parts)r=Math.max(r,o?.largest(e)??0);return r>0?jE*i.radius/r:0}get active(){return this.number>=0}get words(){return this.active?`${this.modes[this.number].name}, ${this.#e(this.modes[this.number])}`:""}choose(e){this.number=e,this.phase=0,this.buttons.forEach((t,i)=>t.setAttribute("aria-pressed",String(i===e))),this.stop.hidden=e<0,this.changed()}advance(e){this.active&&(this.phase=(this.phase+2*Math.PI*e/QE)%(2*Math.PI))}pose({poses:e}){e.ofMode(this.modes[this.number],this.phase,this.amplitude*this.unit[this.number])}};var e1=.07,Oh=Math.PI/2-.001,kh=class{constructor(e,t,i,r){this.camera=e,this.element=t,this.changed=i,this.up=new C(...r).normalize(),this.basis=new Ut().setFromUnitVectors(new C(0,1,0),this.up),this.now={target:new C,azimuth:.6,elevation:.4,distance:1},this.goal={target:new C,azimuth:.6,elevation:.4,distance:1},this.nearest=1e-6,this.farthest=1e6,this.chosen=!1,this.takesWheel=()=>!0,this.shift=0,this.drop=0,this.pointers=new Map,t.addEventListener("pointerdown",s=>this.#i(s)),t.addEventListener("pointermove",s=>this.#r(s));for(let s of["pointerup","pointercancel"])t.addEventListener(s,o=>this.#n(o));t.addEventListener("wheel",s=>this.#s(s),{passive:!1}),t.addEventListener("contextmenu",s=>s.preventDefault())}get pixel(){return 2*this.now.distance*Math.tan(this.camera.fov*Math.PI/360)/Math.max(this.element.clientHeight,1)}direction(e=this.now){let t=Math.cos(e.elevation);return new C(t*Math.sin(e.azimuth),Math.sin(e.elevation),t*Math.cos(e.azimuth)).applyQuaternion(this.basis)}look({target:e,direction:t,distance:i},r=!1){if(this.chosen=!0,e&&this.goal.target.copy(e),i&&(this.goal.distance=this.#t(i)),t){let s=t.clone().normalize().applyQuaternion(this.basis.clone().invert());if(this.goal.elevation=Math.max(-Oh,Math.min(Oh,Math.asin(Math.max(-1,Math.min(1,s.y))))),Math.hypot(s.x,s.z)>1e-6){let o=Math.atan2(s.x,s.z);this.goal.azimuth=o+2*Math.PI*Math.round((this.now.azimuth-o)/(2*Math.PI))}}r&&this.settle(),this.changed()}settle(){this.now.target.copy(this.goal.target);for(let e of["azimuth","elevation","distance"])this.now[e]=this.goal[e];this.#e()}step(e){let t=1-Math.exp(-e/e1),{now:i,goal:r}=this,s=i.target.distanceTo(r.target)/i.distance+Math.abs(i.azimuth-r.azimuth)+Math.abs(i.elevation-r.elevation)+Math.abs(Math.log(i.distance/r.distance));return s<1e-4?(s&&this.settle(),!1):(i.target.lerp(r.target,t),i.azimuth+=t*(r.azimuth-i.azimuth),i.elevation+=t*(r.elevation-i.elevation),i.distance*=(r.distance/i.distance)**t,this.#e(),!0)}#e(){let{camera:e,now:t}=this;e.position.copy(t.target).addScaledVector(this.direction(),t.distance),Jv.lookAt(this.direction(),t1,this.up),e.quaternion.setFromRotationMatrix(Jv),e.updateMatrixWorld(!0)}#t(e){return Math.max(this.nearest,Math.min(this.farthest,e))}#i(e){e.button>2||(this.element.setPointerCapture?.(e.pointerId),this.pointers.set(e.pointerId,{x:e.clientX,y:e.clientY,pan:e.button!==0||e.shiftKey||e.ctrlKey}))}#n(e){this.pointers.delete(e.pointerId)}get dragging(){return this.pointers.size>0}#r(e){let t=this.pointers.get(e.pointerId);if(!t)return;let i=[...this.pointers.entries()].filter(([o])=>o!==e.pointerId).map(([,o])=>o),r=e.clientX-t.x,s=e.clientY-t.y;if(i.length){let[o]=i,a=Math.hypot(t.x-o.x,t.y-o.y),c=Math.hypot(e.clientX-o.x,e.clientY-o.y);a>0&&c>0&&this.zoom(a/c,(e.clientX+o.x)/2,(e.clientY+o.y)/2),this.pan(r/2,s/2)}else t.pan?this.pan(r,s):this.turn(r,s);t.x=e.clientX,t.y=e.clientY}turn(e,t){this.chosen=!0;let i=1.1*Math.PI/Math.max(this.element.clientHeight,1);this.goal.azimuth-=i*e,this.goal.elevation=Math.max(-Oh,Math.min(Oh,this.goal.elevation+i*t)),this.changed()}pan(e,t){this.chosen=!0;let i=this.pixel;this.goal.target.addScaledVector(Bh.set(1,0,0).applyQuaternion(this.camera.quaternion),-e*i),this.goal.target.addScaledVector(Bh.set(0,1,0).applyQuaternion(this.camera.quaternion),t*i),this.changed()}zoom(e,t,i){this.chosen=!0;let r=this.goal.distance;if(this.goal.distance=this.#t(r*e),t!==void 0){let s=this.element.getBoundingClientRect(),o=this.pixel*r/this.now.distance*(1-this.goal.distance/r);this.goal.target.addScaledVector(Bh.set(1,0,0).applyQuaternion(this.camera.quaternion),(t-s.left-this.middle(t-s.left))*o),this.goal.target.addScaledVector(Bh.set(0,1,0).applyQuaternion(this.camera.quaternion),((.5+this.drop)*s.height-(i-s.top))*o)}this.changed()}middle(e){let t=this.element.clientWidth/(this.pictures??1);return(Math.floor(e/t)+.5-this.shift)*t}#s(e){if(!this.takesWheel(e))return;e.preventDefault();let t=e.deltaMode===1?33:1;this.zoom(Math.exp(Math.max(-1,Math.min(1,e.deltaY*t*.0015))),e.clientX,e.clientY)}},Jv=new ye,t1=new C,Bh=new C;var[i1,n1]=[5126,5125],[Qv,r1]=[34962,34963],id=class{constructor(){this.pieces=[],this.length=0,this.json={asset:{version:"2.0",generator:"pitchpoint"},scene:0,scenes:[{nodes:[]}],nodes:[],meshes:[],materials:[],accessors:[],bufferViews:[],buffers:[{byteLength:0}]}}put(e,t,i,r=!1){let s={SCALAR:1,VEC3:3,VEC4:4}[t];this.json.bufferViews.push({buffer:0,byteOffset:this.length,byteLength:e.byteLength,...i&&{target:i}});let o={bufferView:this.json.bufferViews.length-1,componentType:e instanceof Float32Array?i1:n1,count:e.length/s,type:t};return r&&(o.min=Array(s).fill(1/0),o.max=Array(s).fill(-1/0),e.forEach((a,c)=>{o.min[c%s]=Math.min(o.min[c%s],a),o.max[c%s]=Math.max(o.max[c%s],a)})),this.pieces.push(new Uint8Array(e.buffer,e.byteOffset,e.byteLength)),this.length+=e.byteLength,this.json.accessors.push(o)-1}bytes(){this.json.buffers[0].byteLength=this.length;let e=new TextEncoder().encode(JSON.stringify(this.json)),t=Math.ceil(e.length/4)*4,i=new Uint8Array(20+t+8+this.length),r=new DataView(i.buffer);[1179937895,2,i.length,t,1313821514].forEach((o,a)=>r.setUint32(4*a,o,!0)),i.fill(32,20,20+t),i.set(e,20),r.setUint32(20+t,this.length,!0),r.setUint32(24+t,5130562,!0);let s=28+t;for(let o of this.pieces)i.set(o,s),s+=o.length;return i}};function jv(n,e,t,i){let r=new id,{json:s}=r,o=new C,a=new Ut,c=new C,l=new Ut,h=i.length>1,f=h?r.put(Float32Array.from(i,m=>m-i[0]),"SCALAR",void 0,!0):0,u={name:"record",samplers:[],channels:[]},d=new Set(n.map(({solid:m})=>m.blend?m.blend.bodies[0]:m.body)),g=new Map;for(let m of d){let p={name:m<0?"ground":e[m].name,children:[]};if(g.set(m,p),s.scenes[0].nodes.push(s.nodes.push(p)-1),m<0)continue;let _=new Float32Array(3*i.length),y=new Float32Array(4*i.length);if(t[m].forEach((S,R)=>{S.decompose(o,a,c),R&&a.dot(l)<0&&a.set(-a.x,-a.y,-a.z,-a.w),l.copy(a),o.toArray(_,3*R),a.toArray(y,4*R)}),p.translation=[..._.slice(0,3)],p.rotation=[...y.slice(0,4)],!!h)for(let[S,R,A,v]of[["translation",_,"VEC3",3],["rotation",y,"VEC4",4]]){if(R.every((F,D)=>F===R[D%v]))continue;let E=u.samplers.push({input:f,output:r.put(R,A),interpolation:"LINEAR"})-1;u.channels.push({sampler:E,target:{node:s.nodes.indexOf(p),path:S}})}}let x=new Map;for(let{solid:m,geometry:p,colour:_}of n){let y=_+!!m.see_through;if(!x.has(y)){let{r:D,g:N,b:k}=new ke(_),G={baseColorFactor:[D,N,k,m.see_through?.22:1],metallicFactor:.1,roughnessFactor:.7};x.set(y,s.materials.push({pbrMetallicRoughness:G,...m.see_through&&{alphaMode:"BLEND"}})-1)}let{position:S,normal:R}=p.attributes,A={POSITION:r.put(S.array,"VEC3",Qv,!0),NORMAL:r.put(R.array,"VEC3",Qv)},v=r.put(Uint32Array.from(p.index.array),"SCALAR",r1),E=s.meshes.push({name:m.name,primitives:[{attributes:A,indices:v,material:x.get(y)}]})-1,F=s.nodes.push({name:m.name,mesh:E})-1;g.get(m.blend?m.blend.bodies[0]:m.body).children.push(F)}for(let m of g.values())m.children.length||delete m.children;return u.channels.length&&(s.animations=[u]),r.bytes()}var s1=[.5377,.7071,.4591],o1=1e-6;function eM(n,e){let t=n.length/3,i=new Float64Array(t),r=0;for(let c=0;c<t;c++)for(let l=0;l<3;l++)i[c]+=s1[l]*n[3*c+l],r=Math.max(r,o1*Math.abs(n[3*c+l]));let s=Uint32Array.from(i.keys()).sort((c,l)=>i[c]-i[l]),o=new Uint32Array(t);s.forEach((c,l)=>{o[c]=c;for(let h=l-1;h>=0&&i[c]-i[s[h]]<=r;h--){let f=o[s[h]];if(!(Math.hypot(...[0,1,2].map(d=>n[3*c+d]-n[3*f+d]))>r)){o[c]=f;break}}});let a=[];for(let c=0;c<e.length;c+=3){let l=[o[e[c]],o[e[c+1]],o[e[c+2]]];new Set(l).size===3&&a.push(...l)}return a}function wl(n,e){let t=URL.createObjectURL(n),i=Y("a",{href:t,download:e});document.body.append(i),i.click(),i.remove(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}function El(n,e){return`${n.scenes[0].title.toLowerCase().replace(/[^a-z0-9]+/g,"-").replace(/^-|-$/g,"")||"scene"}.${e}`}function zh(n,e=1){let{stage:t}=n,{renderer:i,canvas:r}=t;i.setPixelRatio(t.ratio*e),i.setSize(t.size.width,t.size.height),n.draw();let s=Y("canvas",{width:r.width,height:r.height}),o=s.getContext("2d");o.drawImage(r,0,0),t.resize(),n.draw();let a=t.ratio*e;o.scale(a,a);let c=getComputedStyle(n.root),l=c.getPropertyValue("--v-ink").trim()||"#222",h=c.getPropertyValue("--v-soft").trim()||"#666",{width:f,height:u}=t.size;o.textBaseline="top",o.font=`600 14px ${c.fontFamily}`,o.fillStyle=l;let d=f/n.scenes.length,g=n.scenes.map((p,_)=>{let y=nd(o,[p.title,p.label].filter(Boolean).join(", "),d-24);return o.fillText(y,12+_*d,10),o.measureText(y).width+24});o.font=`12px ${c.fontFamily}`,o.fillStyle=h;let x=n.modes?.active?n.modes.words:`t = ${bs(n.player.time,n.transport.stepLength/10)}`;n.scenes.forEach((p,_)=>o.fillText(nd(o,[p.subtitle,x].filter(Boolean).join(", "),d-24),12+_*d,28)),n.legends.forEach((p,_)=>{p.element.hidden||h1(o,n,_,{right:(_+1)*d,room:d-g[_]},l,c)}),n.boxes.forEach((p,_)=>{p.element.hidden||l1(o,p,{x:12+_*d,y:u-62,room:d-24},h)}),o.fillStyle=o.strokeStyle=h,n.scales.forEach((p,_)=>{p.hidden||a1(o,p,12+_*d,u)});let m=atob(s.toDataURL("image/png").split(",")[1]);return new Blob([Uint8Array.from(m,p=>p.charCodeAt(0))],{type:"image/png"})}function a1(n,e,t,i){let[r,s]=e.children,o=parseFloat(s.style.width);n.fillText(r.textContent,t,i-30),n.beginPath(),n.moveTo(t,i-15),n.lineTo(t,i-10),n.lineTo(t+o,i-10),n.lineTo(t+o,i-15),n.stroke();let[,,a,c]=e.children;if(c.hidden)return;let l=t+Math.max(o,n.measureText(r.textContent).width)+14,h=l+parseFloat(c.style.width);n.fillText(a.textContent,l,i-30),n.beginPath(),n.moveTo(l,i-12),n.lineTo(h,i-12);for(let f of[-4,4])n.moveTo(h,i-12),n.lineTo(h-7,i-12+f);n.stroke()}function l1(n,e,{x:t,y:i,room:r},s){if(n.fillStyle=s,n.font=n.font.replace(/^\d+px/,"11px"),!e.bar.hidden){for(let c=0;c<210;c++)n.fillStyle=`rgb(${fl(c/209).map(l=>Math.round(255*l)).join(" ")})`,n.fillRect(t+c,i,1.5,8);n.fillStyle=s;let a=`${e.what.textContent}: 0 \u2026 ${e.end.textContent}, ${e.now.textContent}`;n.fillText(nd(n,a,r),t,i+11)}if(e.gap.hidden)return;let o=c1(n,e.gap.textContent,r);o.forEach((a,c)=>n.fillText(a,t,i-16-14*(o.length-1-c)))}function c1(n,e,t){let i=[""];for(let r of e.split(" ")){let s=i.at(-1)?`${i.at(-1)} ${r}`:r;i.at(-1)&&n.measureText(s).width>t?i.push(r):i[i.length-1]=s}return i}function nd(n,e,t){if(n.measureText(e).width<=t)return e;let i=e.length;for(;i>1&&n.measureText(`${e.slice(0,i)}\u2026`).width>t;)i--;return`${e.slice(0,i).trimEnd()}\u2026`}function h1(n,e,t,{right:i,room:r},s,o){let{arrows:a}=e.stage.pictures[t],c=e.legends[t],{columns:l}=c,h=c.folded?[]:c.lines(a.now,a.shown).slice(0,20),f=92*l.length+24+Math.max(0,...h.map(({name:d})=>n.measureText(d).width)),u=f>r?44:0;n.globalAlpha=.85,n.fillStyle=o.getPropertyValue("--v-paper").trim()||"#fff",n.fillRect(i-f,u,f,34+16*h.length),n.globalAlpha=1,n.textAlign="right",l.forEach((d,g)=>{n.fillStyle=cl(e.root,d),n.fillText(d,i-12-92*(l.length-1-g),u+10)}),h.forEach(({name:d,values:g},x)=>{let m=u+27+16*x;n.fillStyle=s,n.font=`12px ${o.fontFamily}`,n.fillText(d,i-12-92*l.length,m);for(let{part:p,text:_}of g)n.fillText(_,i-12-92*(l.length-1-l.indexOf(p)),m)}),n.textAlign="left"}function Gh(n){let e=n.stage.pictures[0].solids.exported(!1).map(({solid:h,geometry:f})=>{let u=f.attributes.position.array;return{solid:h,points:u,index:eM(u,f.index.array)}}),t=e.reduce((h,{index:f})=>h+f.length/3,0),i=new ArrayBuffer(84+50*t),r=new DataView(i);r.setUint32(80,t,!0);let s=84,o=[new C,new C,new C],a=new C,c=new C,l=h=>{for(let f of[h.x,h.y,h.z])r.setFloat32(s,f,!0),s+=4};for(let{solid:h,points:f,index:u}of e){let d=n.stage.pictures[0].poses.ofSolid(h);for(let g=0;g<u.length;g+=3)o.forEach((x,m)=>x.fromArray(f,3*u[g+m]).applyMatrix4(d)),a.subVectors(o[1],o[0]).cross(c.subVectors(o[2],o[0])).normalize(),l(a),o.forEach(l),s+=2}return new Blob([i],{type:"model/stl"})}var tM=1e3;function Hh(n){let{solids:e,poses:t,data:i}=n.stage.pictures[0],r=t.times.length,s=Math.max(1,Math.ceil((r-1)/(tM-1))),o=[];for(let h=0;h<r;h+=s)o.push(h);let a=f1(o.map(h=>t.times[h]),t),c=e.exported(!0),l=t.world.map(()=>[]);for(let h of a)t.at(h),t.world.forEach((f,u)=>l[u].push(new ye().copy(f)));return t.at(n.player.time),n.changed(),new Blob([jv(c,i.bodies,l,a)],{type:"model/gltf-binary"})}function f1(n,e){let t=s=>(e.at(s),e.bodies.map((o,a)=>e.angle(a))),i=[n[0]],r=t(n[0]);for(let s=1;s<n.length&&i.length<8*tM;s++){let o=t(n[s]),a=Math.max(0,...o.map((l,h)=>Math.abs(l-r[h]))),c=Math.min(64,Math.max(1,Math.ceil(a/(Math.PI/2))));for(let l=1;l<=c;l++)i.push(n[s-1]+(n[s]-n[s-1])*l/c);r=o}return i}function iM(n){if(typeof MediaRecorder>"u"||!n.captureStream)return null;let t=["video/mp4;codecs=avc1.42E01E","video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm"].find(i=>MediaRecorder.isTypeSupported(i));return t?{ending:t.slice(6,t.includes(";")?t.indexOf(";"):void 0),start(){let i=new MediaRecorder(n.captureStream(30),{mimeType:t,videoBitsPerSecond:6e6}),r=[];return i.ondataavailable=({data:s})=>s.size&&r.push(s),i.start(500),()=>new Promise(s=>{i.onstop=()=>s(new Blob(r,{type:t.split(";")[0]})),i.stop()})}}:null}var u1=.4,Vh=class{constructor(){this.bar=Y("div",{className:"ppv-tools",role:"toolbar","aria-label":"Scene"}),this.panel=Y("div",{className:"ppv-panel",hidden:!0}),this.open=null,this.panel.addEventListener("keydown",e=>{e.key==="Escape"&&this.close()})}action(e,t,i){let r=xt(e,t,i);return this.bar.append(r),r}add(e,t,i){let r=xt(e,t,()=>this.open===e?this.close():this.show(e,i,r),{"aria-expanded":"false"});return this.bar.append(r),r}show(e,t,i){this.close(),this.open=e,this.opener=i,i.setAttribute("aria-expanded","true"),this.panel.replaceChildren(Y("div",{className:"ppv-panel-head"},Y("b",{},e),xt("\xD7","Close",()=>this.close())),...t),this.panel.hidden=!1}get share(){let e=this.open?(this.panel.offsetWidth+12)/Math.max(this.panel.parentElement.clientWidth,1):0;return e>u1?0:e}close(){if(!this.open)return;let e=this.panel.contains(document.activeElement);this.open=null,this.panel.hidden=!0,this.opener.setAttribute("aria-expanded","false"),e&&this.opener.focus()}};function nM(n){let{stage:e}=n,t=[["axis","Along the axis of the shafts (a)"],["side","From the side (e)"],["top","From above (t)"],["iso","Oblique (i)"]];n.parallel=Cn("parallel projection (o)",!1,l=>n.project(l)),n.followed=on("follow",[["-1","none"],...n.views.names.map((l,h)=>[String(h),l])],l=>n.follow(Number(l)),"Body that the camera follows (1 to 9, 0)");let i=Cn("rotate with body",!1,l=>{n.views.turning=l,n.views.follow(n.views.body,l)}),r=n.scenes.flatMap(l=>l.solids),s=r.some(l=>l.see_through)?on("housing",[["see-through","see-through"],["solid","solid"],["hidden","hidden"]],l=>{for(let h of e.pictures)h.solids.cover(l);n.changed()}).row:null,o=r.some(l=>l.schematic)?Cn("schematic parts",!0,l=>{for(let h of e.pictures)h.solids.schematics(l);n.changed()}).row:null,c=n.scenes.flatMap(l=>l.arrows.filter(h=>h.kind==="mesh")).filter((l,h,f)=>f.findIndex(({name:u})=>u===l.name)===h).map(l=>xt(l.name,`View the mesh ${l.name} along its axis`,()=>n.intoMesh(l)));return[Y("div",{className:"ppv-buttons"},...t.map(([l,h])=>xt(l,h,()=>n.views.named(l)))),n.followed.row,i.row,n.parallel.row,s,o,c.length?Y("div",{},Y("span",{className:"ppv-soft"},"view a mesh"),Y("div",{className:"ppv-buttons"},...c)):null].filter(Boolean)}var d1={mesh:"mesh forces",pair:"forces of tooth pairs",bearing:"bearing forces",load:"loads"};function rM(n){let e=n.stage.pictures.map(s=>s.arrows),t=[...new Set(e.flatMap(s=>[...s.kinds]))],i=_r({label:"length",title:"Length of the arrows",least:.05,most:20,value:1,show:s=>`\xD7 ${ai(s,2)}`,changed:s=>{for(let o of e)o.scale=s;n.changed()}});n.kinds=Object.fromEntries(t.map(s=>[s,Cn(d1[s]??s,e.some(o=>o.shown.has(s)),o=>n.arrows(s,o))])),n.sparse=Cn("sparse",!0,s=>n.density(s)),n.sparse.row.title="Omit small components and arrows close to larger ones; smaller arrows where there are many";let r=e.some(s=>s.many);return[...Object.values(n.kinds).map(({row:s})=>s),r?n.sparse.row:null,i.row].filter(Boolean)}async function p1(n){history.replaceState(null,"",n);try{return await navigator.clipboard.writeText(n),"link copied"}catch{return"the link is in the address bar"}}function sM(n){let{stage:e}=n,t=c=>wl(zh(n,c),El(n,"png")),i=iM(e.canvas),r=null,s=(c,l)=>{a.textContent=c,a.title=a.ariaLabel=l,a.setAttribute("aria-pressed",String(!!r))},o=i&&`Record a video of the playback up to the end of the record, ${i.ending}`,a=i?xt("video",o,async()=>{if(!r){n.filming=!0,e.coarsen(!1),r=i.start(),s("stop and save","Stop and save the video; it stops automatically at the end of the playback"),n.player.atEnd=()=>a.click(),n.toggle(!0);return}let c=r;r=null,n.player.atEnd=null,n.filming=!1,n.toggle(!1),s("video",o),wl(await c(),El(n,i.ending))}):null;return[Y("div",{className:"ppv-buttons"},xt("picture","PNG of the scene with title, time and forces",()=>t(1)),xt("picture \xD7 2","PNG with twice the resolution",()=>t(2)),a),/^(file|https?):/.test(location.protocol)?Y("div",{className:"ppv-buttons"},xt("copy link","Copy the address of this page with view, section and time",async()=>n.hint(await p1(x_(n))))):null,Y("div",{className:"ppv-buttons"},xt("GLB (animated)","Solids and their motion, binary glTF",()=>wl(Hh(n),El(n,"glb"))),xt("STL","Solids at the current time, in metres",()=>wl(Gh(n),El(n,"stl"))))].filter(Boolean)}function oM(n){return n.magnification=_r({label:"magnification \xD7",title:"Magnification of vibrations; rotation is not magnified (m)",least:1,most:1e4,value:1,show:e=>String(e<10?Number(e.toPrecision(2)):Math.round(e)),changed:e=>n.magnify(e)}),[n.magnification.row,Y("p",{className:"ppv-soft"},"Displacements, tilts and torsion about their means; mean rotation is not magnified.")]}var ez=new C(1,0,0),qh=new C(0,0,1);function aM(n,e,t,i){let r=Math.hypot(e,t,i);if(r<1e-300)return n.identity();let s=Math.sin(r/2)/r;return n.set(s*e,s*t,s*i,Math.cos(r/2))}var Zo=class{constructor(e){this.bodies=e.bodies,this.shafts=new Set((e.solids??[]).filter(({kind:t})=>t==="gear"||t==="shaft").map(({blend:t,body:i})=>t?t.bodies[0]:i)),this.times=e.times?.data??new Float64Array([0]),this.where={low:0,share:0},this.magnification=1,this.world=this.bodies.map(()=>new ye),this.still=this.bodies.map(()=>new ye),this.rest=this.bodies.map(()=>new ye),this.means=this.bodies.map(t=>({position:t.position&&Fo(t.position),turn:t.turn&&Fo(t.turn),spin:t.spin&&Fo(t.spin)})),this.bodies.forEach((t,i)=>{let[r,s,o]=t.place??[0,0,0],a=new Ut(...t.axes??[0,0,0,1]).normalize();t.frame=new ye().compose(new C(r,s,o),a,new C(1,1,1)),this.rest[i].multiplyMatrices(this.#e(this.rest,i),t.frame)}),this.at(this.times[0])}#e(e,t){let i=this.bodies[t].parent??-1;return i<0?Wh:e[i]}ofSolid(e){if(e.between)return this.#t(e);let t=e.blend?e.blend.bodies[0]:e.body,i=t<0?Wh:this.world[t];return!e.place&&!e.axes?i:(e.seat??=new ye().compose(new C(...e.place??[0,0,0]),new Ut(...e.axes??[0,0,0,1]).normalize(),lM),e.placed??=new ye,e.placed.multiplyMatrices(i,e.seat))}#t(e){let{bodies:t,ends:i}=e.between,[r,s]=t.map((d,g)=>new C(...i[g]).applyMatrix4(d<0?Wh:this.world[d])),o=s.clone().sub(r),a=o.length()||1e-12,c=o.clone().divideScalar(a),l=t[0]<0?Wh:this.world[t[0]],h=[0,1,2].map(d=>new C().setFromMatrixColumn(l,d)).reduce((d,g)=>Math.abs(g.dot(c))<Math.abs(d.dot(c))-.2?g:d),f=h.addScaledVector(c,-h.dot(c)).normalize(),u=new C().crossVectors(c,f);return e.placed??=new ye,e.placed.makeBasis(f,u,o.lengthSq()?o:c.multiplyScalar(a)).setPosition(r)}#i({gross:e,ratio:t=1},i){return e?t*jt(e,i):0}angle(e,t=this.where){let{spin:i}=this.bodies[e];return this.#i(this.bodies[e],t)+(i?jt(i,t):0)}at(e){this.mode=null,this.where=Uo(this.times,e);let{where:t,magnification:i}=this,r=(s,o,a)=>{let c=jt(s,t,a);return i===1?c:o[a]+i*(c-o[a])};return this.bodies.forEach((s,o)=>{this.still[o].multiplyMatrices(this.#e(this.world,o),s.frame),Ds.set(0,0,0);let a=this.means[o];s.position&&Ds.set(r(s.position,a.position,0),r(s.position,a.position,1),r(s.position,a.position,2)),s.travel&&Ds.set(Ds.x+jt(s.travel,t,0),Ds.y+jt(s.travel,t,1),Ds.z+jt(s.travel,t,2)),s.quaternion?(Dr.set(...[0,1,2,3].map(l=>s.quaternion.data[l+(s.quaternion.count>1?4*t.low:0)])),s.quaternion.count>1&&t.share&&(rd.set(...[4,5,6,7].map(l=>s.quaternion.data[l+4*t.low])),Dr.slerp(rd,t.share)),Dr.normalize()):(Dr.identity(),s.turn&&aM(Dr,r(s.turn,a.turn,0),r(s.turn,a.turn,1),r(s.turn,a.turn,2)));let c=this.#i(s,t)+(s.spin?r(s.spin,a.spin,0):0);c&&Dr.multiply(rd.setFromAxisAngle(qh,c)),Xh.compose(Ds,Dr,lM),this.world[o].multiplyMatrices(this.still[o],Xh)}),this}ofMode(e,t,i){let r=i*Math.cos(t),s=-i*Math.sin(t);this.mode={shape:e,cosine:r,sine:s};let o=(a,c,l)=>a?r*a.data[6*c+l]+s*a.data[6*c+3+l]:0;return this.bodies.forEach((a,c)=>{aM(Dr,o(e.turn,c,0),o(e.turn,c,1),o(e.turn,c,2));let l=this.rest[c];Xh.makeRotationFromQuaternion(Dr),this.world[c].multiplyMatrices(Xh,l);let h=this.world[c].elements;for(let f=0;f<3;f++)h[12+f]=l.elements[12+f]+o(e.position,c,f);this.still[c].copy(this.world[c])}),this}axis(){let e=new C,t=this.bodies.some(r=>r.gross),i=t||this.bodies.some(r=>r.spin);return this.bodies.forEach((r,s)=>{if(i?!r.gross&&(t||!r.spin):!this.shafts.has(s))return;let o=new C().setFromMatrixColumn(this.rest[s],2);e.addScaledVector(o,e.dot(o)<0?-1:1)}),e.length()>1e-9?e.normalize():qh.clone()}},Wh=new ye,Xh=new ye,Ds=new C,lM=new C(1,1,1),Dr=new Ut,rd=new Ut;var m1=n=>n.length>1?(n[n.length-1]-n[0])/(n.length-1):1/0;function cM(n){let e=n.map(g=>g.times?.data??[]);if(e.length===1)return{times:e[0],whose:"",note:""};let t=e.map(m1),i=t[1]<t[0]?1:0,[r,s]=[e[i],e[1-i]],o=.5*Math.min(...t),a=[...s].filter(g=>!r.length||g<r[0]-o||g>r[r.length-1]+o),c=Float64Array.from([...r,...a]).sort();if(r.length===s.length&&r.every((g,x)=>Math.abs(g-s[x])<1e-6*o)||!Number.isFinite(t[1-i]))return{times:c,whose:"",note:""};let h=bl(n),[f,u]=[h[i],h[1-i]],d=`Time steps follow the frames of ${f}, every ${fr(t[i])}; the frames of ${u}, every ${fr(t[1-i])}, are interpolated linearly.`;return{times:c,whose:f,note:d}}var g1=2e-6,Ns={x:new C(1,0,0),y:new C(0,1,0),z:new C(0,0,1)},Yh=class{constructor(e,t){this.stage=e,this.changed=t,this.on=!1,this.normal=new C(0,0,1),this.base=new C(0,0,1),this.flipped=!1,this.places=e.pictures.map(()=>0),this.planes=e.pictures.map(()=>new zi);let[i]=Object.entries(Ns).reduce((r,s)=>Math.abs(s[1].dot(e.pictures[0].poses.axis()))>Math.abs(r[1].dot(e.pictures[0].poses.axis()))?s:r);this.enable=Cn("section (s)",!1,r=>this.turn(r)),this.axis=on("normal to",[...Object.keys(Ns).map(r=>[r,r]),["mesh","axis of the mesh"],["free","other"]],r=>this.along(r));for(let r of["mesh","free"])this.#t(r).hidden=!0;this.place=Y("input",{type:"range",min:"0",max:"1000",title:"Position of the section plane","aria-label":"Position of the section plane"}),this.place.addEventListener("input",()=>this.#l()),this.output=Y("output",{}),this.angles=Object.fromEntries(["turn","tilt"].map(r=>{let s=Y("input",{type:"range",min:"-90",max:"90",value:"0",title:`${r[0].toUpperCase()}${r.slice(1)} of the section plane`,"aria-label":`${r[0].toUpperCase()}${r.slice(1)} of the section plane`});return s.addEventListener("input",()=>this.#s()),[r,{input:s,output:Y("output",{})}]})),this.flip=Cn("flip side",!1,r=>{this.flipped=r,this.update(),t()}),this.rows=[this.enable.row,this.axis.row,Y("label",{className:"ppv-slider"},Y("span",{},"position"),this.place,this.output),...Object.entries(this.angles).map(([r,{input:s,output:o}])=>Y("label",{className:"ppv-slider"},Y("span",{},r),s,o)),Y("div",{className:"ppv-buttons"},xt("parallel to the screen","Section plane parallel to the screen (S)",()=>this.facing())),this.flip.row],e.section=this,this.along(i)}along(e){e in Ns&&this.#i(Ns[e],e),this.#a(this.#e()),this.#c()}#e(){let[{poses:e,data:t}]=this.stage.pictures,[i,r]=this.#o();if(Math.abs(this.normal.dot(e.axis()))>.1||!(r>i))return .5;let s=!t.bodies.some(({gross:a})=>a),o=t.bodies.map((a,c)=>(this.normal.dot(new C().setFromMatrixPosition(e.rest[c]))-i)/(r-i)).filter((a,c)=>!t.bodies[c].part&&(t.bodies[c].gross||s)).filter(a=>a>.05&&a<.95);return o.reduce((a,c)=>Math.abs(c-.5)<Math.abs(a-.5)?c:a,o[0]??.5)}facing(){let{camera:e,pictures:t}=this.stage,i=t[0].seen.clone().invert(),r=new C(0,0,1).applyQuaternion(e.quaternion),s=r.clone().transformDirection(i);this.#i(s,"free");let o=e.position.clone().addScaledVector(r,-e.distance).applyMatrix4(i),[a,c]=this.#o();this.#a(Math.max(0,Math.min(1,(s.dot(o)-a)/(c-a||1)))),this.#c(),this.#h(!0)}#t(e){return[...this.axis.select.options].find(({value:t})=>t===e)}#i(e,t){this.normal.copy(e).normalize(),this.base.copy(this.normal),this.#n(t);for(let{input:i}of Object.values(this.angles))i.value="0";this.#r()}#n(e){for(let t of["mesh","free"])this.#t(t).hidden=t!==e;this.axis.select.value=e}#r(){for(let{input:e,output:t}of Object.values(this.angles))t.textContent=`${e.value.replace("-","\u2212")}\xB0`}#s(){let[e,t]=["turn","tilt"].map(c=>Number(this.angles[c].input.value)*Math.PI/180),i=Math.abs(this.base.y)<.9?new C(0,1,0):new C(0,0,1);i.addScaledVector(this.base,-i.dot(this.base)).normalize();let r=new C().crossVectors(i,this.base),s=this.normal.clone();this.normal.copy(this.base).applyAxisAngle(r,t).applyAxisAngle(i,e),this.places=this.places.map((c,l)=>{let{pictures:h,alike:f}=this.stage,{low:u,high:d}=f?this.stage.bounds():h[l].bounds,g=u.clone().add(d).multiplyScalar(.5);return this.normal.dot(g.addScaledVector(s,c-s.dot(g)))}),(e||t)&&this.#n("free");let[o,a]=this.#o();this.place.value=String(1e3*(this.at-o)/(a-o||1)),this.#r(),this.#f(),this.update(),this.changed()}move(e){this.#a(Math.max(0,Math.min(1,Number(this.place.value)/1e3+e)))}set(e,t){let i=this.stage.pictures[0].poses.axis(),r=Array.isArray(e)?new C(...e):Ns[e]??i,s=Object.entries(Ns).find(([,c])=>c.dot(r)>1-1e-9);this.#i(r,s?s[0]:"free");let[o,a]=this.#o();this.#a(t===void 0?this.#e():(t-o)/(a-o||1)),this.#c(),this.#h(!0)}get at(){return this.places[0]}through(e,t){let i=Object.entries(Ns).find(([,a])=>Math.abs(a.dot(t))>.999999999);this.#i(i?i[1]:t,i?i[0]:"mesh"),this.flipped=this.normal.dot(t)<0,this.flip.input.checked=this.flipped;let r=e.findIndex(Boolean),[s,o]=this.#o(r);this.#a((this.normal.dot(e[r])-s)/(o-s||1)),e.forEach((a,c)=>a&&(this.places[c]=this.normal.dot(a))),this.#f(),this.#h(!0)}#o(e=0){let{alike:t,pictures:i}=this.stage,{low:r,high:s}=t?this.stage.bounds():i[e].bounds,o=1/0,a=-1/0;for(let c=0;c<8;c++){let l=new C(c&1?s.x:r.x,c&2?s.y:r.y,c&4?s.z:r.z).dot(this.normal);o=Math.min(o,l),a=Math.max(a,l)}return[o,a]}#l(){this.#a(Number(this.place.value)/1e3)}#a(e){this.places=this.places.map((t,i)=>{let[r,s]=this.#o(i);return r+e*(s-r)}),this.place.value=String(1e3*e),this.#f(),this.update(),this.changed()}#f(){let e=rh(1e3*Math.max(...this.#o().map(Math.abs)))(this.at*1e3);this.output.textContent=`${Number(e)===0?"0":e} mm`}#c(){let{camera:e,pictures:t}=this.stage;this.face(new C(0,0,1).applyQuaternion(e.quaternion),e.position,t[0].seen)}face(e,t,i=this.stage.pictures[0].seen){let r=i.clone().invert(),s=this.normal.dot(e.clone().transformDirection(r));Math.abs(s)>.001?this.flipped=s<0:t&&(this.flipped=this.normal.dot(t.clone().applyMatrix4(r))<this.at),this.flip.input.checked=this.flipped,this.update()}turn(e){e&&this.#c(),this.#h(e)}#h(e){this.on=e,this.enable.input.checked=e,this.stage.pictures.forEach(({solids:t,flanks:i},r)=>{for(let s of[t,i])s.cut(e?[this.planes[r]]:[])}),this.update(),this.changed()}removes(e,t){let i=this.normal.dot(e)-this.places[t];return(this.flipped?-i:i)>.001*this.stage.pictures[t].bounds.whole.radius}update(){let e=this.flipped?1:-1;this.planes.forEach((t,i)=>{t.normal.copy(this.normal).multiplyScalar(e),t.constant=-e*this.places[i]-g1*this.stage.pictures[i].bounds.whole.radius,t.applyMatrix4(this.stage.pictures[i].seen)})}};var hM=6,x1=.45,_1=40,v1=.06,M1=300,S1=8;function y1(){let n=new To(.19,.19,.72,12,1,!1).translate(0,.36,0),e=new Pc(.5,.3,16,1,!1).translate(0,.85,0),t=[n.toNonIndexed(),e.toNonIndexed()],i=s=>t.flatMap(o=>[...o.attributes[s].array]),r=new Tt;return r.setAttribute("position",new bt(i("position"),3)),r.setAttribute("normal",new bt(i("normal"),3)),r.rotateX(Math.PI/2)}var $h=class{constructor(e,t,i,r,s){this.arrows=e.arrows,this.poses=i,this.radius=s,this.scale=1,this.kinds=new Set(this.arrows.map(f=>f.kind)),this.shown=new Set(this.kinds),this.shown.delete("pair"),this.arrows.filter(f=>f.kind==="bearing").length>S1&&this.shown.delete("bearing"),this.hidden=!1,this.many=this.arrows.filter(({kind:f})=>f!=="pair").length>hM,this.sparse=this.many;let o=y1(),a=new Ro(.5,14,10),c=f=>new Rr({color:f,emissive:f,emissiveIntensity:.35}),l=Object.fromEntries(Cr.map(f=>[f,c(cl(r,f))]));this.states=Object.fromEntries(Object.entries(Fn).map(([f,{colour:u}])=>[f,c(u)]));let h=(f,u)=>{let d=new St(f,u);return d.matrixAutoUpdate=!1,t.add(d),d};this.drawn=this.arrows.map(f=>({parts:Object.fromEntries(Cr.filter(u=>(f.components??f.largest)?.[u]).map(u=>[u,h(o,l[u])])),ball:f.state?h(a,this.states[0]):null})),this.largest=this.arrows.map(f=>f.largest??Object.fromEntries(Cr.filter(u=>f.components?.[u]).map(u=>[u,pM(f.components[u].data)]))),this.size=Math.max(0,...this.arrows.map(f=>f.size??0))}grow(){let e=new C;this.arrows.forEach((t,i)=>{if(t.components){e.set(0,0,0);for(let[r,{data:s}]of Object.entries(t.components))this.largest[i][r]=Math.max(this.largest[i][r]??0,pM(s)),e.add(dM.fromArray(s));t.size=Math.max(t.size??0,e.length()),this.size=Math.max(this.size,t.size)}})}get share(){if(!this.sparse)return 1;let e=this.arrows.filter(({kind:t})=>this.shown.has(t)&&t!=="pair").length;return Math.max(x1,Math.min(1,Math.sqrt(hM/Math.max(e,1))))}get longest(){return .55*this.radius*this.scale*this.share}forces(){let{where:e}=this.poses;return this.arrows.map(t=>{if(t.now)return{name:t.name,kind:t.kind,unit:t.unit,...t.now()};let i=t.body<0?null:this.poses.still[t.body],r=new C(jt(t.at,e,0),jt(t.at,e,1),jt(t.at,e,2));i&&r.applyMatrix4(i);let s={},o={},a=new C;for(let f of Cr){let u=t.components?.[f];if(!u)continue;let d=new C(jt(u,e,0),jt(u,e,1),jt(u,e,2));o[f]=d.length(),a.add(d),i&&(fM.extractRotation(i),d.applyMatrix4(fM)),s[f]=d}let c=t.state?e.share===1?e.low+1:e.low:0,l=t.state?t.state.data[t.state.count>1?c:0]:null,h=l===255?-1:l;return{name:t.name,kind:t.kind,unit:t.unit??"N",state:h,vectors:s,values:o,at:r,total:a.length()}})}ends(){return this.hidden||!(this.size>0)?[]:this.forces().flatMap((e,t)=>this.shown.has(e.kind)?Object.entries(e.vectors).map(([i,r])=>{let s=this.longest*(this.largest[t][i]??0)/this.size;return r.clone().setLength(r.length()?s:0).add(e.at)}):[])}#e(e){let t=new Set,i=[],r=this.now.map((s,o)=>o).filter(s=>this.shown.has(this.now[s].kind));r.sort((s,o)=>(this.arrows[o].size??0)-(this.arrows[s].size??0));for(let s of r){let{kind:o,at:a}=this.now[s],c=e?.(a);if(!c?.removed){if(c&&this.sparse&&o!=="pair"){let l=h=>h.kind===o&&Math.hypot(h.x-c.x,h.y-c.y)<_1;if(i.some(l))continue;i.push({...c,kind:o})}t.add(s)}}return t}update(e,t){this.now=this.forces();let i=this.hidden?new Set:this.#e(t),r=this.sparse?v1*this.size:0,s=Math.min(this.longest,M1*this.scale*this.share*e||1/0);this.perForce=i.size&&this.size>0?s/this.size:0,this.now.forEach((o,a)=>{let c=i.has(a),{parts:l,ball:h}=this.drawn[a],f=this.share*Math.min(.055*this.radius*Math.sqrt(this.scale),22*e||1/0);for(let[u,d]of Object.entries(l)){let g=o.vectors[u],x=this.size>0?s*g.length()/this.size:0,m=c&&(o.kind==="pair"||(this.largest[a][u]??0)>r);if(d.visible=m&&x>2*e&&x>0,!d.visible)continue;let p=Math.min(f,.5*x);uM.copy(g).normalize(),d.matrix.compose(o.at,b1.setFromUnitVectors(qh,uM),dM.set(p,p,x))}h&&(h.visible=c,h.material=this.states[o.state]??this.states[0],h.matrix.makeScale(.6*f,.6*f,.6*f).setPosition(o.at))})}},fM=new ye,b1=new Ut,uM=new C,dM=new C;function pM(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}var Kh=class extends Hi{distance=1;get parallel(){return this.isPerspectiveCamera===!1}set parallel(e){this.isPerspectiveCamera=!e,this.isOrthographicCamera=e,this.updateProjectionMatrix()}updateProjectionMatrix(){if(!this.parallel){super.updateProjectionMatrix();return}let e=this.distance*Math.tan(this.fov*Math.PI/360)/this.zoom,t=2*e,i=this.aspect*t,r=-i/2,{view:s}=this;s?.enabled&&(r+=s.offsetX*i/s.fullWidth,e-=s.offsetY*t/s.fullHeight,i*=s.width/s.fullWidth,t*=s.height/s.fullHeight),this.projectionMatrix.makeOrthographic(r,r+i,e,e-t,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}};var w1=Math.PI/180,sd=[[45,1],[135,1],[45,.6],[135,.6],[30,1.4],[150,1.4],[60,.8],[120,.8]].map(([n,e])=>({angle:n*w1,spacing:e}));function mM(n){let e=[];return n.forEach((t,i)=>{let r=sd.map(()=>0);for(let s=0;s<i;s++)E1(t,n[s])&&r[e[s]]++;e.push(r.indexOf(Math.min(...r)))}),e}function E1(n,e){let t=.001*Math.max(n.low.distanceTo(n.high),e.low.distanceTo(e.high));return["x","y","z"].every(i=>n.low[i]<=e.high[i]+t&&e.low[i]<=n.high[i]+t)}function gM({geometry:n},e){n.boundingBox??n.computeBoundingBox();let t=n.boundingBox.clone().applyMatrix4(e);return{low:t.min,high:t.max}}function xM({attributes:n,index:e}){let{array:t}=n.position,[i,r,s,o]=[0,0,0,0].map(()=>new C),a=0;for(let c=0;c<e.count;c+=3)i.fromArray(t,3*e.array[c]),r.fromArray(t,3*e.array[c+1]).sub(i),s.fromArray(t,3*e.array[c+2]).sub(i),r.cross(s),o.add(r),a+=r.length();return o.length()<=1e-4*a}var T1=new ye,Zh=new zi;function ad(n,e,t,i){Zh.copy(t).applyMatrix4(T1.copy(e).invert());let{center:r,radius:s}=n.boundingSphere;if(Math.abs(Zh.distanceToPoint(r))>s)return;let{array:o}=n.attributes.position,a=n.index.array,{x:c,y:l,z:h}=Zh.normal,f=o.length/3;od.length<f&&(od=new Float64Array(2*f));let u=od;for(let x=0;x<f;x++)u[x]=c*o[3*x]+l*o[3*x+1]+h*o[3*x+2]+Zh.constant;let d=e.elements,g=(x,m)=>{let p=u[x]/(u[x]-u[m]),_=o[3*x]+p*(o[3*m]-o[3*x]),y=o[3*x+1]+p*(o[3*m+1]-o[3*x+1]),S=o[3*x+2]+p*(o[3*m+2]-o[3*x+2]);i.push(d[0]*_+d[4]*y+d[8]*S+d[12],d[1]*_+d[5]*y+d[9]*S+d[13],d[2]*_+d[6]*y+d[10]*S+d[14])};for(let x=0;x<a.length;x+=3){let m=a[x],p=a[x+1],_=a[x+2],y=(u[m]>=0)+2*(u[p]>=0)+4*(u[_]>=0);if(y===0||y===7)continue;let S=y===1||y===6?m:y===2||y===5?p:_,[R,A]=S===m?[p,_]:S===p?[_,m]:[m,p];g(S,R),g(S,A)}}var od=new Float64Array(1024);var ld=["shaft","element","bearing","gear","carrier","spring","body","housing"],A1=9,R1=new C(0,0,1),MM=127,SM=128;function _M(n){return new In({side:n?$t:Yi,colorWrite:!1,depthWrite:!1,depthTest:!1,stencilWrite:!0,stencilFunc:Zl,stencilWriteMask:MM,stencilZPass:n?hp:fp})}function C1(){return new Gi({uniforms:{paint:{value:new ke},line:{value:new ke},across:{value:new C},phase:{value:0},opacity:{value:1}},vertexShader:`varying vec2 at;
      void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,fragmentShader:`varying vec2 at;
      uniform vec3 paint, line, across;
      uniform float phase, opacity;
      void main() {
        float s = dot(at, across.xy) + phase;
        float wide = max(length(vec2(dFdx(s), dFdy(s))), 1e-9);
        float inked = 1.0 - smoothstep(0.35, 1.15, abs(fract(s) - 0.5) / wide);
        gl_FragColor = vec4(mix(paint, line, inked * min(1.0, 0.25 / wide)), opacity);
        #include <colorspace_fragment>
      }`,side:Ei,depthFunc:ls,stencilWrite:!0,stencilFunc:dp,stencilFuncMask:MM,stencilRef:SM,stencilZPass:Cf,stencilZFail:Cf})}var Qh=class{constructor(e,t){this.solids=e,this.whole=t.whole;let i=new Tt;i.setAttribute("position",new bt([-1,-1,0,1,-1,0,1,1,0,-1,1,0],3)),i.setIndex([0,1,2,0,2,3]),this.counters=[!1,!0].map(()=>[_M(!0),_M(!1)]),this.face=new St(i,C1()),this.face.matrixAutoUpdate=!1,this.face.frustumCulled=!1,this.lines=new el(new Tt,new vs({stencilWrite:!0,stencilFunc:up,stencilFuncMask:SM})),this.lines.matrixAutoUpdate=!1,this.lines.frustumCulled=!1}#e(){let{parts:e,batches:t,poses:i}=this.solids;if(this.members)return this.members;let r=l=>({part:l,objects:l.repeated?.meshes??[l.mesh],colour:new ke(l.colour),kind:l.solid.kind,shows:()=>this.solids.shows(l),clear:l.solid.see_through}),s=l=>({batch:l,objects:[l],colour:new ke("#9aa5b1"),kind:"body",shows:()=>!0,clear:!1}),o=t.length?t.map(s):e.filter(l=>xM(l.geometry)).map(r),a=t.length?o.map(()=>0):mM(o.map(({part:l})=>gM(l,i.ofSolid(l.solid))));o.forEach((l,h)=>l.hatch=sd[a[h]]);let c=({kind:l})=>(ld.indexOf(l)+ld.length)%ld.length;return this.members=o.sort((l,h)=>c(l)-c(h))}state(){return Object.fromEntries((this.shown??[]).map(({part:e,hatch:t})=>[e?.solid.name??"",t]))}render(e,t,i,r,s,o){for(let c of this.counters.flat())c.clippingPlanes=[i];let a=2**Math.round(Math.log2(A1*s));this.#i(i,r,a),this.shown=[];for(let c of this.#e()){if(!c.shows()||!this.#r(c,i))continue;let l=c.batch?[]:this.#o(c,i);!c.batch&&!l.length||(this.shown.push(c),!(l.length&&!this.#t(e,t,l,o))&&(this.#l(e,t,l,c,i,s),this.#s(e,t,c),this.#n(c,a),e.render(this.face,t)))}e.setScissor(o.left,0,o.width,o.height),this.shown.length&&e.clearStencil()}#t(e,t,i,{left:r,width:s,height:o}){vM.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse);let a=vM.elements,[c,l,h,f]=[1,-1,1,-1];for(let p=0;p<i.length;p+=3){let _=i[p],y=i[p+1],S=i[p+2],R=a[3]*_+a[7]*y+a[11]*S+a[15];if(R<=0){[c,l,h,f]=[-1,1,-1,1];break}let A=(a[0]*_+a[4]*y+a[8]*S+a[12])/R,v=(a[1]*_+a[5]*y+a[9]*S+a[13])/R;c=Math.min(c,A),l=Math.max(l,A),h=Math.min(h,v),f=Math.max(f,v)}let u=(p,_,y)=>Math.max(0,Math.min(_,y((p+1)/2*_))),d=u(c,s,Math.floor),g=u(h,o,Math.floor),x=u(l,s,Math.ceil)-d,m=u(f,o,Math.ceil)-g;return x<=0||m<=0?!1:(e.setScissor(r+d,g,x,m),!0)}#i(e,t,i){let r=e.projectPoint(this.whole.centre.clone().applyMatrix4(t),new C);Jh.setFromUnitVectors(R1,e.normal);let{radius:s}=this.whole,o=1.5*s;this.face.matrix.compose(r,Jh,P1.set(o,o,1)),this.face.matrixWorldNeedsUpdate=!0,this.half=o,this.x=r.dot(new C(1,0,0).applyQuaternion(Jh))/i,this.y=r.dot(new C(0,1,0).applyQuaternion(Jh))/i}#n({colour:e,hatch:t,clear:i},r){let{uniforms:s}=this.face.material,o=r*t.spacing,[a,c]=[-Math.sin(t.angle),Math.cos(t.angle)];s.across.value.set(a*this.half/o,c*this.half/o,0);let l=(a*this.x+c*this.y)/t.spacing;s.phase.value=l-Math.floor(l),s.paint.value.copy(e),s.line.value.copy(e).multiplyScalar(.3),s.opacity.value=i?.75:1,this.face.material.transparent=!!i}#r({part:e,batch:t},i){return t?!0:(cd.copy(e.geometry.boundingSphere).applyMatrix4(e.mesh.matrixWorld),e.blend||e.modal||Math.abs(i.distanceToPoint(cd.center))<=cd.radius)}#s(e,t,{objects:i,batch:r}){let s=i.map(({material:o})=>o);for(let o of this.counters[+!!i[0].isInstancedMesh]){let a=r?r.adapted(o):o;for(let c of i)c.material=a;for(let c of i)c.visible&&e.render(c,t)}i.forEach((o,a)=>o.material=s[a])}#o({part:e},t){let i=[];if(!e.repeated)return(e.blend||e.modal)&&e.geometry.computeBoundingSphere(),ad(e.geometry,e.mesh.matrixWorld,t,i),i;for(let{turns:r,levels:s}of e.repeated.pieces)for(let{geometry:o,shown:a}of s)for(let c of a)ad(o,L1.makeRotationZ(r[c]).premultiply(e.mesh.matrixWorld),t,i);return i}#l(e,t,i,{colour:r},s,o){if(!i.length)return;let{geometry:a}=this.lines,[c,l,h]=i,f=new Float32Array(i.length);for(let u=0;u<i.length;u+=3)f[u]=i[u]-c,f[u+1]=i[u+1]-l,f[u+2]=i[u+2]-h;a.dispose(),a.setAttribute("position",new bt(f,3)),this.lines.matrix.setPosition(new C(c,l,h).addScaledVector(s.normal,-.7*o)),this.lines.matrixWorldNeedsUpdate=!0,this.lines.material.color.copy(r).multiplyScalar(.16),e.render(this.lines,t)}},Jh=new Ut,P1=new C,L1=new ye,vM=new ye,cd=new Bi;var Tl=1024,ef=class extends St{constructor(e,t){let i=x=>e.reduce((m,p)=>m+x(p.geometry),0),r=i(x=>x.attributes.position.count),s=new Float32Array(3*r),o=new Float32Array(3*r),a=new Uint8Array(3*r),c=new Float32Array(r),l=new Uint32Array(i(x=>x.index.count)),h=new ke,f=0,u=0;e.forEach(({geometry:x,colour:m},p)=>{let{array:_}=x.attributes.position;s.set(_,3*f),o.set(x.attributes.normal.array,3*f),h.set(m);let y=[h.r,h.g,h.b].map(S=>Math.round(255*S));for(let S=f;S<f+_.length/3;S++)c[S]=p,a.set(y,3*S);for(let S of x.index.array)l[u++]=f+S;f+=_.length/3});let d=new Tt;d.setAttribute("position",new Pt(s,3)),d.setAttribute("normal",new Pt(o,3)),d.setAttribute("color",new Pt(a,3,!0)),d.setAttribute("member",new Pt(c,1)),d.setIndex(new Pt(l,1)),super(d,t),this.parts=e,this.first=[],e.reduce((x,{geometry:{attributes:m}})=>(this.first.push(x),x+m.position.array.length),0);let g=Math.ceil(4*e.length/Tl);this.places=new Tr(new Float32Array(4*Tl*g),Tl,g,Oi,ui),this.frustumCulled=!1,this.matrixAutoUpdate=!1,t.vertexColors=!0,this.#e(t)}#e(e){e.onBeforeCompile=t=>{t.uniforms.places={value:this.places},t.vertexShader=`attribute float member;
        uniform highp sampler2D places;
        mat4 placeOf() {
          int at = 4 * int(member + 0.5);
          ivec2 t = ivec2(at % ${Tl}, at / ${Tl});
          return mat4(texelFetch(places, t, 0), texelFetch(places, t + ivec2(1, 0), 0),
            texelFetch(places, t + ivec2(2, 0), 0), texelFetch(places, t + ivec2(3, 0), 0));
        }
        ${t.vertexShader}`.replace("#include <beginnormal_vertex>",`#include <beginnormal_vertex>
objectNormal = mat3(placeOf()) * objectNormal;`).replace("#include <begin_vertex>","vec3 transformed = (placeOf() * vec4(position, 1.0)).xyz;")},e.customProgramCacheKey=()=>"batch"}adapted(e){if(this.others??=new Map,!this.others.has(e)){let i=e.clone();this.#e(i),this.others.set(e,i)}let t=this.others.get(e);return t.clippingPlanes=e.clippingPlanes,t}place(e,t){this.places.image.data.set(t.elements,16*e),this.places.needsUpdate=!0}bend(e){let{attributes:t}=this.parts[e].geometry;for(let i of["position","normal"]){let{array:r}=t[i],s=this.geometry.attributes[i];s.array.set(r,this.first[e]),s.addUpdateRange(this.first[e],r.length),s.needsUpdate=!0}}raycast(e,t){this.parts.forEach((i,r)=>{jh.geometry=i.geometry,jh.material=this.material,jh.matrixWorld.fromArray(this.places.image.data,16*r).premultiply(this.matrixWorld);let s=[];jh.raycast(e,s);for(let o of s)t.push({...o,object:this,member:r})})}},jh=new St;function tf(n,e,t=40){let i=n.length/3,r=e.length/3,s=new Float64Array(3*r),o=new Float64Array(r);for(let x=0;x<r;x++){let[m,p,_]=[3*e[3*x],3*e[3*x+1],3*e[3*x+2]],y=n[p]-n[m],S=n[p+1]-n[m+1],R=n[p+2]-n[m+2],A=n[_]-n[m],v=n[_+1]-n[m+1],E=n[_+2]-n[m+2],F=S*E-R*v,D=R*A-y*E,N=y*v-S*A,k=Math.hypot(F,D,N);o[x]=k,k&&s.set([F/k,D/k,N/k],3*x)}let a=new Uint32Array(i+1);for(let x=0;x<e.length;x++)a[e[x]+1]++;for(let x=0;x<i;x++)a[x+1]+=a[x];let c=a.slice(0,i),l=new Uint32Array(e.length);for(let x=0;x<e.length;x++)l[c[e[x]]++]=x;let h=Math.cos(t*Math.PI/180),f=[],u=[],d=[],g=new Uint32Array(e.length);for(let x=0;x<i;x++){let m=[];for(let p=a[x];p<a[x+1];p++){let _=3*(l[p]/3|0),y=0,S=0,R=0;for(let E=a[x];E<a[x+1];E++){let F=l[E]/3|0;s[_]*s[3*F]+s[_+1]*s[3*F+1]+s[_+2]*s[3*F+2]<h||(y+=o[F]*s[3*F],S+=o[F]*s[3*F+1],R+=o[F]*s[3*F+2])}let A=Math.hypot(y,S,R)||1;y/=A,S/=A,R/=A;let v=m.find(E=>Math.abs(u[3*E]-y)+Math.abs(u[3*E+1]-S)+Math.abs(u[3*E+2]-R)<1e-6);v===void 0&&(v=d.length,m.push(v),d.push(x),f.push(n[3*x],n[3*x+1],n[3*x+2]),u.push(y,S,R)),g[l[p]]=v}}return{points:Float32Array.from(f),normals:Float32Array.from(u),index:g,source:Uint32Array.from(d)}}var yM=Math.PI*(3-Math.sqrt(5));function bM(n){return Array.from({length:n},(e,t)=>{let i=1-(2*t+1)/n,r=Math.sqrt(1-i*i);return new C(r*Math.cos(yM*t),r*Math.sin(yM*t),i)})}function wM(n,e){let{array:t,count:i}=n,r=new Set;for(let{x:s,y:o,z:a}of i?e:[]){let c=0,l=-1/0;for(let h=0;h<i;h++){let f=s*t[3*h]+o*t[3*h+1]+a*t[3*h+2];f>l&&([c,l]=[h,f])}r.add(c)}return[...r].map(s=>new C().fromBufferAttribute(n,s))}var D1=.35;function sf({points:n,normals:e,index:t}){let i=new Tt;return i.setAttribute("position",new Pt(n,3)),i.setAttribute("normal",new Pt(e,3)),i.setIndex(n.length/3<65536?new Pt(Uint16Array.from(t),1):new Pt(Uint32Array.from(t),1)),i.computeBoundingSphere(),i}function ud(n,e){let t=Math.cos(e),i=Math.sin(e),r=new Float32Array(n.length);for(let s=0;s<n.length;s+=3)r[s]=t*n[s]-i*n[s+1],r[s+1]=i*n[s]+t*n[s+1],r[s+2]=n[s+2];return r}function N1(n,e,t){let i=n.points.data,r=n.triangles.data,s=i.length/3,o=0;for(let m of i)o=Math.max(o,Math.abs(m));let a=new Map,c=[],l=(m,p,_)=>{let y=[m,p,_].map(S=>Math.round(S/o*2e5)).join();return a.has(y)||(a.set(y,c.length/3),c.push(m,p,_)),a.get(y)},h=[];for(let m of[0,-1,1]){let p=m?ud(i,m*e):i,_=Array.from({length:s},(y,S)=>l(p[3*S],p[3*S+1],p[3*S+2]));for(let y of r)h.push(_[y])}let f=tf(Float32Array.from(c),Uint32Array.from(h),t),u=f.index.subarray(0,r.length),d=new Map,g=Uint32Array.from(u,m=>(d.has(m)||d.set(m,d.size),d.get(m))),x=m=>{let p=new Float32Array(3*d.size);for(let[_,y]of d)p.set(m.subarray(3*_,3*_+3),3*y);return p};return sf({points:x(f.points),normals:x(f.normals),index:g})}var EM=new ye,hd=new ye,nf=new ye,fd=new Bi,TM=new hn,I1=new C,rf=class extends Sn{constructor(e,t){super();let{solid:i}=e;this.matrixAutoUpdate=!1;let r=2*Math.PI/Math.max(i.teeth||0,2);this.pieces=i.pieces.map(s=>{let o=Array.from(s.turns.data),a=s.levels.map(f=>{let u=N1(f,r,i.creases??40),d=new Qa(u,t(s.fault),o.length);return d.instanceMatrix=new Jr(new Float32Array(16*o.length),16),d.frustumCulled=!1,d.matrixAutoUpdate=!1,d.count=0,d.visible=!1,Object.assign(d.userData,{part:e,fault:s.fault}),this.add(d),{error:f.error,geometry:u,mesh:d,shown:[]}}),{center:c,radius:l}=a[a.length-1].geometry.boundingSphere,h=o.map(f=>c.clone().applyMatrix4(EM.makeRotationZ(f)));return{turns:o,levels:a,centres:h,radius:l}})}get meshes(){return this.pieces.flatMap(({levels:e})=>e.map(({mesh:t})=>t))}get drawn(){return this.meshes.reduce((e,t)=>e+(t.visible?t.count*t.geometry.index.count/3:0),0)}get finest(){return this.pieces.reduce((e,{turns:t,levels:i})=>e+t.length*i[i.length-1].geometry.index.count/3,0)}choose(e,t,i){hd.multiplyMatrices(e,this.matrix),nf.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),TM.setFromProjectionMatrix(nf),nf.multiplyMatrices(t.matrixWorldInverse,hd);for(let r of this.pieces){let s=r.levels.map(()=>[]);r.centres.forEach((o,a)=>{if(fd.center.copy(o).applyMatrix4(hd),fd.radius=r.radius,!TM.intersectsSphere(fd))return;let c=t.parallel?t.distance:Math.max(-I1.copy(o).applyMatrix4(nf).z-r.radius,t.near),l=D1*i*c,h=r.levels.findIndex(({error:f})=>f<=l);h<0&&(h=r.levels.length-1),s[h].push(a)}),r.levels.forEach((o,a)=>this.#e(r,o,s[a]))}}#e(e,t,i){let{mesh:r}=t;i.length===t.shown.length&&i.every((s,o)=>s===t.shown[o])||(t.shown=i,i.forEach((s,o)=>EM.makeRotationZ(e.turns[s]).toArray(r.instanceMatrix.array,16*o)),r.instanceMatrix.needsUpdate=!0,r.count=i.length,r.visible=i.length>0,r.boundingSphere=null)}whole(e){let t=this.pieces.flatMap(({turns:l,levels:h})=>{let f=h.length-(h.length>2?2:1),{geometry:u}=h[e==="fine"?f:0];return l.map(d=>({geometry:u,turn:d}))}),i=l=>t.reduce((h,{geometry:f})=>h+l(f),0),r=new Float32Array(i(({attributes:l})=>l.position.array.length)),s=new Float32Array(r.length),o=new Uint32Array(i(l=>l.index.count)),[a,c]=[0,0];for(let{geometry:l,turn:h}of t){r.set(ud(l.attributes.position.array,h),a),s.set(ud(l.attributes.normal.array,h),a);for(let f of l.index.array)o[c++]=a/3+f;a+=l.attributes.position.array.length}return sf({points:r,normals:s,index:o})}};var U1=new ye,of=(n,e)=>e<0?U1:n[e],af=class{constructor(e,t,i,r){this.blend=e,this.geometry=t,this.source=i,this.poses=r,this.points=t.attributes.position.array.slice(),this.normals=t.attributes.normal.array.slice();let s=of(r.rest,e.bodies[0]);this.toBody=e.bodies.map(o=>of(r.rest,o).clone().invert().multiply(s)),this.moved=e.bodies.map(()=>new ye),this.drawn=e.bodies.map(()=>new ye)}update(e,t){let{blend:i,poses:r,moved:s,drawn:o}=this,a=of(r.world,i.bodies[0]).clone().invert(),c=0;if(s.forEach((g,x)=>{g.multiplyMatrices(a,of(r.world,i.bodies[x])).multiply(this.toBody[x]);for(let m=0;m<16;m++)c=Math.max(c,Math.abs(g.elements[m]-o[x].elements[m])*(m<12?t:1))}),c<=e)return!1;s.forEach((g,x)=>o[x].copy(g));let{position:l,normal:h}=this.geometry.attributes,{first:f,second:u,weight:d}=i;for(let g=0;g<this.source.length;g++){let x=this.source[g],m=u.data[x],p=d.data[x],_=o[f?f.data[x]:0].elements,y=o[m].elements,S=this.points[3*g],R=this.points[3*g+1],A=this.points[3*g+2],v=this.normals[3*g],E=this.normals[3*g+1],F=this.normals[3*g+2];for(let D=0;D<3;D++){let N=_[D]+p*(y[D]-_[D]),k=_[4+D]+p*(y[4+D]-_[4+D]),G=_[8+D]+p*(y[8+D]-_[8+D]);l.array[3*g+D]=N*S+k*R+G*A+_[12+D]+p*(y[12+D]-_[12+D]),h.array[3*g+D]=N*v+k*E+G*F}}return l.needsUpdate=h.needsUpdate=!0,this.geometry.computeBoundingSphere(),!0}};var lf=class{constructor(e,t,i,r){this.name=e.name,this.geometry=t,this.poses=r;let{shapes:s,node:o,coordinates:a}=e.modal;this.shapes=s.data,this.count=s.shape[0],this.nodes=s.shape[1],this.node=Uint32Array.from(i,c=>o.data[c]),this.points=t.attributes.position.array.slice(),this.coordinates=a,this.mean=a&&Fo(a),this.drawn=new Float64Array(this.count),this.moved=new Float64Array(3*this.nodes)}#e(){let{mode:e,magnification:t,where:i}=this.poses;return this.drawn.map((r,s)=>{if(e){let a=e.shape.modal?.[this.name];return a?e.cosine*a.data[2*s]+e.sine*a.data[2*s+1]:0}if(!this.coordinates)return 0;let o=jt(this.coordinates,i,s);return t===1?o:this.mean[s]+t*(o-this.mean[s])})}largest(e){let t=e.modal?.[this.name],i=0;for(let r=0;t&&r<this.nodes;r++){let s=0;for(let o=0;o<6;o++){let a=0;for(let c=0;c<this.count;c++)a+=t.data[2*c+o%2]*this.shapes[3*(this.nodes*c+r)+(o>>1)];s+=a*a}i=Math.max(i,Math.sqrt(s))}return i}update(){let e=this.#e();if(e.every((i,r)=>i===this.drawn[r]))return!1;this.drawn=e,this.moved.fill(0);for(let i=0;i<this.count;i++){let r=3*this.nodes*i;for(let s=0;s<this.moved.length;s++)this.moved[s]+=e[i]*this.shapes[r+s]}let{position:t}=this.geometry.attributes;for(let i=0;i<this.node.length;i++)for(let r=0;r<3;r++)t.array[3*i+r]=this.points[3*i+r]+this.moved[3*this.node[i]+r];return t.needsUpdate=!0,this.geometry.computeBoundingSphere(),!0}};var AM=300,F1=2.5,O1=new ye().multiplyScalar(0);function RM(n,e){let t=new Rr({color:n});return e&&Object.assign(t,{transparent:!0,opacity:.22,depthWrite:!1}),t}var B1=new Set(["gear","bearing","element"]),cf=class{constructor(e,t,i){this.solids=e.solids,this.root=t,this.poses=i,this.known=new Map;let r={};this.parts=e.solids.map(s=>{let o=r[s.kind]=(r[s.kind]??-1)+1,a={solid:s,colour:n_(s.kind,o,s.schematic)};if(s.pieces)a.repeated=new rf(a,l=>this.#e(a,l,"repeated")),a.geometry=a.repeated.whole("coarse");else{let l=tf(s.points.data,s.triangles.data,s.creases??40);a.geometry=sf(l),a.blend=s.blend?new af(s.blend,a.geometry,l.source,i):null,a.modal=s.modal?new lf(s,a.geometry,l.source,i):null}let c=a.geometry.attributes.position.array;return Object.assign(a,{radius:z1(c),rim:k1(c)})}),this.triangles=this.parts.reduce((s,o)=>s+(o.repeated?.finest??o.geometry.index.count/3),0),this.meshes=[],this.batches=[],this.parts.length>AM?this.#i():this.#t(),this.update(0)}#e({colour:e,solid:t},i="",r=""){let s=[e,!!t.see_through,!!i,r].join();if(!this.known.has(s)){let o=i?new ke(e).lerp(new ke(i_),.55):e;this.known.set(s,RM(o,t.see_through))}return this.known.get(s)}get materials(){return[...this.known.values()]}#t(){for(let e of this.parts){let t=e.repeated??new St(e.geometry,this.#e(e));t.matrixAutoUpdate=!1,t.renderOrder=e.solid.see_through?1:0,t.userData.part=e,e.mesh=t,this.meshes.push(...e.repeated?.meshes??[t]),this.root.add(t)}}#i(){for(let e of[!1,!0]){let t=this.parts.filter(s=>!!s.solid.see_through===e);if(!t.length)continue;let i=RM("#ffffff",e),r=new ef(t,i);t.forEach((s,o)=>Object.assign(s,{batch:r,member:o,repeated:null})),r.renderOrder=e?1:0,this.known.set(`batch ${e}`,i),this.batches.push(r),this.root.add(r)}}update(e){for(let t of this.parts){let i=this.poses.ofSolid(t.solid),r=[t.blend?.update(e,t.radius),t.modal?.update()].some(Boolean);t.batch?(t.batch.place(t.member,this.shows(t)?i:O1),r&&t.batch.bend(t.member)):t.mesh.matrix.copy(i)}}choose(e,t,i){for(let{repeated:r}of this.parts)r?.choose(e,t,i)}exported(e){return this.parts.filter(t=>this.shows(t)).map(t=>{let i=t.repeated?t.repeated.whole("fine"):t.geometry,{solid:r}=t;if(!e||!(r.place||r.axes||r.between))return{...t,geometry:i};let s=this.poses.ofSolid(r).clone(),o=r.between?r.between.bodies[0]:r.body;return o>=0&&s.premultiply(this.poses.world[o].clone().invert()),{...t,solid:{...r,body:o},geometry:i.clone().applyMatrix4(s)}})}get drawn(){return this.parts.reduce((e,t)=>e+(t.repeated?.drawn??(this.shows(t)?t.geometry.index.count/3:0)),0)}cut(e){for(let t of this.materials)t.clippingPlanes=e.length?e:null,t.side=e.length?Ei:Yi,t.needsUpdate=!0}cover(e){let t=new Set;for(let i of this.parts){if(!i.solid.see_through)continue;i.hidden=e==="hidden",this.#n(i);let r=i.batch?.material??i.mesh.material;t.has(r)||(t.add(r),Object.assign(r,e==="solid"?{transparent:!1,opacity:1,depthWrite:!0}:{transparent:!0,opacity:.22,depthWrite:!1}),r.needsUpdate=!0)}}schematics(e){this.plain=!e;for(let t of this.parts)t.solid.schematic&&this.#n(t)}shows(e){return!e.hidden&&!(this.plain&&e.solid.schematic)}#n(e){e.mesh&&(e.mesh.visible=this.shows(e))}hit(e){let i=e.intersectObjects([...this.meshes,...this.batches].filter(r=>r.visible),!1).map(({object:r,member:s,point:o})=>({part:r.userData.part??r.parts[s],fault:r.userData.fault??"",point:o})).filter(({part:r})=>this.shows(r));return i.find(({part:r,point:s})=>!r.solid.see_through&&this.#r(s))??i.find(({point:r})=>this.#r(r))??null}#r(e){return!this.materials[0]?.clippingPlanes?.some(t=>t.distanceToPoint(e)<0)}bounds(){let e=this.parts.filter(({solid:o})=>!o.see_through||o.schematic),t=this.#s(this.parts),i=e.length&&e.length<this.parts.length?this.#s(e):t,r=t.radius<F1*i.radius?t:i,s=this.parts.filter(({solid:o})=>B1.has(o.kind)&&!o.schematic);return{...r,size:i.radius,whole:t,drive:s.length?this.#s(s).radius:i.radius}}#s(e){let t=new C(1/0,1/0,1/0),i=t.clone().negate(),r=new C,s=[],o=bM(this.parts.length>AM?6:64);for(let a of e){let c=this.poses.ofSolid(a.solid),{center:l,radius:h}=a.geometry.boundingSphere;a.geometry.computeBoundingBox();let{min:f,max:u}=a.geometry.boundingBox;if(h>=0){a.reaches??=wM(a.geometry.attributes.position,o);for(let d of a.reaches)s.push(d.clone().applyMatrix4(c));for(let d=0;d<8;d++)r.set(d&1?u.x:f.x,d&2?u.y:f.y,d&4?u.z:f.z),r.sub(l).clampLength(0,h).add(l).applyMatrix4(c),t.min(r),i.max(r)}}return i.x>=t.x?{centre:t.clone().add(i).multiplyScalar(.5),radius:Math.max(t.distanceTo(i)/2,1e-9),low:t,high:i,outline:s}:{centre:r.set(0,0,0),radius:1,low:r.clone().set(-1,-1,-1),high:r.clone().set(1,1,1),outline:s}}reachOf(e){return Math.max(0,...this.parts.filter(t=>t.solid.body===e).map(t=>t.radius))}};function k1(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1]));return e}function z1(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}var G1=/swiftshader|llvmpipe|softpipe|software|basic render/i;function PM(){try{let n=document.createElement("canvas").getContext("webgl2");if(!n)return null;let e=n.getExtension("WEBGL_debug_renderer_info"),t=String(n.getParameter(e?e.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),{software:G1.test(t)}}catch{return null}}var H1=1400,CM={size:1.5,away:.5},dd=class{constructor(e,t,i){this.data=e,this.camera=i,this.seen=new ye,this.factor=1,this.centre=new C,this.scene=new uo,this.over=new uo,this.root=new Sn,this.overRoot=new Sn,this.root.matrixAutoUpdate=this.overRoot.matrixAutoUpdate=!1,this.scene.add(this.root),this.over.add(this.overRoot),this.lights=[this.scene,this.over].map(r=>{let s=new il("#ffffff",2.1),o=new tl("#ffffff","#8f98a3",1.25);return r.add(s,s.target,o),{light:s,sky:o}}),this.poses=new Zo(e),this.solids=new cf(e,this.root,this.poses),this.bounds=this.solids.bounds(),this.caps=new Qh(this.solids,this.bounds),this.flanks=new ah(e,this.root,this.overRoot,this.poses),this.arrows=new $h({arrows:[...e.arrows,...this.flanks.pairs()]},this.overRoot,this.poses,t,this.bounds.size)}},V1=3,hf=class{constructor(e,t,i){this.host=e,this.software=i,this.renderer=new ll({antialias:!i,stencil:!0,powerPreference:"high-performance"}),this.renderer.autoClear=!1,this.renderer.localClippingEnabled=!0,this.canvas=this.renderer.domElement,this.canvas.className="ppv-canvas",e.append(this.canvas),this.camera=new Kh(28,1,.01,100),this.pictures=t.map((l,h)=>new dd(l,e,h?this.camera.clone():this.camera)),this.alike=W1(this.pictures);let[{bounds:r}]=this.pictures;this.meet(this.pictures.map(()=>new C),this.pictures.map(l=>l.bounds.size));let s=Math.max(...this.pictures.map(l=>l.arrows.size)),o=({size:l,drive:h})=>Math.min(l,V1*h),a=this.alike?Math.max(...this.pictures.map(l=>o(l.bounds))):o(r),c=Math.max(...this.pictures.map(l=>l.flanks.greatest));for(let{arrows:l,flanks:h,factor:f}of this.pictures)Object.assign(l,{size:s,radius:f*a}),h.greatest=c;this.background=new ke("#ffffff"),this.size={width:1,height:1},this.drawn=0,this.coarse=!1,this.large=!1,this.shift=0,this.drop=0}coarsen(e){return e===this.coarse?!1:(this.coarse=e,this.resize(),!0)}enlarge(e){this.large=e,this.resize()}get ratio(){return this.large?Math.min(Math.max(H1/this.size.width,1),4):this.coarse?.6:this.software?1:Math.min(window.devicePixelRatio||1,2)}resize(){let{clientWidth:e,clientHeight:t}=this.host;if(!(!e||!t)){this.size={width:e,height:t},this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(e,t);for(let{camera:i}of this.pictures)i.aspect=e/this.pictures.length/t,i.updateProjectionMatrix()}}get parallel(){return this.camera.parallel}set parallel(e){for(let{camera:t}of this.pictures)t.parallel=e}bounds(){let e=(this.alike?this.pictures:this.pictures.slice(0,1)).map(({bounds:o})=>o),t=e.reduce((o,a)=>o.min(a.low),e[0].low.clone()),i=e.reduce((o,a)=>o.max(a.high),e[0].high.clone()),r=t.clone().add(i).multiplyScalar(.5),s=Math.max(...e.map(o=>o.centre.distanceTo(r)+o.radius));return{centre:r.applyMatrix4(this.pictures[0].seen),radius:s,low:t,high:i}}targetOf(e,t){let[i]=this.pictures;return e.centre.clone().addScaledVector(t.clone().sub(i.centre),e.factor)}meet(e,t){this.pictures.forEach((i,r)=>{i.centre.copy(e[r]),t&&!this.alike&&(i.factor=t[r]/t[0])})}#e(e,t){let{camera:i,seen:r,factor:s}=e,{whole:o}=e.bounds,a=s*t.now.distance,c=this.targetOf(e,t.now.target);i!==this.camera&&(i.position.copy(c).addScaledVector(t.direction(),a),i.quaternion.copy(this.camera.quaternion));let l=c.distanceTo(o.centre.clone().applyMatrix4(r));i.distance=a,i.near=Math.max(i.parallel?-1/0:.01*a,a-l-1.3*o.radius),i.far=a+l+2.5*o.radius;let h=this.size.width/this.pictures.length;i.setViewOffset(h,this.size.height,this.shift*h,-this.drop*this.size.height,h,this.size.height),i.updateMatrixWorld()}render(e){let{renderer:t}=this;this.setLights(),t.setScissorTest(!0);let i=this.size.width/this.pictures.length,r=this.size.height*Math.min(1,this.ratio),s=(this.software?2.5:1)*2*Math.tan(this.camera.fov*Math.PI/360)/r;this.pictures.forEach((o,a)=>{let{camera:c,seen:l}=o;if(this.#e(o,e),t.setViewport(a*i,0,i,this.size.height),t.setScissor(a*i,0,i,this.size.height),t.setClearColor(this.background,1),t.clear(),o.root.matrix.copy(l),o.overRoot.matrix.copy(l),o.solids.choose(l,c,s),t.render(o.scene,c),this.section?.on){let h=2*c.distance*Math.tan(c.fov*Math.PI/360)/this.size.height;o.caps.render(t,c,this.section.planes[a],l,h,{left:a*i,width:i,height:this.size.height})}(o.arrows.hidden||!o.arrows.shown.size)&&!o.flanks.over||(t.clearDepth(),t.render(o.over,c))}),this.drawn++}setLights(){let e=new C(-.45,.7,.9).applyQuaternion(this.camera.quaternion),t=new C(0,1,0).applyQuaternion(this.camera.quaternion);for(let i of this.pictures)for(let r of i.lights)r.light.position.copy(e),r.sky.position.copy(t)}hit(e,t){let i=this.canvas.getBoundingClientRect(),r=i.width/this.pictures.length,s=Math.floor((e-i.left)/r),o=this.pictures[s];if(!o)return null;let a=new Ke((e-i.left-s*r)/r*2-1,1-(t-i.top)/i.height*2),c=new nl;c.setFromCamera(a,o.camera),o.camera.parallel&&c.ray.origin.addScaledVector(c.ray.direction,Math.min(0,o.camera.near));let l=o.solids.hit(c);return l&&{...l,picture:s}}onScreen(e,t=0){let{seen:i,camera:r}=this.pictures[t],s=e.clone().applyMatrix4(i).project(r),o=this.size.width/this.pictures.length;return{x:(t+(s.x+1)/2)*o,y:(1-s.y)/2*this.size.height,front:s.z<1}}};function W1(n){let[{bounds:e}]=n;return n.every(({bounds:t})=>{let[i,r]=[t.size,e.size].sort((s,o)=>s-o);return r<=CM.size*i&&t.centre.distanceTo(e.centre)<=CM.away*r})}function LM(n){let{canvas:e}=n.stage,t=()=>{e.style.touchAction=n.fills||document.activeElement===e?"none":"pan-y"};for(let i of["focus","blur","pointerenter"])e.addEventListener(i,t);window.addEventListener("resize",t),t()}var pd=1e6,ff=class{constructor(e,t,i,r=""){this.player=e,this.marks=[...t].sort((o,a)=>o.time-a.time),this.kinds=[...new Set(this.marks.map(o=>o.kind))],this.does=i,this.stepLength=1/0;for(let o=1;o<e.times.length;o++)this.stepLength=Math.min(this.stepLength,e.times[o]-e.times[o-1]||1/0);Number.isFinite(this.stepLength)||(this.stepLength=1);let s=r&&`, ${fr(this.stepLength)}, the frame interval of ${r}`;this.play=xt("","Play (space)",i.toggle,{className:"ppv-play"}),this.range=Y("input",{type:"range",min:"0",max:String(pd),step:"1",className:"ppv-range",title:"Time","aria-label":"Time"}),this.range.addEventListener("input",()=>i.seek(this.#e(Number(this.range.value)/pd))),this.strip=Y("canvas",{className:"ppv-marks",role:"img","aria-label":`${this.marks.length} marks`}),this.tip=Y("div",{className:"ppv-tip",hidden:!0}),this.strip.addEventListener("pointermove",o=>this.#n(o)),this.strip.addEventListener("pointerleave",()=>this.tip.hidden=!0),this.strip.addEventListener("click",o=>{let a=this.#i(o);i.seek(a?a.time:this.#e(this.#t(o)))}),this.read=Y("output",{className:"ppv-now",title:"Time"}),this.speed=_r({label:"",title:"Speed relative to real time (+ and \u2212)",least:Sl,most:1,value:e.speed,show:h_,changed:i.speed}),this.loop=on("repeat",[["record","whole record"],["turn","one turn"],["cycle","one mesh cycle"]],o=>{let a=i.loop(o);this.loop.select.value=e.loop,this.announce(a)}),this.status=Y("span",{className:"ppv-status",role:"status"}),this.jump=this.marks.length?[xt("\u27E8","Previous mark ([)",()=>this.toMark(-1)),xt("\u27E9","Next mark (])",()=>this.toMark(1))]:[],this.row=Y("div",{className:"ppv-transport"},this.play,xt("|\u25C2","To the start (Home)",()=>i.seek(e.window[0])),xt("\u25C2",`One frame back (left arrow)${s}`,()=>i.step(-1)),xt("\u25B8",`One frame forward (right arrow)${s}`,()=>i.step(1)),...this.jump,this.read,this.speed.row,this.loop.row,this.status),this.element=Y("div",{className:"ppv-time"},Y("div",{className:"ppv-track"},this.strip,this.range,this.tip),this.row),e.times.length<2&&this.element.classList.add("ppv-still")}#e(e){return this.player.first+e*(this.player.last-this.player.first)}#t(e){let t=this.strip.getBoundingClientRect();return Math.max(0,Math.min(1,(e.clientX-t.left)/t.width))}#i(e){let t=this.strip.getBoundingClientRect(),i=this.#e(this.#t(e)),r=6*(this.player.last-this.player.first)/Math.max(t.width,1),s=null;for(let o of this.marks)Math.abs(o.time-i)<=r&&(!s||Math.abs(o.time-i)<Math.abs(s.time-i))&&(s=o);return s}#n(e){let t=this.#i(e);if(this.tip.hidden=!t,this.strip.style.cursor="pointer",!t)return;this.tip.textContent=`${yl(t.kind)}${t.what?`, ${t.what}`:""}, ${bs(t.time,this.stepLength/10)}`;let i=this.strip.getBoundingClientRect(),r=e.clientX-i.left;this.tip.style.left=`${Math.max(0,Math.min(i.width-180,r))}px`}announce(e){this.status.textContent=e}toMark(e){let t=this.player.time,i=1e-9*(this.player.last-this.player.first),r=e>0?this.marks.find(s=>s.time>t+i):this.marks.findLast(s=>s.time<t-i);r&&this.does.seek(r.time)}draw(){let{strip:e,player:t}=this,i=e.clientWidth,r=e.clientHeight;if(!i)return;let s=window.devicePixelRatio||1;e.width=i*s,e.height=r*s;let o=e.getContext("2d");o.scale(s,s);let a=t.last-t.first||1,c=f=>(f-t.first)/a*i,l=getComputedStyle(this.element);t.loop!=="record"&&(o.fillStyle=l.getPropertyValue("--v-accent"),o.globalAlpha=.35,o.fillRect(c(t.window[0]),r-4,Math.max(2,c(t.window[1])-c(t.window[0])),4),o.globalAlpha=1);let h={};for(let f of this.marks)o.fillStyle=ys(this.kinds,f.kind),o.globalAlpha=.3,f.until>f.time&&o.fillRect(c(f.time),3,c(f.until)-c(f.time),r-9),!(c(f.time)-(h[f.kind]??-9)<Ku)&&(h[f.kind]=c(f.time),o.globalAlpha=1,o.fillRect(c(f.time)-.75,1,1.5,r-5));o.globalAlpha=1}update(){let{player:e}=this,t=e.last-e.first,i=t>0?(e.time-e.first)/t:0;this.range.value=String(Math.round(i*pd));let r=bs(e.time,e.playing?this.stepLength:this.stepLength/10);this.range.ariaValueText=r,this.read.textContent=r,this.read.title=`Time; record length ${fr(t)}`;let s=e.playing?"pause":"play";this.play.dataset.state!==s&&(this.play.dataset.state=s,this.play.textContent=e.playing?"\u275A\u275A":"\u25B6\uFE0E",this.play.title=e.playing?"Pause (space)":"Play (space)",this.play.setAttribute("aria-label",this.play.title))}};var uf=class{constructor(e,t,i=()=>[],r=()=>0){this.stage=e,this.orbit=t,this.legends=i,this.panel=r,this.names=[...new Set(e.pictures.flatMap(({data:s})=>s.bodies.filter(({part:o})=>!o).map(({name:o})=>o)))],this.body=-1,this.turning=!1,this.anchors=e.pictures.map(()=>new ye)}bodyIn({data:e}){return this.body<0?-1:e.bodies.findIndex(({name:t})=>t===this.names[this.body])}get first(){return this.bodyIn(this.stage.pictures[0])}get poses(){return this.stage.pictures[0].poses}directions(){let e=this.poses.axis().transformDirection(this.stage.pictures[0].seen),t=this.orbit.up,i=new C().crossVectors(t,e);i.length()<.001&&i.crossVectors(new C(1,0,0),e),i.length()<.001&&i.crossVectors(new C(0,0,1),e),i.normalize();let r=new C().crossVectors(e,i),s=Math.abs(e.dot(t))>.9,[o,a,c]=s?[.55*Math.sign(e.dot(t)),1,.7]:[1,.75,.55];return{axis:e,side:i,top:s?e:r,iso:e.clone().multiplyScalar(o).addScaledVector(i,a).addScaledVector(r,c)}}distanceFor(e){let{camera:t}=this.stage,i=Math.atan(Math.tan(t.fov*Math.PI/360)*Math.min(1,t.aspect));return e/Math.sin(i)}#e(e,t=0){this.stage.shift=this.orbit.shift=e/2,this.stage.drop=this.orbit.drop=t/2}fit(e=!1){let{alike:t,pictures:i}=this.stage,r=i.map(({bounds:x,arrows:m,seen:p})=>[...x.outline,...m.ends()].map(_=>_.clone().applyMatrix4(p))),s=t?[{points:r.flat(),bounds:this.stage.bounds(),factor:1}]:i.map(({bounds:x,seen:m},p)=>({points:r[p],bounds:{radius:x.radius,centre:x.centre.clone().applyMatrix4(m)},factor:x.size/i[0].bounds.size})),o=this.legends()??[],[a,c,l]=["share","strip","drop"].map(x=>Math.max(0,...o.map(m=>m[x]))),[h,f]=[-this.panel(),0],u=()=>s.map(({points:x,bounds:m})=>this.#i(x,m,h,f)),d=u(),g=x=>x>0&&s.some(({points:m},p)=>m.some(_=>d[p].under(_,x,l)));g(a)?h=a:g(c)&&(f=l),(h||f)&&(d=u()),this.#e(h,f),this.#t(i.map((x,m)=>d[t?0:m].target),i.map(({bounds:x})=>x.size),{distance:Math.max(...d.map(({distance:x},m)=>x/s[m].factor))},e),this.orbit.chosen=!1}#t(e,t,i,r=!1){this.stage.meet(e,t),this.orbit.look({target:e[0],...i},r||!this.stage.alike)}#i(e,{centre:t,radius:i},r,s){let{camera:o}=this.stage,a=this.orbit.direction(this.orbit.goal),c=new C().crossVectors(this.orbit.up,a).normalize(),l=new C().crossVectors(a,c),h=Math.tan(o.fov*Math.PI/360),f=.9*h*(1-s),u=.9*h*o.aspect*(1-Math.abs(r)),d=t.clone(),g=this.distanceFor(i);for(let m=0;e.length&&m<3;m++){let p=[1/0,-1/0,1/0,-1/0],_=0;for(let y of e){let S=y.clone().sub(d),[R,A,v]=[S.dot(c),S.dot(l),S.dot(a)],E=o.parallel?g:Math.max(g-v,.001*i);p[0]=Math.min(p[0],R/E),p[1]=Math.max(p[1],R/E),p[2]=Math.min(p[2],A/E),p[3]=Math.max(p[3],A/E);let F=o.parallel?0:v;_=Math.max(_,F+Math.abs(R)/u,F+Math.abs(A)/f)}if(m===2){g=_;break}d.addScaledVector(c,g*(p[0]+p[1])/2),d.addScaledVector(l,g*(p[2]+p[3])/2)}return g=Math.max(g,.1*i),{target:d,distance:g,under:(m,p,_)=>{let y=m.clone().sub(d),S=h*(o.parallel?g:g-y.dot(a));return y.dot(c)>S*o.aspect*(1-2*p)&&y.dot(l)>S*(1-2*_)}}}named(e,t=!1){let i=this.directions(),r=i[e==="front"?"side":e];e==="top"&&this.orbit.look({direction:i.side}),this.orbit.look({direction:r},t),this.stage.section?.face(r),this.fit(t)}follow(e,t=this.turning){this.body=e,this.turning=t;let{pictures:i}=this.stage;if(e<0){let r=i.map(s=>this.stage.targetOf(s,this.orbit.goal.target).applyMatrix4(s.seen.clone().invert()));for(let{seen:s}of i)s.identity();this.stage.meet(r),this.orbit.look({target:r[0]},!0);return}i.forEach((r,s)=>this.anchors[s].multiplyMatrices(r.seen,this.#n(r))),this.orbit.changed()}#n(e){let t=e.poses.world[this.bodyIn(e)]??new ye;return this.turning?t.clone():new ye().setPosition(new C().setFromMatrixPosition(t))}update(){this.body<0||this.stage.pictures.forEach((e,t)=>e.seen.multiplyMatrices(this.anchors[t],this.#n(e).invert()))}look(e,t,i){let r=i/(2*Math.tan(this.stage.camera.fov*Math.PI/360));this.#e(0),this.orbit.look({target:new C(...e),direction:t&&new C(...t),distance:r},!0)}closeUp(){if(this.body<0)return;let{pictures:e}=this.stage,t=e.map(i=>{let r=this.bodyIn(i);return r<0?null:{target:new C().setFromMatrixPosition(i.poses.world[r]).applyMatrix4(i.seen),size:i.solids.reachOf(r)}});this.#r(t,i=>this.distanceFor(1.15*i))}#r(e,t,i){let{pictures:r,alike:s}=this.stage,{target:o}=this.orbit.goal,a=e.map((f,u)=>f?.target??this.stage.targetOf(r[u],o)),c=e.findIndex(f=>f?.size>0);if(c<0)return this.#t(a,void 0,{direction:i});let l=e[c].size/r[c].bounds.size,h=r.map(({bounds:f},u)=>e[u]?.size>0?e[u].size:l*(s?r[c]:{bounds:f}).bounds.size);this.#t(a,h,{direction:i,distance:t(s?Math.max(...h):h[0])})}#s(e,{solids:t,poses:i}){let r=null;for(let s of t.parts){if(!s.solid.teeth)continue;let o=i.ofSolid(s.solid),a=new C().setFromMatrixColumn(o,2),c=e.clone().sub(new C().setFromMatrixPosition(o)),l=c.addScaledVector(a,-c.dot(a)).length(),h=Math.abs(s.rim-l)/s.rim;(!r||h<r.off)&&(r={off:h,axis:a,pitch:2*Math.PI*l/s.solid.teeth})}return r}#o(e,t){let{poses:i,arrows:r,data:s,seen:o,bounds:a}=e,c=r.forces()[s.arrows.indexOf(t)].at,l=this.#s(c,e),h=l?l.axis:i.axis();return{point:c,axis:h,target:c.clone().applyMatrix4(o),size:l?l.pitch:.1*a.radius}}intoMesh(e){let{pictures:t,camera:i}=this.stage,r=t.map(a=>{let c=a.data.arrows.find(({kind:l,name:h})=>l==="mesh"&&h===e.name);return c?this.#o(a,c):null}),s=r.findIndex(Boolean),o=r[s].axis.clone().transformDirection(t[s].seen);return this.#r(r,a=>1.6*a/(2*Math.tan(i.fov*Math.PI/360)),o),r}};var X1="WebGL 2 is not available, so the solids cannot be drawn; curves and time controls work.",q1=900,df=class{constructor(e,t){this.root=e,this.scenes=t,this.last=0,this.waiting=0,this.stage=null,this.shared=cM(t);let{times:i}=this.shared;this.poses=new Zo(t[0]),this.player=new Ih(i,this.poses);let r=Y1(t),s=[this.player.first,this.player.last];this.curves=new Dh(t,s,r,l=>this.seek(l)),this.transport=new ff(this.player,r,{seek:l=>this.seek(l),toggle:()=>this.toggle(),step:l=>this.step(l),speed:l=>this.player.speed=l,loop:l=>this.loop(l)},this.shared.whose),this.panels=new Vh,this.host=Y("div",{className:"ppv-view"}),this.area=Y("div",{className:"ppv-scene"},this.host,this.panels.panel);let o=[...new Set(t.map(l=>l.title))].join(" and "),a=t.length>1?"":t[0].subtitle,c=Y("div",{className:"ppv-head"},Y("div",{className:"ppv-title",title:`${o} ${a}`},Y("b",{},o),Y("span",{},a)),this.panels.bar);this.transport.row.append(this.curves.bar),e.replaceChildren(c,this.area,this.transport.element,this.curves.element),this.#t(),this.#i(),Kv(this),this.watch=new ResizeObserver(()=>this.resize()),this.watch.observe(e),this.watch.observe(this.curves.body),window.addEventListener("beforeprint",()=>this.draw()),this.dark=window.matchMedia("(prefers-color-scheme: dark)"),this.dark.addEventListener("change",()=>this.colours()),this.resize(),this.curves.build(),this.colours()}#e(e){this.area.append(Y("div",{className:"ppv-message",role:"alert"},Y("p",{},e)))}#t(){if(!this.scenes.some(o=>o.solids.length)){this.#e("This scene contains no solids: the model defines no geometry, or the result does not contain it.");return}let e=PM();if(!e){this.#e(X1);return}this.stage=new hf(this.host,this.scenes,e.software);let{stage:t}=this;t.canvas.tabIndex=0,t.canvas.setAttribute("aria-label","3-D scene: drag to rotate, right button to pan, wheel to zoom"),t.canvas.addEventListener("webglcontextlost",()=>this.#e("The graphics context was lost. Reload the page.")),this.orbit=new kh(t.camera,t.canvas,()=>this.changed(),this.scenes[0].up),this.orbit.takesWheel=o=>{let a=this.fills||o.ctrlKey||document.activeElement===t.canvas;return a||this.hint("click the scene to zoom with the wheel"),a},LM(this),this.orbit.pictures=t.pictures.length;let{radius:i}=t.bounds();this.orbit.nearest=2e-5*i,this.orbit.farthest=40*i,this.views=new uf(t,this.orbit,()=>this.legends,()=>this.scenes[1]?0:this.panels.share),this.hover=new Nh(t,this.orbit,o=>this.follow(this.views.names.indexOf(o))),this.legends=t.pictures.map(({arrows:o})=>new Uh(o.arrows)),this.boxes=t.pictures.map(({flanks:o})=>new lh(o)),this.scales=t.pictures.map(()=>Y("div",{className:"ppv-scale","aria-hidden":"true"},Y("span"),Y("i"),Y("span"),Y("b"))),this.status=Y("div",{className:"ppv-status",role:"status"});let r=bl(this.scenes);this.names=r.map((o,a)=>o&&Y("span",{className:"ppv-name",title:this.scenes[a].label},Y("span",{},o),Y("span",{})));let s=this.legends.map((o,a)=>Y("div",{className:"ppv-half"},o.element,this.boxes[a].element,this.names[a],this.scales[a]));this.host.append(Y("div",{className:"ppv-halves"},...s),this.hover.label,this.status)}#i(){let{panels:e,stage:t}=this;if(t){e.action("Fit","Fit all (f)",()=>this.views.fit()),e.add("View","Standard views, followed body, housing, view into a mesh",nM(this)),this.scenes.some(o=>o.arrows.length)&&e.add("Forces","Force arrows",rM(this)),this.scenes.some(o=>o.contacts.length)&&e.add("Flanks","Contact lines, pattern and gap of the teeth",p_(this)),this.player.times.length>1&&e.add("Vibration","Magnify vibrations",oM(this)),this.section=new Yh(t,()=>this.changed()),e.add("Section","Section plane through the solids",this.section.rows);let{modes:s}=this.scenes[0];if(s.length&&!this.scenes[1]){this.modes=new Fh(s,t,()=>this.changed());let o=e.add("Modes","Mode shapes",this.modes.rows);this.player.times.length<2&&this.host.clientWidth>=q1&&e.show("Modes",this.modes.rows,o)}e.add("Save","Picture, solids, video",sM(this))}this.transport.marks.length&&e.add("Marks","Events in the record",Zv(this));let i=[...new Set([this.shared.note,...this.scenes.flatMap(s=>s.notes)])].filter(Boolean),r=[Y("dl",{},...$v.flatMap(([s,o])=>[Y("dt",{},s),Y("dd",{},o)]))];i.length&&r.unshift(Y("ul",{className:"ppv-notes"},...i.map(s=>Y("li",{},s)))),e.add(i.length?`Notes (${i.length})`:"?","Notes and keyboard shortcuts",r)}colours(){this.stage?.background.set(getComputedStyle(this.area).backgroundColor),this.curves.build(),this.transport.draw(),this.changed()}resize(){if(!(!this.root.clientWidth||!this.root.clientHeight)){if(this.stage){let e=this.stage.size.width===1;this.stage.resize(),e&&this.draw();for(let t of this.legends)t.settle();e&&this.views.named("iso",!0),this.orbit.chosen||this.views.fit(!0),this.draw()}this.curves.resize(),this.transport.draw(),this.update()}}changed(){this.waiting||(this.waiting=requestAnimationFrame(e=>this.#n(e)))}#n(e){this.waiting=0;let t=this.player.playing||this.easing||this.modes?.active,i=t&&this.last?Math.min(.25,Math.max(0,(e-this.last)/1e3)):1/60;this.last=e,this.player.advance(i),this.modes?.advance(i),this.easing=this.orbit?.step(i)??!1,this.#r(i,t),this.update(),this.draw(),this.frames=(this.frames??0)+1,this.player.playing||this.easing||this.modes?.active?this.changed():this.last=0}#r(e,t){let i=this.player.playing||this.easing||this.modes?.active;t&&i&&(this.pace=.7*(this.pace??e)+.3*e),!this.filming&&this.stage?.coarsen(!!i&&this.pace>(this.stage.coarse?.03:.085))}update(){this.transport.update(),this.curves.cursor(this.player.time),this.#s()}#s(){this.player.time!==this.sent&&(this.sent=this.player.time,this.#o(),this.root.dispatchEvent(new CustomEvent("pp-time",{bubbles:!0,detail:this.sent})))}#o(){this.scenes.length<2||!this.names||this.names.forEach((e,t)=>{let i=this.scenes[t].times?.data.at(-1),r=Zu(i,this.sent)?` (ended at ${fr(i)})`:"";e&&e.lastChild.textContent!==r&&(e.lastChild.textContent=r)})}draw(){let{stage:e,orbit:t}=this;if(!(!e||e.size.width===1)){for(let i of e.pictures)this.modes?.active?this.modes.pose(i):i.poses.at(this.player.time);this.modes?.active||this.views.update(),this.section?.update(),e.pictures.forEach((i,r)=>{let s=i.factor*t.pixel;i.solids.update(.25*s),i.arrows.hidden=i.flanks.hidden=!!this.modes?.active,i.flanks.look();let o=a=>!!this.section?.on&&this.section.removes(a,r);i.flanks.update(s,o),i.arrows.update(s,a=>({...e.onScreen(a,r),removed:o(a)}))}),e.render(t),e.pictures.forEach(({arrows:i},r)=>this.legends[r].update(i.now,i.shown,i.hidden));for(let i of this.boxes)i.update();this.#l()}}#l(){let{alike:e,pictures:t}=this.stage,i=this.host.clientWidth/t.length<300?60:90;this.scales.forEach((c,l)=>{let h=t[l].factor*this.orbit.pixel,f=Ko(i*h),[u,d,g,x]=c.children;c.hidden=e&&l>0,u.textContent=c_(f),d.style.width=`${f/h}px`;let{perForce:m=0,size:p,hidden:_}=t[l].arrows,y=m>0?Ko(i*h/m):0;g.hidden=x.hidden=_||!(y>0&&y<=2*p),!x.hidden&&(g.textContent=sh(y,"N").replace(/\.0+(?=\D)/,""),x.style.width=`${y*m/h}px`)});let{body:r,names:s}=this.views,o=r>=0?`following ${s[r]}`:"",a=this.stage.pictures[0].poses.magnification>1?`vibrations \xD7 ${this.magnification.row.lastChild.textContent}`:"";this.status.textContent=[o,a,this.modes?.words].filter(Boolean).join(" \xB7 ")}get fills(){return this.root.clientHeight>.8*window.innerHeight}live(e){e(this.scenes[0]);for(let{arrows:t}of this.stage?.pictures??[])t.grow();this.changed()}hint(e){this.status.textContent=e,clearTimeout(this.hinted),this.hinted=setTimeout(()=>this.changed(),2500)}advance(e){this.player.advance(e),this.modes?.advance(e),this.update(),this.draw()}seek(e){this.player.seek(e),this.update(),this.changed()}toggle(e=!this.player.playing){this.player.playing=e&&this.player.last>this.player.first,this.transport.update(),this.changed()}step(e){this.player.step(e),this.update(),this.changed()}loop(e){let t=this.player.repeat(e,this.views?.first??-1,this.scenes[0].solids);return this.transport.loop.select.value=this.player.loop,this.transport.draw(),this.changed(),t}project(e){this.stage&&(this.stage.parallel=e,this.parallel.input.checked=e,this.orbit.chosen||this.views.fit(!0),this.changed())}follow(e){!this.stage||e>=this.views.names.length||(this.views.follow(e),e>=0&&this.views.closeUp(),this.followed.select.value=String(e),this.changed())}magnify(e){for(let t of this.stage.pictures)t.poses.magnification=e;this.changed()}arrows(e,t){for(let{arrows:i}of this.stage.pictures)t?i.shown.add(e):i.shown.delete(e);this.kinds?.[e]&&(this.kinds[e].input.checked=t),this.changed()}density(e){for(let{arrows:t}of this.stage.pictures)t.sparse=e;this.sparse&&(this.sparse.input.checked=e),this.changed()}intoMesh(e){let t=this.views.intoMesh(e);this.section.through(t.map(i=>i?.point),t.find(Boolean).axis)}};function Y1(n){let e=bl(n);return n.flatMap((t,i)=>t.marks.map(r=>({...r,what:[r.what,e[i]].filter(Boolean).join(", ")})))}function DM(n,e,{shape:t,differences:i,across:r}){let s=new Float64Array(e);for(let l=0,h=1;l<n.length;l+=e,h*=256)for(let f=0;f<e;f++)s[f]+=h*n[l+f];for(let l=0;l<e;l++)s[l]=s[l]%2?-(s[l]+1)/2:s[l]/2;let o=r?t[t.length-1]:t[0];for(let l=0;o&&l<e;l+=o)$1(s,l,l+o,i);if(r)return s;let a=o?e/o:0,c=new Float64Array(e);for(let l=0;l<a;l++)for(let h=0;h<o;h++)c[h*a+l]=s[l*o+h];return c}function $1(n,e,t,i){if(i===0)for(let r=e+1;r<t;r++)n[r]+=n[e];if(i===2)for(let r=e+2;r<t;r++)n[r]+=n[r-1];if(i>0)for(let r=e+1;r<t;r++)n[r]+=n[r-1]}function NM(n,e,t,i){let r=i.length,s=new Float64Array(e*r);for(let o=0;o<e;o++)for(let a=0;a<r;a++){let c=i[a];for(let l=0;l<t.length;l++)c+=t[l][a]*n[o*t.length+l];s[o*r+a]=c}return s}var K1=63;function IM(n){for(let e of n.channels){if(!e.curve)continue;let[t,i]=e.curve,[r,s]=e.from,{times:o,least:a,span:c,mean:l}=n.curves[t],h=d=>({data:Float64Array.from({length:a.count},(x,m)=>r+s*d(m)),shape:[a.count],width:1,count:a.count}),f=(d,g)=>d.data[g*d.width+i];e.times=o,e.least=h(d=>f(a,d)),c&&e.least.data.some((d,g)=>f(c,g)!==0)&&(e.most=h(d=>f(a,d)+f(c,d)),l&&(e.mean=h(d=>f(a,d)+f(l,d)/K1*f(c,d))))}}var UM="pitchpoint-scene-2",Z1={f8:Float64Array,f4:Float32Array,i4:Int32Array,u4:Uint32Array,i2:Int16Array,u2:Uint16Array,u1:Uint8Array},fn=class extends Error{};function J1(n){let e;try{e=atob(n.trim())}catch{throw new fn("The data of this scene cannot be decoded (not base64). The file may be damaged.")}let t=new Uint8Array(e.length);for(let i=0;i<t.length;i++)t[i]=e.charCodeAt(i);return t}async function Q1(n){if(typeof DecompressionStream>"u")throw new fn("This browser cannot decompress the data of the scene (no DecompressionStream). Use a newer browser.");try{let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip"));return await new Response(e).arrayBuffer()}catch{throw new fn("The data of this scene cannot be decompressed: the file is truncated or damaged.")}}function j1(n,e,t){let i=e?.type==="planes",r=i?Uint8Array:Z1[e?.type],s=e?.shape;if(!r||!Array.isArray(s)||!s.length||s.some(y=>!Number.isInteger(y)||y<0))throw new fn(`This scene cannot be read: ${t} has an unknown type or shape.`);let o=s.reduce((y,S)=>y*S,1),a=e.at,c=i?o*e.bytes:o;if(!Number.isInteger(a)||a<0||a%8||!(a+c*r.BYTES_PER_ELEMENT<=n.byteLength))throw new fn(`This scene is truncated: ${t} is beyond the end of the data.`);let l=new r(n,a,c),h=i?DM(l,o,e):l,f=s[s.length-1],u=s.length>1?o/Math.max(s[0],1):1,d=s[0];if(!e.scale&&!e.offset)return{data:h,shape:s,width:u,count:d};let g=s.length>1?f:1,x=e.scale??Array(g).fill(1),m=!e.mix&&e.offset||Array(g).fill(0),p=new Float64Array(o);for(let y=0;y<o;y++)p[y]=m[y%g]+x[y%g]*h[y];if(e.exponent&&p.forEach((y,S)=>p[S]=Math.exp(y)),!e.mix)return{data:p,shape:s,width:u,count:d};let _=e.offset.length;return{data:NM(p,d,e.mix,e.offset),shape:[d,_],width:_,count:d}}function md(n,e,t,i=new Map){if(Array.isArray(n))return n.map((s,o)=>md(s,e,s?.name?`${t} ${s.name}`:`${t} ${o+1}`,i));if(n===null||typeof n!="object")return n;if("at"in n&&"type"in n&&"shape"in n){let s=JSON.stringify(n);return i.has(s)||i.set(s,j1(e,n,t)),i.get(s)}let r={};for(let[s,o]of Object.entries(n))r[s]=md(o,e,`${s} of ${t}`,i);return r}function li(n,e){if(!n)throw new fn(`This scene cannot be read: ${e}.`)}function eT(n){let e=n.times?.count??0,t=(i,r)=>li(!i||i.count===e||i.count===1,`${r} has ${i?.count} rows for ${e} times`);for(let{channel:i,lines:r,times:s,levels:o}of n.maps)li(r?.count>1&&s?.count>1&&o?.data.length===r.count*s.count,`the map of ${i} has ${o?.data.length} levels for ${r?.count} lines at ${s?.count} times`);n.bodies.forEach((i,r)=>{li(Number.isInteger(i.parent??-1)&&(i.parent??-1)<r,`body ${i.name} is listed before its parent`);for(let s of["position","travel","turn","spin","gross","quaternion"])t(i[s],`${s} of body ${i.name}`)});for(let i of n.solids){li(i.body>=-1&&i.body<n.bodies.length,`solid ${i.name} refers to an unknown body`);let r=i.pieces?i.pieces.flatMap(s=>s.levels??[]):[i];li(r.length,`solid ${i.name} has no surface`);for(let{points:s,triangles:o}of r){li(s?.width===3&&o?.width===3,`solid ${i.name} has no surface`);for(let a of o.data)li(a<s.count,`solid ${i.name} has a triangle with an invalid point index`)}for(let s of i.pieces??[])li(s.turns?.count,`solid ${i.name} has no positions`);if(i.modal){let{shapes:s,node:o,coordinates:a}=i.modal;li(s?.shape.length===3&&o?.count===i.points?.count,`solid ${i.name} has no deformation data`);for(let c of o.data)li(c<s.shape[1],`solid ${i.name} has a point with an invalid node index`);t(a,`the modal coordinates of ${i.name}`)}for(let s of i.between?.bodies??[])li(s>=-1&&s<n.bodies.length,`solid ${i.name} refers to an unknown body`);for(let s of i.blend?.bodies??[])li(s>=-1&&s<n.bodies.length,`the blend of ${i.name} refers to an unknown body`)}for(let i of n.arrows){li(i.body>=-1&&i.body<n.bodies.length,`arrow ${i.name} refers to an unknown body`);for(let r of["circumferential","radial","axial"])t(i.components?.[r],`the ${r} force ${i.name}`);t(i.at,`the position of arrow ${i.name}`),t(i.state,`the state of arrow ${i.name}`)}for(let i of n.contacts)tT(n,i,t);for(let i of n.channels){let r=i.least?.count;li(i.times&&r&&i.times.count===r&&(i.most?.count??r)===r,`channel ${i.name} has times and values of different length`)}}function tT(n,e,t){let{name:i}=e;for(let r of["at","axes","pressure_angle","penetration"])li(e[r],`contact ${i} has no ${r}`),t(e[r],`${r} of contact ${i}`);li(e.width?.length===2&&e.path?.length===2,`contact ${i} has no position`),li(!e.unit_pressure||e.unit_pressure.count>1,`contact ${i} has no pressures`),li(e.base_pitch>0&&e.flanks?.length,`contact ${i} has no flanks`);for(let r of e.flanks){li(r.travel?.count===n.times.count,`contact ${i} does not give the travel at each time`);for(let s of["forces","loads"])t(r[s],`${s} of contact ${i}`);li(!!r.forces==!!r.loads,`contact ${i} has forces without loads, or loads without forces`);for(let s of r.surfaces??[])li(s.body in n.bodies,`a flank of contact ${i} refers to an unknown body`),li(s.points?.shape.length===3&&s.teeth>0,`a flank of contact ${i} has no surface`)}}async function gd(n=""){let e=document.getElementById(`pp-scene${n}`),t=document.getElementById(`pp-scene-numbers${n}`);if(!e||!t)throw new fn("This page contains no scene.");let i;try{i=JSON.parse(e.textContent??"")}catch{throw new fn("The header of this scene cannot be read: the file is truncated or damaged.")}if(i?.format!==UM)throw new fn(`This scene has format "${i?.format}"; this viewer requires "${UM}".`);let r=await Q1(J1(t.textContent??"")),o={title:"",subtitle:"",up:[0,1,0],...{bodies:[],solids:[],arrows:[],contacts:[],channels:[],spectra:[],maps:[],marks:[],modes:[],notes:[]},...md(i,r,"this scene")};return IM(o),eT(o),o}function FM(n){let{player:e,stage:t,curves:i}=n,r=s=>[s.x,s.y,s.z];return{time:e.time,playing:e.playing,frame:e.frame,speed:e.speed,loop:e.loop,window:[...e.window],channels:[...i.plots.names],cursor:i.plots.drawn.map(({plot:s,line:o})=>({at:o.hidden?null:s.posToVal(new DOMMatrix(getComputedStyle(o).transform).m41,"x"),readings:[...o.closest(".ppv-plot").querySelectorAll("output")].map(a=>a.textContent)})),spectrum:i.spectra.state(),marks:n.transport.marks.length,message:n.area.querySelector(".ppv-message")?.textContent??null,drawn:t?.drawn??0,ratio:t?.ratio??0,projection:t?.parallel?"parallel":"central",section:n.section?{on:n.section.on,normal:r(n.section.normal),at:n.section.at}:null,mode:n.modes?.number??-1,following:n.views?.body??-1,camera:n.orbit?{position:r(t.camera.position),target:r(n.orbit.now.target),distance:n.orbit.now.distance,near:t.camera.near,far:t.camera.far}:null,pictures:(t?.pictures??[]).map(s=>({bodies:s.poses.world.map(o=>[...o.elements]),seen:[...s.seen.elements],factor:s.factor,target:r(t.targetOf(s,n.orbit.now.target)),magnification:s.poses.magnification,triangles:s.solids.triangles,drawnTriangles:s.solids.drawn,batches:s.solids.batches.length,hatches:n.section?.on?s.caps.state():{},contacts:s.flanks.state(),arrows:(s.arrows.now??[]).map((o,a)=>({name:o.name,kind:o.kind,state:o.state,at:r(o.at),vectors:Object.fromEntries(Object.entries(o.vectors).map(([c,l])=>[c,r(l)])),lengths:Object.fromEntries(Object.entries(s.arrows.drawn[a].parts).map(([c,l])=>[c,l.visible?new C().setFromMatrixColumn(l.matrix,2).length():0]))}))}))}}var zn=null;async function iT(n,{compare:e=!1,start:t={}}={}){document.getElementById("ppv-style")||document.head.append(Y("style",{id:"ppv-style"},Fd+Od));let i=Y("div",{className:"ppv"}),r=Y("p",{},"Reading the scene \u2026");i.append(Y("div",{className:"ppv-message",role:"status"},r)),n.replaceChildren(i);try{let s=[await gd()];return e&&s.push(await gd("-2")),zn=new df(i,s),g_(zn,{...t,...m_()}),i.dataset.ready="scene",!0}catch(s){return r.textContent=s instanceof fn?s.message:`Internal error of the viewer: ${s instanceof Error?s.message:s}.`,i.replaceChildren(Y("div",{className:"ppv-message",role:"alert"},r)),i.dataset.ready="failed",s instanceof fn||console.error(s),!1}}var Bt=()=>{if(!zn)throw new Error("No scene is displayed.");return zn};function OM(n){zn?.stage?.enlarge(n),zn?.stage&&zn.stage.background.set(n?"#ffffff":getComputedStyle(zn.area).backgroundColor),zn&&!n&&zn.draw()}window.addEventListener("beforeprint",()=>OM(!0));window.addEventListener("afterprint",()=>OM(!1));window.pitchpointViewer={mount:iT,state:()=>zn?FM(zn):null,seek:n=>Bt().seek(n),play:()=>Bt().toggle(!0),pause:()=>Bt().toggle(!1),step:n=>Bt().step(n),repeat:n=>Bt().loop(n),advance:n=>Bt().advance(n),follow:n=>Bt().follow(n),look:(n,e,t)=>Bt().views?.look(n,e,t),view:n=>Bt().views?.named(n,!0),project:n=>Bt().project(n==="parallel"),section:(n,e)=>n?Bt().section?.set(n,e):Bt().section?.turn(!1),show:(n,e=!0)=>Bt().curves.plots.show(n,e),spectrum:(n,e)=>Bt().curves.spectrum(n,e),magnify:n=>Bt().magnify(n),arrows:(n,e=!0)=>Bt().arrows(n,e),density:n=>Bt().density(n==="sparse"),lines:(n=!0)=>Bo(Bt(),e=>e.showsLines=n),pattern:n=>Bo(Bt(),e=>e.mode=n),shade:n=>Bo(Bt(),e=>e.shade=e.pressures?n:"load"),gauge:(n,e)=>ch(Bt(),n,e),live:n=>Bt().live(n),mode:n=>Bt().modes.choose(n),file:(n,e=1)=>n==="png"?zh(Bt(),e):n==="glb"?Hh(Bt()):Gh(Bt()),draw:()=>{Bt().orbit?.settle(),Bt().draw()}};})();
