/*
 * The grammar of urbiscript (manual, "urbiscript Language Reference Manual").
 *
 * The rule "expression" is flat on purpose: operators are grouped by the precedence table of
 * org.urbi.lang.parse.Operators. A long chain costs neither stack nor lookahead that way, and every
 * decision here needs one token, seldom two.
 */
parser grammar UrbiscriptParser;

options { tokenVocab = UrbiscriptLexer; superClass = ParserBase; }

// ------------------------------------------------------------------------------ whole texts

/** One statement of an interactive session, and the separator that ended it. */
item : pipe? (SEMICOLON | COMMA) EOF ;

/** A complete text. */
program : sequence EOF ;

// ------------------------------------------------------------------------------ composition

sequence : pipe? ((SEMICOLON | COMMA) pipe?)* ;
pipe : parallel (PIPE parallel?)* ;
parallel : statement (AND statement?)* ;
scope : LBRACE sequence RBRACE ;

/** What a control structure governs. */
body : statement? ;

flavor : SEMICOLON | PIPE | COMMA | AND ;

// ------------------------------------------------------------------------------ statements

statement
  : ifStatement
  | whileStatement
  | forStatement
  | loopStatement
  | switchStatement
  | everyStatement
  | atStatement
  | wheneverStatement
  | waitUntilStatement
  | timeoutStatement
  | stopIfStatement
  | freezeIfStatement
  | tryStatement
  | throwStatement
  | returnStatement
  | breakStatement
  | continueStatement
  | assertStatement
  | classDefinition
  | enumDefinition
  | packageDefinition
  | importStatement
  | externalDeclaration
  | accessor
  | emitStatement
  | expressionStatement
  ;

ifStatement : IF LPAREN sequence RPAREN body (ELSE body)? ;
whileStatement : WHILE flavor? LPAREN sequence RPAREN body ;
loopStatement : LOOP flavor? body ;
everyStatement : EVERY flavor? LPAREN expression RPAREN body ;

forStatement : FOR flavor? LPAREN forHead RPAREN body ;
forHead
  : VAR name (COLON | IN) expression
  | init=forClause? SEMICOLON test=forClause? SEMICOLON step=forClause?
  | expression
  ;
forClause : expression (PIPE expression)* ;

switchStatement : SWITCH LPAREN sequence RPAREN LBRACE switchCase* switchDefault? RBRACE ;
switchCase : CASE expression (IF expression)? COLON sequence ;
switchDefault : DEFAULT COLON sequence ;

atStatement : AT flavor? name* LPAREN condition RPAREN body (ONLEAVE body)? ;
wheneverStatement : WHENEVER LPAREN condition RPAREN body (ELSE body)? ;
waitUntilStatement : WAITUNTIL LPAREN condition RPAREN ;
stopIfStatement : STOPIF LPAREN condition RPAREN body ;
freezeIfStatement : FREEZEIF LPAREN condition RPAREN body ;
timeoutStatement : TIMEOUT LPAREN expression RPAREN body ;

/** "e?(patterns) if guard ~ duration", or "expression ~ duration". */
condition
  : expression (QUESTION arguments? (IF guard=expression)?)? (TILDE duration=expression)?
  ;

tryStatement
  : TRY scope (catchClause+ elseClause? finallyClause? | finallyClause)
  ;
catchClause : CATCH (LPAREN expression (IF expression)? RPAREN)? scope ;
elseClause : ELSE scope ;
finallyClause : FINALLY scope ;
throwStatement : THROW expression? ;

returnStatement : RETURN expression? ;
breakStatement : BREAK ;
continueStatement : CONTINUE ;

assertStatement : ASSERT (LPAREN expression RPAREN | LBRACE sequence RBRACE) ;

/** What is no name must at least have a body, so that the first thing wrong is told. */
classDefinition : CLASS postfix (COLON protos)? (scope | {isNoScope($postfix.ctx)}?) ;
packageDefinition : PACKAGE path (COLON protos)? scope ;
protos : expression (COMMA expression)* ;
enumDefinition : ENUM postfix LBRACE (name (COMMA name)* COMMA?)? RBRACE ;
importStatement : IMPORT path (DOT TIMES)? ;

/** What a remote UObject says of itself: "external function (2) robot.move from robot". */
externalDeclaration
  : EXTERNAL (VAR | FUNCTION | WORD) (LPAREN NUMBER RPAREN)? path (WORD path)?
  ;

accessor : (GET | SET) path formals? scope ;

/** The deprecated "emit e(arguments) ~ duration". */
emitStatement : EMIT expression (TILDE expression)? ;

/** An expression, "tag: statement" (the tag is one operand), or "e!(arguments) ~ duration". */
expressionStatement : head=expression ({isTag($head.ctx)}? COLON body | TILDE expression)? ;

// ------------------------------------------------------------------------------ expressions

/**
 * Operands and operators, the last operand being assigned to if an assignment follows. Modifiers
 * follow what is assigned; elsewhere they are an error that only the next token shows.
 */
expression : prefix* operand (binary prefix* operand)* (assignment | modifier*) ;

/** The same without assignment. */
plain : prefix* operand (binary prefix* operand)* ;

prefix : PLUS | MINUS | BANG | NOT | COMPL | TILDE ;

binary
  : POWER
  | TIMES | DIVIDE | MODULO
  | PLUS | MINUS
  | SHIFT_LEFT | SHIFT_RIGHT
  | EQUAL | NOT_EQUAL | SAME | NOT_SAME | NEAR | NEAR_ABSOLUTE
  | LESS | LESS_EQUAL | GREATER | GREATER_EQUAL
  | BITAND
  | XOR
  | BITOR
  | IN
  | NOT IN
  | AND_AND
  | OR_OR
  ;

operand : declaration | postfix ;

declaration : CONST? VAR postfix ;

assignment
  : ASSIGN (modifier+ | expression)
  | (PLUS_ASSIGN | MINUS_ASSIGN | TIMES_ASSIGN | DIVIDE_ASSIGN | MODULO_ASSIGN | XOR_ASSIGN)
    expression
  ;

/** "time: 5s" in a trajectory. */
modifier : name COLON plain ;

postfix : primary suffix* ;

suffix
  : DOT name arguments?
  | DOT_AND name
  | ARROW name
  | LBRACKET (expression (COMMA expression)* COMMA?)? RBRACKET
  | BANG arguments?
  | INCREMENT
  | DECREMENT
  | DERIVED
  | arguments
  ;

arguments : LPAREN (expression (COMMA expression)* COMMA?)? RPAREN ;

primary
  : NUMBER
  | DURATION+
  | STRING+
  | BINARY
  | THIS
  | CALL
  | NEW path arguments?
  | NEW
  | identifier
  | AND name
  | WATCH LPAREN expression RPAREN
  | scope
  | DO (LPAREN expression RPAREN)? scope
  | function
  | parentheses
  | list
  ;

parentheses : LPAREN (expression (COMMA expression)* COMMA?)? RPAREN ;
list : LBRACKET (FAT_ARROW | element (COMMA element)* COMMA?)? RBRACKET ;
element : expression (FAT_ARROW expression)? ;

function : (FUNCTION | CLOSURE) path? formals? scope ;
formals : LPAREN (formal (COMMA formal)* COMMA?)? RPAREN ;
formal : VAR? name (LBRACKET RBRACKET)? (COLON postfix)? (ASSIGN expression)? ;

/** "a.b.c", "this.f". */
path : (THIS | name) (DOT name)* ;

identifier : WORD | QUOTED | GET | SET | IMPORT | PACKAGE ;
name : identifier | NEW | WATCH | EMIT ;
