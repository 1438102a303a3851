"""How people judge: value functions, probability weighting, and teachers of known taste."""
