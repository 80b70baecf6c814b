# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""ROS 2 recordings in SQLite by Python's own sqlite3: written, and listed.

Messages are dictionaries as write_cdr.mjs prints them: topic, type, log_time_ns, base64.
"""
import base64
import os
import sqlite3
import urllib.parse

TABLES = """
CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);
CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL,
                      metadata TEXT NOT NULL);
CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
                    serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);
CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,
                      timestamp INTEGER NOT NULL, data BLOB NOT NULL);
CREATE INDEX timestamp_idx ON messages (timestamp ASC);
INSERT INTO schema VALUES (3, 'humble');
"""

METADATA = """rosbag2_bagfile_information:
  version: 5
  storage_identifier: sqlite3
  compression_format: ""
  compression_mode: ""
  relative_file_paths:
"""


def write_file(path, messages):
    with sqlite3.connect(path) as connection:
        connection.executescript(TABLES)
        ids = {}
        for message in messages:
            topic = message["topic"]
            if topic not in ids:
                ids[topic] = len(ids) + 1
                connection.execute("INSERT INTO topics VALUES (?, ?, ?, 'cdr', '')",
                                   (ids[topic], topic, message["type"]))
            connection.execute(
                "INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)",
                (ids[topic], int(message["log_time_ns"]), base64.b64decode(message["base64"])))
    connection.close()


def write_folder(folder, messages, num_files=3):
    """A folder as rosbag2 leaves it, its messages in several files."""
    os.mkdir(folder)
    name = os.path.basename(folder)
    num_of_file = -(-len(messages) // num_files)
    with open(os.path.join(folder, "metadata.yaml"), "w", encoding="utf-8") as metadata:
        metadata.write(METADATA)
        for file in range(num_files):
            part = messages[file * num_of_file:(file + 1) * num_of_file]
            write_file(os.path.join(folder, f"{name}_{file}.db3"), part)
            metadata.write(f"    - {name}_{file}.db3\n")


def messages_in(path):
    """The messages of a file in the order of recording."""
    uri = f"file:{urllib.parse.quote(os.path.abspath(path))}?mode=ro&immutable=1"
    connection = sqlite3.connect(uri, uri=True)
    rows = connection.execute("SELECT name, type, timestamp, data FROM messages JOIN topics "
                              "ON topics.id = topic_id ORDER BY messages.id")
    for topic, kind, log_time_ns, data in rows:
        yield {"topic": topic, "type": kind, "log_time_ns": str(log_time_ns),
               "base64": base64.b64encode(data).decode()}
    connection.close()
