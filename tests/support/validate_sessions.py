"""Checks documents by a JSON Schema of draft 7.

  validate_sessions.py SCHEMA TEXTS     TEXTS is a JSON list of the documents, each as a text

Prints a line per document: a JSON list of the places that are wrong, such as "events[0].a". A key
that is missing is a place too. The list of a document that is valid is empty.
"""
import json
import sys

from jsonschema import Draft7Validator


def place(error):
    parts = [f"[{part}]" if isinstance(part, int) else f".{part}" for part in error.absolute_path]
    if error.validator in ("required", "dependencies", "additionalProperties"):
        parts.append("." + error.message.split("'")[1])  # the key that it speaks of
    return "".join(parts).lstrip(".")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        schema = json.load(file)
    Draft7Validator.check_schema(schema)
    validator = Draft7Validator(schema)
    with open(sys.argv[2], encoding="utf-8") as file:
        texts = json.load(file)
    for text in texts:
        print(json.dumps([place(error) for error in validator.iter_errors(json.loads(text))]))


main()
