// A directive that does not exist.
#delcare Radius = 2;
sphere { 0, Radius }
