/** The sentences of urbiscript (manual, "The urbiscript Language"). */
parser grammar UrbiParser;

options { tokenVocab = UrbiLexer; superClass = ParserBase; }

program: sequence EOF;

sequence: parallel? ((SEMI | COMMA) parallel?)*;
parallel: piped (AMP piped)* AMP?;
piped: statement (PIPE statement)* PIPE?;

statement
  : expression (COLON body?)?                                       # expressionStatement
  | IF LPAREN sequence RPAREN body? (ELSE body?)?                 # ifStatement
  | WHILE flavor? LPAREN sequence RPAREN body?                    # whileStatement
  | FOR flavor? LPAREN (VAR? identifier (RANGE_COLON | IN))? expression RPAREN body? # forEach
  | FOR flavor? LPAREN init=expression? SEMI condition_=expression? SEMI step=expression? RPAREN
      body?                                                         # forStatement
  | LOOP flavor? body?                                              # loopStatement
  | EVERY flavor? LPAREN expression RPAREN body?                    # everyStatement
  | AT flavor? identifier* LPAREN condition RPAREN body? (ONLEAVE body?)? # atStatement
  | WHENEVER flavor? LPAREN condition RPAREN body? (ELSE body?)?    # wheneverStatement
  | WAITUNTIL LPAREN condition RPAREN                               # waitUntilStatement
  | TIMEOUT LPAREN expression RPAREN body?                          # timeoutStatement
  | STOPIF LPAREN condition RPAREN body?                            # stopIfStatement
  | FREEZEIF LPAREN condition RPAREN body?                          # freezeIfStatement
  | SWITCH LPAREN expression RPAREN LBRACE switchCase* defaultCase? RBRACE # switchStatement
  | RETURN expression?                                              # returnStatement
  | THROW expression?                                               # throwStatement
  | BREAK                                                           # breakStatement
  | CONTINUE                                                        # continueStatement
  | TRY scope catchClause* (ELSE scope)? (FINALLY scope)?           # tryStatement
  | ASSERT LPAREN argument (COMMA argument)* RPAREN                 # assertStatement
  | ASSERT scope                                                    # assertBlock
  | CLASS path (COLON proto (COMMA proto)*)? scope?                 # classStatement
  | PACKAGE path scope                                              # packageStatement
  | IMPORT (identifier | THIS) (DOT identifier)* (DOT STAR)?                 # importStatement
  | ENUM path LBRACE (identifier (COMMA identifier)* COMMA?)? RBRACE # enumStatement
  | GET path formals? scope                                         # getStatement
  | SET path formals scope                                          # setStatement
  ;

proto: PROTECTION? expression;
body: statement;
flavor: FLAVOR;
condition: expression (IF expression)? (TILDE expression)?;
switchCase: CASE expression (IF expression)? PATTERN_COLON sequence;
defaultCase: DEFAULT COLON sequence;
catchClause: CATCH (LPAREN expression (IF expression)? RPAREN)? scope;
scope: LBRACE sequence RBRACE;

expression
  : primary                                                         # primaryExpression
  | expression DOT selector                                         # slotExpression
  | expression COLONS selector                                      # accessExpression
  | expression DOT_AMP selector                                     # accessExpression
  | expression ARROW selector                                       # propertyExpression
  | expression arguments                                            # callExpression
  | expression LBRACKET argumentList? RBRACKET                      # subscriptExpression
  | expression op=(INCREMENT | DECREMENT)                           # postfixExpression
  | expression QUESTION arguments?                                  # eventExpression
  | expression EMIT arguments? (TILDE expression)?                  # emitExpression
  | <assoc=right> expression op=POWER expression                    # binaryExpression
  | op=(PLUS | MINUS | COMPL) expression                            # unaryExpression
  | op=(INCREMENT | DECREMENT) expression                           # prefixExpression
  | expression op=(STAR | SLASH | PERCENT) expression               # binaryExpression
  | expression op=(PLUS | MINUS) expression                         # binaryExpression
  | expression op=(SHIFT_LEFT | SHIFT_RIGHT) expression             # binaryExpression
  | expression op=(EQUAL | NOT_EQUAL | SAME | NOT_SAME | NEAR | ALMOST | LESS | LESS_EQUAL
      | GREATER | GREATER_EQUAL) expression                         # comparison
  | expression op=BITAND expression                                 # binaryExpression
  | expression op=CARET expression                                  # binaryExpression
  | expression op=BITOR expression                                  # binaryExpression
  | op=BANG expression                                              # unaryExpression
  | expression BANG? IN expression                                  # membership
  | expression AND expression                                       # conjunction
  | expression OR expression                                        # disjunction
  | expression ASSIGN (expression modifier* | modifier+)            # assignment
  | <assoc=right> expression op=(PLUS_ASSIGN | MINUS_ASSIGN | STAR_ASSIGN | SLASH_ASSIGN
      | PERCENT_ASSIGN | CARET_ASSIGN) expression                   # operatorAssignment
  ;

modifier: MODIFIER COLON expression;

primary
  : FLOAT                                                           # floatLiteral
  | ANGLE                                                           # angleLiteral
  | DURATION+                                                       # durationLiteral
  | STRING+                                                         # stringLiteral
  | THIS                                                            # thisPrimary
  | CALL                                                            # callPrimary
  | (identifier | NEW)                                              # namePrimary
  | DERIVATIVE                                                      # derivativePrimary
  | AMP identifier                                                  # accessPrimary
  | LPAREN argumentList? RPAREN                                     # parentheses
  | LBRACKET (FAT_ARROW | element (COMMA element)* COMMA?)? RBRACKET # brackets
  | NEW path arguments?                                             # newPrimary
  | CONST? VAR variable (COLON path ASSIGN expression | ASSIGN expression)? # declaration
  | CONST variable (ASSIGN expression)?                             # declaration
  | (FUNCTION | CLOSURE) path? formals? scope                       # functionPrimary
  | DO (LPAREN expression RPAREN)? scope                            # doPrimary
  | WATCH LPAREN expression RPAREN                                  # watchPrimary
  | scope                                                           # scopePrimary
  ;

variable: (selector | THIS) ((DOT selector) | (ARROW selector) | arguments
    | (LBRACKET argumentList? RBRACKET))*;
path: (selector | THIS | CALL) (DOT selector)*;
selector: identifier | NEW | DERIVATIVE;
identifier: IDENTIFIER | QUOTED;
element: argument (FAT_ARROW argument)?;
argument: expression (COLON body)?;
argumentList: argument (COMMA argument)* COMMA?;
arguments: LPAREN argumentList? RPAREN;
formals: LPAREN (formal (COMMA formal)* COMMA?)? RPAREN;
formal: VAR? identifier (LBRACKET RBRACKET)? (COLON type)? (ASSIGN expression (COLON type)?)?;
type: primary (DOT selector)*;
