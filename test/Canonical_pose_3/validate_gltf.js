// Runs Khronos' validator on files: node validate_gltf.js FILE...
// Prints a line per file, and fails if there is an error or a warning.

const fs = require('fs');
const validator = require('gltf-validator');

async function main(files) {
  let defects = 0;
  for (const file of files) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
    const { numErrors, numWarnings, numInfos, messages } = report.issues;
    defects += numErrors + numWarnings;
    console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} notes`,
      ...new Set(messages.map(message => message.code)));
  }
  process.exitCode = defects > 0 ? 1 : 0;
}

main(process.argv.slice(2));
