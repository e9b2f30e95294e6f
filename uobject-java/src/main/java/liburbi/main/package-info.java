/** The package that programs import whose main is their own. */
@NullMarked
package liburbi.main;

import org.jspecify.annotations.NullMarked;
