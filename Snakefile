"""The workflow, found from the top folder together with its default profile."""


include: "workflow/Snakefile"
