// The rooms of the studio, in the order in which they are offered. A room is a class `Room` in a module of its own, made when
// it is first visited, with the studio (studio.js) and the element that is all its own. What it may have:
//   show(path)     it comes in sight; path is what stands behind its name in the address (#name/path)
//   hide()         another one comes in sight
//   welcome(anew)  the server is there, for the first time or again: what was known may no longer be true; anew if it is
//                  another one than before, whose numbers mean other jobs, tags and events
//   take(message)  what the server says, in sight or not
export const ROOMS = [
  // What the first one needs is named in index.html, too: nobody waits for one file to name the next.
  { name: "jobs", title: "Jobs", load: () => import("./jobs-room.js") },
  { name: "reactions", title: "Reactions", styles: ["reactions.css"], load: () => import("./reactions-room.js") },
  {
    name: "variables",
    title: "Variables",
    styles: ["variables.css", "libraries/uPlot.min.css"],
    load: () => import("./variables-room.js"),
  },
  { name: "code", title: "Code", styles: ["code.css"], load: () => import("./code-room.js") },
  { name: "robot", title: "Robot", styles: ["robot.css"], load: () => import("./robot-room.js") },
];
