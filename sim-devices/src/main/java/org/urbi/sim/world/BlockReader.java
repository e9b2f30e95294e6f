package org.urbi.sim.world;

import java.util.ArrayList;
import java.util.List;
import org.urbi.sim.world.WorldFileTokens.Kind;
import org.urbi.sim.world.WorldFileTokens.Token;

/** Reads the blocks of a world file, whatever they mean. */
final class BlockReader {
  private static final int DEEPEST = 16;

  private final List<Token> tokens;
  private int at;

  private BlockReader(List<Token> tokens) {
    this.tokens = tokens;
  }

  static List<Block> read(String file, String text) {
    BlockReader reader = new BlockReader(WorldFileTokens.of(file, text));
    List<Block> blocks = new ArrayList<>();
    reader.skipEnds();
    while (reader.peek().kind() != Kind.END_OF_FILE) {
      Token word = reader.expect(Kind.WORD, "a block, as 'body NAME {', expected");
      List<Token> values = reader.values();
      if (reader.peek().kind() != Kind.OPEN) {
        throw new WorldFileException(
            reader.peek().place(), "'{' expected, not " + reader.peek().shown());
      }
      blocks.add(reader.block(word, values, 1));
      reader.skipEnds();
    }
    return blocks;
  }

  private Token peek() {
    return tokens.get(at);
  }

  private void skipEnds() {
    while (peek().kind() == Kind.END_OF_PROPERTY) {
      at++;
    }
  }

  private Token expect(Kind kind, String message) {
    Token token = peek();
    if (token.kind() != kind) {
      throw new WorldFileException(token.place(), message + ", not " + token.shown());
    }
    at++;
    return token;
  }

  private List<Token> values() {
    List<Token> values = new ArrayList<>();
    while (List.of(Kind.WORD, Kind.NUMBER, Kind.STRING).contains(peek().kind())) {
      values.add(tokens.get(at++));
    }
    return values;
  }

  private Block block(Token kind, List<Token> names, int depth) {
    if (names.size() > 1 || !names.isEmpty() && names.getFirst().kind() == Kind.NUMBER) {
      throw new WorldFileException(
          names.getLast().place(), "one name expected before '{', not " + names.getLast().shown());
    }
    if (depth > DEEPEST) {
      throw new WorldFileException(kind.place(), "blocks in blocks too deep");
    }
    Block block =
        new Block(kind.text(), names.isEmpty() ? null : names.getFirst().text(), kind.place());
    Token open = expect(Kind.OPEN, "'{' expected");
    skipEnds();
    while (peek().kind() != Kind.CLOSE) {
      if (peek().kind() == Kind.END_OF_FILE) {
        throw new WorldFileException(open.place(), "this '{' has no '}'");
      }
      Token word = expect(Kind.WORD, "a property, a block or '}' expected");
      List<Token> values = values();
      if (peek().kind() == Kind.OPEN) {
        block.addBlock(block(word, values, depth + 1));
      } else {
        block.addProperty(word.text(), word.place(), values);
        if (peek().kind() != Kind.CLOSE && peek().kind() != Kind.END_OF_FILE) {
          expect(Kind.END_OF_PROPERTY, "';' or the end of the line expected");
        }
      }
      skipEnds();
    }
    at++;
    return block;
  }
}
