#!/usr/bin/python3
"""Leads the blade of `kerf replay ... --serve 18944` down through a sphere, by OpenIGTLink.

    python3 scripts/examples/lead_blade.py [PORT]

Needs Python alone.
"""
import socket
import struct
import sys
import time


def checksum(body):
    crc = 0
    for bit in (byte >> k & 1 for byte in body for k in range(7, -1, -1)):
        crc = (crc << 1 & 2**64 - 1) ^ (0x42F0E1EBA9EA3693 if crc >> 63 ^ bit else 0)
    return crc


def message(kind, name, body):
    return struct.pack(">H12s20sQQQ", 1, kind, name, 0, len(body), checksum(body)) + body


link = socket.create_connection(("127.0.0.1", int(sys.argv[1]) if len(sys.argv) > 1 else 18944))
link.recv(58)  # the session has begun
for k in range(120):
    axes = (0, 1, 0, 0, 0, 1, 1, 0, 0)         # the third one is the edge: along x, to the right
    tip = (-1000, 0, 700 - 1400 * k / 119)     # in millimetres: right, anterior, superior
    link.sendall(message(b"TRANSFORM", b"Blade", struct.pack(">12f", *axes, *tip)))
    time.sleep(0.01)
link.sendall(message(b"STRING", b"Blade", struct.pack(">HH", 3, 4) + b"lift"))
time.sleep(0.2)
link.close()
