# SPDX-License-Identifier: Apache-2.0
"""Parser of formulas: translates the text to a postfix programme.

Precedence climbing over a list of tokens, independent of the Python grammar, so that only the language of
`pitchpoint.core.formula.language` is accepted. Size and depth are limited.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple, NoReturn

import numpy as np

from pitchpoint.core.errors import UnitError
from pitchpoint.core.formula.dimension import (
    CycleError,
    Kind,
    RadianError,
    check_result,
    combine,
    of_amount,
    of_number,
    of_variable,
)
from pitchpoint.core.formula.language import (
    ADD,
    ARITY,
    CONST,
    CONSTANTS,
    CYCLE_REMEDY,
    DIV,
    FUNCTIONS,
    MAX,
    MAX_DEPTH,
    MAX_TOKENS,
    MIN,
    MUL,
    NEG,
    POW,
    RADIAN_REMEDY,
    STEP,
    SUB,
    UNIT_REMEDY,
    VAR,
    Amount,
    FormulaError,
    apply,
)
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.core.unit_table import UNITS
from pitchpoint.core.units import natural_si


class Token(NamedTuple):
    """Token: a number (in SI; `word` is its unit), a name, an operator, or the end."""

    kind: str
    word: str
    value: float
    at: int


_NUMBER = re.compile(r"(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?")
_WORD = re.compile(r"[A-Za-z_µ°%][A-Za-z0-9_µ°]*")
_UNIT_POWER = re.compile(r"\s*(?:\^|\*\*)\s*[+-]?\d+|[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+")
_BRACKET = re.compile(r"\s*/\s*\(([^()]*)\)")
_OPERATORS = {
    "**": "^",
    "·": "*",
    "+": "+",
    "-": "-",
    "*": "*",
    "/": "/",
    "^": "^",
    "(": "(",
    ")": ")",
    ",": ",",
}


def tokenize(text: str, variables: tuple[str, ...]) -> list[Token]:
    """Split a formula into tokens; a number includes its unit.

    Parameters
    ----------
    text
        Text of the formula.
    variables
        Declared variables; they have precedence over units of the same name.
    """
    text = text.replace("⋅", "·").replace("−", "-").replace("μ", "µ")
    tokens: list[Token] = []
    at = 0
    while at < len(text):
        if text[at].isspace():
            at += 1
            continue
        if len(tokens) >= MAX_TOKENS:
            raise FormulaError(f"the formula is too long (limit {MAX_TOKENS} parts)", text, at)
        number, word = _NUMBER.match(text, at), _WORD.match(text, at)
        if number:
            end = _unit_end(text, number.end(), variables)
            unit = text[number.end() : end].strip()
            tokens.append(Token("number", unit, _literal(text, number, unit), at))
            at = end
        elif word:
            tokens.append(Token("name", word.group(), 0.0, at))
            at = word.end()
        else:
            operator = next((o for o in _OPERATORS if text.startswith(o, at)), None)
            if operator is None:
                raise FormulaError(f"unexpected '{text[at]}'", text, at)
            tokens.append(Token("op", _OPERATORS[operator], 0.0, at))
            at += len(operator)
    tokens.append(Token("end", "the end", 0.0, len(text)))
    return tokens


def _remedy(error: UnitError) -> str:
    if isinstance(error, RadianError):
        return RADIAN_REMEDY
    return CYCLE_REMEDY if isinstance(error, CycleError) else UNIT_REMEDY


def _literal(text: str, number: re.Match[str], unit: str) -> float:
    """SI value of a number with its unit."""
    try:
        value = float(number.group()) * (natural_si(unit) if unit else 1.0)
    except UnitError as error:
        raise FormulaError(str(error), text, number.start()) from None
    if not math.isfinite(value):
        raise FormulaError(f"'{number.group()}' is too large", text, number.start())
    return value


def _unit_end(text: str, at: int, variables: tuple[str, ...]) -> int:
    """End of the unit after a number that ends at `at`; `at` if there is no unit."""

    def unit_at(place: int) -> int:
        """End of the unit that begins at a position of the text, power included; -1 if there is no unit."""
        match = _WORD.match(text, place)
        if match is None or match.group() in variables or match.group() not in UNITS:
            return -1
        power = _UNIT_POWER.match(text, match.end())
        return power.end() if power else match.end()

    end = first = at
    while True:
        place = end
        while place < len(text) and text[place].isspace():
            place += 1
        slash = text[place : place + 1] == "/" and end > first
        bracket = _BRACKET.match(text, end) if slash else None
        if bracket and all(w in UNITS and w not in variables for w in bracket.group(1).split()):
            end = bracket.end()
            continue
        if slash or (text[place : place + 1] == "·" and end > first):
            place += 1
            while place < len(text) and text[place].isspace():
                place += 1
        found = unit_at(place)
        if found < 0:
            return end
        end = found


@dataclass
class Parser:
    """Precedence-climbing parser that emits postfix code, folds constants and checks units.

    `names` are constants with units that the formula may use, in addition to its variables.
    """

    text: str
    variables: tuple[str, ...]
    dimension: str = ""
    names: Mapping[str, Amount] = field(default_factory=dict)
    code: list[tuple[int, int]] = field(default_factory=list)
    consts: list[float] = field(default_factory=list)
    at: int = 0
    depth: int = 0
    _height: int = 0
    _kinds: list[Kind] = field(default_factory=list)

    def run(self) -> None:
        """Parse the text to `code` and `consts`."""
        for name in self.variables:
            if name in FUNCTIONS or name in CONSTANTS or not name.isidentifier():
                raise FormulaError(f"'{name}' cannot be a variable")
        self.used: set[str] = set()
        self.tokens = tokenize(self.text, self.variables)
        self._sum(0)
        if self._peek.kind != "end":
            self._fail(self._unexpected(self._peek))
        self._check_result()
        self._compact()

    @property
    def kind(self) -> Kind:
        """Kind of the result."""
        return self._kinds[0]

    @property
    def _peek(self) -> Token:
        return self.tokens[self.at]

    def _take(self) -> Token:
        self.at += 1
        return self.tokens[self.at - 1]

    def _fail(self, message: str, token: Token | None = None) -> NoReturn:
        raise FormulaError(message, self.text, (token or self._peek).at)

    def _unexpected(self, token: Token) -> str:
        if token.kind in ("number", "name") and self.at > 0:
            return "an operator is missing"
        return f"unexpected {token.word}"

    def _is(self, *words: str) -> bool:
        return self._peek.kind == "op" and self._peek.word in words

    def _sum(self, level: int) -> None:
        if level > MAX_DEPTH:
            self._fail(f"the formula is nested too deeply (limit {MAX_DEPTH})")
        self._term(level)
        while self._is("+", "-"):
            token = self._take()
            self._term(level)
            self._emit(ADD if token.word == "+" else SUB, token)

    def _term(self, level: int) -> None:
        self._signed(level)
        while self._is("*", "/"):
            token = self._take()
            self._signed(level)
            self._emit(MUL if token.word == "*" else DIV, token)

    def _signed(self, level: int) -> None:
        if level > MAX_DEPTH:
            self._fail(f"the formula is nested too deeply (limit {MAX_DEPTH})")
        if self._is("+", "-"):
            token = self._take()
            self._signed(level + 1)
            if token.word == "-":
                self._emit(NEG, token)
            return
        self._atom(level)
        if self._is("^"):
            token = self._take()
            self._signed(level + 1)
            self._emit(POW, token)

    def _atom(self, level: int) -> None:
        token = self._take()
        if token.kind == "number":
            self._push(token.value, token.word)
        elif token.kind == "name":
            self._name(token, level)
        elif token == ("op", "(", 0.0, token.at):
            self._sum(level + 1)
            self._close()
        else:
            self._fail(f"a number, variable or function is missing before {token.word}", token)

    def _close(self) -> None:
        if not self._is(")"):
            self._fail(
                "a closing bracket is missing" if self._peek.kind == "end" else self._unexpected(self._peek)
            )
        self._take()

    def _name(self, token: Token, level: int) -> None:
        word = token.word
        if word in self.variables:
            self._put(VAR, self.variables.index(word), of_variable(word))
        elif word in CONSTANTS:
            self._push(CONSTANTS[word])
        elif word in FUNCTIONS:
            self._call(token, level)
        elif word in self.names:
            value, unit = self.names[word]
            self.used.add(word)
            self.consts.append(value)
            self._put(CONST, len(self.consts) - 1, of_amount(value, unit))
        else:
            known = [*self.variables, *self.names, *CONSTANTS, *FUNCTIONS]
            guess = did_you_mean(word, known)
            self._fail(f"unknown name '{word}'; {guess}known are {', '.join(known)}", token)

    def _call(self, token: Token, level: int) -> None:
        op, wanted = FUNCTIONS[token.word]
        if not self._is("("):
            self._fail(f"'{token.word}' needs its arguments in brackets", token)
        self._take()
        self._sum(level + 1)
        count = 1
        while self._is(","):
            self._take()
            self._sum(level + 1)
            count += 1
            if op in (MIN, MAX):
                self._emit(op, token)
        self._close()
        if op == STEP and count == 2:
            # step(t, t0) is the step of t - t0
            self._emit(SUB, token)
        elif count != wanted and not (op in (MIN, MAX) and count >= 2):
            self._fail(f"'{token.word}' takes {wanted} argument{'s' * (wanted > 1)}, not {count}", token)
        if op not in (MIN, MAX):
            self._emit(op, token)

    def _push(self, value: float, unit: str = "") -> None:
        self.consts.append(value)
        self._put(CONST, len(self.consts) - 1, of_number(value, unit))

    def _put(self, op: int, arg: int, kind: Kind) -> None:
        self.code.append((op, arg))
        self._kinds.append(kind)
        self._height += 1
        self.depth = max(self.depth, self._height)

    def _emit(self, op: int, token: Token) -> None:
        n = ARITY[op]
        tail = self.code[-n:]
        self._height -= n - 1
        exponent = self.consts[tail[-1][1]] if tail[-1][0] == CONST else None
        try:
            self._kinds[-n:] = [combine(op, self._kinds[-n:], exponent)]
        except UnitError as error:
            raise FormulaError(str(error), self.text, token.at, _remedy(error)) from None
        if not all(o == CONST for o, _ in tail):
            self.code.append((op, 0))
            return
        with np.errstate(all="ignore"):
            value = float(apply(op, *(self.consts[a] for _, a in tail)))
        if not math.isfinite(value):
            self._fail("the result of this operation is not a finite number", token)
        del self.code[-n:]
        self.consts.append(value)
        self.code.append((CONST, len(self.consts) - 1))

    def _check_result(self) -> None:
        if not self.dimension:
            return
        try:
            check_result(self._kinds[0], self.dimension)
        except UnitError as error:
            first = next(t for t in self.tokens if (t.kind == "number" and t.word) or t.word in self.names)
            raise FormulaError(str(error), self.text, first.at, _remedy(error)) from None

    def expanded(self) -> str:
        """The text with the names replaced by their values in SI units."""
        out, end = [], 0
        for token in self.tokens:
            if token.kind == "name" and token.word in self.used:
                out += [self.text[end : token.at], f"({self.names[token.word].value!r})"]
                end = token.at + len(token.word)
        return "".join([*out, self.text[end:]])

    def _compact(self) -> None:
        """Remove constants that are unused after folding."""
        kept: list[float] = []
        for i, (op, arg) in enumerate(self.code):
            if op == CONST:
                kept.append(self.consts[arg])
                self.code[i] = (CONST, len(kept) - 1)
        self.consts = kept
