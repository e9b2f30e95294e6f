/** The package that programs import whose main is their own. */
package liburbi.main;
