// What a newcomer types into the search box leads somewhere.

const WORDS = ["yaw", "conicity", "kappa", "traction", "rolling radius", "bearing", "CONTACT", "FASTSIM"];

export async function search(place) {
  const page = await place.open("index.html");
  const faults = [];
  for (const word of WORDS) {
    await page.fill(".md-search__input", "");
    await page.click(".md-search__input");
    await page.keyboard.type(word);
    try {
      await page.waitForSelector(".md-search-result__item", { timeout: 20_000 });
    } catch {
      faults.push(`search: nothing is found for ${word}`);
    }
    await page.keyboard.press("Escape");
  }
  console.log(`search: ${WORDS.length - faults.length} of ${WORDS.length} words found`);
  await page.context().close();
  return faults;
}
