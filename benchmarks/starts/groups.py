"""All problems by group and name. A problem is a function without arguments that makes a ``Problem``."""

import approach
import arches
import assemblies
import guided
import layers
import refusals
import rubbing
import scales
import snap
import stacks
import through
import touching
import unloading

_MODULES = {
    "touching": touching,
    "stacks": stacks,
    "refusals": refusals,
    "arches": arches,
    "assemblies": assemblies,
    "layers": layers,
    "approach": approach,
    "unloading": unloading,
    "rubbing": rubbing,
    "snap": snap,
    "scales": scales,
    "through": through,
    "guided": guided,
}

GROUPS = {name: module.PROBLEMS for name, module in _MODULES.items()}

SLOW = {(name, one) for name, module in _MODULES.items() for one in module.SLOW}
"""Problems that take more than 5 s."""

MAY_FAIL = {name: module.MAY_FAIL for name, module in _MODULES.items() if hasattr(module, "MAY_FAIL")}
"""By group: how many of which problems need not be solved."""


def named(words):
    """Groups and names of the problems in whose ``group: name`` all words of one of the arguments occur; of all without arguments."""
    everything = [(group, name) for group, problems in GROUPS.items() for name in problems]
    found = lambda one: any(all(word in f"{one[0]}: {one[1]}" for word in text.split()) for text in words)
    return [one for one in everything if found(one)] if words else everything
