// Looks at a report as a person would and writes down what is there, for tests/report.rs.
addEventListener("load", () => {
  const all = (what) => [...document.querySelectorAll(what)];
  const viewer = all(".viewer")[0];
  const inside = (what) => viewer.querySelector(what);
  const shown = () => all(".viewer img").filter((image) => image.getClientRects().length > 0).map((image) => image.className);
  const clip = () => getComputedStyle(inside("img.picture:not([hidden])")).clipPath;
  const change = (element, value) => {
    element.value = value;
    element.dispatchEvent(new Event("input", { bubbles: true }));
  };
  const found = {
    plots: all("svg.plot").map((plot) => {
      const box = plot.getBoundingClientRect();
      const marks = [...plot.querySelectorAll(".mark")];
      const within = (mark) => {
        const at = mark.getBoundingClientRect();
        return at.left > box.left - 2 && at.right < box.right + 2 && at.top > box.top - 2 && at.bottom < box.bottom + 2;
      };
      return { width: box.width, height: box.height, marks: marks.length, within: marks.every(within) };
    }),
    colors: new Set(all(".plots .series").map((series) => getComputedStyle(series).getPropertyValue("--ink-of"))).size,
    images: all("img").map((image) => image.naturalWidth),
    choices: all(".rung option").length,
    overflow: document.documentElement.scrollWidth - innerWidth,
    failures: all(".failed").map((element) => element.textContent),
  };
  found.before = clip();
  change(inside(".slider"), "20");
  found.after = clip();
  found.beside_reference = shown();
  inside("input[value=heatmap]").click();
  found.beside_heatmap = shown();
  change(inside(".rung"), all(".rung option").at(-1).value);
  found.name = inside(".left-name").textContent;
  found.last_choice = all(".rung option").at(-1).textContent;
  found.problems = window.problems;
  const note = document.createElement("pre");
  note.id = "found";
  note.textContent = JSON.stringify(found);
  document.body.append(note);
});
