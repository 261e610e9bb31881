#!/usr/bin/env python3
"""Cuts ten models, exports them in five formats, opens these files and cuts them on: at rest, when
the pieces still lie face to face, and fallen. Pieces, volumes, materials, texture coordinates and
colours must come back, and the second cut must leave closed pieces of the same volume.

    round_trip.py KERF    a second cut for one of the formats in turn; with KERF_NIGHTLY for all
"""
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

FORMATS = ['ply', 'obj', 'stl', 'glb', 'gltf']
MATERIALS = ['obj', 'glb', 'gltf']  # the formats that name them
VOLUME_TOLERANCE = 1e-5  # of floats, as a share


def grid_box(size, low, n, vertex_of):
    """Quads of a box, each side with n x n of them, facing outward."""
    axes = [[size[0], 0, 0], [0, size[1], 0], [0, 0, size[2]]]
    for a in range(3):
        b, c = (a + 1) % 3, (a + 2) % 3
        for far, u, v in ((0, c, b), (1, b, c)):
            start = [low[k] + far * axes[a][k] for k in range(3)]
            for i in range(n):
                for j in range(n):
                    yield [vertex_of([start[k] + (s * axes[u][k] + t * axes[v][k]) / n
                                      for k in range(3)], (s / n, t / n))
                           for s, t in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]


def write_boxes(file, boxes, textured):
    """Boxes (size, lowest corner) as objects of an OBJ."""
    file.with_suffix('.mtl').write_text('newmtl wood\nKd .8 .5 .3\n')
    lines, numbers = [f'mtllib {file.stem}.mtl', 'usemtl wood'], {}
    for number, (size, low) in enumerate(boxes):
        lines.append(f'o part{number}')

        def vertex_of(place, uv):
            key = (number, *(round(x, 9) for x in place))
            if key not in numbers:
                numbers[key] = len(numbers) + 1
                lines.append('v ' + ' '.join(f'{x:.9g}' for x in place))
            lines.append('vt {:.9g} {:.9g}'.format(*uv))
            return f'{numbers[key]}/-1' if textured else str(numbers[key])

        for quad in grid_box(size, low, 6, vertex_of):
            lines.append('f ' + ' '.join(
                corner.replace('/-1', f'/{k - 4}') for k, corner in enumerate(quad)))
    file.write_text('\n'.join(lines) + '\n')


def write_torus(file, around=32, across=16):
    """With colours of vertices."""
    def angle(i, n):
        return 2 * math.pi * i / n
    rows = [((.35 + .15 * math.cos(angle(j, across))) * math.cos(angle(i, around)),
             .15 * math.sin(angle(j, across)),
             (.35 + .15 * math.cos(angle(j, across))) * math.sin(angle(i, around)), i * 7 % 256)
            for i in range(around) for j in range(across)]
    faces = [(i * across + j, i * across + (j + 1) % across,
              (i + 1) % around * across + (j + 1) % across, (i + 1) % around * across + j)
             for i in range(around) for j in range(across)]
    head = (f'ply\nformat ascii 1.0\nelement vertex {len(rows)}\nproperty float x\n'
            'property float y\nproperty float z\nproperty uchar red\nproperty uchar green\n'
            f'property uchar blue\nelement face {len(faces)}\n'
            'property list uchar int vertex_indices\nend_header\n')
    file.write_text(head + ''.join(f'{x:.9g} {y:.9g} {z:.9g} {c} 90 200\n' for x, y, z, c in rows)
                    + ''.join('4 {} {} {} {}\n'.format(*f) for f in faces))


def write_models(folder):
    """A model of a session by name."""
    boxes = {'box': [((1, 1, 1), (0, 0, 0))], 'plate': [((1, .1, 1), (0, 0, 0))],
             'rod': [((.2, .2, 1.5), (0, 0, 0))],
             'assembly': [((1, 1, 1), (0, 0, 0)), ((1, .6, 1), (1, 0, 0))]}
    for name, parts in boxes.items():
        write_boxes(folder / f'{name}.obj', parts, textured=name != 'rod')
    write_boxes(folder / 'hollow.obj', [((1, 1, 1), (0, 0, 0)), ((.6, .5, .7), (.2, .2, .2))],
                textured=False)
    write_torus(folder / 'torus.ply')
    files = {name: {'path': f'{name}.obj'} for name in (*boxes, 'hollow')}
    builtin = {name: {'builtin': name} for name in ('sphere80', 'sphere768', 'banana', 'octopus')}
    return files | {'torus': {'path': 'torus.ply'}} | builtin


