# The folders of include/rift and source, one per stage of the step, in the
# order in which they may include each other.
set(rift_folders base mesh discretization material module solid cohesive bonds contact
  loading damping rigid time_integration io app)
