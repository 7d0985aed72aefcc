"""Results and figures of the solver vibroimpact."""
