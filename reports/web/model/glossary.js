// SPDX-License-Identifier: GPL-3.0-or-later
// What the page's words mean: [term, other spellings, meaning]. Shown where a word stands and as a list.

const TERMS = [
  // Verdicts.
  [
    "holds",
    ["hold", "pass"],
    "A check holds when its error is at most its tolerance; a record when all its checks do.",
  ],
  [
    "fails",
    ["fail"],
    "The error is beyond the tolerance, and nobody had stated that beforehand. Something is broken.",
  ],
  [
    "expected shortfall",
    ["expected-shortfall", "falls short", "short"],
    "The value misses its claim, as was stated beforehand: it lies in a band that a measured cause explains. Outside the band, on either side, the check fails.",
  ],
  [
    "refuted",
    [],
    "The same for a claim of the paper: it was tested as the paper states it, and found not to hold.",
  ],
  [
    "broke off",
    ["error"],
    "The run ended before its time: an error, a crash, or values that are no numbers.",
  ],
  [
    "for information",
    ["for-information", "not judged"],
    "Measured and shown, but judged by nobody: there is no claim to hold it to.",
  ],
  ["not applicable", ["not-applicable"], "The engine cannot run this case, and says why."],
  // Configurations.
  [
    "configuration",
    [],
    "The way an engine was run: its method with its usual settings. A row names only what it sets otherwise.",
  ],
  [
    "quiet",
    [],
    "This project's own method: contact forces that cannot overshoot, contacts that are kept where rounding would lose them, and friction that is remembered as a vector, so that what rests comes to rest.",
  ],
  [
    "paper, fixed point",
    [],
    "The paper's method with its fixed-point iteration: each step corrects a contact's factor of friction, ξ, by the slip that is left.",
  ],
  [
    "paper, secant",
    [],
    "The paper's method with its secant iteration: the correction of ξ is extrapolated from the last two steps.",
  ],
  [
    "paper, no memory",
    [],
    "The paper's method with ξ = 1 in each step: nothing is remembered from the steps before.",
  ],
  [
    "old",
    [],
    "The older method that the paper compares itself with. It is asserted only that it breaks where the paper says so; the rest is for information.",
  ],
  [
    "fixed point",
    ["fixed-point"],
    "An iteration that adds to the last guess a share of the error that is left.",
  ],
  ["secant", [], "An iteration that takes the next guess from the line through the last two."],
  // Numbers.
  [
    "digits",
    [],
    "How many digits of a value agree with what was expected: −log₁₀ of the error over the size of the quantity, at most 16. None where zero is expected and nothing tells of what size.",
  ],
  [
    "perturbation",
    ["perturbations", "perturbed"],
    "Something done to a whole scene that must not change what is measured: it is turned, moved, mirrored, its bodies are renumbered, its units are others, its numbers are rounded otherwise.",
  ],
  [
    "digits that survive",
    [],
    "−log₁₀ of the scatter σ of a figure under perturbations over its size, of the worst figure, at most 16; 0 is none.",
  ],
  [
    "ladder",
    ["rung"],
    "A parameter swept over decades until something breaks; each of its values is a rung, a case of its own.",
  ],
  [
    "of tolerance",
    ["error ÷ tolerance", "worst ratio", "tolerance"],
    "Error ÷ tolerance. A check holds up to 1 (100 %). Every tolerance is derived, with its reason beside the check.",
  ],
  [
    "CPU time",
    [],
    "CPU seconds that the engine's steps took, without making the case ready and judging it.",
  ],
  [
    "state hash",
    ["end state"],
    "A number made of every bit of the last state. Equal hashes: the two runs did exactly the same.",
  ],
  [
    "effort",
    [],
    "What changes only how much work is done, not what is simulated: the time step, the sweeps, the cells of a mesh.",
  ],
  // Physics.
  [
    "creep",
    ["creeps"],
    "Motion of what should rest, as a speed (m/s): friction that only brakes never brings it to a stop.",
  ],
  [
    "slip",
    ["contact slip"],
    "Tangential velocity of the two surfaces at a contact, m/s. Static friction means none.",
  ],
  ["drift", [], "The way that something at rest has moved in a stated time, m."],
  [
    "critical slope",
    ["critical tan θ", "threshold"],
    "The slope at which a body at rest begins to slide. Coulomb: tan θ = μ.",
  ],
  [
    "μ",
    ["mu", "friction coefficient"],
    "The largest tangential force that friction bears over the normal force.",
  ],
  [
    "κ",
    ["kappa", "gain"],
    "How much of the penetration depth the contact forces close in one step. Above its bound the contacts overshoot and what rests is shaken.",
  ],
  [
    "ξ",
    ["xi"],
    "In the paper's method the factor of a contact's friction: f = −ξ ũ/w, of the free slip ũ and the inverse mass w. It is corrected from step to step; ξ = 1 is friction without memory.",
  ],
  [
    "penetration depth",
    ["depth"],
    "How far a vertex lies inside another body, m. A penalty contact pushes back in proportion to it.",
  ],
  [
    "sweep",
    ["sweeps"],
    "One pass of the friction iteration over all contacts, within a time step.",
  ],
  ["Δt", ["dt", "time step"], "Length of a time step, s."],
];

const normal = (word) => word.toLowerCase();
const BY_WORD = new Map(
  TERMS.flatMap(([name, others, meaning]) =>
    [name, ...others].map((word) => [normal(word), { name, meaning }]),
  ),
);

/** {name, meaning} of a word; undefined where the glossary has none. */
export const glossary_entry = (word) => BY_WORD.get(normal(word));

/** All terms: [{name, meaning}]. */
export const GLOSSARY = TERMS.map(([name, , meaning]) => ({ name, meaning }));
