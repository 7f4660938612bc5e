// Bundles the page, and writes what is before and after its scenes as C++: node build.mjs SOURCES OUT.cpp
// Takes esbuild and three.js from the folder of this file.

import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const [sources, out] = process.argv.slice(2);

async function bundle(name) {
  const { outputFiles } = await build({
    entryPoints: [join(sources, name)], bundle: true, minify: true, write: false, format: 'iife', target: 'es2022',
    nodePaths: [join(dirname(fileURLToPath(import.meta.url)), 'node_modules')]
  });
  return outputFiles[0].text.trim();
}

// Adjacent literals, as some compilers limit the length of one.
function literal(text) {
  return (text.match(/[^]{1,2000}/g) || ['']).map(part => '  ' + JSON.stringify(part).replaceAll('?', '\\?')).join('\n');
}

const style = await bundle('page.css'), script = await bundle('page.js');
const page = readFileSync(join(sources, 'page.html'), 'utf8')
  .replace('/* style */', () => style).replace('/* script */', () => script);
const [head, tail] = page.split('<!-- scenes -->\n');
writeFileSync(out, `// Made from src/page.

#include "page_text.h"

namespace Canonical_pose_tool {

const char* const PAGE_HEAD =
${literal(head)};

const char* const PAGE_TAIL =
${literal(tail)};

} // namespace Canonical_pose_tool
`);
