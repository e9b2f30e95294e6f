package org.urbi.lang.grammar;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.Lexer;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.problem.SyntaxProblem;

/** The part of the scanner that a grammar cannot say: see {@code UrbiscriptLexer.g4}. */
public abstract class LexerBase extends Lexer {
  private static final Set<String> DERIVATIVES = Set.of("d", "dd", "e", "n", "in", "out");
  private static final String OPERATOR_CHARACTERS = "+-*/%^<>=!~&|";

  private final List<LexicalError> issues = new ArrayList<>();
  private final TextStream stream;
  private @Nullable Object value;
  private int previous;
  private int depth;
  private boolean separatorDue;
  private int endOfName = -1;
  private Checkpoint checkpoint = Checkpoint.NONE;

  protected LexerBase(CharStream input) {
    super(input);
    this.stream = (TextStream) input;
  }

  /** Sets what is passed before each token. */
  public void setCheckpoint(Checkpoint passed) {
    checkpoint = passed;
  }

  /** What was wrong or is deprecated, in the order of the text. */
  public List<LexicalError> issues() {
    return issues;
  }

  @Override
  public Token nextToken() {
    if (separatorDue) {
      separatorDue = false;
      int at = stream.index();
      previous = UrbiscriptLexer.SEMICOLON;
      return new UrbiToken(_tokenFactorySourcePair, UrbiscriptLexer.SEMICOLON, 0, at, at - 1, ";");
    }
    checkpoint.pass();
    return super.nextToken();
  }

  @Override
  public Token emit() {
    var token =
        new UrbiToken(
            _tokenFactorySourcePair,
            _type,
            _channel,
            _tokenStartCharIndex,
            stream.index() - 1,
            value);
    value = null;
    previous = _type;
    switch (_type) {
      case UrbiscriptLexer.LPAREN, UrbiscriptLexer.LBRACE, UrbiscriptLexer.LBRACKET -> depth++;
      case UrbiscriptLexer.RPAREN, UrbiscriptLexer.RBRACE, UrbiscriptLexer.RBRACKET -> depth--;
      // A binary literal typed at top level is a statement of its own: nothing ends it but itself.
      case UrbiscriptLexer.BINARY -> separatorDue = depth == 0;
      default -> {}
    }
    emit(token);
    return token;
  }

  /** A word was read: finds which. */
  protected final void word() {
    String word = matched();
    if (word.equals("operator") && operatorName() || word.equals("BIN") && binary()) {
      return;
    }
    if (Keywords.reserved(word)) {
      tell(_tokenStartCharIndex, stream.index(), SyntaxProblem.RESERVED_WORD, word);
    } else if (Keywords.ignored(word)) {
      if (word.equals("static") || word.equals("internal")) {
        warn(SyntaxProblem.DEPRECATED, word);
      }
      skip();
      return;
    } else if (word.equals("foreach") || word.equals("loopn")) {
      warn(SyntaxProblem.DEPRECATED_FOR, word, "for");
    }
    _type = Keywords.token(word);
    endOfName = Keywords.keyword(word) ? -1 : stream.index();
  }

  /** A number was read, with its unit if any. */
  protected final void number() {
    String text = matched();
    Numbers.Value number = Numbers.parse(text);
    if (number == Numbers.INVALID) {
      tell(_tokenStartCharIndex, stream.index(), SyntaxProblem.INVALID_NUMBER, text);
    } else if (text.charAt(text.length() - 1) == 'm') {
      warn(SyntaxProblem.DEPRECATED_FOR, text, text + "in");
    }
    value = number.value();
    _type = number.duration() ? UrbiscriptLexer.DURATION : UrbiscriptLexer.NUMBER;
  }

  /** The opening quote of a string was read: reads the rest. */
  protected final void string() {
    quote('"', SyntaxProblem.OPEN_STRING);
  }

  /** The opening quote of a name was read: reads the rest. */
  protected final void quoted() {
    if (_tokenStartCharIndex == endOfName) {
      derived();
      return;
    }
    quote('\'', SyntaxProblem.OPEN_NAME);
  }

