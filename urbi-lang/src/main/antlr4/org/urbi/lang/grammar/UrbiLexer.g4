/** The words of urbiscript; what regular expressions cannot tell is in {@code LexerBase}. */
lexer grammar UrbiLexer;

options { superClass = LexerBase; }

// Tokens that only the token filter makes, from what stands around a word.
tokens { MODIFIER, EMIT, GET, SET, PATTERN_COLON, RANGE_COLON, SYNC, FLAVOR, BAD_STRING }

ASSERT: 'assert';
AT: 'at';
BREAK: 'break';
CALL: 'call';
CASE: 'case';
CATCH: 'catch';
CLASS: 'class';
CLOSURE: 'closure';
CONST: 'const';
CONTINUE: 'continue';
DEFAULT: 'default';
DO: 'do';
ELSE: 'else';
ENUM: 'enum';
EVERY: 'every';
FINALLY: 'finally';
FOR: 'for' | 'foreach';
FREEZEIF: 'freezeif';
FUNCTION: 'function';
IF: 'if';
IMPORT: 'import';
IN: 'in';
LOOP: 'loop';
NEW: 'new';
ONLEAVE: 'onleave';
PACKAGE: 'package';
PROTECTION: 'private' | 'protected' | 'public';
RETURN: 'return';
STOPIF: 'stopif';
SWITCH: 'switch';
THIS: 'this';
THROW: 'throw';
TIMEOUT: 'timeout';
TRY: 'try';
VAR: 'var';
WAITUNTIL: 'waituntil';
WATCH: 'watch';
WHENEVER: 'whenever';
WHILE: 'while';

RESERVED
  : 'asm' | 'auto' | 'bool' | 'char' | 'const_cast' | 'delete' | 'double' | 'dynamic_cast'
  | 'explicit' | 'export' | 'extern' | 'float' | 'friend' | 'goto' | 'inline' | 'int' | 'long'
  | 'mutable' | 'namespace' | 'register' | 'reinterpret_cast' | 'short' | 'signed' | 'sizeof'
  | 'static_cast' | 'struct' | 'template' | 'typedef' | 'typeid' | 'typename' | 'union'
  | 'unsigned' | 'using' | 'virtual' | 'volatile' | 'wchar_t'
  ;

PLUS_ASSIGN: '+=';
MINUS_ASSIGN: '-=';
STAR_ASSIGN: '*=';
SLASH_ASSIGN: '/=';
PERCENT_ASSIGN: '%=';
CARET_ASSIGN: '^=' | 'xor_eq';
EQUAL: '==';
NOT_EQUAL: '!=' | 'not_eq';
SAME: '===';
NOT_SAME: '!==';
NEAR: '~=';
ALMOST: '=~=';
LESS_EQUAL: '<=';
LESS: '<';
GREATER_EQUAL: '>=';
GREATER: '>';
SHIFT_LEFT: '<<';
SHIFT_RIGHT: '>>';
INCREMENT: '++';
DECREMENT: '--';
POWER: '**';
STAR: '*';
SLASH: '/';
PERCENT: '%';
PLUS: '+';
MINUS: '-';
CARET: '^' | 'xor';
COMPL: 'compl';
BITAND: 'bitand';
BITOR: 'bitor';
ARROW: '->';
FAT_ARROW: '=>';
AND: '&&' | 'and';
OR: '||' | 'or';
BANG: '!' | 'not';
ASSIGN: '=';
TILDE: '~';
QUESTION: '?';
DOT_AMP: '.&';
DOT: '.';
COLONS: '::';
COLON: ':';
SEMI: ';';
COMMA: ',';
PIPE: '|';
AMP: '&';
LPAREN: '(';
RPAREN: ')';
LBRACKET: '[';
RBRACKET: ']';
LBRACE: '{';
RBRACE: '}';

FLOAT: NUMBER | '0x' HEX ('_'* HEX)*;
ANGLE: NUMBER ('deg' | 'rad' | 'grad');
DURATION: (NUMBER ('ms' | 's' | 'm' | 'min' | 'h' | 'd'))+;
BAD_TOKEN: NUMBER LETTER (LETTER | DIGIT)*;

IDENTIFIER: LETTER (LETTER | DIGIT)*;
OPERATOR_NAME
  : 'operator' [ \t]* ('+' | '-' | '*' | '/' | '%' | '**' | '^' | '!' | '<<' | '>>' | '==' | '!='
    | '===' | '!==' | '~=' | '=~=' | '<' | '<=' | '>' | '>=' | '()' | '[]' | '[]=' | '+=' | '-='
    | '*=' | '/=' | '%=' | '^=' | '++' | '--' | '&&' | '||') -> type(IDENTIFIER)
  ;
OPERATOR_NEW: 'operator' [ \t]+ 'new' -> type(IDENTIFIER);
DERIVATIVE: LETTER (LETTER | DIGIT)* '\'' ('\'' | 'd' | 'dd' | 'e' | 'in' | 'n' | 'out')?;
QUOTED: '\'' (~['\\] | '\\' .)* '\'';
STRING: '"' { string(); };

BLANK: [ \t\r\n\f\u000B]+ -> skip;
LINE_COMMENT: '//' ~[\n]* -> skip;
COMMENT: '/*' { comment(); } -> skip;

BAD_CHARACTER: .;

fragment NUMBER: DIGITS ('.' DIGITS)? ([eE] [+\-]? DIGITS)?;
fragment DIGITS: DIGIT ('_'* DIGIT)*;
fragment DIGIT: [0-9];
fragment HEX: [0-9a-fA-F];
fragment LETTER: [a-zA-Z_$];
