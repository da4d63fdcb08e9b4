import { render } from "preact";
import { App } from "./parts/App";
import { begin } from "./store";
import { language, speak } from "./texts";
import "./style.css";

speak(language.value);
begin();
render(<App />, document.getElementById("page") as HTMLElement);
