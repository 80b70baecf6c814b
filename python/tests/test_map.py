# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
import subprocess
import threading

import numpy as np
import pytest

import setsquare


@pytest.fixture(scope="module")
def log(simulated_log):
    return simulated_log / "scans.clf"


@pytest.fixture(scope="module")
def mapped(log):
    return setsquare.map_log(log)


def test_the_files_are_those_of_the_command(command, log, mapped, tmp_path):
    subprocess.run([command, "map", str(log), "-o", str(tmp_path / "by_command")], check=True,
                   capture_output=True)
    # The same name of the log as on the command line: it stands in run.json.
    names = setsquare.map_log(str(log)).save(tmp_path / "by_python")
    assert "trajectory.tum" in names and names[-1] == "run.json"
    for name in names:
        by_command = (tmp_path / "by_command" / name).read_bytes()
        assert (tmp_path / "by_python" / name).read_bytes() == by_command, name


def test_a_map_lives_on_disk(mapped, tmp_path):
    mapped.save(tmp_path / "one", pose_of="sensor")
    loaded = setsquare.Map.load(tmp_path / "one")
    assert repr(loaded) == repr(mapped) and loaded.format == mapped.format
    assert loaded.findings == mapped.findings and loaded.verdict == mapped.verdict
    assert np.array_equal(loaded.scans, mapped.scans)
    assert np.array_equal(loaded.graph.constraints, mapped.graph.constraints)
    for name in loaded.save(tmp_path / "two"):  # The frame is that of the map that was saved.
        assert (tmp_path / "two" / name).read_bytes() == (tmp_path / "one" / name).read_bytes(), name
    loaded.save_file(tmp_path / "alone.setsquare")
    saved = (tmp_path / "alone.setsquare").read_bytes()
    assert saved == (tmp_path / "one" / "map.setsquare").read_bytes()
    (tmp_path / "short.setsquare").write_bytes(saved[:-1])
    with pytest.raises(setsquare.FormatError, match="cut short"):
        setsquare.Map.load(tmp_path / "short.setsquare")
    with pytest.raises(setsquare.FileError):
        setsquare.Map.load(tmp_path / "absent")


def test_is_right(mapped, simulated_log):
    truth = setsquare.Trajectory.read_tum(str(simulated_log / "truth.tum"))
    assert setsquare.evaluate_trajectory(mapped.trajectory(), truth).translation_m.rmse < 0.1
    assert mapped.verdict.startswith("consistent"), mapped.doubts


def test_scan_by_scan_gives_the_same(log, mapped):
    mapper = setsquare.Mapper(num_threads=1)
    for record in setsquare.read_log(log):
        placed = mapper.add(record.scan, record.T_odom_base)
        assert placed.status in ("tracked", "degenerate", "recovered", "lost")
    assert len(mapper) == len(mapped)
    again = mapper.finish()
    assert np.array_equal(again.scans, mapped.scans)
    assert np.array_equal(again.graph.nodes, mapped.graph.nodes)


