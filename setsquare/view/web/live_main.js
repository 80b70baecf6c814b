// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Puts the page together.

const byId = (id) => document.getElementById(id);

/** Replaces the list's items by texts. */
function fillList(list, texts) {
  list.replaceChildren(...texts.map((text) => element("li", "", text)));
  list.hidden = texts.length === 0;
}

class LivePage {
  constructor() {
    this.pose = null;
    this.report = null;
    this.drawing = new LiveDrawing((pose) => {
      this.send({ do: "set_pose", ...pose });
      this.setPlacing(false);
    });
    this.link = new LiveLink({
      report: (report) => this.showReport(report),
      map: (map) => this.showMap(map),
      way: ({ points }) => this.drawing.showWay(points),
      pose: (pose) => this.showPose(pose),
      answer: ({ text }) => { byId("answer").textContent = text; },
    }, (isConnected) => this.setConnected(isConnected));
    byId("save").addEventListener("click", () => this.send({ do: "save" }));
    byId("pause").addEventListener("click", () => this.send({ do: "pause", on: !this.report.paused }));
    byId("set-pose").addEventListener("click", () => this.setPlacing(!this.drawing.isPlacing));
    addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.setPlacing(false);
    });
  }

  send(command) {
    byId("answer").textContent = "asked";
    this.link.send(command);
  }

  setPlacing(isPlacing) {
    this.drawing.setPlacing(isPlacing);
    byId("set-pose").setAttribute("aria-pressed", isPlacing);
    byId("answer").textContent = isPlacing
      ? "Press where the robot is, and drag the way it looks; Escape to leave it." : "";
  }

  setConnected(isConnected) {
    byId("state").classList.toggle("away", !isConnected);
    if (isConnected) return;
    byId("state").textContent = "no connection to the robot: tried again each second";
    for (const button of document.querySelectorAll(".commands button")) button.disabled = true;
  }

  showReport(report) {
    this.report = report;
    byId("state").textContent = report.paused ? report.doing + ", paused" : report.doing;
    fillList(byId("warnings"), report.warnings);
    this.drawing.showPlaces(report.places);
    const save = byId("save");
    save.disabled = !report.canSave;
    save.title = report.canSave ? "" : "Only a map that is being made, and with -o DIR";
    const setPose = byId("set-pose");
    setPose.disabled = !report.canSetPose;
    setPose.title = report.canSetPose ? "" : "Only where the robot is localised in a map";
    const pause = byId("pause");
    pause.disabled = false;
    pause.setAttribute("aria-pressed", report.paused);
    this.showFacts();
  }

  showMap(map) {
    this.drawing.show(map);
    byId("map-empty").hidden = true;
    byId("map-facts").textContent = "map " + whole(map.number) + ", " +
      counted(map.closures.length, "loop closure", "loop closures");
    byId("doubt-section").hidden = map.doubts.length === 0;
    fillList(byId("doubts"), map.doubts.map(({ kind, reason }) => kind + ": " + reason));
  }

  showPose(pose) {
    this.pose = pose;
    this.drawing.showPose(pose);
    this.showFacts();
  }

  showFacts() {
    const facts = this.report ? [...this.report.values] : [];
    const { pose } = this;
    if (pose) {
      facts.unshift(["pose", pose.placed
        ? "x " + inMetres(pose.x) + ", y " + inMetres(pose.y) + ", " + inDegrees(pose.heading)
        : "its place in the map is not known"]);
      if (pose.placed && pose.sigma > 0) facts.splice(1, 0, ["known to", sigmaText(pose.sigma)]);
      facts.splice(1, 0, ["last scan", pose.status]);
    }
    byId("facts").replaceChildren(...facts.flatMap(([name, value]) => [element("dt", "", name), element("dd", "", value)]));
  }
}

// For the console and for tests: what is shown, and where.
window.setsquare = new LivePage();
