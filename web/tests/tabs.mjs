// Every tab with content: where a link leads to it, and what is there once it is whole.

import { open } from "./page.mjs";

export const TABS = {
  start: ["#start?drive=1.003", "#start-seen:has-text('evidence')"],
  plane: ["#plane?a1=-1/4&a2=1/2&n=12", "#plane-status[data-full=true]"],
  motion: ["#motion", "#panel-motion :text('The theory is of first order')"],
  theory: ["#theory?place=plane&x=-3/2&y=9/10&n=9", "#theory-out table"],
  check: ["#check?example=word", "#check-results [data-verdict=proved]"],
  rejected: ["#check?example=false", "#check-results [data-verdict=false]"],
};

/** Views of a tab that are as long as another, read where all is. */
export const VIEWS = {
  born: ["#motion?view=born&from=-0.01&to=0.01", "#panel-motion p:has-text('Dotted: the prediction')"],
  box: ["#plane?a1=-0.4..=0.3&a2=0.4..=0.6&n=12", "#plane-facts :text('the words are certain on')"],
  range: ["#check?example=branch", "#check-results table.parts"],
  tasks: [
    "#motion?view=tasks",
    "#panel-motion h2:has-text('period-4: ')",
    async (page) => {
      await page.getByLabel("Task", { exact: true }).selectOption("period-4");
      await page.getByRole("button", { name: "Run", exact: true }).click();
    },
  ],
};

/** A tab with its content. */
export async function tab(browser, name, options) {
  const [fragment, whole] = TABS[name];
  const opened = await open(browser, fragment, { reducedMotion: "reduce", ...options });
  await opened.page.locator(whole).first().waitFor();
  return opened;
}
