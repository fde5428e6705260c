// Wide tables scroll by keyboard too: the theme wraps them when the page is there.
window.addEventListener("load", () => {
  for (const table of document.querySelectorAll(".md-typeset__scrollwrap")) table.tabIndex = 0;
});