  /** The beginning of a comment was read: reads the rest. Comments nest. */
  protected final void comment() {
    String text = stream.text();
    int at = stream.index();
    int nesting = 1;
    while (nesting > 0 && at < stream.end()) {
      char c = text.charAt(at++);
      if (at < stream.end() && c == '*' && text.charAt(at) == '/') {
        nesting--;
        at++;
      } else if (at < stream.end() && c == '/' && text.charAt(at) == '*') {
        nesting++;
        at++;
      }
    }
    stream.seek(at);
    if (nesting > 0) {
      tell(_tokenStartCharIndex, at, SyntaxProblem.OPEN_COMMENT);
    }
  }

  /** A character was read that cannot start a token. */
  protected final void unknown() {
    char c = stream.text().charAt(_tokenStartCharIndex);
    tell(
        _tokenStartCharIndex,
        stream.index(),
        SyntaxProblem.INVALID_CHARACTER,
        CharacterDisplay.show(c));
    _type = UrbiscriptLexer.INVALID;
  }

  /** What directly follows a name is not the opening quote of another: {@code x'd}. */
  private void derived() {
    String text = stream.text();
    int at = stream.index();
    if (at < stream.end() && text.charAt(at) == '\'') {
      at++;
    } else {
      while (at < stream.end() && 'a' <= text.charAt(at) && text.charAt(at) <= 'z') {
        at++;
      }
      if (!DERIVATIVES.contains(text.substring(stream.index(), at))) {
        at = stream.index();
      }
    }
    stream.seek(at);
    _type = UrbiscriptLexer.DERIVED;
  }

  private void quote(char quote, SyntaxProblem unclosed) {
    int begin = _tokenStartCharIndex;
    var escapes =
        new Escapes(
            stream.text(),
            stream.index(),
            stream.end(),
            quote,
            (end, problem, values) -> tell(begin, end, problem, values));
    boolean closed = escapes.read();
    stream.seek(escapes.position());
    if (!closed) {
      tell(begin, escapes.position(), unclosed);
    }
    value = escapes.value();
  }

  /** {@code operator +} after a dot or {@code function}: the name {@code '+'}. */
  private boolean operatorName() {
    if (previous != UrbiscriptLexer.DOT && previous != UrbiscriptLexer.FUNCTION) {
      return false;
    }
    String text = stream.text();
    int at = stream.index();
    while (at < stream.end() && text.charAt(at) == ' ') {
      at++;
    }
    int begin = at;
    while (at < stream.end() && OPERATOR_CHARACTERS.indexOf(text.charAt(at)) >= 0) {
      at++;
    }
    if (at == begin && (text.startsWith("()", at) || text.startsWith("[]", at))) {
      at += text.startsWith("[]=", at) ? 3 : 2;
    } else if (at == begin && text.startsWith("new", at)) {
      at += 3;
    }
    if (at == begin || at > stream.end()) {
      return false;
    }
    value = text.substring(begin, at);
    stream.seek(at);
    _type = UrbiscriptLexer.QUOTED;
    return true;
  }

  /** {@code BIN size keywords;data}. */
  private boolean binary() {
    String text = stream.text();
    BinaryHeader header = BinaryHeader.read(text, stream.index(), stream.end());
    if (header == null) {
      return false;
    }
    int data = header.data();
    int last = (int) Math.min(stream.end(), (long) data + header.size());
    if (last - data < header.size()) {
      tell(_tokenStartCharIndex, last, SyntaxProblem.OPEN_BINARY);
    }
    value = new BinaryLiteral(header.keywords(), text.substring(data, last));
    stream.seek(last);
    _type = UrbiscriptLexer.BINARY;
    return true;
  }

  private String matched() {
    return stream.text().substring(_tokenStartCharIndex, stream.index());
  }

  private void tell(int begin, int end, SyntaxProblem problem, Object... values) {
    issues.add(new LexicalError(begin, end, problem, problem.text(values)));
  }

  private void warn(SyntaxProblem problem, Object... values) {
    tell(_tokenStartCharIndex, stream.index(), problem, values);
  }
}
