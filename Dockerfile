FROM python:3.12-slim

WORKDIR /opt/hoistway
COPY requirements/runtime.txt requirements/
RUN pip install --no-cache-dir --disable-pip-version-check --require-hashes -r requirements/runtime.txt
COPY app app
COPY migrations migrations
COPY plants plants
RUN useradd --system --create-home hoistway && mkdir /var/lib/hoistway && chown hoistway /var/lib/hoistway
USER hoistway
ENV PYTHONPATH=/opt/hoistway PYTHONUNBUFFERED=1 HOISTWAY_LOG_FORMAT=json
EXPOSE 8080
ENTRYPOINT ["python", "-m", "app.main"]
CMD ["--help"]
