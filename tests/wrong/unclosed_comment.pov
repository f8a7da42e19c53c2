// A comment that is never closed.
sphere { 0, 1 }
/* The rest of the scene
plane { y, 0 }
