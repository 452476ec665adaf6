"""Names of rings and their data, read, judged and forged by what shares nothing with prover and checker."""
