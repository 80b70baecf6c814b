// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The connection to the robot: texts of JSON come, commands go. Where it breaks it is tried again.

class LiveLink {
  /** `hear`: by the type of a message; `changed` with whether there is a connection. */
  constructor(hear, changed) {
    this.hear = hear;
    this.changed = changed;
    this.open();
  }

  open() {
    this.socket = new WebSocket("ws://" + location.host + "/live");
    this.socket.onopen = () => this.changed(true);
    this.socket.onmessage = ({ data }) => {
      const message = JSON.parse(data);
      this.hear[message.type]?.(message);
    };
    this.socket.onclose = () => {
      this.changed(false);
      setTimeout(() => this.open(), 1000);
    };
  }

  send(command) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(command));
  }
}