def in_threads(work, num_threads=4):
    threads = [threading.Thread(target=work) for _ in range(num_threads)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()


def test_threads_share_a_reader(log):
    expected = [record.stamp_ns for record in setsquare.read_log(log)]
    reader, found = setsquare.read_log(log), []

    def work():
        for record in reader:
            found.append(record.stamp_ns)
            assert reader.problems == "" and reader.format

    in_threads(work)
    assert sorted(found) == sorted(expected)


def test_threads_share_a_mapper(log):
    scans = [record.scan for record in setsquare.read_log(log)][:10]
    mapper = setsquare.Mapper(audit=False, num_threads=1)
    in_threads(lambda: [mapper.add(scan) for scan in scans])
    assert len(mapper) == 4 * len(scans)
    assert len(mapper.finish()) == len(mapper)


def test_arrays_fit_together(mapped):
    scans, trajectory = mapped.scans, mapped.trajectory()
    placed = scans[scans["is_placed"]]
    assert np.array_equal(trajectory.stamps_ns, placed["stamp_ns"])
    assert np.array_equal(trajectory.poses[:, 0], placed["x_m"])
    assert len(mapped.graph.nodes) == len(mapped.keyframes)
    constraints = mapped.graph.constraints
    assert constraints["information"].shape == (len(constraints), 3, 3)
    assert constraints["to_node"].max() < len(mapped.graph.nodes)
    assert set(mapped.closures["axes"]) <= {b"xy", b"x", b"y"}
    assert (scans["position_sigma_m"][scans["is_placed"]] < 1.0).all()


def test_the_grid_is_the_map(mapped):
    grid = mapped.grid()
    assert grid.probability.shape == grid.occupancy.shape == grid.log_odds.shape
    assert set(np.unique(grid.occupancy)) == {-1, 0, 100}
    left, right, bottom, top = grid.extent_m
    poses = mapped.trajectory().poses
    assert left < poses[:, 0].min() and poses[:, 0].max() < right
    assert bottom < poses[:, 1].min() and poses[:, 1].max() < top
    # The robot drove through what is free.
    columns = ((poses[:, 0] - left) / grid.resolution_m).astype(int)
    rows = ((poses[:, 1] - bottom) / grid.resolution_m).astype(int)
    assert (grid.occupancy[rows, columns] == 0).mean() > 0.99


def test_progress_is_told_and_ends_the_work(log):
    shares = []
    setsquare.map_log(log, audit=False, progress=shares.append)
    assert all(0.0 <= share <= 1.0 for share in shares)

    class Enough(Exception):
        pass

    def stop(_):
        raise Enough

    with pytest.raises(Enough):
        for _ in range(20):  # Told a few times a second: a fast machine may need several maps.
            setsquare.map_log(log, progress=stop)


def test_errors_have_the_commands_words(tmp_path):
    with pytest.raises(setsquare.FileError, match="No such file or directory"):
        setsquare.map_log(tmp_path / "absent.clf")
    with pytest.raises(OSError):
        setsquare.read_log(tmp_path / "absent.clf")
    for read in (setsquare.read_log, setsquare.map_log):
        with pytest.raises(setsquare.ParameterError, match="must name a log"):
            read([])
    with pytest.raises(ValueError, match="zero byte"):
        setsquare.read_log("absent.clf\0.txt")
    (tmp_path / "empty.clf").write_text("")
    with pytest.raises(setsquare.FormatError):
        list(setsquare.read_log(tmp_path / "empty.clf"))
    with pytest.raises(TypeError, match="colour"):
        setsquare.read_log(tmp_path / "empty.clf", colour="blue")
    for wrong in ({"sensor": None}, {"fov_deg": "wide"}, {"mountings": {"FLASER": (1, 2)}}):
        with pytest.raises(TypeError, match=next(iter(wrong))):
            setsquare.read_log(tmp_path / "empty.clf", **wrong)
    with pytest.raises(setsquare.ParameterError, match="pose_of"):
        setsquare.Mapper().finish().trajectory("wheel")
    with pytest.raises(setsquare.Error):
        setsquare.Trajectory.read_tum(str(tmp_path / "absent.tum"))


def test_a_map_of_nothing_is_a_map():
    nothing = setsquare.Mapper().finish()
    assert len(nothing) == 0
    assert len(nothing.trajectory()) == 0


def test_a_map_is_gone_on_with_and_merged(log, mapped, tmp_path):
    # With the log that it was made of, seen again: the robot is found where it was.
    both = setsquare.map_log(log, continue_from=mapped)
    count = len(mapped.scans)
    assert len(both.scans) == 2 * count and both.scans["is_placed"].all()
    for axis in ("x_m", "y_m"):
        assert np.abs(both.scans[axis][:count] - mapped.scans[axis]).max() < 0.05
        assert np.abs(both.scans[axis][count:] - mapped.scans[axis]).max() < 0.05
    assert both.sessions[["first_scan", "num_scans"]].tolist() == [(0, count), (count, count)]
    assert both.sessions["recency"][1] > both.sessions["recency"][0]
    assert len(mapped.sessions) == 1
    # With nothing it stays as it is, and so it does merged with itself.
    assert np.array_equal(setsquare.Mapper(continue_from=mapped).finish().keyframes,
                          mapped.keyframes)
    merged = setsquare.merge([mapped, mapped])
    assert len(merged.scans) == count
    assert np.allclose(merged.scans["x_m"], mapped.scans["x_m"], rtol=0.0, atol=1e-9)
    with pytest.raises(setsquare.ParameterError):
        setsquare.merge([])
    by_paper = setsquare.map_log(log, preset="paper")
    with pytest.raises(setsquare.ParameterError, match="track"):
        setsquare.Mapper(continue_from=by_paper)
