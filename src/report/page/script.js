// The pictures of each scene: which one is seen, beside what, where the border runs, how large.
for (const viewer of document.querySelectorAll(".viewer")) {
  const find = (what) => viewer.querySelector(what);
  const pane = find(".pane"), slider = find(".slider"), rung = find(".rung"), zoom = find(".zoom");
  const update = () => {
    const beside = find("input[type=radio]:checked").value;
    for (const image of viewer.querySelectorAll("img[data-rung]")) {
      const chosen = image.dataset.rung === rung.value;
      image.hidden = !chosen || (image.classList.contains("heatmap") && beside !== "heatmap");
    }
    pane.style.setProperty("--at", slider.value + "%");
    pane.style.setProperty("--zoom", zoom.value);
    find(".scale").hidden = beside !== "heatmap";
    find(".left-name").textContent = rung.selectedOptions[0].textContent;
    find(".right-name").textContent = beside === "heatmap" ? "error map of the same" : "reference";
  };
  viewer.addEventListener("input", update);
  update();
}
