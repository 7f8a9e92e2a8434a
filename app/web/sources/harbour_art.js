// Colours and sprites of the test picture 'harbour'.

/** Indices into harbourPalette, in the order of the letters of sprites. */
export const harbourPaint = {
    night: 0,  // a
    indigo: 1,  // b
    violet: 2,  // c
    plum: 3,  // d
    rose: 4,  // e
    orange: 5,  // f
    peach: 6,  // g
    cream: 7,  // h
    deepSea: 8,  // i
    sea: 9,  // j
    foam: 10,  // k
    stone: 11,  // l
    shade: 12,  // m
    wood: 13,  // n
    red: 14,  // o
    moss: 15,  // p
};

/** 0xRRGGBB, display values. */
export const harbourPalette = [
    0x120c26, 0x241a4e, 0x4a2474, 0x8a3480, 0xd2546e, 0xf58a52, 0xffbe6e, 0xfff0c0,
    0x16264e, 0x2a4a7c, 0x7aa8c8, 0x6a6480, 0x3a3552, 0x70422e, 0xc03440, 0x2c4a3c,
];

export const harbourBoat = [
    '...........a..........', '..........ahh.........', '..........ahhg........',
    '.........hahhg........', '.........hahhgg.......', '........hhahhhg.......',
    '........hhahhhgg......', '.......hhhahhhhg......', '.......hhhahhhhgg.....',
    '......hhhhahhhhhg.....', '......hhhhahhhhhgg....', '.....hhhhhahhhhhhg....',
    '.....ghhhhahhhhhhgg...', '....ghhhhhahhhhhhhg...', '....gghhhhahhhhhhhgg..',
    '...ggghhhhaooooooooo..', '...gggghhhahhhhhhhhgg.', '..gggggghhahhhhhhhhhg.',
    '..........a...........', 'nnnnnnnnnnnnnnnnnnnnnn', '.ohhhhhhhhhhhhhhhhhho.',
    '..nnnnnnnnnnnnnnnnnn..', '...naaaaaaaaaaaaaan...', '....aaaaaaaaaaaaaa....',
];

export const harbourFlowers = [
    '..o..g..o.e.', '.ooppeppoope', 'pppopppepppp', 'nnnnnnnnnnnn',
    '.nnnnnnnnnn.', '..nnnnnnnn..',
];

export const harbourCat = [
    '..aa......aa..', '..afa....afa..', '..affaaaaffa..', '..affffffffa..', '..afffnffnfa..',
    '..afffnffnfa..', '..affffffffa..', '...affffffa...', '....aaffaa....', '...afffffna...',
    '..afffffffna..', '..affnfffnna..', '.affffffffnna.', '.afnnffffnnna.', '.affffffffnna.',
    'afffnffffnnnna', 'affffffffffnna', 'afnnfffffffnna', 'affffffffffnna', 'afffffafffffna',
    'affffaaaffffna', '.aaaa...aaaaa.',
];

export const harbourBarrel = [
    '...aaaaaaaaa...', '.aannnnnnnnnaa.', 'annnnnnnnnnnnna', 'aaannnnnnnnnaaa',
    'afnaaaaaaaaanna', 'anfnnnannnannna', 'annfnnannnannna', 'alllllllllllmma',
    'ammmmmmmmmmmmma', 'anfnnnannnannna', 'anfnnnannnannna', 'annfnnannnannna',
    'alllllllllllmma', 'ammmmmmmmmmmmma', 'anfnnnannnannna', '.aannnnnnnnnaa.',
    '...aaaaaaaaa...',
];
