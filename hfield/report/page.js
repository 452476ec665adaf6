const place = (id) => document.getElementById(id);

// The filter: a line is shown if its section, its verdict and its words are those asked for.
const form = place("filter"), shown = place("shown"), table = document.querySelector(".matrix");
const heads = [...table.tHead.rows[0].cells];
const lines = [...table.tBodies].flatMap((body) =>
  [...body.rows].filter((row) => row.dataset.id).map((row) => {
    const article = place(row.dataset.id);
    return { row, article, section: body.dataset.s, words: article.textContent.toLowerCase() };
  }));

function apply() {
  const section = place("section").value, field = place("field").value, verdict = place("verdict").value;
  const word = place("search").value.trim().toLowerCase();
  const column = heads.findIndex((head) => head.dataset.f === field);
  let count = 0;
  for (const line of lines) {
    const cells = column > 0 ? [line.row.cells[column]] : [...line.row.cells].slice(1);
    const fits = (!section || `${line.section}.`.startsWith(`${section}.`))
      && (!word || line.words.includes(word))
      && (verdict ? cells.some((cell) => cell.classList.contains(verdict))
        : column < 1 || cells[0].className !== "");
    line.row.hidden = line.article.hidden = !fits;
    count += fits;
  }
  for (const body of table.tBodies) body.hidden = ![...body.rows].some((row) => row.dataset.id && !row.hidden);
  for (const part of document.querySelectorAll(".of-section"))
    part.hidden = !part.querySelector("article:not([hidden])");
  for (const row of table.rows)
    if (!row.classList.contains("group"))
      [...row.cells].forEach((cell, n) => { cell.hidden = column > 0 && n > 0 && n !== column; });
  shown.textContent = shown.dataset.text.replace("{n}", count).replace("{all}", lines.length);
}

form.hidden = false;
form.addEventListener("input", apply);
form.addEventListener("submit", (event) => event.preventDefault());
form.addEventListener("reset", () => setTimeout(apply));
apply();

// A link to a claim that the filter hides shows it again, and opens its decisions.
function visit() {
  const article = place(decodeURIComponent(location.hash.slice(1)));
  if (!article || !article.matches("article")) return;
  if (article.hidden) { form.reset(); apply(); }
  const details = article.querySelector("details");
  if (details) details.open = true;
  article.scrollIntoView();
}
addEventListener("hashchange", visit);
visit();

// Certificates: one compressed text, a line each, unpacked at the first click.
let unpacked = null;
function unpack() {
  const bytes = Uint8Array.from(atob(place("pack").textContent), (char) => char.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).text().then((text) => text.split("\n"));
}
document.addEventListener("click", async (event) => {
  const button = event.target.closest("button[data-c]");
  if (!button) return;
  unpacked ??= unpack();
  const all = button.dataset.c === "all", texts = await unpacked;
  const text = all ? texts.join("\n") : JSON.stringify(JSON.parse(texts[button.dataset.c]), null, 1);
  const claim = all ? "" : button.closest("article").id.replace("claim-", "");
  const field = all ? "" : button.dataset.f.replace(/[^\w-]+/g, "_");
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text + "\n"], { type: "application/json" }));
  link.download = all ? "certificates.jsonl" : `${claim}.${field}.json`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
});

// Paper shows everything.
let opened = [];
addEventListener("beforeprint", () => {
  opened = [...document.querySelectorAll("details:not([open])")];
  for (const details of opened) details.open = true;
});
addEventListener("afterprint", () => { for (const details of opened) details.open = false; });

// What is wider than the page can be scrolled by keys as well.
function reach() {
  for (const box of document.querySelectorAll(".scroll:not(.tall), .formula")) {
    if (box.scrollWidth > box.clientWidth) {
      box.tabIndex = 0;
      box.setAttribute("role", "group");
      const title = box.querySelector("caption") || box.closest("article, li, section").querySelector("h4, h3, h2");
      box.setAttribute("aria-label", title.textContent);
    }
  }
}
// The matrix is cut where more of it lies to the right.
const wide = document.querySelector(".tall");
function mark() {
  wide.classList.toggle("cut", wide.scrollLeft + wide.clientWidth < wide.scrollWidth - 1);
}
wide.addEventListener("scroll", mark, { passive: true });
form.addEventListener("input", mark);
form.addEventListener("reset", () => setTimeout(mark));
addEventListener("resize", mark);
mark();
addEventListener("resize", reach);
document.addEventListener("toggle", reach, true);
reach();
