// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The lines on standard input as messages in CDR, for sqlite_recording.py: one JSON object per line,
// {"topic", "type", "log_time_ns", "base64"}.
import { messageOf, print, readLines, writerOf } from "./messages.mjs";

for await (const line of readLines()) {
  const writer = writerOf("cdr", line.kind);
  print({
    topic: line.topic,
    type: writer.type,
    log_time_ns: line.log_time_ns,
    base64: Buffer.from(writer.write(messageOf(line))).toString("base64"),
  });
}
