"""Checks a command file with the linter of adams_vscode; prints one line of JSON.

    PYTHONPATH=<adams_vscode>/adams-cmd-lsp python bench/peer_linter.py FILE.cmd
"""

import json
import resource
import sys
from pathlib import Path

from adams_cmd_lsp.linter import lint_text
from adams_cmd_lsp.schema import Schema

text = Path(sys.argv[1]).read_text(encoding="utf-8")
found = lint_text(text, Schema.load() if hasattr(Schema, "load") else Schema())
used = resource.getrusage(resource.RUSAGE_SELF)
print(json.dumps({"cpu_s": used.ru_utime + used.ru_stime, "peak_bytes": used.ru_maxrss * 1024, "diagnostics": len(found)}))
