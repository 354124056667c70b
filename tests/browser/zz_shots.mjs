import { start, stop, visit, state, until, kPhone, kWide, still } from "./support.mjs";
await start();
const after=[]; const t={after:(f)=>after.push(f)};
for (const [id, keys, name, opt] of JSON.parse(process.argv[2])) {
  const page = await visit(t, `?lesson=${id}`, opt==="phone"?kPhone:opt==="big"?{viewport:{width:1920,height:1080}}:opt==="dark"?{...kWide,colorScheme:"dark"}:kWide);
  for (const k of keys) { if (k.startsWith("wait")) await page.waitForTimeout(+k.slice(4)); else if (k.startsWith("click:")) await page.getByRole("button",{name:k.slice(6)}).first().click(); else await page.keyboard.press(k); await still(page).catch(()=>{}); }
  await page.screenshot({path:`/tmp/h/s_${name}.png`}); const s=await state(page);
  console.log(name, s.step, s.steps, s.caption, JSON.stringify(s.asked)?.slice(0,200));
}
await stop();
