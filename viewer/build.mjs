// SPDX-License-Identifier: Apache-2.0
// Builds the scripts that are embedded in pages, with their licences as headers: viewer.js (src/main.js with
// three.js and uPlot) and plots.js (the published build of plotly.js for Cartesian axes).
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));

/** Licence notice as the header comment of a script. @param {string} file */
function banner(file) {
  const notice = readFileSync(join(here, file), "utf8").trim();
  if (notice.includes("*/")) throw new Error(`${file} would end the comment it becomes`);
  return `/*!\n${notice}\n*/`;
}

/** @param {string} name of the script @param {string} script */
function write(name, script) {
  // The script is embedded in a <script> element, where these sequences would end or hide it.
  const text = script.replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--");
  const out = join(here, "../src/pitchpoint/viz/assets", name);
  writeFileSync(out, text);
  console.log(`${out}: ${(text.length / 1000).toFixed(0)} kB`);
}

/**
 * Bundles three.js from its sources, so that unused modules are dropped, and strips comments and indentation
 * from its shaders.
 */
const lean = {
  name: "lean-three",
  setup(build) {
    build.onLoad(
      { filter: /three\/src\/renderers\/shaders\/Shader(Chunk|Lib)\/.*\.glsl\.js$/ },
      ({ path }) => {
        const text = readFileSync(path, "utf8");
        const contents = text.replace(/`([^`]*)`/g, (_, glsl) => {
          const bare = glsl.replace(/\/\*[\s\S]*?\*\//g, "").replace(/\/\/.*$/gm, "");
          return "`" + bare.replace(/^[ \t]+|[ \t]+$/gm, "").replace(/\n{2,}/g, "\n") + "`";
        });
        return { contents, loader: "js" };
      },
    );
  },
};

const result = await build({
  absWorkingDir: here,
  entryPoints: ["src/main.js"],
  bundle: true,
  alias: { three: join(here, "node_modules/three/src/Three.js") },
  plugins: [lean],
  minify: true,
  write: false,
  format: "iife",
  target: "es2022",
  loader: { ".css": "text" },
  legalComments: "none",
  // Escape sequences keep the script valid in pages that declare no encoding.
  charset: "ascii",
  banner: { js: banner("LICENSES.txt") },
});
write("viewer.js", result.outputFiles[0].text);

const plots = readFileSync(
  join(here, "node_modules/plotly.js-cartesian-dist-min/plotly-cartesian.min.js"),
  "utf8",
);
write("plots.js", `${banner("LICENSES-plots.txt")}\n${plots}`);
