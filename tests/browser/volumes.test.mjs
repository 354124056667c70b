// What `snug lesson check` accepts, the page opens: a small lesson of each volume in both dimensions, whatever the
// site's own lessons have.
import { after, before, test } from "node:test";
import {
  add_lesson, assert, pixels_of_volume, ready, start_for_pictures, state, still, stop, until, visit,
} from "./support.mjs";

before(async () => {
  await start_for_pictures();
  for (const [dim, volumes] of kEach)
    for (const [volume, algorithm] of Object.entries(volumes))
      await add_lesson(`test-${volume}-${dim}`, small_lesson(volume, algorithm, dim));
  await add_lesson("test-broken", small_lesson("sphere", "welzl", 3).replace("count = 24", "count = 0"));
});
after(stop);

const kVolumes = {
  sphere: "welzl", aabb: "min_max", obb: "pca", capsule: "pca", lozenge: "pca", kdop: "k14", hull: "quickhull",
};
const kFlatVolumes = {
  sphere: "ritter", aabb: "min_max", obb: "exact", capsule: "pca", lozenge: "pca", kdop: "k8", hull: "quickhull",
};
const kEach = [[3, kVolumes], [2, kFlatVolumes]];

const small_lesson = (volume, algorithm, dim) => `version = 2
title = "${volume}"
summary = "A volume around a few points."
minutes = 1
volume = "${volume}"
algorithms = ["${algorithm}"]

[points]
dim = ${dim}
generate = "gaussian"
count = 24

[[section]]
title = "A volume"
text = "It is fitted around the points."
`;

for (const [dim, volumes] of kEach) {
  for (const volume of Object.keys(volumes)) {
    test(`a lesson of the volume ${volume} in ${dim}-D opens, steps to its end and shows it`, async (t) => {
      const id = `test-${volume}-${dim}`;
      const page = await visit(t, `?lesson=${id}&step=0`);
      const begin = await pixels_of_volume(page);
      let now = await state(page);
      assert.equal(now.lesson, id);
      const { framesDrawn } = now;
      for (let presses = 0; now.step < now.steps; ++presses) {
        assert.ok(presses < 500);
        await page.keyboard.press("PageDown");
        now = await until(page, (it, step) => it.step > step, now.step);
      }
      await still(page);
      now = await state(page);
      assert.ok(now.framesDrawn > framesDrawn);
      const sizes = Object.values(now.readout).filter((figure) => typeof figure === "number" && figure > 0);
      assert.ok(sizes.length > 0, JSON.stringify(now.readout));
      assert.ok(now.caption.length > 5);
      const end = await pixels_of_volume(page);
      t.diagnostic(`${begin} to ${end} pixels`);
      assert.ok(end > begin + 150, `${begin} pixels of the volume's colour at the start, ${end} at the end`);
    });
  }
}

test("what cannot be read is said by its line, and the lessons stay within reach", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter");
  await choose_broken(page);
  await page.locator("#veil").getByText(/test-broken\.toml:11/).waitFor();
  await page.goBack();
  await ready(page);
  await page.locator("#veil").waitFor({ state: "hidden" });
  assert.equal((await state(page)).lesson, "sphere-ritter");
});

async function choose_broken(page) {
  await page.locator("#picker").click();
  await page.locator('#lessons a[href="?lesson=test-broken"]').click();
}
