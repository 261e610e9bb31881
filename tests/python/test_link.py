"""`kerf replay --serve`: clients in this process lead the blade of a kerf in another one."""

import json
import math
import re
import socket
import struct
import subprocess
import sys
import time
import unittest

from support import KERF, ROOT, TestCase, command_line

SESSION = {
    "format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"}, "steps": 400,
    "params": {"gravity": [0, 0, 0], "floor": None, "time_step": 0.005},
    "events": [{"step": 0, "type": "blade", "a": [-0.8, 0.7, 0], "b": [0.8, 0.7, 0]},
               {"step": 1, "type": "check", "hash": "0123456789abcdef"},
               {"step": 3, "type": "grab", "at": [0, -0.5, 0], "radius": 0.1},
               {"step": 400, "type": "drag", "to": [0, -0.6, 0.01]}]}


def checksum(body):
    """CRC-64 of ECMA-182, bit by bit."""
    crc = 0
    for byte in body:
        crc ^= byte << 56
        for _ in range(8):
            crc = (crc << 1 ^ (0x42F0E1EBA9EA3693 if crc >> 63 else 0)) & 0xFFFFFFFFFFFFFFFF
    return crc


def message(kind, device, content, version=1):
    if version > 1:  # an extended header, and metadata
        content = struct.pack(">HHII", 12, 10, 3, 7) + content + struct.pack(
            ">HHHI", 1, 1, 3, 2) + b"k:v"
    return struct.pack(">H12s20sQQQ", version, kind.encode(), device.encode(), 0, len(content),
                       checksum(content)) + content


def transform(position, axis, device="Blade", version=1):
    """The tool's third axis is `axis`."""
    return message("TRANSFORM", device,
                   struct.pack(">12f", 0, 0, 0, 0, 0, 0, *axis, *position), version)


class Client:
    """A client of OpenIGTLink in a few lines."""

    def __init__(self, port, most_received=1 << 20):
        self.socket = socket.socket()
        self.socket.settimeout(20)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, most_received)
        self.socket.connect(("127.0.0.1", port))

    def send(self, data):
        self.socket.sendall(data)

    def exactly(self, count):
        data = b""
        while len(data) < count:
            part = self.socket.recv(count - len(data))
            if not part:
                raise EOFError
            data += part
        return data

    def receive(self):
        """Type, device and content of the next message."""
        version, kind, device, _, size, crc = struct.unpack(">H12s20sQQQ", self.exactly(58))
        content = self.exactly(size)
        assert version == 1 and crc == checksum(content)
        return kind.rstrip(b"\0").decode(), device.rstrip(b"\0").decode(), content

    def until(self, device):
        while True:
            found = self.receive()
            if found[1] == device:
                return found

    def close(self):
        self.socket.close()


def swing(height):
    """A pose of a horizontal blade, 1.6 m long, at a height [m], in millimetres and RAS."""
    return transform((-800, -20, 1000 * height), (1, 0, 0))


