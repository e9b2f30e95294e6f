/*
 * The tokens of urbiscript (manual, "Syntax").
 *
 * Keywords, numbers with units, strings, nested comments and binary blobs are finished by hand in
 * LexerBase: their extent or their kind depends on their contents.
 */
lexer grammar UrbiscriptLexer;

options { superClass = LexerBase; }

tokens {
  // Keywords, by their names in lower case: LexerBase turns a WORD into one of these. Class Keywords
  // has the same list, from the first to the last of the operators without a symbol.
  ASSERT, AT, BREAK, CALL, CASE, CATCH, CLASS, CLOSURE, CONST, CONTINUE, DEFAULT, DO, ELSE, EMIT,
  ENUM, EVERY, EXTERNAL, FINALLY, FOR, FREEZEIF, FUNCTION, IF, IN, LOOP, NEW, NOT, ONLEAVE, RETURN,
  STOPIF, SWITCH, THIS, THROW, TIMEOUT, TRY, VAR, WAITUNTIL, WATCH, WHENEVER, WHILE,
  // Words that are keywords in one place and identifiers everywhere else.
  GET, SET, IMPORT, PACKAGE,
  // Operators that have no symbol.
  BITAND, BITOR, COMPL, AND_EQ, OR_EQ,
  // Numbers with a time unit, binary literals, quotes after a name as in x'd, and errors.
  DURATION, BINARY, DERIVED, INVALID
}

WORD : [a-zA-Z_] [a-zA-Z_0-9]* { word(); } ;

NUMBER
  : [0-9] [0-9_]* ('.' [0-9] [0-9_]*)? ([eE] [+\-]? [0-9] [0-9_]*)? [a-zA-Z_0-9]* { number(); }
  ;

STRING : '"' { string(); } ;
QUOTED : '\'' { quoted(); } ;

LINE_COMMENT : '//' ~[\n]* -> skip ;
BLOCK_COMMENT : '/*' { comment(); } -> skip ;
BLANK : [ \t\r\n\u000B\f]+ -> skip ;

SEMICOLON : ';' ;
COMMA : ',' ;
PIPE : '|' ;
AND : '&' ;
COLON : ':' ;
QUESTION : '?' ;
TILDE : '~' ;
LPAREN : '(' ;
RPAREN : ')' ;
LBRACKET : '[' ;
RBRACKET : ']' ;
LBRACE : '{' ;
RBRACE : '}' ;

DOT : '.' ;
DOT_AND : '.&' ;
ARROW : '->' ;
FAT_ARROW : '=>' ;

ASSIGN : '=' ;
PLUS_ASSIGN : '+=' ;
MINUS_ASSIGN : '-=' ;
TIMES_ASSIGN : '*=' ;
DIVIDE_ASSIGN : '/=' ;
MODULO_ASSIGN : '%=' ;
XOR_ASSIGN : '^=' ;
INCREMENT : '++' ;
DECREMENT : '--' ;

POWER : '**' ;
TIMES : '*' ;
DIVIDE : '/' ;
MODULO : '%' ;
PLUS : '+' ;
MINUS : '-' ;
SHIFT_LEFT : '<<' ;
SHIFT_RIGHT : '>>' ;
EQUAL : '==' ;
NOT_EQUAL : '!=' ;
SAME : '===' ;
NOT_SAME : '!==' ;
NEAR : '~=' ;
NEAR_ABSOLUTE : '=~=' ;
LESS : '<' ;
LESS_EQUAL : '<=' ;
GREATER : '>' ;
GREATER_EQUAL : '>=' ;
XOR : '^' ;
BANG : '!' ;
AND_AND : '&&' ;
OR_OR : '||' ;

UNKNOWN : . { unknown(); } ;
