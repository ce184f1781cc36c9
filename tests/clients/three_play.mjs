// node three_play.mjs CHROMIUM FILE.glb FOLDER TIME ...: play a face in three.js in a headless browser.
// For every time FOLDER gets a picture TIME.png and TIME.json, the places of all vertices (base64 of float32, metres).
import { createServer } from "node:http";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, extname, join, normalize } from "node:path";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const [program, file, folder, ...times] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const three = join(dirname(createRequire(import.meta.url).resolve("three")), "..");
const kinds = { ".html": "text/html", ".js": "text/javascript", ".glb": "model/gltf-binary" };

const server = createServer((request, response) => {
  const path = normalize(new URL(request.url, "http://localhost").pathname);
  const known = path === "/" ? join(here, "three_page.html") : path === "/face.glb" ? file
    : path.startsWith("/three/") ? join(three, path.slice("/three/".length)) : null;
  if (known === null) return response.writeHead(404).end();
  response.writeHead(200, { "content-type": kinds[extname(known)] ?? "application/octet-stream" });
  response.end(readFileSync(known));
});
await new Promise((ready) => server.listen(0, "127.0.0.1", ready));

const browser = await chromium.launch({
  executablePath: program,
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
});
try {
  const page = await browser.newPage({ viewport: { width: 640, height: 640 } });
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  await page.waitForFunction("window.play", null, { timeout: 120_000 });
  for (const time of times) {
    const places = await page.evaluate((t) => window.play(t), Number(time));
    writeFileSync(join(folder, `${time}.json`), JSON.stringify(places));
    await page.screenshot({ path: join(folder, `${time}.png`) });
  }
  console.log(JSON.stringify({ ...(await page.evaluate("window.about")), complaints }));
} finally {
  await browser.close();
  server.close();
}
