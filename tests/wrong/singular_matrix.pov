// A matrix that flattens space: its second row is twice the first.
sphere { 0, 1 matrix <1, 2, 0, 2, 4, 0, 0, 0, 1, 0, 0, 0> }
