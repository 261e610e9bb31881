"""The look of all plots, and strips of pictures."""

import matplotlib
import matplotlib.pyplot as plt

matplotlib.use("Agg")

# Hues that people with any sight of colours tell apart (Okabe and Ito).
BLUE, GREEN, ORANGE, VERMILLION, GRAY = "#0072b2", "#009e73", "#cc8400", "#d55e00", "#60636c"
DPI = 100
TEXT = 24  # height of a line of text below a picture [pixels]
GAP = 14  # between pictures [pixels]

plt.rcParams.update({
    "figure.dpi": DPI, "savefig.dpi": DPI, "figure.constrained_layout.use": True,
    "font.size": 11, "axes.titlesize": 12, "axes.titlelocation": "left", "axes.grid": True,
    "grid.alpha": 0.3, "axes.axisbelow": True, "legend.frameon": False, "lines.linewidth": 1.2,
    "axes.formatter.useoffset": False,
})


def panels(rows, columns=1, width=900, height=280):
    """A figure of panels of this size [pixels]."""
    return plt.subplots(rows, columns, squeeze=False,
                        figsize=(columns * width / DPI, rows * height / DPI))


def strip(title, pictures):
    """Pictures beside each other in their own size, each with a text below it, as a figure.

    pictures: pairs of an array [height, width, 4] and a text.
    """
    widths = [image.shape[1] for image, _ in pictures]
    tallest = max(image.shape[0] for image, _ in pictures)
    lines = max(text.count("\n") + 1 for _, text in pictures)
    width = sum(widths) + GAP * (len(widths) + 1)
    height = tallest + TEXT * (lines + 2)
    figure = plt.figure(figsize=(width / DPI, height / DPI), layout="none")
    figure.text(GAP / width, 1 - TEXT / height, title, va="center", fontsize=13)
    left = GAP
    for image, text in pictures:
        rows, columns = image.shape[:2]
        bottom = height - 2 * TEXT - rows
        figure.figimage(image, left, bottom)
        figure.text(left / width, (bottom - 6) / height, text, va="top", fontsize=12)
        left += columns + GAP
    return figure
