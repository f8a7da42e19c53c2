// A bare texture name among an object's modifiers.
#declare Paint = texture { pigment { rgb 1 } }
sphere { 0, 1 Paint }
