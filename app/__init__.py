"""The document and what may be done to it: commands, tools, jobs, actions, the command line."""
