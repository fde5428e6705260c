// What a newcomer types into the search box leads somewhere.

const WORDS = ["yaw", "conicity", "kappa", "traction", "rolling radius", "bearing", "CONTACT", "FASTSIM"];

export async function search(place) {
  const faults = [];
  for (const word of WORDS) {
    if (!(await finds(place, word))) faults.push(`search: nothing is found for ${word}`);
  }
  console.log(`search: ${WORDS.length - faults.length} of ${WORDS.length} words found`);
  return faults;
}

// In a page of its own: a box that still closes lets letters through to the page, where "p" and "n" turn it.
async function finds(place, word) {
  const page = await place.open("index.html");
  await page.locator(".md-search__input").pressSequentially(word);
  const found = page.waitForSelector(".md-search-result__item", { timeout: 60_000 });
  const answer = await found.then(() => true, () => false);
  await page.context().close();
  return answer;
}
