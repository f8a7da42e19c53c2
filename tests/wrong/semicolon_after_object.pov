// A semicolon after an object, as in other languages.
sphere { 0, 1 pigment { rgb 1 } };
plane { y, 0 }
