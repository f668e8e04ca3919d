# SPDX-License-Identifier: Apache-2.0
"""Writes report.html and figures/*.svg, *.png of an experiment's results: the command tocsin experiment report DIR."""
import os
import sys

try:
    import jinja2
    from markupsafe import Markup

    import sections
    import thesis
    from results import Results, ResultsError
except ImportError as error:
    sys.exit(f"tocsin experiment report: {error} (packages python3-jinja2, python3-matplotlib, python3-yaml)")


class Page:
    """The report while it is written: blocks for page.html.j2. What is not Markup is escaped there."""

    def __init__(self, folder):
        self.figures_folder = os.path.join(folder, "figures")
        os.makedirs(self.figures_folder, exist_ok=True)
        self.blocks = []
        self.figures = 0

    def heading(self, level, text):
        self.blocks.append((f"h{level}", text))

    def paragraph(self, text):
        self.blocks.append(("p", text))

    def table(self, rows):
        self.blocks.append(("table", rows))

    def list(self, items):
        self.blocks.append(("list", items))

    def details(self, summary, rows=None, text=""):
        self.blocks.append(("details", {"summary": summary, "rows": rows, "text": text}))

    def figure(self, figure, caption):
        svg = Markup(figure.draw(self.figures_folder))
        self.blocks.append(("figure", {"svg": svg, "caption": caption}))
        self.figures += 1

    def html(self):
        loader = jinja2.FileSystemLoader(os.path.dirname(os.path.abspath(__file__)))
        environment = jinja2.Environment(loader=loader, autoescape=True)
        return environment.get_template("page.html.j2").render(blocks=self.blocks)


PARTS = (sections.overview, sections.verdicts, sections.recommendation, sections.costs, sections.fit, sections.regimes,
         thesis.figures, sections.channels, sections.distributions, sections.comparisons, sections.sensitivity,
         sections.reality, sections.definitions, sections.settings)


def write_page(folder):
    results = Results(folder)
    page = Page(folder)
    for add in PARTS:
        add(results, page)
    path = os.path.join(folder, "report.html")
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write(page.html())
    os.replace(path + ".part", path)
    print(f"{path}, {page.figures} figures in {page.figures_folder}")


def main():
    try:
        write_page(sys.argv[1])
        return 0
    except ResultsError as error:
        print(f"tocsin experiment report: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"tocsin experiment report: {error.filename}: {error.strerror}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
