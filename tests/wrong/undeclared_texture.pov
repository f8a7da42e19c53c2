// A texture that comes from an include file which is not included.
sphere { 0, 1 texture { Polished_Chrome } }
