#!/usr/bin/env python3
"""Rewrites a compute shader so that any driver treats it as other drivers may.

    quirk_shader.py QUIRK < kernel.comp > rewritten.comp

GLSL becomes SPIR-V (glslangValidator), whose loads, stores and sums are one instruction a line.
Calls of the functions in quirks.glsl are put beside them, and spirv-cross makes it GLSL again.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

QUIRKS = {
    "none": "the way there and back alone",
    "denormals": "floats below 1.2e-38 are 0 where they are loaded, made of bits or computed",
    "groups": "work groups come in another order",
    "garbage": "fresh buffers, shared memory and variables hold NaN and huge indices",
    "dead": "each block has a branch that is never taken",
    "bounds": "each index is checked; one too large is a fault",
    "contraction": "a * b + c is rounded once",
    "races": "two invocations that come to a word, one of which writes, are a fault",
}
HERE = pathlib.Path(__file__).resolve().parent


# --- in the source --------------------------------------------------------------------------------

def with_helpers(text, quirk):
    """The kernel with the functions that it will call, and what is simpler in GLSL."""
    version, rest = text.split("\n", 1)
    helpers = (HERE / "quirks.glsl").read_text()
    if quirk == "groups":
        rest = re.sub(r"\bgl_WorkGroupID\b", "kerfGroup()", rest)
        rest = re.sub(r"\bgl_GlobalInvocationID\b", "kerfInvocation()", rest)
    rest = re.sub(r"\bvoid main\(\)", "void kernelMain()", rest)
    begin, end = {
        "garbage": (fill_shared(rest) + "barrier();", ""),
        "dead": ("kerfBegin();", "kerfReport();"),
        "bounds": ("", "kerfReport();"),
        "races": ("kerfBegin();", "kerfSettle(); kerfReport();"),
    }.get(quirk, ("", ""))
    end = f"\nvoid main() {{\n{begin}\nkernelMain();\n{end}\n}}\n"
    return f"{version}\n{place_helpers(rest, helpers)}{end}"


def place_helpers(rest, helpers):
    """Behind the size of the group, on which they depend."""
    size = re.search(r"^ *layout\(local_size_x *=[^)]*\) *in *;.*\n", rest, re.M)
    line = rest[: size.end()].rfind("#line")
    number = re.match(r"#line (\d+)", rest[line:])
    next_line = int(number.group(1)) + rest[line : size.end()].count("\n") - 1
    return f"{rest[:size.end()]}#line 1\n{helpers}#line {next_line}\n{rest[size.end():]}"


def fill_shared(text):
    """Statements by which the group fills its shared memory with what no kernel asked for."""
    lines = []
    for line in re.findall(r"^\s*shared .*", text, re.M):
        declared = re.match(r"\s*shared (bool|float|u?int|vec[234]) (\w+)\s*(\[[^]]*\])?;", line)
        if not declared:
            sys.exit(f"garbage cannot be put into: {line}")
        kind, name, is_array = declared.groups()
        value = {"bool": "true", "uint": "0xdeadbeefu", "int": "-559038737"}.get(
            kind, f"{kind}(uintBitsToFloat(0x7fa1b2c3u))")
        if is_array:
            lines.append(f"for (uint i = gl_LocalInvocationIndex; i < uint({name}.length()); "
                         f"i += gl_WorkGroupSize.x) {name}[i] = {value};\n")
        else:
            lines.append(f"if (gl_LocalInvocationIndex == 0u) {name} = {value};\n")
    return "".join(lines)


# --- SPIR-V as text -------------------------------------------------------------------------------

class Module:
    """Instructions of a module: (result or None, opcode, operands); what they say of types."""

    def __init__(self, assembly):
        assembly = re.sub(r'"(?:[^"\\]|\\.)*"', lambda m: '""' if "\n" in m[0] else m[0], assembly)
        self.code = [parse(line) for line in assembly.splitlines() if not line.startswith(";")]
        self.by_id = {result: (op, args) for result, op, args in self.code if result}
        self.names = {}
        self.decorations = {}
        self.fresh = 0
        self.added = {}
        self.uses = {}  # of loaded values
        for _, op, args in self.code:
            for arg in set(args):
                if self.by_id.get(arg, ("",))[0] == "OpLoad":
                    self.uses.setdefault(arg, []).append((op, args))
            if op == "OpName":
                self.names[args[0]] = args[1].strip('"')
            elif op == "OpDecorate":
                self.decorations.setdefault(args[0], {})[args[1]] = args[2:]
            elif op == "OpMemberDecorate":
                self.decorations.setdefault((args[0], args[1]), {})[args[2]] = args[3:]
        self.uint = self.type_like("OpTypeInt", ["32", "0"])
        self.int = self.type_like("OpTypeInt", ["32", "1"])
        self.float = self.type_like("OpTypeFloat", ["32"])
        self.void = self.type_like("OpTypeVoid", [])

    def type_like(self, op, args):
        return next(i for i, (o, a) in self.by_id.items() if (o, a) == (op, args))

    def new(self):
        self.fresh += 1
        return f"%q{self.fresh}"

    def uint_constant(self, value):
        return self.constant(self.uint, "OpConstant", [str(value & 0xFFFFFFFF)])

    def constant(self, kind, op, args):
        key = (kind, op, *args)
        if key not in self.added:
            self.added[key] = self.new()
        return self.added[key]

    def value(self, constant):
        """Of an integer constant; None for anything else."""
        op, args = self.by_id.get(constant, ("", []))
        return int(args[1]) if op == "OpConstant" and args[0] in (self.uint, self.int) else None

    def helper(self, name):
        """The function of quirks.glsl of this mangled name."""
        return next(i for i, n in self.names.items() if n == name)

    def type_of(self, i):
        return self.by_id[i][1][0]

    def pointee(self, pointer):
        return self.by_id[self.type_of(pointer)][1][1]

    def storage(self, pointer):
        return self.by_id[self.type_of(pointer)][1][0]

    def float_width(self, kind):
        """1 for float, 2 to 4 for its vectors, 0 for anything else."""
        if kind == self.float:
            return 1
        op, args = self.by_id.get(kind, ("", []))
        return int(args[1]) if op == "OpTypeVector" and args[0] == self.float else 0

    def text(self):
        lines = []
        functions = False
        for result, op, args in self.code:
            if op == "OpFunction" and not functions:
                functions = True
                lines += [render(i, key[1], [key[0], *key[2:]]) for key, i in self.added.items()]
            lines.append(render(result, op, args))
        return "\n".join(lines) + "\n"


def parse(line):
    words = re.findall(r'"(?:[^"\\]|\\.)*"|\S+', line)
    if len(words) > 1 and words[1] == "=":
        return words[0], words[2], words[3:]
    return None, words[0] if words else "OpNop", words[1:]


def render(result, op, args):
    return f"{result} = {op} {' '.join(args)}" if result else f"{op} {' '.join(args)}"


# --- what is put beside an instruction ------------------------------------------------------------

VECTORS = {1: "f1", 2: "vf2", 3: "vf3", 4: "vf4"}


class Rewriter:
    """Walks over the functions of a kernel, but for those of quirks.glsl."""

    def __init__(self, module, quirk):
        self.m = module
        self.visit = getattr(self, quirk)
        self.site = 0
        self.out = []
        self.begins = False  # the block that comes is the first of main
        self.fresh_block = False

    def run(self):
        inside = False
        for instruction in self.m.code:
            result, op, args = instruction
            if op == "OpFunction":
                inside = not self.m.names.get(result, "").startswith("kerf")
            if op == "OpLine":
                self.site = int(args[1])
            if inside:
                self.visit(result, op, args)
            else:
                self.out.append(instruction)
        self.m.code = self.out

    def emit(self, result, op, *args):
        self.out.append((result, op, list(args)))
        return result

    def call(self, name, *args, kind=None, result=None):
        return self.emit(result or self.m.new(), "OpFunctionCall", kind or self.m.void,
                         self.m.helper(name), *args)

    def here(self):
        return self.m.uint_constant(self.site)

    def as_uint(self, index):
        if self.m.by_id.get(index, ("", [None]))[1][0] == self.m.uint or index.startswith("%q"):
            return index
        return self.emit(self.m.new(), "OpBitcast", self.m.uint, index)

    def none(self, result, op, args):
        self.out.append((result, op, args))

    groups = none

    FLUSHED = {"OpLoad", "OpBitcast", "OpImageRead", "OpImageFetch", "OpCompositeExtract", "OpFMul",
               "OpFDiv", "OpFAdd", "OpFSub", "OpDot", "OpExtInst", "OpVectorTimesScalar",
               "OpMatrixTimesVector"}

    def denormals(self, result, op, args):
        width = self.m.float_width(args[0]) if op in self.FLUSHED else 0
        if width == 0:
            return self.none(result, op, args)
        raw = self.emit(self.m.new(), op, *args)
        self.call(f"kerfFlush({VECTORS[width]};", raw, kind=args[0], result=result)

    def contraction(self, result, op, args):
        width = self.m.float_width(args[0]) if args else 0
        if op == "OpDot":
            v = VECTORS[self.m.float_width(self.m.type_of(args[1]))]
            return self.call(f"kerfDot({v};{v};", args[1], args[2], kind=args[0], result=result)
        if op == "OpExtInst" and args[2] == "Cross":
            return self.call("kerfCross(vf3;vf3;", args[3], args[4], kind=args[0], result=result)
        if op in ("OpFAdd", "OpFSub") and width and not self.exact(result):
            for side in (0, 1):
                factors = self.factors(args[1 + side])
                if factors:
                    return self.fuse(result, args[0], factors, args[2 - side], op, side)
        self.none(result, op, args)

    def exact(self, i):
        return "NoContraction" in self.m.decorations.get(i, {})

    def factors(self, product):
        op, args = self.m.by_id.get(product, ("", []))
        if op in ("OpFMul", "OpVectorTimesScalar") and not self.exact(product):
            return op, args
        return None

    def fuse(self, result, kind, factors, summand, op, side):
        product, (_, a, b) = factors
        width = self.m.float_width(kind)
        if product == "OpVectorTimesScalar":
            b = self.emit(self.m.new(), "OpCompositeConstruct", kind, *[b] * width)
        if op == "OpFSub" and side == 0:
            summand = self.emit(self.m.new(), "OpFNegate", kind, summand)
        if op == "OpFSub" and side == 1:
            a = self.emit(self.m.new(), "OpFNegate", kind, a)
        v = VECTORS[width]
        self.call(f"kerfFma({v};{v};{v};", a, b, summand, kind=kind, result=result)

    def garbage(self, result, op, args):
        if op == "OpVariable" and len(args) == 2:
            args = [*args, self.junk(self.m.by_id[args[0]][1][1])]
        elif op == "OpFunction":
            self.begins = self.m.names.get(result) == "main"
        elif op not in self.STARTS and self.begins:
            self.begins = False
            self.fill_globals()
        self.none(result, op, args)

    def fill_globals(self):
        for i, (op, args) in list(self.m.by_id.items()):
            own = self.m.names.get(i, "").startswith("kerf")
            if op == "OpVariable" and args[1] == "Private" and len(args) == 2 and not own:
                self.emit(None, "OpStore", i, self.junk(self.m.pointee(i)))

    def junk(self, kind):
        op, args = self.m.by_id[kind]
        if op == "OpTypeFloat":
            return self.m.constant(kind, "OpConstant", ["0x1.8p+128"])
        if op == "OpTypeInt":
            return self.m.constant(kind, "OpConstant",
                                   ["3735928559" if args[1] == "0" else "-559038737"])
        if op == "OpTypeBool":
            return self.m.constant(kind, "OpConstantTrue", [])
        if op in ("OpTypeVector", "OpTypeMatrix"):
            parts = [args[0]] * int(args[1])
        elif op == "OpTypeArray":
            parts = [args[0]] * self.m.value(args[1])
        else:
            parts = args  # of a structure
        return self.m.constant(kind, "OpConstantComposite", [self.junk(part) for part in parts])

    STARTS = {"OpLabel", "OpPhi", "OpVariable", "OpLine", "OpNoLine", "OpFunctionParameter",
              "OpFunction"}

    def dead(self, result, op, args):
        if op == "OpLabel":
            self.fresh_block = True
        elif op not in self.STARTS and self.fresh_block:
            self.fresh_block = False
            self.call("kerfNever(u1;", self.here())
        self.none(result, op, args)

    # --- bounds -----------------------------------------------------------------------------------

    def bounds(self, result, op, args):
        if op in ("OpAccessChain", "OpInBoundsAccessChain"):
            self.check_chain(args[1], args[2:])
        elif op in ("OpImageRead", "OpImageFetch"):
            count = self.emit(self.m.new(), "OpImageQuerySize", self.m.int, args[1])
            size = self.emit(self.m.new(), "OpBitcast", self.m.uint, count)
            self.call("kerfCheck(u1;u1;u1;", self.as_uint(args[2]), size, self.here())
        elif op in ("OpVectorExtractDynamic", "OpVectorInsertDynamic"):
            width = int(self.m.by_id[self.m.type_of(args[1])][1][1])
            self.call("kerfCheck(u1;u1;u1;", self.as_uint(args[-1]), self.m.uint_constant(width),
                      self.here())
        self.none(result, op, args)

    def check_chain(self, base, indices):
        kind = self.m.pointee(base)
        for place, index in enumerate(indices):
            op, args = self.m.by_id[kind]
            known = self.m.value(index)
            if op == "OpTypeStruct":
                kind = args[known]
                continue
            count = self.count_of(op, args, base, indices[:place])
            if count is not None and (known is None or op == "OpTypeRuntimeArray"):
                self.call("kerfCheck(u1;u1;u1;", self.as_uint(index), count, self.here())
            kind = args[0]

    def count_of(self, op, args, base, before):
        if op == "OpTypeRuntimeArray" and len(before) == 1:
            member = str(self.m.value(before[0]))
            return self.emit(self.m.new(), "OpArrayLength", self.m.uint, base, member)
        if op == "OpTypeArray":
            return self.m.uint_constant(self.m.value(args[1]))
        return self.m.uint_constant(int(args[1])) if op != "OpTypeRuntimeArray" else None

    # --- races ------------------------------------------------------------------------------------

    def races(self, result, op, args):
        if op == "OpLoad":
            self.touch(args[1], 1, self.components_used(result))
        elif op == "OpStore":
            self.touch(args[0], 2)
        elif op.startswith("OpAtomic"):
            self.touch(args[0 if op == "OpAtomicStore" else 1], 3)
        elif op == "OpImageFetch":
            self.touch_texel(args[1], args[2])
        if op == "OpControlBarrier":
            self.call("kerfSettle(")
        self.none(result, op, args)
        if op == "OpControlBarrier":
            self.call("kerfPass(")

    def touch_texel(self, image, index):
        """Textures have caches of their own: nobody else may write what they show."""
        op, args = self.m.by_id[image]
        variable = self.m.by_id[args[1]][1][1] if op == "OpImage" else args[1]
        kind = self.m.by_id[self.m.pointee(variable)]
        decorations = self.m.decorations.get(variable, {})  # none of a parameter
        if kind[0] == "OpTypeSampledImage" and "Binding" in decorations:
            binding = int(decorations["Binding"][0])
            self.call("kerfTouch(u1;u1;u1;", self.as_uint(index), self.m.uint_constant(1 << 26),
                      self.m.uint_constant(self.site | 64 + binding << 24))

    def components_used(self, loaded):
        """Of a vector, up to the last that is looked at: p.xyz loads all four."""
        last = -1
        for op, args in self.m.uses.get(loaded, []):
            if op == "OpCompositeExtract":
                last = max(last, int(args[2]))
            elif op == "OpVectorShuffle" and args[1] == args[2]:
                last = max(last, *map(int, args[3:]))
            else:
                return 4
        return last + 1 or 4

    def touch(self, pointer, how, most=None):
        root, indices = pointer, []
        while self.m.by_id[root][0].endswith("AccessChain"):
            op, args = self.m.by_id[root]
            root, indices = args[1], args[2:] + indices
        if self.m.by_id[root][0] == "OpFunctionParameter":
            return  # of function memory: blocks and shared memory are no arguments
        if self.m.by_id[root][0] != "OpVariable":
            sys.exit(f"races does not know where {pointer} lies")
        storage = self.m.storage(root)
        block = self.m.pointee(root)
        is_block = storage == "Uniform" and "BufferBlock" in self.m.decorations.get(block, {})
        if not is_block and storage != "Workgroup":
            return
        first, kind, columns = self.place(block, indices, is_block)
        words = max(1, self.size(kind, is_block, columns) // 4)
        if most and self.m.by_id[kind][0] == "OpTypeVector":
            words = min(words, most)
        binding = 255
        if is_block:
            decorations = self.m.decorations[root]
            binding = int(decorations["Binding"][0])
            if "Coherent" in decorations or "Coherent" in self.m.decorations.get((block, "0"), {}):
                how |= 4
        else:
            first = self.plus(first, self.m.uint_constant(self.shared_place(root)))
        for at in range(0, words, 4):
            self.call("kerfTouch(u1;u1;u1;", self.plus(first, self.m.uint_constant(at)) if at else first,
                      self.m.uint_constant(min(words - at, 4) - 1 << 24 | how << 26),
                      self.m.uint_constant(self.site | binding << 24))

    def plus(self, a, b):
        return self.emit(self.m.new(), "OpIAdd", self.m.uint, a, b)

    def shared_place(self, variable):
        """[words], in the order of the module."""
        place = 0
        for i, (op, args) in self.m.by_id.items():
            if op == "OpVariable" and args[1] == "Workgroup":
                if i == variable:
                    return place
                place += self.size(self.m.pointee(i), False, None) // 4
        raise KeyError(variable)

    def place(self, kind, indices, laid_out):
        """The first word of what a chain of indices leads to, its type, and the stride of its
        columns where it is a matrix."""
        fixed = 0
        varying = []
        columns = None
        for index in indices:
            op, args = self.m.by_id[kind]
            known = self.m.value(index)
            if op == "OpTypeStruct":
                member = self.m.decorations.get((kind, str(known)), {})
                fixed += int(member["Offset"][0]) if laid_out else sum(
                    self.size(part, False, None) for part in args[:known])
                columns = int(member["MatrixStride"][0]) if "MatrixStride" in member else None
                kind = args[known]
                continue
            stride = self.stride(kind, op, args, laid_out, columns)
            if known is None:
                varying.append((index, stride // 4))
            else:
                fixed += known * stride
            kind = args[0]
        word = self.m.uint_constant(fixed // 4)
        for index, stride in varying:
            scaled = self.emit(self.m.new(), "OpIMul", self.m.uint, self.as_uint(index),
                               self.m.uint_constant(stride))
            word = self.plus(word, scaled)
        return word, kind, columns

    def stride(self, kind, op, args, laid_out, columns):
        if op == "OpTypeMatrix" and laid_out:
            return columns or 16
        if op in ("OpTypeArray", "OpTypeRuntimeArray") and laid_out:
            return int(self.m.decorations[kind]["ArrayStride"][0])
        return self.size(args[0], laid_out, columns)

    def size(self, kind, laid_out, columns):
        """[bytes]"""
        op, args = self.m.by_id[kind]
        if op in ("OpTypeInt", "OpTypeFloat", "OpTypeBool"):
            return 4
        if op == "OpTypeStruct":
            if not laid_out:
                return sum(self.size(part, False, None) for part in args)
            last = self.m.decorations[(kind, str(len(args) - 1))]
            return int(last["Offset"][0]) + self.size(args[-1], True, columns)
        if op == "OpTypeRuntimeArray":
            return 0
        count = self.m.value(args[1]) if op == "OpTypeArray" else int(args[1])
        return count * self.stride(kind, op, args, laid_out, columns)


# --- there and back -------------------------------------------------------------------------------

REFUSED = 3  # exit code for what is no GLSL, as tests write


def run(*command, stdin=None, failure=1):
    done = subprocess.run(command, input=stdin, capture_output=True, text=True)
    if done.returncode != 0:
        print(f"{command[0]} failed:\n{done.stdout}{done.stderr}", file=sys.stderr)
        sys.exit(failure)
    return done.stdout


# So that a product and its sum are one expression, in variables too.
JOINED = ["--eliminate-local-single-block", "--eliminate-local-single-store", "--ssa-rewrite"]


def rewritten(text, quirk):
    with tempfile.TemporaryDirectory() as folder:
        source, binary = f"{folder}/kernel.comp", f"{folder}/kernel.spv"
        pathlib.Path(source).write_text(text)
        run("glslangValidator", source, failure=REFUSED)
        active = run("glslangValidator", "-E", source).lstrip()
        pathlib.Path(source).write_text(with_helpers(active, quirk))
        run("glslangValidator", "-G", "-g", "--aml", "--keep-uncalled", "-o", binary, source)
        if quirk == "contraction":
            run("spirv-opt", *JOINED, binary, "-o", binary)
        module = Module(run("spirv-dis", "--raw-id", "--no-header", binary))
        rewriter = Rewriter(module, quirk)
        rewriter.run()
        assembly = module.text()
        if quirk == "bounds":
            assembly = "OpCapability ImageQuery\n" + assembly
        run("spirv-as", "--target-env", "spv1.0", "-o", binary, "-", stdin=assembly)
        return run("spirv-cross", "--version", "450", "--no-es", binary)


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] not in QUIRKS:
        sys.exit("Give one of:\n" + "\n".join(f"  {q:12} {why}" for q, why in QUIRKS.items()))
    if sys.argv[2:] != ["--known"]:
        print(rewritten(sys.stdin.read(), sys.argv[1]), end="")