class RoundTrip:
    def __init__(self, kerf, folder):
        self.kerf, self.folder, self.wrong, self.trips = kerf, folder, [], 0

    def run(self, *arguments):
        return subprocess.run([self.kerf, *arguments], cwd=self.folder, capture_output=True,
                              text=True, check=False)

    def inspect(self, model):
        run = self.run('inspect', '--json', str(model))
        report = json.loads(run.stdout.splitlines()[-1]) if run.stdout else {}
        return report if run.returncode == 0 else {'problem': run.stderr}

    def cut(self, name, model, normal, report, fallen, exports=(), depth=1):
        """Cuts a model along a plane near its middle; its summary, or None."""
        low, high = report['bounds']['low'], report['bounds']['high']
        size = math.dist(low, high)
        middle = [(a + b) / 2 + .03 * size * n for a, b, n in zip(low, high, normal)]
        steps = 60 if fallen else 15
        events = [] if fallen else [{'step': 0, 'type': 'hold'}]
        events += stroke(middle, normal, size, depth)
        events += [{'step': 15, 'type': 'set', 'name': 'gravity', 'value': [0, -9.81, 0]}] * fallen
        events += [{'step': steps, 'type': 'export', 'file': f'x.{kind}'} for kind in exports]
        session = {'format': 'kerf-session', 'version': 1, 'model': model, 'steps': steps,
                   'params': {'gravity': [0, 0, 0], 'floor': low[1] - .02 * size},
                   'events': events}
        (self.folder / f'{name}.kerf.json').write_text(json.dumps(session))
        run = self.run('replay', f'{name}.kerf.json', '--out', name)
        self.expect(name, run.returncode == 0, run.stderr)
        return json.loads((self.folder / name / 'summary.json').read_text())

    def expect(self, what, right, why):
        if not right:
            self.wrong.append(f'{what}: {why}')

    def expect_same(self, what, report, pieces, volume):
        self.expect(what, report.get('cuttable'), report.get('problem'))
        self.expect(what, pieces is None or report.get('pieces') == pieces,
                    f'{report.get("pieces")} pieces for {pieces}')
        self.expect(what, abs(report.get('volume', 0) / volume - 1) < VOLUME_TOLERANCE,
                    f'volume {report.get("volume")} for {volume}')

    def expect_looks(self, what, kind, before, now):
        if kind in MATERIALS:
            names = [m['name'] for m in now['materials']]
            for name in [m['name'] for m in before['materials']] + ['cut']:
                self.expect(what, name in names, f'no material {name} among {names}')
            self.expect(what, now['texture_coordinates'], 'no texture coordinates')
        if kind != 'stl' and before['vertex_colors']:
            self.expect(what, now['vertex_colors'], 'no colours of vertices')

    def slit(self):
        """Half way through a ball: the walls lie on each other, and STL can't tell them apart."""
        before = self.inspect('sphere80')
        summary = self.cut('slit', {'builtin': 'sphere80'}, [.92, .26, .29], before, False,
                           FORMATS, depth=.05)
        for kind in FORMATS:
            report = self.inspect(f'slit/x.{kind}')
            if kind == 'stl':
                self.expect('slit stl', not report.get('cuttable'), 'it was read')
            else:
                self.expect_same(f'slit {kind}', report, 1, summary['pieces'][0]['volume'])
                self.expect(f'slit {kind}', report.get('triangles', 0) > before['triangles'] + 20,
                            'without its walls')

    def follow(self, name, model, fallen, second):
        """Cuts, exports, opens; cuts what the formats in `second` give once more."""
        before = self.inspect(model.get('path') or model['builtin'])
        name = f'{name}-{"fallen" if fallen else "rest"}'
        summary = self.cut(name, model, [.92, .26, .29], before, fallen, FORMATS)
        volume = sum(piece['volume'] for piece in summary['pieces'])
        for kind in FORMATS:
            what = f'{name} {kind}'
            file = f'{name}/x.{kind}'
            report = self.inspect(file)
            self.expect_same(what, report, len(summary['pieces']), volume)
            if 'looks' not in report:
                continue
            self.expect_looks(what, kind, before['looks'], report['looks'])
            if kind in second:
                again = self.cut(f'{name}-{kind}', {'path': file}, [.1, .2, .974], report, False)
                self.expect(what, again['cut_report']['steps']['refused'] == 0, again['cut_report']['steps'])
                self.expect(what, len(again['pieces']) > len(summary['pieces']), 'not cut again')
                self.expect_same(f'{what}, cut again',
                                 self.inspect(f'{name}-{kind}/final.ply'), len(again['pieces']),
                                 volume)
            self.trips += 1


def stroke(middle, normal, size, depth):
    """Straight down, in a plane through the middle of a model, so far below it."""
    down = [-normal[1] * n for n in normal]
    down[1] += 1
    length = math.sqrt(sum(x * x for x in down))
    down = [-x / length for x in down]
    across = [normal[(k + 1) % 3] * down[(k + 2) % 3] - normal[(k + 2) % 3] * down[(k + 1) % 3]
              for k in range(3)]

    def pose(way):
        return {end: [m + side * size * a + way * size * d
                      for m, a, d in zip(middle, across, down)]
                for end, side in (('a', -1), ('b', 1))}
    return [{'step': 1, 'type': 'blade', **pose(-1)}, {'step': 13, 'type': 'blade', **pose(depth)},
            {'step': 14, 'type': 'lift'}]


def main(kerf):
    nightly = 'KERF_NIGHTLY' in os.environ
    with tempfile.TemporaryDirectory() as folder:
        trip = RoundTrip(Path(kerf).resolve(), Path(folder))
        turn = 0
        trip.slit()
        for name, model in write_models(Path(folder)).items():
            for fallen in (False, True):
                second = FORMATS if nightly else [FORMATS[turn % len(FORMATS)]]
                trip.follow(name, model, fallen, second)
                turn += 1
    print('\n'.join(trip.wrong))
    print(f'{trip.trips} files came back, {len(trip.wrong)} things wrong')
    return 1 if trip.wrong or trip.trips != turn * len(FORMATS) else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
