#!/usr/bin/env python3
"""Makes the icon of the desktop entry: that of the window (assets/window/icon.png), in lines.

  make_icon.py FILE.svg
"""
import sys

SIDE = 64
CUT = 3.5  # half of the gap that the blade leaves

ICON = f"""<svg xmlns="http://www.w3.org/2000/svg" width="256" height="256" viewBox="-32 -32 {SIDE} {SIDE}">
  <title>Kerf</title>
  <clipPath id="halves">
    <path transform="rotate(-45)" d="M-32 -32H32V-{CUT}H-32ZM-32 {CUT}H32V32H-32Z"/>
  </clipPath>
  <g clip-path="url(#halves)">
    <circle r="27" fill="#e25422"/>
    <circle r="23" fill="#ffe2b2"/>
    <circle r="20" fill="#f69642"/>
  </g>
  <path transform="rotate(-45)" d="M-31 -1.6H31V1.6H-31Z" fill="#40e0be"/>
</svg>
"""

with open(sys.argv[1], "w", encoding="utf-8") as file:
    file.write(ICON)
