// A type of picture that POV-Ray lists but cannot read.
plane { z, 0 pigment { image_map { iff "backdrop.iff" } } }