class Link(TestCase):
    def serve(self, *options, session=None, address="0"):
        """Starts a kerf that serves; its port."""
        file = self.folder / "scene.kerf.json"
        file.write_text(json.dumps(session or SESSION))
        self.record = self.folder / "record.kerf.json"
        # pylint: disable-next=consider-using-with
        self.kerf = subprocess.Popen(
            [KERF, "replay", file, "--out", self.folder / "out", "--json", "--serve", address,
             "--record", self.record, *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True)
        self.addCleanup(self.kerf.kill)
        line = self.kerf.stderr.readline()
        return int(re.search(r"waiting for a client on 127\.0\.0\.1:(\d+)", line)[1])

    def finished(self):
        out, errors = self.kerf.communicate(timeout=120)
        self.assertEqual(self.kerf.returncode, 0, errors)
        return json.loads(out), errors

    def test_a_recorded_session_replays_to_the_same_bits(self):
        subprocess.run([sys.executable, "-B", ROOT / "scripts/examples/lead_blade.py",
                        str(self.serve())], check=True)
        summary, _ = self.finished()
        self.assertEqual(len(summary["pieces"]), 2)
        recorded = json.loads(self.record.read_text())
        kinds = [event["type"] for event in recorded["events"]]
        self.assertGreater(kinds.count("blade"), 30)
        self.assertEqual(kinds.count("lift"), 1)
        self.assertGreater(kinds.count("drag"), 30, "the rest of the session plays")
        self.assertEqual(recorded["steps"], summary["steps"])
        first = next(event for event in recorded["events"] if event["type"] == "blade")
        for got, wanted in zip(first["a"][:1] + first["b"], [-1, 0.6, first["a"][1], 0]):
            self.assertAlmostEqual(got, wanted, 6)
        done = command_line("replay", self.record, "--out", self.folder / "again", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["state_hash"], summary["state_hash"])

    def test_clients_get_the_body_the_force_and_the_blade(self):
        session = {**SESSION, "params": {**SESSION["params"], "toughness": 5, "blade_feels": 1,
                                         "youngs_modulus": 20000}}
        client = Client(self.serve(session=session))
        self.assertEqual(client.until("Kerf")[2][:12], b"\0\1" + bytes(8) + b"OK")
        client.send(swing(0.45))
        client.send(swing(0.45))
        kind, _, content = client.until("KerfBody")
        self.assertEqual(kind, "POLYDATA")
        points, *none, count, size, strips, _, attributes = struct.unpack(">10I", content[:40])
        self.assertEqual((points, none, count, size, strips, attributes),
                         (42, [0, 0, 0, 0], 80, 80 * 16, 0, 0))
        self.assertEqual(len(content), 40 + 12 * points + size)
        for k in range(points):
            self.assertAlmostEqual(math.hypot(*struct.unpack_from(">3f", content, 40 + 12 * k)),
                                   500, delta=5)
        cells = struct.unpack(f">{size // 4}I", content[40 + 12 * points:])
        self.assertEqual(set(cells[::4]), {3})
        self.assertLess(max(cells), points)
        forces = []
        for k in range(40):
            client.send(swing(0.45 - 0.005 * k))
            kind, _, content = client.until("KerfForce")
            self.assertEqual((kind, content[:10]),
                             ("SENSOR", b"\3\0" + struct.pack(">Q", 0x02C4000000000000)))
            forces.append(struct.unpack(">3d", content[10:]))
        self.assertGreater(max(z for _, _, z in forces), 0.01, "the body holds the blade up")
        client.close()
        self.finished()

    def test_a_score_is_told_at_the_end_of_a_stroke(self):
        task = {"name": "Across", "lines": [{"points": [[-0.4, 0.5, 0.02], [0.4, 0.5, 0.02]]}]}
        client = Client(self.serve(session={**SESSION, "task": task}))
        client.until("Kerf")
        for k in range(40):
            client.send(swing(0.7 - 1.4 * k / 39))
            time.sleep(0.01)
        client.send(message("STRING", "Blade", struct.pack(">HH", 3, 4) + b"lift"))
        content = client.until("KerfScore")[2]
        score = json.loads(content[4:])
        self.assertEqual(score["task"], "Across")
        self.assertIn("deviation_max", score)
        client.close()
        self.assertEqual(self.finished()[0]["score"]["deviation_max"], score["deviation_max"])

    def test_a_client_that_takes_nothing_blocks_no_step(self):
        session = {**SESSION, "model": {"builtin": "sphere20", "remesh": True, "remesh_edge": 0.03}}
        port = self.serve("--until", "100", session=session)
        slow = Client(port, most_received=4096)
        summary, errors = self.finished()
        self.assertEqual(summary["steps"], 100)
        self.assertNotIn(" 0 messages were dropped", errors)
        slow.close()

    def test_bytes_that_are_no_message_end_their_client_alone(self):
        port = self.serve()
        good = Client(port)
        good.until("Kerf")
        wrong = bytearray(swing(0))
        wrong[50] ^= 1
        for data in (b"GET / HTTP/1.1\r\nHost: localhost:18944\r\n\r\n" + bytes(58), bytes(wrong),
                     struct.pack(">H12s20sQQQ", 1, b"IMAGE", b"x", 0, 1 << 63, 0),
                     transform((math.nan, 0, 0), (0, 0, 1)), transform((0, 0, 0), (0, 0, 0)),
                     message("TRANSFORM", "Blade", bytes(47)),
                     message("QTDATA", "x", bytes(51)),
                     message("TRANSFORM", "Blade", bytes(4))[:40] + bytes(60)):
            bad = Client(port)
            bad.send(data)
            with self.assertRaises((EOFError, ConnectionResetError)):
                while True:
                    bad.receive()
            bad.close()
        good.until("KerfBody")
        good.close()
        _, errors = self.finished()
        self.assertEqual(errors.count(" 0 messages were dropped"), 9)
        self.assertIn("no message of OpenIGTLink", errors)

    def test_other_messages_lead_the_blade_too(self):
        client = Client(self.serve())
        client.until("Kerf")
        turn = math.sqrt(0.5)  # a quarter about y: z becomes x
        pose = struct.pack(">7f", -800, 0, 600, 0, turn, 0, turn)
        for data in (message("QTDATA", "Tracker", b"Other".ljust(20, b"\0") + bytes(30) +
                             b"Blade".ljust(20, b"\0") + b"\2\0" + pose),
                     message("POSITION", "Blade", pose), message("POSITION", "Blade", pose[:24]),
                     transform((-800, 0, 600), (1, 0, 0), version=2)):
            client.send(data)
            time.sleep(0.05)
        client.send(transform((0, 0, 0), (1, 0, 0), device="Another"))
        client.send(message("POSITION", "Blade", struct.pack(">3f", 1, 2, 3)))
        time.sleep(0.1)
        client.close()
        self.finished()
        poses = [event["a"] + event["b"] for event in json.loads(self.record.read_text())["events"]
                 if event["type"] == "blade"]
        for pose in poses[:-1]:
            for got, wanted in zip(pose, [-0.8, 0.6, 0, 0.8, 0.6, 0]):
                self.assertAlmostEqual(got, wanted, 5)
        for got, wanted in zip(poses[-1], [0.001, 0.003, -0.002, 0.001, 1.603, -0.002]):
            self.assertAlmostEqual(got, wanted, 6, "without an orientation it stands upright")

    def test_it_listens_to_this_machine_alone_unless_asked(self):
        port = self.serve()
        with self.assertRaises(OSError):
            socket.create_connection(("127.0.0.2", port), timeout=5).close()
        taken = command_line("replay", self.folder / "scene.kerf.json", "--out",
                             self.folder / "other", "--serve", str(port))
        self.assertEqual(taken.returncode, 3)
        self.assertIn(f"can't listen on 127.0.0.1:{port}", taken.stderr)
        for wrong in ("70000", "x", "localhost:1", "1.2.3:4", ":5", "-1"):
            refused = command_line("replay", "x", "--out", "y", f"--serve={wrong}")
            self.assertEqual(refused.returncode, 2, wrong)
        Client(port).close()
        self.finished()


if __name__ == "__main__":
    unittest.main()
