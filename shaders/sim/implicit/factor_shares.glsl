// What a vertex or a block of the matrix has of the factors of constraints (factors.comp).
STATE_TEXELS(kFactorsUnit) factors;
RECORD_WORDS(kBlockSharesUnit) blockShares;

// Where the factors of a share begin; its slots follow (kSlotBits).
uint factorsOf(uint share) { return share >> kSlotBits << 1; }
