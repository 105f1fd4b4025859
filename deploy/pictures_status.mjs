// pictures_status.mjs CHROMIUM ADDRESS PNG: the status page once there is something in its charts.
import { createRequire } from "node:module";

const packages = createRequire(`${process.cwd()}/build/web-packages/package.json`);
const { chromium } = packages("playwright-core");
const [executablePath, address, path] = process.argv.slice(2);
const SECONDS = Number(process.env.SECONDS_OF_CHARTS ?? 150);

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu"] });
const page = await browser.newPage({ viewport: { width: 1280, height: 1200 } });
await page.goto(address);
await page.getByRole("button", { name: "Session" }).first().click();
await page.waitForTimeout(1000 * SECONDS);
await page.screenshot({ path, fullPage: true });
await browser.close();
