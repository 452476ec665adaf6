"""How long tests wait for what should have ended, in seconds."""

# No bound on how quick anything is: a busy machine may give a process a tenth of a core.
PATIENCE = 600.0
