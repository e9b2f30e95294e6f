// Fingers zoom a plot as the mouse does, which is all that uPlot knows of: from where one comes down to where it leaves.
const LEAST_PIXELS = 16;

export function zoomByTouch(chart, zoomed) {
  const { over } = chart;
  let from = null;
  const none = { left: 0, width: 0, top: 0, height: 0 };
  const range = (event) => {
    const to = event.clientX - over.getBoundingClientRect().left;
    return { left: Math.min(from, to), width: Math.abs(to - from), top: 0, height: over.clientHeight };
  };
  // Across, a finger selects; up and down it scrolls the page.
  over.style.touchAction = "pan-y";
  over.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch" && event.isPrimary) from = event.clientX - over.getBoundingClientRect().left;
  });
  over.addEventListener("pointermove", (event) => {
    if (from !== null && event.isPrimary) chart.setSelect(range(event), false);
  });
  over.addEventListener("pointerup", (event) => {
    if (from === null || !event.isPrimary) return;
    const { left, width } = range(event);
    from = null;
    chart.setSelect(none, false);
    if (width < LEAST_PIXELS) return;
    zoomed();
    chart.setScale("x", { min: chart.posToVal(left, "x"), max: chart.posToVal(left + width, "x") });
  });
  over.addEventListener("pointercancel", () => {
    from = null;
    chart.setSelect(none, false);
  });
}
