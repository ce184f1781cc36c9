// node validate.mjs FILE.glb ...: what the Khronos validator says, as JSON by file.
import { readFileSync } from "node:fs";
import validator from "gltf-validator";

const found = {};
for (const path of process.argv.slice(2)) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(path)), { maxIssues: 100 });
  found[path] = {
    errors: report.issues.numErrors,
    warnings: report.issues.numWarnings,
    first: report.issues.messages.filter((each) => each.severity < 2).map((each) => `${each.code} at ${each.pointer}: ${each.message}`)[0] ?? "",
  };
}
console.log(JSON.stringify(found));
